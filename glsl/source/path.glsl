// Paths: chains of pieces that shine as one. The field is the sum of the pieces' fields, each by the distance to its nearest
// point, less a point's field at each joint, with the weight there: where the nearest point of one piece is a joint, its
// neighbour's is too, or is nearer, and the joint's point cancels one of the two.

// The integral over a segment, with the field of a path. It may be less than 0 by rounding, or between the arms of a sharp
// corner; the sum over the sources cuts that.
float ew_integrate(const ew_segment segment, const ew_path_block path, const vec2 chord, const float others)
{
    float sum = 0.0;
#ifdef EW_PART
    if (!ew_is_of_part(path)) return sum;
#endif
#ifdef EW_BENDS
    if (EW_HAS_BENDS(path)) sum = ew_integrate_bends(segment, path, chord, others);
#endif
#ifdef EW_POLYLINES
    if (!EW_HAS_BENDS(path) && !EW_IS_BEAM(path)) sum = ew_integrate_polyline(segment, path, chord);
#endif
#ifdef EW_BEAMS
    if (EW_IS_BEAM(path)) sum = ew_integrate_beam(segment, path, chord);
#endif
    return sum;
}
