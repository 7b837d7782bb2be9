// The published method for curves: the nearest point by Cardano's formula, once a sample (section 2.3 and appendix A).

// The steps 1 to 5 of section 2.3: the stationary points of the distance inside the domain, and both ends. (12) lacks P in its
// linear coefficient; it is 2 C2.(C0 - P) + |C1|^2.
float ew_nearest_on_curve(const ew_polynomial_curve curve, const vec3 position, out float nearest_tau)
{
    vec3 offset = curve.c0 - position;
    float cubic = 2.0 * ew_length_squared(curve.c2);
    float quadratic = 3.0 * dot(curve.c1, curve.c2);
    float linear = 2.0 * dot(curve.c2, offset) + ew_length_squared(curve.c1);
    float constant = dot(curve.c1, offset);
    vec3 roots;
    if (curve.has_vertex) {
        roots = ew_cubic_roots(0.0, linear / cubic, constant / cubic);
    } else {
        // Nearly straight: the cubic's leading coefficient means nothing in single precision, Newton's method does.
        float tau = -constant / linear;
        for (int i = 0; i < 2; ++i)
            tau -= (((cubic * tau + quadratic) * tau + linear) * tau + constant) /
                   ((3.0 * cubic * tau + 2.0 * quadratic) * tau + linear);
        roots = vec3(tau);
    }
    float candidates[5] = float[5](curve.first, curve.last, roots.x, roots.y, roots.z);
    float least = 1e38;
    for (int i = 0; i < 5; ++i) {
        float tau = clamp(candidates[i], curve.first, curve.last);
        float distance_squared = ew_length_squared(offset + tau * (curve.c1 + tau * curve.c2));
        if (distance_squared < least) {
            least = distance_squared;
            nearest_tau = tau;
        }
    }
    return least;
}

// The squared distance from `position`, and the weight at the nearest point: for integrators that sample the field.
float ew_distance_squared(const ew_curve_block block, const vec3 position, out float weight)
{
    ew_polynomial_curve curve = ew_make_polynomial_curve(block);
    float tau;
    float distance_squared = ew_nearest_on_curve(curve, position, tau);
    weight = 1.0;
#ifdef EW_WEIGHTS
    if (ew_piece_count(block) > 0.0) weight = ew_weight(tau - curve.first, ew_first_piece(block), ew_piece_count(block));
#endif
    return distance_squared;
}
