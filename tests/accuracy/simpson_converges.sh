#!/bin/sh
# Simpson's rule converges to the reference: simpson_converges.sh EW_ACCURACY SCENE.json
# Each fourfold increase of the divisions must reduce the largest error to a third or less: across kinks, the rule is of second
# order at worst. The last one must reduce it to 1e-4.
set -eu
csv=simpson_converges.csv
rm -f "$csv"
status=0
"$1" "$2" --backend egl --size 160x160 --integrators simpson:16,simpson:64,simpson:256,simpson:1024 --csv "$csv" || status=$?
[ "$status" -eq 0 ] || exit "$status"
awk -F, '
    NR == 1 { for (i = 1; i <= NF; i++) if ($i == "max_rel_error") column = i; next }
    NR > 2 && $column * 3 > previous { print $2 " is not a third of the error before it"; wrong = 1 }
    { previous = $column }
    END { if (NR != 5 || previous > 1e-4) { print "the last error is " previous; wrong = 1 } exit wrong }' "$csv"
