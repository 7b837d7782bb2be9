#!/bin/sh
# ew-bench-growth writes a page and a plot for each sweep, with a positive time for each point and an exponent for each series.
# Usage: bench_growth_writes_a_report.sh EW_BENCH_GROWTH
command -v gnuplot > gnuplot_path || exit 77
set -e
rm -rf bench_growth && mkdir bench_growth && cd bench_growth
"$1" --size 64x36 --largest-side 256 --largest-count 64 --report docs --name test
test "$(ls docs docs/growth-test | tr '\n' ' ')" = \
    "docs: growth-test growth-test.md  docs/growth-test: coverage.svg pixels.svg processor.svg samples.svg sources.svg "
awk -F'|' '
    function complain(what) { print "FAILED: line " NR ": " what ": " $0; failed = 1 }
    /^\| exponent/ { exponents++; if (!($3 ~ /^ -?[0-9.]+ $/ && $4 ~ /^ -?[0-9.]+ $/)) complain("has no exponents"); next }
    /^\| [0-9]/ { points++; if (!($2 > 0 && $3 > 0 && $4 > 0)) complain("has no times") }
    END { if (exponents != 5 || points < 13) complain("has " points " points and " exponents " exponents"); exit failed }' \
    docs/growth-test.md
# More sources are more bytes, but each has its own share: no fewer than the three vec4 of its ends, its light and its glow.
sed -n '/^## The processor/,$p' docs/growth-test.md | awk -F'|' '/^\| 64/ { found = $5 >= 48 } END { exit !found }'
