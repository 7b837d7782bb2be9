#!/bin/sh
# What games draw instead of the field is near it: no pixel is negative or no number, all light together is within a fifth of
# what it ought to be, and most pixels are within their bounds. A peer that draws nothing fails, as does one that draws in the
# wrong place.
# Usage: bench_peers_are_near_the_field.sh EW_BENCH SCENE...
bench=$1
shift
rm -rf bench_near && mkdir -p bench_near/pictures && cd bench_near || exit 1
"$bench" "$@" --size 320x180 --integrators half-marching:64,billboards:64,ribbon:64 --repetitions 3 --error-samples 512 \
    --csv table.csv --pictures pictures || exit 1
sed 's/"[^"]*"/quoted/' table.csv | awk -F, '
    BEGIN { bounds["half-marching:64"] = 1.5; bounds["billboards:64"] = 0.8; bounds["ribbon:64"] = 1.5 }
    NR > 1 {
        rows++
        if (!($8 + 0 >= 0) || $8 ~ /inf|nan/) complain("has pixels that are negative or no number")
        if (!($9 + 0 <= bounds[$2])) complain("is wrong by more than " bounds[$2] " at a pixel in a hundred: " $9)
        if (!($10 >= 0.8 && $10 <= 1.2)) complain("has " $10 " of the light")
    }
    function complain(what) { print "FAILED: " $1 ": " $2 " " what; failed = 1 }
    END { exit failed || rows < 3 }' || exit 1
for scene; do
    for peer in half-marching-64 billboards-64 ribbon-64; do
        test -s "pictures/$(basename "$scene" .json)-$peer.png" || exit 1
    done
done
