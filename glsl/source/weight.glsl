ew_weight_block ew_weight_piece(int i)
{
    return ew_weight_block(ew_source_data[EW_WEIGHT_START + i]);
}

// S(t) of (15) at `place` in [0, 1] along the curve whose pieces start at `first`: the clamped uniform quadratic B-spline with
// the knots of (16), the last interval closed. Each span between knots is a polynomial, prepared by the CPU.
float ew_weight(float place, float first, float count)
{
    float scaled = clamp(place, 0.0, 1.0) * count;
    float piece = min(floor(scaled), count - 1.0);
    float f = scaled - piece;
    vec3 polynomial = ew_weight_piece(int(first + piece)).polynomial.xyz;
    return polynomial.x + f * (polynomial.y + f * polynomial.z);
}
