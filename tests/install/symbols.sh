#!/bin/sh
# The shared library exports the functions that the installed header declares, and nothing else.
# Usage: symbols.sh PREFIX
header=$(find "$1" -name energywave.h)
library=$(find "$1" -name libenergywave.so)
sed -n 's/^EW_API .*\(ew_[a-z_]*\)(.*/\1/p' "$header" | sort > declared
nm -D --defined-only "$library" | awk '{ print $3 }' | sort > exported
echo "$(wc -l < declared) functions"
[ "$(grep -c '^EW_API ' "$header")" -eq "$(wc -l < declared)" ] && [ -s declared ] && diff declared exported
