// The light of a curve.
float ew_irradiance_of(const ew_surface surface, const ew_curve_block curve)
{
    return ew_light_of_bend(surface, curve, vec2(0.0, 1.0), vec2(ew_first_piece(curve), ew_piece_count(curve)));
}
