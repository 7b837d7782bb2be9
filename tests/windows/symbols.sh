#!/bin/sh
# The DLL exports the functions that the header declares, and nothing else.
# Usage: symbols.sh OBJDUMP DLL HEADER
sed -n 's/^EW_API .*\(ew_[a-z_]*\)(.*/\1/p' "$3" | sort > declared
"$1" -p "$2" | sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/s/^.*\[ *[0-9]*\] *\([^ ]*\)$/\1/p' | sort > exported
echo "$(wc -l < declared) functions"
[ -s declared ] && diff declared exported
