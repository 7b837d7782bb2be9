// The uniform blocks. Each array is as long as the context's uniform blocks allow.

layout(std140) uniform ew_frame_uniforms
{
    ew_frame_block ew_frame;
};

#ifdef EW_POINTS
layout(std140) uniform ew_point_uniforms
{
    ew_point_block ew_points[EW_POINT_CAPACITY];
};
#endif

#ifdef EW_LINES
layout(std140) uniform ew_line_uniforms
{
    ew_line_block ew_lines[EW_LINE_CAPACITY];
};
#endif

#ifdef EW_TORI
layout(std140) uniform ew_torus_uniforms
{
    ew_torus_block ew_tori[EW_TORUS_CAPACITY];
};
#endif

#ifdef EW_CURVES
layout(std140) uniform ew_curve_uniforms
{
    ew_curve_block ew_curves[EW_CURVE_CAPACITY];
};
#endif

#ifdef EW_WEIGHTS
layout(std140) uniform ew_weight_uniforms
{
    ew_weight_block ew_weight_pieces[EW_WEIGHT_CAPACITY];
};
#endif
