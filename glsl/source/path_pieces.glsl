// What a path's integrator and its samples share: its weights and the units of its pieces.

// The most pieces of a path, as in the public header.
const int EW_MAX_PATH_PIECES = 600;

// The weight at t along a path.
float ew_path_weight(ew_path_block path, float t)
{
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) return ew_weight(t, path.weights.x, path.weights.y);
#endif
    return 1.0;
}

#ifdef EW_JOINTS
vec4 ew_piece_unit(ew_path_block path, float units, int i, int unit)
{
    return ew_source_unit(int(path.pieces.x) + i * int(units) + unit);
}
#endif
