#!/usr/bin/env bash
# make_fracture_pictures.sh [BUILD]: makes docs/images/fracture_patterns.jpg, fracture_inside.jpg and shatter.gif anew, in a
# minute. They follow from seeds and scripts. Needs ImageMagick, FFmpeg and gifsicle (apt-get install imagemagick ffmpeg
# gifsicle).
set -euo pipefail
build=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/release}")
cd "$(dirname "${BASH_SOURCE[0]}")"
viewer=$build/viewer/app/kerf-viewer
models=$(realpath ../../data/models)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One queen for each pattern, twenty frames after the blow.
for pattern in uniform impact crack grid splinters; do
    {
        echo "kerf-script 1"
        echo "scene shatter"
        echo "seed 4"
        for command in "pattern $pattern" "cells 60" "strength 0"; do echo "1000 command $command"; done
    } > "$work/$pattern.kerf"
    "$viewer" --headless --script "$work/$pattern.kerf" --autopilot --frames 56 --draw 0 --size 960x720 \
        --zoom 2.9 --zoom-at=-1.15,-1.35 --screenshot "$work/$pattern.png" "$models/queen.obj" > /dev/null
done
montage -label "%t" "$work"/{uniform,impact,crack,grid,splinters}.png -tile 5x1 -geometry 384x288+2+2 -pointsize 16 \
    "$work/patterns.png"
convert "$work/patterns.png" -quality 86 fracture_patterns.jpg

# What is inside: caps of one material, whose texture runs on from piece to piece.
printf 'kerf-script 1\nscene shatter\nseed 4\n1000 command cells 30\n1000 command strength 0\n' > "$work/inside.kerf"
for model in barrel pedestal; do
    "$viewer" --headless --script "$work/inside.kerf" --autopilot --frames 68 --draw 0 --size 1200x800 --zoom 2.4 \
        --zoom-at=-1.0,-0.4 --screenshot "$work/inside_$model.png" "$models/$model.obj" > /dev/null
done
montage "$work"/inside_{barrel,pedestal}.png -tile 2x1 -geometry 600x400+2+2 "$work/inside.png"
convert "$work/inside.png" -quality 86 fracture_inside.jpg

# Four seconds of the scene: two blows crack a rook, the third is the end of it.
printf 'kerf-script 1\nscene shatter\nseed 4\n1000 command cells 60\n1000 command strength 700\n' > "$work/gif.kerf"
"$viewer" --headless --script "$work/gif.kerf" --autopilot --frames 240 --draw 0 --size 480x270 --zoom 1.25 \
    --zoom-at=0,-0.3 --record "$work/all" "$models/rook.obj" > /dev/null
filter="fps=12.5,split[a][b];[a]palettegen=max_colors=96:stats_mode=diff[p];"
filter+="[b][p]paletteuse=dither=none:diff_mode=rectangle"
ffmpeg -loglevel error -framerate 50 -start_number 16 -i "$work/all/frame_%05d.png" -vf "$filter" "$work/shatter.gif"
gifsicle -O3 --lossy=80 "$work/shatter.gif" -o shatter.gif
