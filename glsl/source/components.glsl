// Names for the numbers that share a vec4 of a source's block with something else; layout.glsl says where they are packed.

float ew_radius(const ew_torus_block torus)
{
    return torus.axis.w;
}

float ew_slope_x(const ew_curve_block curve)
{
    return curve.axis_x.w;
}

float ew_slope_y(const ew_curve_block curve)
{
    return curve.axis_y.w;
}

float ew_bend(const ew_curve_block curve)
{
    return curve.axis_z.w;
}

float ew_mean_weight(const ew_curve_block curve)
{
    return curve.origin.w;
}

float ew_first_tau(const ew_curve_block curve)
{
    return curve.domain.x;
}

float ew_last_tau(const ew_curve_block curve)
{
    return curve.domain.y;
}

float ew_first_piece(const ew_curve_block curve)
{
    return curve.domain.z;
}

// 0: the curve has no weights.
float ew_piece_count(const ew_curve_block curve)
{
    return curve.domain.w;
}

// Whether the pieces of a path are bent. A shader for a part of the sources is for paths of either kind and draws no others, and
// compilers leave out what a literal condition does.
#ifndef EW_PART
#define EW_HAS_BENDS(path) (path.pieces.z != 0.0)
#elif defined(EW_BENDS)
#define EW_HAS_BENDS(path) true
#else
#define EW_HAS_BENDS(path) false
#endif

#ifdef EW_PART
bool ew_is_of_part(const ew_path_block path)
{
    return EW_HAS_BENDS(path) == (path.pieces.z != 0.0);
}
#endif
