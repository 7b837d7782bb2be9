#!/bin/sh
# The compilers of Direct3D and Metal could be handed the shaders. One in four classes of permutations goes there in the dialect of
# WebGL, and of the other dialects, which differ in their heads, one in forty. With "all", every class does in the dialect of WebGL, and
# one in ten of the others, which takes minutes.
# Usage: cross_compile.sh SHADER_TEXT CROSS_COMPILE [all]
rm -rf cross_compiled && mkdir cross_compiled && "$1" cross_compiled || exit 1
cd cross_compiled || exit 1

# Of files with the same content one will do.
find . -name '*.vert' -o -name '*.frag' | sort | xargs md5sum | sort -u -k1,1 | sed 's/^[^ ]* *//' | sort |
    awk -v every="$([ "${3-}" = all ] && echo 1 || echo 4)" 'NR % (/\/300es-[^s]/ ? every : 10 * every) == 0' > files
echo "$(wc -l < files) shaders"
"$2" < files
