#!/bin/sh
# C++ hosts compile against the installed header without a warning, by each compiler in each standard: the header's defaults,
# and the README's glow, which draws its frame.
# Usage: cxx.sh PREFIX SOURCES
prefix=$1 sources=$2
. "$(dirname "$0")/cxx_compilers.sh"
if ! command -v g++ > /dev/null && ! command -v clang++ > /dev/null; then
    echo 'SKIPPED: there is no C++ compiler'
    exit 77
fi
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name energywave.pc)")
export PKG_CONFIG_PATH
LD_LIBRARY_PATH=$(pkg-config --variable=libdir energywave)
export LD_LIBRARY_PATH

# builds_and_runs COMPILER STANDARD PROGRAM SOURCE...
builds_and_runs() {
    compiler=$1 standard=$2 program=$3-$1-$2
    shift 3
    echo "$program"
    # shellcheck disable=SC2046 # flags are words
    $compiler -std="$standard" -x c++ -pedantic-errors -Wall -Wextra -Werror -DGL_GLEXT_PROTOTYPES -o "$program" "$@" -x none \
        $(pkg-config --cflags --libs energywave egl gl) && "./$program"
}

for_each_cxx builds_and_runs header "$sources"/header.cpp &&
    for_each_cxx builds_and_runs glow "$sources"/main.c "$sources"/glow.cpp
