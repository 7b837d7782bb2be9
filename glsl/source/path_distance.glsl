// Samples of a path's field: the sum of its pieces' samples, less one of a point for each joint. See path.glsl.

// The nearest point of a straight piece.
float ew_sample_straight(const ew_path_block path, const vec4 start, const vec4 end, const vec3 position, const float s)
{
    vec3 way = end.xyz - start.xyz;
    float u = clamp(dot(position - start.xyz, way) / max(ew_length_squared(way), 1e-30), 0.0, 1.0);
    float weight = ew_path_weight(path, mix(start.w, end.w, u));
    return weight * ew_sample(ew_length_squared(position - start.xyz - u * way), s, path.glow);
}

#ifdef EW_BENDS
float ew_sample_bent(const ew_path_block path, const int i, const vec3 position, const float s, out vec4 start)
{
    vec4 domain = ew_bent_unit(path, i, 4);
    ew_polynomial_curve polynomial = ew_make_polynomial_curve(ew_bent_piece(path, i));
    float tau;
    float distance_squared = ew_nearest_on_curve(polynomial, position, tau);
    start = vec4(polynomial.c0 + polynomial.first * (polynomial.c1 + polynomial.first * polynomial.c2), domain.z);
    float weight = ew_path_weight(path, mix(domain.z, domain.w, tau - polynomial.first));
    return weight * ew_sample(distance_squared, s, path.glow);
}
#endif

float ew_sample_at(const ew_path_block path, const vec3 position, const float s)
{
    vec4 start = vec4(path.ball.xyz - path.beam.xyz, 0.0);
    float sum = 0.0;
    if (EW_IS_BEAM(path)) sum = ew_sample_straight(path, start, vec4(path.ball.xyz + path.beam.xyz, 1.0), position, s);
#ifdef EW_PIECES
    int count = int(path.pieces.y);
    for (int i = 0; i < count; ++i) {
        if (!EW_HAS_BENDS(path)) {
            start = ew_straight_unit(path, i, 0);
            sum += ew_sample_straight(path, start, ew_straight_unit(path, i, 1), position, s);
        }
#ifdef EW_BENDS
        else {
            sum += ew_sample_bent(path, i, position, s, start);
        }
#endif
        if (i > 0 || path.pieces.w > 0.0)
            sum -= ew_path_weight(path, start.w) * ew_sample(ew_length_squared(position - start.xyz), s, path.glow);
    }
#endif
    return sum;
}
