#!/bin/sh
# ew-render, built as a project of its own with the installed library, draws the same showpiece as the contexts of the gl tests.
# Usage: showpiece.sh PREFIX CONSUMER_SOURCES DEMO_SOURCES C_COMPILER EW_PROBE_IMAGE PICTURES
prefix=$1 consumer=$2 demo=$3 compiler=$4 probe=$5 pictures=$6
. "$(dirname "$0")/../checks.sh"
enters showpiece

{ cmake -S "$consumer" -B build -DCMAKE_PREFIX_PATH="$prefix" -DLIBRARY=EnergyWave::energywave -DDEMO_SOURCES="$demo" \
    -DCMAKE_C_COMPILER="$compiler" &&
    cmake --build build --target ew-render; } > log 2>&1 || { cat log; exit 1; }
build/ew-render "$demo/scenes/showpiece.json" -o consumer.png --size 192x108 || complain 'it does not draw'
alike "$probe" "$pictures/gl33.png" consumer.png
alike "$probe" "$pictures/es30.png" consumer.png
[ ! -e "$pictures/osmesa33.png" ] || alike "$probe" "$pictures/osmesa33.png" consumer.png
concludes
