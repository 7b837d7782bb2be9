#!/bin/sh
# Each block of C on a page compiles on its own, without a warning. Blocks for libraries that are not installed are skipped,
# except for SDL, of which one declaration is enough.
# Usage: page.sh PAGE CC INCLUDE_FOLDER...
page=$1
compiler=$2
shift 2
rm -rf page && mkdir page && cd page || exit 1
includes=
for folder; do
    includes="$includes -I$folder"
done
awk '/^```c$/ { inside = 1; file = sprintf("%02d.c", ++count); next } /^```$/ { inside = 0 } inside { print > file }' "$page"

compiled=0
failures=0
for block in *.c; do
    missing=
    for header in $(sed -n 's/^#include <\(.*\)>$/\1/p' "$block"); do
        # shellcheck disable=SC2086 # a list of options
        echo "#include <$header>" | "$compiler" -std=c11 $includes -E -o header.i -x c - 2> /dev/null || missing=$header
    done
    if [ "$missing" = SDL.h ]; then
        mkdir -p sdl && echo 'extern void *SDL_GL_GetProcAddress(const char *proc);' > sdl/SDL.h
        includes="$includes -Isdl"
    elif [ -n "$missing" ]; then
        echo "$block is left out: there is no $missing"
        continue
    fi
    compiled=$((compiled + 1))
    # shellcheck disable=SC2086
    "$compiler" -std=c11 -Wall -Wextra -Werror $includes -c "$block" -o "${block%.c}.o" || failures=$((failures + 1))
done
printf '%d blocks, %d failures\n' $compiled $failures
[ $compiled -gt 0 ] && [ $failures -eq 0 ]
