#!/bin/sh
# ew-render and ew-demo on Windows draw what they draw elsewhere, write over older files and bytes as they are, and ew-demo
# opens its window and obeys its keys. The display must be there.
# Usage: demo.sh EMULATOR EW_RENDER EW_DEMO EW_PROBE_IMAGE NATIVE_EW_RENDER SCENES
emulator=$1 ew_render=$2 ew_demo=$3 probe=$4 native_ew_render=$5 scenes=$6
. "$(dirname "$0")/../checks.sh"
enters demo
. "$(dirname "$0")/../demo/display.sh"
needs compare "$native_ew_render"

shows() {
    import -window "$id" shown.png && [ "$(compare -metric AE shown.png "$1" null: 2>&1)" = 0 ]
}

# The probe is a program for Windows, too.
probe_by_emulator() {
    $emulator "$probe" "$@" | tr -d '\r'
}

for scene in showpiece artists/beam-struggle; do
    echo 'an older file' > here.png
    $emulator "$ew_render" "$scenes/$scene.json" -o here.png --size 192x108 || complain "$scene: ew-render fails"
    "$native_ew_render" "$scenes/$scene.json" -o there.png --size 192x108
    alike probe_by_emulator here.png there.png
done
$emulator "$ew_render" "$scenes/artists/beam-struggle.json" -o - --size 192x108 > printed.png
cmp here.png printed.png || complain 'the picture on standard output is not that of the file'
for left in *.tmp; do
    [ ! -e "$left" ] || complain "left $left"
done

$emulator "$ew_demo" --offscreen --size 192x108 --frames 3 -o 3.png || complain 'ew-demo --offscreen fails'
trap 'kill $program 2> /dev/null' EXIT
# shellcheck disable=SC2086,SC2154 # the emulator may be several words or none; display.sh gives program and id
opens $emulator "$ew_demo" --size 192x108
for key in space r p period period period; do
    xdotool key $key
done
waits 'the window shows frame 3' shows 3.png
closes
concludes
