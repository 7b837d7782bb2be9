// The uniform block: the frame and, one after the other, all points, lines, tori, curves and weight pieces.
//
// EW_..._COUNT is 0 for a kind that the shader does not know, a literal for few sources, so that loops unroll and the block is
// read at constant places (a software rasteriser gathers from each lane otherwise), and else the frame's own count.

layout(std140) uniform ew_uniforms
{
    ew_frame_block ew_frame;
    vec4 ew_source_data[EW_SOURCE_DATA_SIZE];
};

#define EW_LINE_START (EW_POINT_COUNT * EW_POINT_SIZE)
#define EW_TORUS_START (EW_LINE_START + EW_LINE_COUNT * EW_LINE_SIZE)
#define EW_CURVE_START (EW_TORUS_START + EW_TORUS_COUNT * EW_TORUS_SIZE)
#define EW_WEIGHT_START (EW_CURVE_START + EW_CURVE_COUNT * EW_CURVE_SIZE)

ew_point_block ew_point(int i)
{
    int at = i * EW_POINT_SIZE;
    return ew_point_block(ew_source_data[at], ew_source_data[at + 1]);
}

ew_line_block ew_line(int i)
{
    int at = EW_LINE_START + i * EW_LINE_SIZE;
    return ew_line_block(ew_source_data[at], ew_source_data[at + 1], ew_source_data[at + 2]);
}

ew_torus_block ew_torus(int i)
{
    int at = EW_TORUS_START + i * EW_TORUS_SIZE;
    return ew_torus_block(ew_source_data[at], ew_source_data[at + 1], ew_source_data[at + 2]);
}

ew_curve_block ew_curve(int i)
{
    int at = EW_CURVE_START + i * EW_CURVE_SIZE;
    return ew_curve_block(ew_source_data[at], ew_source_data[at + 1], ew_source_data[at + 2], ew_source_data[at + 3],
                          ew_source_data[at + 4], ew_source_data[at + 5]);
}

ew_weight_block ew_weight_piece(int i)
{
    return ew_weight_block(ew_source_data[EW_WEIGHT_START + i]);
}
