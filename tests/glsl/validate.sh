#!/bin/sh
# Every class of shader permutation is valid GLSL by the reference compiler, for desktop GL and for GLES.
# Usage: validate.sh SHADER_TEXT
if ! command -v glslangValidator > /dev/null; then
    echo 'SKIPPED: glslangValidator is not installed'
    exit 77
fi
rm -rf shaders && mkdir shaders || exit 1
"$1" shaders || exit 1
grep -q '#define EW_SOURCE_VARYINGS' shaders/330-software-*.vert || exit 1
grep -q '#define EW_SOURCE_VARYINGS' shaders/300es-software-*.frag || exit 1
# The compiler names each file that it takes; whatever else it says is a fault.
find shaders -type f | sort > files
echo "$(wc -l < files) shaders"
xargs glslangValidator < files > log
status=$?
grep -vxFf files log
said_more=$?
[ $status -eq 0 ] && [ $said_more -eq 1 ] && cmp -s files log
