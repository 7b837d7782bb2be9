// The integral over an interval of the ray inside which one smooth branch of an arc is nearest.

// Integral over s in [from, to] of what the passage leaves of weight / (max(epsilon, distance) (s + beta)^2): a smooth rest, by
// Gauss quadrature in v = 1 / (s + beta), to either side of the passage, or all at once where its peak is wide. A panel is
// shortened until its values lie on a parabola, up to `allowance`. Next to the passage the rest starts at 0, and a Gauss-Jacobi
// rule for x f(x) is exact for one power more.
float ew_integrate_rest(ew_arc arc, ew_passage passage, float from, float to, float allowance)
{
    float beta = ew_frame.decay.x;
    float sum = 0.0;
    bool is_inside = passage.is_touching && passage.s0 > from && passage.s0 < to;
    float v_from = 1.0 / (from + beta);
    float v_to = 1.0 / (to + beta);
    float v_center = 1.0 / (clamp(passage.s0, from, to) + beta);
    // The first panel is no longer than the peak is wide, or it would not see how the source's peak differs from the passage's.
    float peak = EW_FIRST_PANEL * sqrt(max(passage.b2, ew_square(ew_frame.decay.y)) / passage.k) * v_center * v_center;
    bool is_wide = peak >= 8.0 * (v_from - v_to);
    bool has_near_side = v_center < v_from;
    bool is_last_side = is_wide || !has_near_side || v_center == v_to;
    bool starts_at_zero = is_inside && !is_wide;
    float v = is_wide ? v_to : v_center;
    float remaining = (has_near_side || is_wide ? v_from : v_to) - v;
    float width = clamp(remaining, -peak, peak);
    for (int panel = 0; panel < EW_MAX_PANELS; ++panel) {
        if (passage.is_exact) break;
        vec4 nodes = starts_at_zero ? vec4(0.13975986, 0.41640957, 0.72315699, 0.94289580)
                                    : vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
        vec4 weights = starts_at_zero ? vec4(0.22310390, 0.31182653, 0.28135601, 0.14371356)
                                      : vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);
        // The third divided difference of rest, or of rest / x, over 32: how far a cubic would be from all parabolas.
        vec4 differences = starts_at_zero ? vec4(-1.7249797, 1.6796979, -1.0989184, 0.3567003)
                                          : vec4(-0.2318919, 0.5873578, -0.5873578, 0.2318919);
        vec4 s = 1.0 / (v + width * nodes) - beta;
        vec4 piece;
        vec4 rest = vec4(ew_reciprocal_difference(arc, passage, s.x, piece.x),
                         ew_reciprocal_difference(arc, passage, s.y, piece.y),
                         ew_reciprocal_difference(arc, passage, s.z, piece.z),
                         ew_reciprocal_difference(arc, passage, s.w, piece.w));
        float roughness = abs(dot(rest, differences)) + EW_SECOND_DIFFERENCE * abs(rest.x - rest.y - rest.z + rest.w);
        bool is_fine = roughness * abs(width) <= allowance;
#ifdef EW_WEIGHTS
        // Weights may wave inside of a panel, or jump; four values do not see that. But a panel may be too short to matter.
        vec4 size = abs(rest * width);
        is_fine = is_fine && (abs(piece.w - piece.x) <= 1.0 || max(max(size.x, size.y), max(size.z, size.w)) <= 0.1 * allowance);
#endif
        bool is_last_try = panel > EW_MAX_PANELS - 6;
        // Shorter panels than places have digits for would only add up noise.
        is_fine = is_fine || is_last_try || abs(width) < 1e-6 * v;
        bool is_side_done = is_fine && width == remaining;
        sum += is_fine ? abs(width) * dot(weights, rest) : 0.0;
        if (is_side_done && is_last_side) break;

        float left = remaining - width;
        float next = abs(left) < 1.5 * EW_PANEL_GROWTH * abs(width) || is_last_try ? left : EW_PANEL_GROWTH * width;
        float shorter = 0.4 * width;
#ifdef EW_WEIGHTS
        // Better a panel that ends where the next weight piece starts.
        float to_knot = 1.0 / (ew_next_knot(arc, piece.x, piece.w) + beta) - v;
        if (to_knot * width > 0.0 && abs(to_knot) < 0.95 * abs(width)) shorter = to_knot;
#endif
        v = is_side_done ? v_center : is_fine ? v + width : v;
        remaining = is_side_done ? v_to - v_center : is_fine ? left : remaining;
        width = is_side_done ? clamp(remaining, -peak, peak) : is_fine ? next : shorter;
        starts_at_zero = is_side_done ? is_inside : starts_at_zero && !is_fine;
        is_last_side = is_last_side || is_side_done;
    }
    return sum;
}
