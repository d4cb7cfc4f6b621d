#!/usr/bin/env bash
# make_section_gif.sh [BUILD]: makes docs/images/section.gif anew, in half a minute: a plane moves through a Menger sponge,
# to and fro once, with contours on the way back. Only the times that are shown differ. Needs FFmpeg and gifsicle (apt-get
# install ffmpeg gifsicle).
set -euo pipefail
build=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/release}")
cd "$(dirname "${BASH_SOURCE[0]}")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$build/tools/kerf" shape menger_sponge --triangles 60000 -o "$work/sponge.ply" > /dev/null
"$build/viewer/app/kerf-viewer" --headless --scene section --frames 240 --draw 0 --size 640x360 --panel --ui-scale 0.6 \
    --record "$work/all" "$work/sponge.ply" > "$work/report.json"
filter="fps=12,split[a][b];[a]palettegen=max_colors=96:stats_mode=diff[p];"
filter+="[b][p]paletteuse=dither=none:diff_mode=rectangle"
ffmpeg -loglevel error -framerate 36 -i "$work/all/frame_%05d.png" -vf "$filter" "$work/section.gif"
gifsicle -O3 --lossy=80 "$work/section.gif" -o section.gif
