// What a path's integrator and its samples share: its weights and the units of its pieces.

// The most pieces of a path, as in the public header.
const int EW_MAX_PATH_PIECES = 600;

// The weight at t along a path.
float ew_path_weight(const ew_path_block path, const float t)
{
    float weight = 1.0;
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) weight = ew_weight(t, path.weights.x, path.weights.y);
#endif
    return weight;
}

#ifdef EW_PIECES
// A vec4 of the ew_straight_block or ew_bent_block of the i-th piece.
vec4 ew_straight_unit(const ew_path_block path, const int i, const int unit)
{
    return ew_source_unit(int(path.pieces.x) + EW_STRAIGHT_UNITS * i + unit);
}

#ifdef EW_BENDS
vec4 ew_bent_unit(const ew_path_block path, const int i, const int unit)
{
    return ew_source_unit(int(path.pieces.x) + EW_BENT_UNITS * i + unit);
}

// The i-th piece of a path, as a curve. A loop, because some compilers put a dozen branches into the shader for every read.
ew_curve_block ew_bent_piece(const ew_path_block path, const int i)
{
    vec4 origin = vec4(0.0), axis_x = origin, axis_y = origin, axis_z = origin, domain = origin;
    for (int unit = 0; unit < 5; ++unit) {
        origin = axis_x;
        axis_x = axis_y;
        axis_y = axis_z;
        axis_z = domain;
        domain = ew_bent_unit(path, i, unit);
    }
    return ew_curve_block(vec4(origin.xyz, path.weights.z), axis_x, axis_y, axis_z, vec4(domain.xy, path.weights.xy),
                          path.color, path.glow);
}
#endif
#endif
