#!/bin/sh
# The compilers of Direct3D and Metal could be handed the shaders: their SPIR-V can be written as HLSL and as MSL, the ways of WebGL and
# its like. One in four classes of permutations goes there in the dialect of WebGL, and of the other dialects, which differ in their heads,
# one in forty. With "all", every class does in the dialect of WebGL, and one in ten of the others, which takes minutes.
# Usage: cross_compile.sh SHADER_TEXT [all]
for program in glslangValidator spirv-cross; do
    command -v $program > /dev/null && continue
    echo "SKIPPED: $program is not installed"
    exit 77
done
rm -rf cross_compiled && mkdir cross_compiled && "$1" cross_compiled || exit 1
cd cross_compiled || exit 1

# crosses FILE...: prints the names of those that a compiler refuses, and what it says. SPIR-V takes GLSL ES from 3.10 on, which
# has all that 3.00 has. HLSL has no size of points: ANGLE makes quads of them.
cat > crosses << 'SCRIPT'
for shader; do
    sed '1s/^#version 300 es/#version 310 es/' "$shader" > $$."${shader##*.}"
    {
        glslangValidator -G100 --auto-map-locations --auto-map-bindings -o $$.spv $$."${shader##*.}" &&
            { grep -q gl_PointSize "$shader" || spirv-cross --hlsl --shader-model 50 --output $$.hlsl $$.spv; } &&
            spirv-cross --msl --output $$.metal $$.spv
    } > $$.log 2>&1 || { echo "$shader"; cat $$.log; }
done
rm -f $$.*
SCRIPT
# Of files with the same content one will do.
find . -name '*.vert' -o -name '*.frag' | sort | xargs md5sum | sort -u -k1,1 | sed 's/^[^ ]* *//' | sort |
    awk -v every="$([ "${2-}" = all ] && echo 1 || echo 4)" 'NR % (/\/300es-[^s]/ ? every : 10 * every) == 0' > files
echo "$(wc -l < files) shaders"
xargs -n 100 -P "$(nproc)" sh crosses < files > refused
cat refused
[ ! -s refused ]
