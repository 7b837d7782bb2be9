// The weight along a curve, equations (14) to (16).

ew_weight_block ew_weight_piece(const int i)
{
    return ew_weight_block(ew_source_unit(EW_WEIGHT_START + i));
}

// S(t) of (15) at t = `place`, which is clamped to [0, 1], for a curve whose `count` > 0 pieces start at `first`. S is the
// clamped uniform quadratic B-spline with the knots of (16), its last interval closed. Each span between two knots is a
// polynomial that the CPU prepares.
float ew_weight(const float place, const float first, const float count)
{
    float scaled = clamp(place, 0.0, 1.0) * count;
    float piece = min(floor(scaled), count - 1.0);
    float f = scaled - piece;
    vec3 polynomial = ew_weight_piece(int(first + piece)).polynomial.xyz;
    return polynomial.x + f * (polynomial.y + f * polynomial.z);
}
