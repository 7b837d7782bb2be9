#!/bin/sh
# The showpiece looks the same in contexts of all kinds and in ew-render.
# Usage: showpiece.sh DRAW_IN_CONTEXTS EW_RENDER EW_PROBE_IMAGE SHOWPIECE CONTEXT...
draw_in_contexts=$1 ew_render=$2 probe=$3 scene=$4
shift 4
. "$(dirname "$0")/../checks.sh"
enters showpiece

"$draw_in_contexts" "$scene" 192 108 "$@" || complain 'not every context draws'
"$ew_render" "$scene" -o ew-render.png --size 192x108 || complain 'ew-render fails'
for context; do
    alike "$probe" ew-render.png "$context.png"
done

# Dark pictures would look the same, too, so check that there is light.
sed 's/"brightness": [0-9.]*/"brightness": 0/' "$scene" > dark.json
"$ew_render" dark.json -o dark.png --size 192x108 > stdout
"$probe" difference ew-render.png dark.png > difference && read -r largest _ < difference
[ "$largest" -gt 200 ] || complain "the light adds $largest at most"
concludes
