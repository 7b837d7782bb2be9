// The knots of the weights along a stretch. The nearest point moves along its arm one way, so the knots that it passes follow
// from the weight pieces at both ends of the stretch. Without weights there is one piece, 0, and no knot.

// In which of the arc's weight pieces the points nearest to L(s) are, at three places s.
vec3 ew_pieces_at(const ew_arc arc, const vec3 s)
{
    vec3 pieces = vec3(0.0);
#ifdef EW_WEIGHTS
    // A loop, because compilers put the search for the nearest point into the shader for every place that calls it.
    for (int i = 0; i < 3; ++i) {
        float tau = ew_tau_on_arm(arc, mix(mix(s.x, s.y, i == 1), s.z, i == 2));
        float piece = floor((arc.place + (tau - arc.first) * arc.place_slope) * arc.piece_count);
        pieces = mix(pieces, vec3(clamp(piece, 0.0, max(arc.piece_count - 1.0, 0.0))), bvec3(i == 0, i == 1, i == 2));
    }
#endif
    return pieces;
}

// Whether there is a knot between the pieces `piece` and `last_piece`.
bool ew_has_knot(const float piece, const float last_piece)
{
#ifdef EW_WEIGHTS
    return piece != last_piece;
#else
    return false;
#endif
}

// The s at which the nearest point, on its way from `piece` to `last_piece`, comes to the next knot: equation (12) is linear in
// s.
float ew_next_knot(const ew_arc arc, const float piece, const float last_piece)
{
#ifdef EW_WEIGHTS
    float place = (piece + mix(0.0, 1.0, last_piece > piece)) / max(arc.piece_count, 1.0);
    float tau = arc.first + (place - arc.place) / max(arc.place_slope, 1e-30);
    float left = ((arc.cubic * tau + arc.quadratic) * tau + arc.equation_start.x) * tau - arc.equation_start.y;
    return ew_zero(left, arc.equation_growth.x * tau - arc.equation_growth.y);
#else
    return -1.0;
#endif
}
