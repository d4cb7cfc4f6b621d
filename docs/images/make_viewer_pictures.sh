#!/usr/bin/env bash
# make_viewer_pictures.sh [BUILD]: makes pictures of docs/viewer.md anew, from scripts; only times that are shown differ:
# on a machine that does nothing else. Needs ImageMagick (apt-get install imagemagick).
set -euo pipefail
viewer=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/release}")/viewer/app/kerf-viewer
cd "$(dirname "${BASH_SOURCE[0]}")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture NAME ARGUMENTS...: the last frame. JPEG is a tenth of PNG, whose bytes go into the wall's grain; letters stay sharp.
picture() {
    local name=$1
    shift
    "$viewer" --headless "$@" --screenshot "$work/$name.png" > /dev/null
    convert "$work/$name.png" -sampling-factor 4:4:4 -quality 86 -interlace JPEG "viewer_$name.jpg"
}

barrel() {
    local name=$1
    shift
    picture "$name" --script barrel.kerf --frames 70 --draw 0 --size 800x450 --zoom 1.6 --zoom-at=1.3,1.2 "$@" \
        ../../data/models/barrel.obj
}

picture rook --script rook.kerf --frames 60 --draw 0 --size 800x450 --zoom 3.1 --zoom-at=1.85,1.55 ../../data/models/rook.obj
barrel textured
barrel lambert --lighting lambert
barrel proxies --proxies
# Every frame is drawn, for their times.
picture panel --script barrel.kerf --frames 70 --panel --size 1280x720 --zoom 1.6 --zoom-at=0.6,1.2 \
    ../../data/models/barrel.obj
