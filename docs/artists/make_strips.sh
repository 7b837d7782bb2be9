#!/bin/sh
# Redraws the pictures of docs/artists.md, and the README's first one. Needs ImageMagick, and ew-render in a build folder.
# Usage: docs/artists/make_strips.sh BUILD_FOLDER
set -eu
render=$(cd "$1" && pwd)/demo/ew-render
cd "$(dirname "$0")"
scenes=../../demo/scenes/artists
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# room CAMERA KEYS: prints a scene in front of a dark wall; KEYS are those of the scene.
room() {
    printf '{ "camera": { "eye": [0, 0, %s], "target": [0, 0, 0], "fov_y_degrees": 25 },\n' "$1"
    printf '  "opaque": [{ "shape": "plane", "point": [0, 0, -3], "normal": [0, 0, 1], "color": [0.02, 0.02, 0.025] }],\n'
    printf '  %s }\n' "$2"
}

# draw SCENE PICTURE SIZE
draw() {
    "$render" "$1" -o "$2" --size "$3" > /dev/null
}

# strip NAME TEMPLATE VALUE...: draws the template once for each value, which takes the place of @, and joins the pictures.
strip() {
    name=$1
    template=$2
    shift 2
    rm -f "$scratch"/*.png
    number=10
    for value; do
        echo "$template" | sed "s/@/$value/g" > "$scratch/scene.json"
        draw "$scratch/scene.json" "$scratch/$number.png" 180x120
        number=$((number + 1))
    done
    convert "$scratch"/*.png +append -quality 94 "$name.webp"
}

# A beam out of an orb, whose keys are given.
beam() {
    room 6 "\"composite\": \"soft\",
        \"points\": [{ \"position\": [-1.1, 0, 0], $1 }],
        \"paths\": [{ \"points\": [[-1.1, 0, 0], [3, 0, 0]], $1 }]"
}

# An arch, lit from its left foot to its right one, whose keys are given.
arch() {
    room 6 "\"composite\": \"soft\", \"paths\": [{ \"kind\": \"bspline\", \"sharpness\": 1.5, \"core\": 0.04, \"brightness\": 3,
        \"color\": [0.15, 0.45, 1], \"points\": [[-1.4, -1, 0], [-1.2, 1, 0], [0, 1.2, 0], [1.2, 1, 0], [1.4, -1, 0]], $1 }]"
}

# Two beams of different colours that cross in front of a bright wall.
crossing() {
    room 6 "$1, \"paths\": [
        { \"points\": [[-3, -0.75, 0], [3, 0.75, 0]], \"core\": 0.1, \"reach\": 0.9, \"brightness\": 1.5, \"color\": [0.15, 0.5, 1] },
        { \"points\": [[-3, 0.75, 0], [3, -0.75, 0]], \"core\": 0.1, \"reach\": 0.9, \"brightness\": 1.5, \"color\": [1, 0.3, 0.1] }]" |
        sed 's/"opaque": \[.*\]/"opaque": [{ "shape": "plane", "point": [0, 0, -1], "normal": [0, 0, 1], "color": [0.5, 0.42, 0.35] }]/'
}

blue='"color": [0.15, 0.45, 1]'
strip core "$(beam "\"core\": @, \"reach\": 1, \"brightness\": 2, \"sharpness\": 2, $blue")" 0.01 0.03 0.1 0.2 0.4
strip reach "$(beam "\"core\": 0.05, \"reach\": @, \"brightness\": 2, $blue")" 0.1 0.3 0.6 1 2
strip brightness "$(beam "\"core\": 0.05, \"reach\": 1, \"brightness\": @, \"sharpness\": 2, $blue")" 0.25 0.5 1 2 6
strip sharpness "$(beam "\"core\": 0.05, \"reach\": 1, \"brightness\": 2, \"sharpness\": @, $blue")" 1 1.5 2 3 5
strip color "$(beam '"core": 0.05, "reach": 1, "brightness": 2, "sharpness": 2, "color": [@]')" \
    '1, 0.1, 0.05' '1, 0.45, 0.1' '0.2, 1, 0.3' '0.15, 0.45, 1' '0.6, 0.15, 1'
strip weights "$(arch '"reach": 0.4, "weights": [@]')" 1 '1, 0' '0, 1, 0' '1, 0, 0, 1, 0, 0, 1' '0, 0, 0, 0, 1, 0, 0'
strip composite "$(crossing '"composite": "@"')" lerp add soft
strip exposure "$(crossing '"composite": "soft", "exposure": @')" 0.25 0.5 1 2 4
strip jump "$(room 6 '"composite": "soft", "paths": [{ "kind": "bspline", "points": [[-1.4, -1, 0], [-1.3, 0.9, 0], [1.3, 0.9, 0], [1.4, -1, 0]],
    "core": 0.04, "reach": @, "brightness": 3, "color": [0.15, 0.45, 1], "weights": [1, 0] }]')" 3 1.5 0.8 0.4

# Pixels show best when they are large: 36 x 24 of them.
for pixels in 0 1 1.5 3; do
    room 60 "\"composite\": \"soft\", \"core_pixels\": $pixels, \"paths\": [
        { \"points\": [[-30, -5, 0], [30, 7, 0]], \"core\": 0.02, \"reach\": 2, \"brightness\": 2, \"sharpness\": 2, $blue },
        { \"points\": [[-30, 4, 0], [30, -8, 0]], \"core\": 0.3, \"reach\": 3, \"brightness\": 2, \"sharpness\": 2, $blue }]" \
        > "$scratch/scene.json"
    draw "$scratch/scene.json" "$scratch/pixels.png" 45x30
    convert "$scratch/pixels.png" -filter point -resize 400% "$scratch/pixels-$pixels.png"
done
convert "$scratch"/pixels-0.png "$scratch"/pixels-1.png "$scratch"/pixels-1.5.png "$scratch"/pixels-3.png \
    +append -quality 94 core_pixels.webp

# The papers' integral above, the world's below, seen from farther and farther away.
for eye in 4 8 16; do
    room $eye '"interval": { "start": 2, "end": 30 }, "epsilon": 0.1, "composite": "soft",
        "points": [{ "position": [0, 0, 0], "coefficient": 8, "color": [0.15, 0.45, 1] }]' > "$scratch/papers.json"
    room $eye '"composite": "soft", "points": [{ "position": [0, 0, 0], "core": 0.1, "reach": 1, "brightness": 2, "sharpness": 1.5,
        "color": [0.15, 0.45, 1] }]' > "$scratch/world.json"
    for look in papers world; do
        draw "$scratch/$look.json" "$scratch/$look-$eye.png" 180x120
    done
done
for look in papers world; do
    convert "$scratch/$look"-4.png "$scratch/$look"-8.png "$scratch/$look"-16.png +append -quality 94 $look.webp
done

for scene in slash bolt shield portal aura beam-struggle; do
    draw $scenes/$scene.json "$scratch/$scene.png" 480x300
    convert "$scratch/$scene.png" -quality 94 $scene.webp
done
draw $scenes/orb-and-beam.json ../readme-orb.png 560x240
