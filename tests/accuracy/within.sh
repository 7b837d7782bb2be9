#!/bin/sh
# The luminance of a scene is within a bound of the reference, and never negative, infinite or NaN:
# within.sh EW_ACCURACY SCENE.json BOUND [OPTION...]
# BOUND is relative to max(truth, 1e-3 of the image's largest luminance), and holds for every pixel that is compared. The
# reference must be sure of 99 % of these.
set -eu
program=$1 scene=$2 bound=$3
shift 3
csv=within.$(basename "$scene").$$.csv
trap 'rm -f "$csv"' EXIT
status=0
"$program" "$scene" --csv "$csv" "$@" || status=$?
[ "$status" -eq 0 ] || exit "$status"
awk -F, -v bound="$bound" '
    NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
    {
        rows++
        if (!($column["max_rel_error"] + 0 <= bound)) { print $2 ": " $column["max_rel_error"] " is beyond " bound; wrong = 1 }
        if ($column["bad_pixels"] != 0) { print $2 ": " $column["bad_pixels"] " bad pixels"; wrong = 1 }
        if (!($column["unreliable_pixels"] <= 0.01 * $column["pixels"])) { print "the reference is not sure"; wrong = 1 }
    }
    END { if (!rows || !column["max_rel_error"] || !column["bad_pixels"]) { print "no comparison was made"; wrong = 1 } exit wrong }
    ' "$csv"
