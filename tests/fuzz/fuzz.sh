#!/bin/sh
# Runs a libFuzzer program for this many seconds, starting from the inputs in the folders. In the current folder it leaves new
# inputs in found/, from which the next run starts too, and an input that crashes the program, if any, in crashes/.
# Usage: fuzz.sh FUZZER SECONDS DICTIONARY FOLDER...
fuzzer=$1
seconds=$2
dictionary=$3
shift 3
mkdir -p found crashes
if "$fuzzer" -max_total_time="$seconds" -dict="$dictionary" -max_len=4096 -timeout=10 -artifact_prefix="$PWD/crashes/" \
    -print_final_stats=1 found crashes "$@" > fuzz.log 2>&1; then
    sed -n 's/^stat::number_of_executed_units: *\(.*\)/No crash in \1 inputs./p' fuzz.log
else
    tail -n 60 fuzz.log
    sed -n "s|.*Test unit written to \(.*\)|Crash. Once it is mended, add its input to the corpus; to repeat it: $fuzzer \1|p" fuzz.log
    exit 1
fi
