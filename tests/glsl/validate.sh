#!/bin/sh
# The reference compiler accepts every class of shader permutation, as desktop GLSL and as GLSL ES.
# Usage: validate.sh SHADER_TEXT
if ! command -v glslangValidator > /dev/null; then
    echo 'SKIPPED: glslangValidator is not installed'
    exit 77
fi
rm -rf shaders && mkdir shaders || exit 1
"$1" shaders || exit 1
grep -q '#define EW_SOURCE_VARYINGS' shaders/330-software-*.vert || exit 1
grep -q '#define EW_SOURCE_VARYINGS' shaders/300es-software-*.frag || exit 1
# Of files with the same content one will do. What is for software rasterisers alone is written once for both dialects, and GLSL ES is
# the stricter: of the others, one in four will do.
find shaders -type f | sort | xargs md5sum | sort -u -k1,1 | sed 's/^[^ ]* *//' | sort |
    awk '!/\/330-software/ || NR % 4 == 0' > files
# The compiler prints the name of each file that it compiles. Anything else that it prints is a fault.
echo "$(wc -l < files) shaders"
xargs glslangValidator < files > log
status=$?
grep -vxFf files log
said_more=$?
[ $status -eq 0 ] && [ $said_more -eq 1 ] && cmp -s files log
