// What is mirrored of a curve.
float ew_gloss_of(const ew_surface surface, const ew_gloss gloss, const ew_curve_block curve)
{
    return ew_gloss_of_bend(surface, gloss, curve, vec2(0.0, 1.0), vec2(ew_first_piece(curve), ew_piece_count(curve)));
}
