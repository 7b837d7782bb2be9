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

// The form of a path: a straight beam has no pieces but itself, a polyline has straight ones, and others have bent ones. Where the shader
// knows one form only, this is a literal, and compilers leave the rest out.
#if !defined(EW_BEAMS)
#define EW_IS_BEAM(path) false
#elif !defined(EW_PIECES)
#define EW_IS_BEAM(path) true
#else
#define EW_IS_BEAM(path) (path.pieces.y == 0.0)
#endif
#if !defined(EW_BENDS)
#define EW_HAS_BENDS(path) false
#elif !defined(EW_BEAMS) && !defined(EW_POLYLINES)
#define EW_HAS_BENDS(path) true
#else
#define EW_HAS_BENDS(path) (path.pieces.z != 0.0)
#endif

#ifdef EW_PART
// Whether the path has the only form that the shader draws. Lists have no others.
bool ew_is_of_part(const ew_path_block path)
{
#ifdef EW_LISTS
    return true;
#else
    return EW_IS_BEAM(path) == (path.pieces.y == 0.0) && EW_HAS_BENDS(path) == (path.pieces.z != 0.0);
#endif
}
#endif
