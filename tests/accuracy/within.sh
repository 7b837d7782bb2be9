#!/bin/sh
# The luminance of a scene is within a bound of the reference: within.sh EW_ACCURACY SCENE.json BOUND [OPTION...]
# BOUND is relative to max(truth, 1e-3 of the image's largest luminance), and holds for every pixel that is compared.
set -eu
program=$1 scene=$2 bound=$3
shift 3
csv=within.$(basename "$scene").csv
rm -f "$csv"
status=0
"$program" "$scene" --csv "$csv" "$@" || status=$?
[ "$status" -eq 0 ] || exit "$status"
awk -F, -v bound="$bound" '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == "max_rel_error") column = i; next }
    { rows++; if (!($column + 0 <= bound)) { print $2 ": " $column " is beyond " bound; wrong = 1 } }
    END { if (!column || !rows) { print "no comparison was made"; wrong = 1 } exit wrong }' "$csv"
