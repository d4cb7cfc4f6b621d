#!/usr/bin/env bash
# make_game_pictures.sh [BUILD]: makes the pictures and the recording of the game and the sheets of fruit anew:
# docs/images/game_*.jpg, fruit_*.jpg and game.gif, in some four minutes. They follow from seeds and scripts; only times that
# are shown differ. Of the giant's frames each 17th is drawn, the last but one among them: the time of a frame that it shows
# is of one that was drawn. Needs ImageMagick, FFmpeg and gifsicle (apt-get install imagemagick ffmpeg gifsicle).
set -euo pipefail
build=$(realpath "${1:-$(dirname "${BASH_SOURCE[0]}")/../../build/release}")
cd "$(dirname "${BASH_SOURCE[0]}")"
viewer=$build/viewer/app/kerf-viewer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# picture NAME ARGUMENTS...: the last frame, half as large and without the noise that costs bytes.
picture() {
    local name=$1
    shift
    "$viewer" --headless --draw 0 --size 1920x1080 "$@" --screenshot "$work/$name.png" > "$work/$name.json"
    convert "$work/$name.png" -filter Lanczos -resize 960x540 -quality 84 "game_$name.jpg"
}

picture menu --scene menu --frames 40
picture classic --scene classic --autopilot --seed 3 --frames 1627
picture over --scene classic --screen over --autopilot --seed 3 --frames 2900
picture arcade --scene arcade --autopilot --seed 1 --frames 508
picture zen --scene zen --autopilot --seed 8 --frames 706
picture giant --scene giant --screen play --giant 400000 --script game_giant.kerf --frames 240 --draw 17 --size 960x540
picture duel --scene duel --autopilot --seed 1 --frames 300
picture duel_over --scene duel --autopilot --seed 1 --frames 3602
picture settings --scene menu --screen settings --frames 60

# sheet NAME FRUIT...: whole and cut, a row for each.
sheet() {
    local name=$1
    shift
    "$build/viewer/gallery/fruit_gallery" "$work/$name.png" "$@"
    convert "$work/$name.png" -filter Lanczos -resize 960x -quality 84 "fruit_$name.jpg"
}

sheet round watermelon apple orange lemon kiwi coconut frozen
sheet long banana pineapple bomb freeze frenzy double hammer

# Ten seconds, ten frames each.
"$viewer" --headless --scene arcade --autopilot --seed 1 --frames 800 --draw 0 --size 400x225 --record "$work/all" \
    > "$work/gif.json"
filter="fps=10,split[a][b];[a]palettegen=max_colors=96:stats_mode=diff[p];"
filter+="[b][p]paletteuse=dither=none:diff_mode=rectangle"
ffmpeg -loglevel error -framerate 60 -start_number 200 -i "$work/all/frame_%05d.png" -vf "$filter" "$work/game.gif"
gifsicle -O3 --lossy=80 "$work/game.gif" -o game.gif
