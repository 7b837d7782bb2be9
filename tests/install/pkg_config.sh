#!/bin/sh
# The consumer, built with no flags but pkg-config's, draws its frame.
# Usage: pkg_config.sh shared|static PREFIX SOURCES C_COMPILER
kind=$1 prefix=$2 sources=$3 compiler=$4
set -e
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name energywave.pc)")
export PKG_CONFIG_PATH
library_path=$(pkg-config --variable=libdir energywave)
case $kind in
shared) flags=$(pkg-config --cflags --libs energywave) ;;
# With both libraries in one folder, -lenergywave would choose the shared one.
static) flags=$(pkg-config --static --cflags --libs energywave | sed 's/-lenergywave/-l:libenergywave.a/') ;;
esac
# shellcheck disable=SC2046,SC2086 # flags are words
$compiler -std=c11 -Wall -Wextra -Wpedantic -Werror -DGL_GLEXT_PROTOTYPES -o consumer-"$kind" "$sources"/main.c "$sources"/glow.c $flags \
    $(pkg-config --cflags --libs egl gl)
LD_LIBRARY_PATH=$library_path ./consumer-"$kind"

needed=$(readelf -d consumer-"$kind" | grep -c 'NEEDED.*libenergywave' || true)
case $kind in
shared) [ "$needed" -eq 1 ] ;;
static) [ "$needed" -eq 0 ] ;;
esac
