// The uniform block: the frame and, one after the other, all points, lines, tori, curves and weight pieces.
//
// EW_..._COUNT is 0 for a kind that the shader does not know, a literal for few sources, so that loops unroll and the block is
// read at constant places (a software rasteriser gathers from each lane otherwise), and else the frame's own count.

layout(std140) uniform ew_uniforms
{
    ew_frame_block ew_uniform_frame;
    vec4 ew_source_data[EW_SOURCE_DATA_SIZE];
};

// For a software rasteriser EW_SOFTWARE is defined. It checks the bounds of every component that a fragment reads from a block,
// which costs more than a closed form; so fragments get the frame as a flat varying, and the sources too where these are few:
// EW_SOURCE_VARYINGS is how many vec4 they take. To a GPU the block is constants, and each varying an instruction and a register:
// with them, a point took it 1.4 times as long.
#ifdef EW_VERTEX_STAGE
#define EW_VARYING flat out
#else
#define EW_VARYING flat in
#endif

#ifdef EW_SOFTWARE
EW_VARYING ew_frame_block ew_frame;
#else
#define ew_frame ew_uniform_frame
#endif

#ifdef EW_SOURCE_VARYINGS
EW_VARYING vec4 ew_sources[EW_SOURCE_VARYINGS];
#endif

#ifndef EW_VERTEX_STAGE
// beta of the decay, (21).
float ew_beta()
{
    return ew_frame.decay.x;
}

// The floor under all distances, which is the radius of the cores.
float ew_epsilon()
{
    return ew_frame.decay.y;
}

// How rough a panel of the adaptive integrator may be, relative to the integral.
float ew_tolerance()
{
    return ew_frame.decay.z;
}

#define EW_POINT_START 0
#define EW_LINE_START (EW_POINT_COUNT * EW_POINT_SIZE)
#define EW_TORUS_START (EW_LINE_START + EW_LINE_COUNT * EW_LINE_SIZE)
#define EW_CURVE_START (EW_TORUS_START + EW_TORUS_COUNT * EW_TORUS_SIZE)
#define EW_WEIGHT_START (EW_CURVE_START + EW_CURVE_COUNT * EW_CURVE_SIZE)

// A member of source i of `count`, of which the first has it at `start` and each takes `size` vec4. Where they are varyings, no
// index depends on i: the loops over sources are too long for compilers to unroll, and rasterisers that keep arrays in memory
// gather.
vec4 ew_source(int start, int size, int count, int i)
{
#ifdef EW_SOURCE_VARYINGS
    return count < 2 || i == 0   ? ew_sources[start]
           : count < 3 || i == 1 ? ew_sources[start + size]
           : count < 4 || i == 2 ? ew_sources[start + 2 * size]
                                 : ew_sources[start + 3 * size];
#else
    return ew_source_data[start + i * size];
#endif
}

ew_point_block ew_point(int i)
{
    return ew_point_block(ew_source(EW_POINT_START + 0, EW_POINT_SIZE, EW_POINT_COUNT, i),
                          ew_source(EW_POINT_START + 1, EW_POINT_SIZE, EW_POINT_COUNT, i));
}

ew_line_block ew_line(int i)
{
    return ew_line_block(ew_source(EW_LINE_START + 0, EW_LINE_SIZE, EW_LINE_COUNT, i),
                         ew_source(EW_LINE_START + 1, EW_LINE_SIZE, EW_LINE_COUNT, i),
                         ew_source(EW_LINE_START + 2, EW_LINE_SIZE, EW_LINE_COUNT, i));
}

ew_torus_block ew_torus(int i)
{
    return ew_torus_block(ew_source(EW_TORUS_START + 0, EW_TORUS_SIZE, EW_TORUS_COUNT, i),
                          ew_source(EW_TORUS_START + 1, EW_TORUS_SIZE, EW_TORUS_COUNT, i),
                          ew_source(EW_TORUS_START + 2, EW_TORUS_SIZE, EW_TORUS_COUNT, i));
}

ew_curve_block ew_curve(int i)
{
    return ew_curve_block(ew_source(EW_CURVE_START + 0, EW_CURVE_SIZE, EW_CURVE_COUNT, i),
                          ew_source(EW_CURVE_START + 1, EW_CURVE_SIZE, EW_CURVE_COUNT, i),
                          ew_source(EW_CURVE_START + 2, EW_CURVE_SIZE, EW_CURVE_COUNT, i),
                          ew_source(EW_CURVE_START + 3, EW_CURVE_SIZE, EW_CURVE_COUNT, i),
                          ew_source(EW_CURVE_START + 4, EW_CURVE_SIZE, EW_CURVE_COUNT, i),
                          ew_source(EW_CURVE_START + 5, EW_CURVE_SIZE, EW_CURVE_COUNT, i));
}

ew_weight_block ew_weight_piece(int i)
{
    return ew_weight_block(ew_source_data[EW_WEIGHT_START + i]);
}
#endif
