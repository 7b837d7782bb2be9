// What the benchmark's peers sample: the integrand at L(s), for each kind of source. Distances are the published method's, from
// simpson.glsl, the nearest point of a curve among them.

#ifdef EW_POINTS
float peer_value(ew_segment segment, ew_point_block point, float s)
{
    return ew_sample(ew_length_squared(segment.origin + s * segment.direction - point.position.xyz), s);
}
#endif

#ifdef EW_LINES
float peer_value(ew_segment segment, ew_line_block line, float s)
{
    vec3 difference = segment.origin + s * segment.direction - line.position.xyz;
    difference -= dot(difference, line.direction.xyz) * line.direction.xyz;
    return ew_sample(ew_length_squared(difference), s);
}
#endif

#ifdef EW_TORI
float peer_value(ew_segment segment, ew_torus_block torus, float s)
{
    vec3 difference = segment.origin + s * segment.direction - torus.center.xyz;
    float height = dot(difference, torus.axis.xyz);
    float from_axis = length(difference - height * torus.axis.xyz);
    return ew_sample(ew_square(from_axis - torus.axis.w) + height * height, s);
}
#endif

#ifdef EW_CURVES
struct peer_curve {
    ew_polynomial_curve polynomial;
    vec2 pieces; // of the weights: the first one, how many
};

peer_curve peer_make_curve(ew_curve_block block)
{
    return peer_curve(ew_make_polynomial_curve(block), block.domain.zw);
}

float peer_value(ew_segment segment, peer_curve curve, float s)
{
    float tau;
    float value = ew_sample(ew_nearest_on_curve(curve.polynomial, segment.origin + s * segment.direction, tau), s);
#ifdef EW_WEIGHTS
    if (curve.pieces.y > 0.0) value *= ew_weight(tau - curve.polynomial.first, curve.pieces.x, curve.pieces.y);
#endif
    return value;
}
#endif
