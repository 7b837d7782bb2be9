#!/bin/sh
# Each block of code on a page compiles on its own, without a warning: C by the C compiler, and by both C++ compilers in every
# standard from C++11 on, except where a block of C++ follows it and says the same. Blocks for libraries that are not installed
# are skipped, except for SDL, of which one declaration is enough.
# Usage: page.sh PAGE CC INCLUDE_FOLDER...
page=$1
compiler=$2
shift 2
here=$(dirname "$0")
rm -rf page && mkdir page && cd page || exit 1
includes=
for folder; do
    includes="$includes -I$folder"
done
awk '/^```c(pp)?$/ { inside = 1; file = sprintf("%02d.%s", ++count, substr($0, 4)); next } /^```$/ { inside = 0 }
    inside { print > file }' "$page"
. "$here/cxx_compilers.sh"

# compiles BLOCK COMMAND...
compiles() {
    block=$1
    shift
    compiled=$((compiled + 1))
    # shellcheck disable=SC2086 # a list of options
    "$@" -pedantic-errors -Wall -Wextra -Werror $includes -c "$block" -o block.o && return
    echo "$block: $*"
    failures=$((failures + 1))
}

# in_cxx COMPILER STANDARD BLOCK
in_cxx() {
    compiles "$3" "$1" -std="$2" -x c++
}

compiled=0
failures=0
for block in *.c *.cpp; do
    missing=
    for header in $(sed -n 's/^#include <\(.*\)>$/\1/p' "$block"); do
        # shellcheck disable=SC2086
        echo "#include <$header>" | "$compiler" -std=c11 $includes -E -o header.i -x c - 2> /dev/null || missing=$header
    done
    if [ "$missing" = SDL.h ]; then
        mkdir -p sdl && echo 'extern void *SDL_GL_GetProcAddress(const char *proc);' > sdl/SDL.h
        includes="$includes -Isdl"
    elif [ -n "$missing" ]; then
        echo "$block is left out: there is no $missing"
        continue
    fi
    [ "$block" = "${block%.c}" ] || compiles "$block" "$compiler" -std=c11
    next=$(printf '%02d.cpp' $((1${block%.*} - 99)))
    [ -e "$next" ] || for_each_cxx in_cxx "$block"
done
printf '%d compilations, %d failures\n' $compiled $failures
[ $compiled -gt 0 ] && [ $failures -eq 0 ]
