// The integral of a reciprocal distance whose square is quadratic along the ray, in fog: what the closed form of quadrature.glsl is
// without. docs/method.md, section 16, has the derivation.

// The optical depth of a panel: over so little the transmittance is a polynomial within 1e-4 of its mean; with a weight, which takes
// two of the five degrees, over half of it.
#ifdef EW_WEIGHTS
const float EW_FOG_PANEL = 1.0;
#else
const float EW_FOG_PANEL = 2.0;
#endif
// More panels than any part takes.
const int EW_MAX_FOG_PANELS = 64;

// The longest panel from s on. With a decay, 1 / v must be a polynomial of v, too: see ew_map_fog_panel.
float ew_longest_fog_panel(const float s, const float along, const float optical_depth)
{
    float way = ew_longest_in_fog(s, along, optical_depth);
#ifndef EW_WORLD
    way = max(min(way, 0.5 * (s + ew_beta())), ew_way_through_thin_fog(s, along));
#endif
    return way;
}

// A panel that maps so that t is linear in s or, with a decay, in v = 1 / (s + beta): then the decay is gone, and s is not.
ew_panel ew_map_fog_panel(const float from, const float size)
{
#ifdef EW_WORLD
    return ew_panel(from, size, 0.0, 1.0, 0.5 * size, 1.0);
#else
    float depth = from + ew_beta();
    float m = size / (2.0 * depth + size);
    return ew_panel(from, size, m, 1.0 - m * m, 0.5 * size * (1.0 - m), depth);
#endif
}

// The integral over s in [from, from + size] of weight (1 / sqrt(b2 + k (s - s0)^2) - inverse_reach) transmittance, and with the decay.
// The weight is weight.x + weight.y y + weight.z y^2 with y = s - weight.w. Relative error 1e-4 of the mean transmittance at the
// longest panel, and 1e-6 where that changes by a third.
float ew_integrate_fog_panel(const float b2, const float k, const float s0, const float from, const float size, const vec4 weight,
                             const float inverse_reach)
{
    ew_panel panel = ew_map_fog_panel(from, size);
    // A zero that is far away may as well be that far away, where its square is a float.
    float far = 1e6 * size;
    ew_mapped_zero zero = ew_map_zero(vec2(from + clamp(s0 - from, -far, far), min(sqrt(b2 / k), far)), panel);
    ew_moments moments = ew_find_moments(zero);
    bool is_far = zero.square > 4.0;
    vec3 even = 0.5 * (EW_PANEL_LAGRANGE * moments.even);
    vec3 odd = (0.5 / EW_PANEL_NODES) * (EW_PANEL_LAGRANGE * moments.odd);

#ifdef EW_WORLD
    vec3 right = from + 0.5 * size * (1.0 + EW_PANEL_NODES);
    vec3 left = from + 0.5 * size * (1.0 - EW_PANEL_NODES);
    float measure = 0.5 * size;
    float peak = inversesqrt(k);
#else
    vec3 shrink_right = 1.0 - panel.m * EW_PANEL_NODES;
    vec3 shrink_left = 1.0 + panel.m * EW_PANEL_NODES;
    vec3 right = from + panel.scale * (1.0 + EW_PANEL_NODES) / shrink_right;
    vec3 left = from + panel.scale * (1.0 - EW_PANEL_NODES) / shrink_left;
    float measure = 0.5 * size / (panel.depth * (panel.depth + size));
    float peak = size * (1.0 - panel.m) / ((1.0 + panel.m) * panel.depth * panel.depth) * inversesqrt(zero.scale2 * k);
#endif
    float middle = from + 0.5 * size;
    vec2 fog = ew_fog_at(middle);
    vec3 smooth_right = ew_transmittance_in_panel(fog, right - middle);
    vec3 smooth_left = ew_transmittance_in_panel(fog, left - middle);
    vec3 y_right = right - s0;
    vec3 y_left = left - s0;
#ifdef EW_WEIGHTS
    smooth_right *= weight.x + (right - weight.w) * (weight.y + (right - weight.w) * weight.z);
    smooth_left *= weight.x + (left - weight.w) * (weight.y + (left - weight.w) * weight.z);
#endif
    // Where the peak is far away, the moments would cancel; but then it is smooth, too, and Gauss's weights serve.
    vec3 field_right = inversesqrt(max(b2 + k * y_right * y_right, 1e-37)) - inverse_reach;
    vec3 field_left = inversesqrt(max(b2 + k * y_left * y_left, 1e-37)) - inverse_reach;
    float by_gauss = measure * dot(EW_PANEL_WEIGHTS, smooth_right * field_right + smooth_left * field_left);
    float all = measure * dot(EW_PANEL_WEIGHTS, smooth_right + smooth_left);
#ifndef EW_WORLD
    smooth_right *= shrink_right;
    smooth_left *= shrink_left;
#endif
    float at_peak = peak * (dot(even, smooth_right + smooth_left) + dot(odd, smooth_right - smooth_left));
    return mix(at_peak - inverse_reach * all, by_gauss, is_far);
}

// The same over a part, with the core, in which 1 / r' takes the place of the reciprocal distance. Panels end at the core's edges.
float ew_integrate_in_fog(const float b2, const float k, const float s0, const vec2 part, vec2 core, const vec4 weight,
                          const vec4 glow)
{
    core = mix(part.yy, clamp(core, part.x, part.y), bvec2(core.x < core.y));
    float core_k = 1e-30;
    float core_s0 = s0;
#ifdef EW_CORE_PIXELS
    core_k = max(ew_core_growth2(), 1e-30);
    core_s0 = -ew_view_depth.x / ew_view_depth.y;
    float core_b2 = ew_core_radius2(glow);
#else
    float core_b2 = glow.x * glow.x;
#endif
    float sum = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        bool is_in_core = from >= core.x && from < core.y;
        float stop = mix(mix(part.y, core.y, is_in_core), core.x, from < core.x);
        float longest = ew_longest_fog_panel(from, 1.0, EW_FOG_PANEL);
        bool reaches_stop = longest >= stop - from;
        float size = mix(longest, stop - from, reaches_stop);
        float light = ew_integrate_fog_panel(mix(b2, core_b2, is_in_core), mix(k, core_k, is_in_core), mix(s0, core_s0, is_in_core),
                                             from, max(size, 1e-15), weight, ew_inverse_reach(glow));
        sum += mix(0.0, light, size > 0.0);
        from = mix(from + size, stop, reaches_stop);
    } while (from < part.y && ++panel < EW_MAX_FOG_PANELS);
    return sum;
}
