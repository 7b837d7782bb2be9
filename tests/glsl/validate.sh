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
sh "$(dirname "$0")/distinct_files.sh" shaders > files
# The compiler prints the name of each file that it compiles. Anything else that it prints is a fault.
echo "$(wc -l < files) shaders"
xargs glslangValidator < files > log
status=$?
grep -vxFf files log
said_more=$?
[ $status -eq 0 ] && [ $said_more -eq 1 ] && cmp -s files log
