#!/bin/sh
# The compilers of Direct3D and Metal could be handed the shaders. One in four classes of permutations goes there in the dialect of
# WebGL, and of the other dialects, which differ in their heads, one in forty. With "all", every class does in the dialect of WebGL, and
# one in ten of the others, which takes minutes.
# Usage: cross_compile.sh SHADER_TEXT CROSS_COMPILE [all]
rm -rf cross_compiled && mkdir cross_compiled && "$1" cross_compiled || exit 1
sh "$(dirname "$0")/distinct_files.sh" cross_compiled |
    awk -v every="$([ "${3-}" = all ] && echo 1 || echo 4)" 'NR % (/\/300es-[^s]/ ? every : 10 * every) == 0' > crossed_files
echo "$(wc -l < crossed_files) shaders"
"$2" < crossed_files
