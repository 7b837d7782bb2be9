#!/bin/sh
# The library and the programs are in the language that Microsoft's compiler takes, as far as clang can tell when it plays
# that compiler: no warning, no extension and, in the library, no __attribute__. The C library's and Windows' headers are
# wine's, which follow Microsoft's; those of GL are MinGW's. No code is made, so nothing is said about linking.
# Usage: msvc_syntax.sh SOURCE_FOLDER BUILD_FOLDER INCLUDE_FOLDER, the last of GLFW, Jansson and stb
sources=$1 build=$2 includes=$3
wine=/usr/include/wine/wine
mingw=/usr/x86_64-w64-mingw32/include
. "$(dirname "$0")/../checks.sh"
needs clang
[ -e $wine/msvcrt/stdio.h ] || { echo "SKIPPED: wine's headers (on Debian: libwine-dev) are not installed"; exit 77; }
enters msvc_syntax
mkdir -p gl/GL gl/KHR && cp $mingw/GL/glcorearb.h $mingw/GL/wglext.h gl/GL && cp $mingw/KHR/khrplatform.h gl/KHR

# takes FILE OPTION...
takes() {
    file=$1
    shift
    clang --target=x86_64-pc-windows-msvc -std=c11 -fsyntax-only -Wall -Wextra -Wvla -pedantic-errors -Werror -DEW_STATIC \
        -isystem $wine/msvcrt -isystem $wine/windows -idirafter gl -I"$sources/src" -I"$build/src" "$@" "$file" ||
        complain "$file"
}

library=$(find "$sources/src" -name '*.c')
programs=$(find "$sources/demo/support" "$sources/demo/ew_demo" "$sources/demo/ew_render" -name '*.c' |
    grep -v '_\(posix\|egl\|osmesa\|webgl\)\.c$')
for file in $library "$build/src/glsl_text.c"; do
    takes "$file" '-D__attribute__(x)=this_compiler_has_no_attributes'
done
for file in $programs "$build/demo/demo_shaders.c"; do
    takes "$file" -I"$sources/demo/support" -I"$sources/demo/ew_demo" -I"$build/demo" -isystem "$includes" \
        -D_USE_MATH_DEFINES -DEW_HAVE_GLFW
done
printf '%s sources\n' "$(printf '%s\n' "$library" "$programs" | wc -l)"
concludes
