// The integral over an interval of the ray inside which one smooth branch of a shape is nearest. Assembled once for each EW_SHAPE;
// that is a structure for which ew_reciprocal_difference is defined, which also says in which weight piece the nearest point is.

// Integral over s in [from, to] of weight / (max(epsilon, distance) (s + beta)^2): the passage's closed form, which takes away
// the peak and all of the integral that matters, and the smooth rest by Gauss quadrature in v = 1 / (s + beta), to either side
// of the passage. A panel is halved until its three values lie on a line, up to `tolerance` times the integral. Next to the
// passage the rest starts at 0, and a Gauss-Jacobi rule for x f(x) is exact for two powers more.
// Where one point of the source is taken to be nearest all along, `probe` is a place at which that is least certain, and it is
// looked at there and at the interval's ends; else it is negative.
float ew_integrate_interval(EW_SHAPE shape, ew_passage passage, float from, float to, float probe, float so_far)
{
    float beta = ew_frame.decay.x;
    float tolerance = ew_frame.decay.z;
    float reciprocal = ew_integrate_line_distance(passage.b2, passage.k, passage.s0, from, to);
    float sum = passage.weight * reciprocal;
    float allowance = tolerance * (so_far + max(passage.weight, 0.02 * shape.mean_weight) * reciprocal);
    bool is_inside = passage.is_touching && passage.s0 > from && passage.s0 < to;
    float v_center = 1.0 / (clamp(passage.s0, from, to) + beta);
    float v_end = 1.0 / (from + beta);
    bool is_last_side = v_end == v_center;
    if (is_last_side) v_end = 1.0 / (to + beta);
    float v = v_center;
    // The first panel is no longer than the peak is wide, or it would not see how the source's peak differs from the passage's.
    float peak = EW_FIRST_PANEL * sqrt(max(passage.b2, ew_square(ew_frame.decay.y)) / passage.k) * v_center * v_center;
    if (probe >= 0.0) peak = 1e9;
    float v_next = v + clamp(v_end - v, -peak, peak);
    bool starts_at_zero = is_inside;
    bool is_probing = probe >= 0.0;
    for (int panel = 0; panel < EW_MAX_PANELS; ++panel) {
        float width = v_next - v;
        vec4 nodes = starts_at_zero ? vec4(0.13975986, 0.41640957, 0.72315699, 0.94289580)
                                    : vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
        vec4 weights = starts_at_zero ? vec4(0.22310390, 0.31182653, 0.28135601, 0.14371356)
                                      : vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);
        // The third divided difference of rest, or of rest / x, over 32: how far a cubic would be from all parabolas.
        vec4 differences = starts_at_zero ? vec4(-1.7249797, 1.6796979, -1.0989184, 0.3567003)
                                          : vec4(-0.2318919, 0.5873578, -0.5873578, 0.2318919);
        vec4 at = v + width * nodes;
        if (is_probing) at = vec4(v, v + 0.5 * width, clamp(1.0 / (probe + beta), min(v, v_next), max(v, v_next)), v_next);
        vec4 piece;
        vec4 rest = vec4(ew_reciprocal_difference(shape, passage, 1.0 / at.x - beta, piece.x),
                         ew_reciprocal_difference(shape, passage, 1.0 / at.y - beta, piece.y),
                         ew_reciprocal_difference(shape, passage, 1.0 / at.z - beta, piece.z),
                         ew_reciprocal_difference(shape, passage, 1.0 / at.w - beta, piece.w));
        bool is_last_try = panel > EW_MAX_PANELS - 6;
        vec4 size = abs(rest * width);
        float largest = max(max(size.x, size.y), max(size.z, size.w));
        float roughness = abs(dot(rest, differences)) + EW_SECOND_DIFFERENCE * abs(rest.x - rest.y - rest.z + rest.w);
        // Weights may wave inside of a panel, or jump; four values do not see that. But a panel may be too short to matter.
        bool is_in_one_piece = abs(piece.w - piece.x) <= 1.0 || largest <= 0.1 * allowance;
        bool is_fine = is_probing ? largest <= 0.005 * allowance : is_in_one_piece && roughness * abs(width) <= allowance;
        is_probing = false;
        if (is_fine || is_last_try) {
            sum += abs(width) * dot(weights, rest);
            starts_at_zero = false;
            v = v_next;
            v_next = abs(v_end - v) < 1.5 * EW_PANEL_GROWTH * abs(width) || is_last_try ? v_end : v + EW_PANEL_GROWTH * width;
            if (v == v_end) {
                if (is_last_side) break;
                is_last_side = true;
                starts_at_zero = is_inside;
                is_probing = probe >= 0.0;
                v = v_center;
                v_end = 1.0 / (to + beta);
                v_next = v + clamp(v_end - v, -peak, peak);
                if (v == v_end) break;
            }
        } else {
            v_next = v + 0.4 * width;
#ifdef EW_WEIGHTS
            // Better a panel that ends where the next weight piece starts.
            float v_knot = 1.0 / (ew_next_knot(shape, piece.x, piece.w) + beta);
            if ((v_knot - v) * width > 0.0 && abs(v_knot - v) < 0.95 * abs(width)) v_next = v_knot;
#endif
        }
    }
    return sum;
}
