#!/bin/sh
# Redraws the figures of docs/method.md. Needs gnuplot, and ew-render and ew-accuracy in a build folder.
# Usage: docs/method/make_figures.sh BUILD_FOLDER
set -eu
build=$(cd "$1" && pwd)
cd "$(dirname "$0")"

for figure in substitution rest nearest profile; do
    gnuplot $figure.gnuplot
done

for scene in beziers-5.0-oblique torus-0.9-oblique; do
    file=../../demo/scenes/$scene.json
    "$build/demo/ew-render" $file --size 256x256 -o $scene.png > /dev/null
    for integrator in simpson:200 adaptive:1e-3; do
        "$build/tests/accuracy/ew-accuracy" $file --size 256x256 --full --integrators $integrator \
            --heatmap $scene-"${integrator%:*}".png
    done
done
