#!/bin/sh
# C++ programs compile against the installed header without a warning, link and run.
# Usage: cxx.sh PREFIX SOURCES
prefix=$1 sources=$2
if ! command -v c++ > /dev/null; then
    echo 'SKIPPED: there is no C++ compiler'
    exit 77
fi
set -e
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name energywave.pc)")
export PKG_CONFIG_PATH
for standard in c++11 c++20; do
    # shellcheck disable=SC2046 # flags are words
    c++ -std=$standard -Wall -Wextra -Wpedantic -Werror -o header-$standard "$sources"/header.cpp \
        $(pkg-config --cflags --libs energywave)
    LD_LIBRARY_PATH=$(pkg-config --variable=libdir energywave) ./header-$standard
done
