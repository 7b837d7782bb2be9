// Names for the numbers that share a vec4 of a source's block with something else; layout.glsl says where they are packed.

float ew_radius(ew_torus_block torus)
{
    return torus.axis.w;
}

float ew_slope_x(ew_curve_block curve)
{
    return curve.axis_x.w;
}

float ew_slope_y(ew_curve_block curve)
{
    return curve.axis_y.w;
}

float ew_bend(ew_curve_block curve)
{
    return curve.axis_z.w;
}

float ew_mean_weight(ew_curve_block curve)
{
    return curve.origin.w;
}

float ew_first_tau(ew_curve_block curve)
{
    return curve.domain.x;
}

float ew_last_tau(ew_curve_block curve)
{
    return curve.domain.y;
}

float ew_first_piece(ew_curve_block curve)
{
    return curve.domain.z;
}

// 0: the curve has no weights.
float ew_piece_count(ew_curve_block curve)
{
    return curve.domain.w;
}
