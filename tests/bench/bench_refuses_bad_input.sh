#!/bin/sh
# On bad input, ew-bench says on one line what to correct, exits with status 2, and measures nothing.
# Usage: bench_refuses_bad_input.sh EW_BENCH SCENE
bench=$1
scene=$2
failures=0

# refuses PATTERN ARGUMENT...
refuses() {
    pattern=$1
    shift
    "$bench" "$@" > bench_stdout 2> bench_stderr
    status=$?
    if [ $status -ne 2 ] || [ "$(wc -l < bench_stderr)" -ne 1 ] || ! grep -q "^ew-bench: .*$pattern" bench_stderr; then
        echo "FAILED: ew-bench $*: status $status, \"$(cat bench_stderr)\""
        failures=$((failures + 1))
    fi
}

for size in 0x1 1x0 1 1x1x1 9000x1 axb ''; do
    refuses '--size' "$scene" --size "$size"
done
for list in '' adaptive adaptive:1e-5 simpson:3 simpson:0 simpson:5000 marching marching:0 marching:x newton:3 bare:1 \
    bare,bare simpson:2,,simpson:4 'bare,' ribbon ribbon:0 billboards:5000 \
    half-marching:0; do
    refuses '--integrators' "$scene" --integrators "$list"
done
refuses '--repetitions' "$scene" --repetitions 2
refuses '--error-samples' "$scene" --error-samples 0
refuses '--name' "$scene" --report bench_docs --name a/b
refuses '--name' "$scene" --name a
refuses '--backend' "$scene" --backend glide
refuses '--nonsense' "$scene" --nonsense
refuses '-z: is' "$scene" -z
refuses '--help=please: is' --help=please
refuses '--csv' "$scene" --csv
for peer in billboards:64 ribbon:64; do
    refuses 'need.*a reach' "$scene" --size 8x8 --integrators $peer
done
refuses 'nowhere.json' nowhere.json --size 8x8
refuses 'nowhere/table.csv' "$scene" --size 8x8 --csv nowhere/table.csv
refuses 'rename' "$scene" "$scene"
exit $failures
