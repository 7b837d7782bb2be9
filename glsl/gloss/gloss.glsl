// What a glossy surface mirrors of the sources, as thin emitters: see emitter.glsl. In the place of max(0, n . l) there is Phong's lobe
// about the mirrored view R, normalised over directions and cut by the surface's horizon:
//
//     G = gain * sum over the sources of  color c integral of  w (p + 1) / (2 pi) max(0, R . l)^p k(|C - P|)  |dC|,    n . l > 0.
//
// Straight emitters: with t = h tan(theta) the way along the emitter, R . l = rho cos(theta - theta_0), and dt = d^2 / h dtheta. Six nodes
// of Gauss and Legendre over what the lobe sees of the emitter, 2.6 of its widths to either side.

struct ew_gloss {
    vec3 mirrored;
    float exponent;
};

// The lobe at the cosine of an angle from its axis.
float ew_lobe(const ew_gloss gloss, const float cosine)
{
    return (gloss.exponent + 1.0) * 0.159154943 * exp2(gloss.exponent * log2(max(cosine, 1e-6)));
}

// Of a straight piece, relative to the surface. `weights`: where its ends are in the list of weights, the first weight piece, and how
// many there are.
float ew_gloss_of_segment(const ew_surface surface, const ew_gloss gloss, const vec3 from, const vec3 to, const float core,
                          const vec4 weights)
{
    const float half_pi = 1.57079632679;
    vec3 way = to - from;
    float way_length = max(length(way), 1e-30);
    vec3 axis = way / way_length;
    float first = dot(from, axis);
    vec3 foot = from - first * axis;
    float a = dot(surface.normal, foot);
    float b = dot(surface.normal, axis);
    vec2 ends = vec2(first, first + way_length);
    vec2 t = ew_above_horizon(a, b, ends);
    float h = max(length(foot), 1e-3 * core);
    vec2 lean = vec2(dot(gloss.mirrored, foot) / h, dot(gloss.mirrored, axis));
    float turn = lean.x == 0.0 && lean.y == 0.0 ? 0.0 : atan(lean.y, lean.x);
    float width = min(2.6 * inversesqrt(0.5 * gloss.exponent), half_pi);
    vec2 theta = clamp(atan(t / h), turn - width, turn + width);
    if (max(a + b * ends.x, a + b * ends.y) <= 0.0 || theta.x >= theta.y) return 0.0;
    float half_angle = 0.5 * (theta.y - theta.x);
    float sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        float along = clamp(h * tan(theta.x + half_angle * (1.0 + EW_EMITTER_NODES[i])), t.x, t.y);
        float distance_squared = h * h + along * along;
        float light = ew_lobe(gloss, dot(gloss.mirrored, foot + along * axis) * inversesqrt(distance_squared)) *
                      ew_light_falloff(distance_squared, core) * distance_squared;
#ifdef EW_WEIGHTS
        float place = mix(weights.x, weights.y, clamp((along - first) / way_length, 0.0, 1.0));
        if (weights.w > 0.0) light *= ew_weight(place, weights.z, weights.w);
#endif
        sum += EW_EMITTER_WEIGHTS[i] * light;
    }
    return half_angle * sum / h;
}
