#!/bin/sh
# ew-bench writes a report: the page, and a plot for each scene. The report does not depend on when it was written.
# Usage: bench_writes_a_report.sh EW_BENCH SCENE
command -v gnuplot > gnuplot_path || exit 77
set -e
rm -rf bench_report && mkdir bench_report && cd bench_report
"$1" "$2" --size 32x32 --integrators bare,adaptive:1e-2,adaptive:1e-3,simpson:16,simpson:200,marching:16,equiangular:16 \
    --repetitions 3 --error-samples 64 --report docs --name test
scene=$(basename "$2" .json)
test "$(ls docs docs/speed-and-error-test | tr '\n' ' ')" = \
    "docs: speed-and-error-test speed-and-error-test.md  docs/speed-and-error-test: $scene.svg "
page=docs/speed-and-error-test.md
grep -q "^### $scene\$" $page
grep -q "(speed-and-error-test/$scene.svg)" $page
grep -q '^`adaptive:1e-3` takes .* times the speed at .* times the accuracy\.$' $page
for name in bare adaptive:1e-2 adaptive:1e-3 simpson:16 simpson:200 marching:16 equiangular:16; do
    test "$(grep -c "^| \`$name\` | [0-9]" $page)" = 1
done
for family in adaptive Simpson 'uniform marching' 'equiangular sampling' 'a bare pass'; do
    grep -q ">$family<" "docs/speed-and-error-test/$scene.svg"
done
if grep "$(date +%Y)" $page; then exit 1; fi
