#!/bin/sh
# ew-bench prints a table and writes the CSV that it was asked for: a header, and a row for each scene and integrator, with
# numbers where numbers belong. The test judges neither times nor errors, except that no error may be negative.
# Usage: bench_writes_a_table.sh EW_BENCH SCENE
set -e
rm -rf bench_table && mkdir bench_table && cd bench_table
"$1" "$2" --size 32x32 --integrators bare,adaptive:1e-3,simpson:16 --repetitions 3 --error-samples 64 --csv table.csv > stdout
test "$(head -n 1 table.csv)" = \
    'scene,integrator,size,renderer,ms_median,ms_min,evaluations_per_pixel,max_rel_error,p99_rel_error,brightness'
scene=$(basename "$2" .json)
sed 's/"[^"]*"/quoted/' table.csv | awk -F, -v scene="$scene" '
    BEGIN { split("bare adaptive:1e-3 simpson:16", integrators, " ") }
    function fail(what) { print "FAILED: line " NR ": " what ": " $0; failed = 1 }
    NR == 1 { next }
    NF != 10 { fail("has not 10 fields") }
    $1 != scene || $2 != integrators[NR - 1] || $3 != "32x32" || $4 != "quoted" { fail("is about something else") }
    !($5 > 0 && $6 > 0 && $6 <= $5) { fail("has no times") }
    $2 == "bare" && ($8 != "" || $9 != "" || $10 != "") { fail("has errors") }
    $2 != "bare" && !($8 ~ /^[0-9]/ && $9 ~ /^[0-9]/ && $9 + 0 <= $8 + 0) { fail("has no errors") }
    $2 == "adaptive:1e-3" && !($10 > 0.999 && $10 < 1.001) { fail("has not all light") }
    $2 == "simpson:16" && $7 != 17 { fail("has not the evaluations of Simpson with 16 divisions") }
    END { if (NR != 4) fail("there are not three rows"); exit failed }'
for name in bare adaptive:1e-3 simpson:16; do
    grep -q "^  $name " stdout
done
