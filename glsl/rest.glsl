// The integral over an interval of the ray inside which one smooth branch of a shape is nearest. Assembled once for each EW_SHAPE;
// that is a structure for which ew_reciprocal_difference is defined, which also says in which weight piece the nearest point is.

// Integral over s in [from, to] of weight / (max(epsilon, distance) (s + beta)^2): the passage's closed form, which takes away
// the peak and all of the integral that matters, and the smooth rest by Gauss quadrature in v = 1 / (s + beta), to either side
// of the passage. A panel is halved until its three values lie on a line, up to `tolerance` times the integral. Next to the
// passage the rest starts at 0, and a Gauss-Jacobi rule for x f(x) is exact for two powers more.
float ew_integrate_interval(EW_SHAPE shape, ew_passage passage, float from, float to, float so_far)
{
    float beta = ew_frame.decay.x;
    float tolerance = ew_frame.decay.w;
    float reciprocal = ew_integrate_line_distance(passage.b2, passage.k, passage.s0, from, to);
    float sum = passage.weight * reciprocal;
    float allowance = tolerance * (so_far + max(passage.weight, shape.mean_weight) * reciprocal);
    bool is_inside = passage.is_touching && passage.s0 > from && passage.s0 < to;
    float v_center = 1.0 / (clamp(passage.s0, from, to) + beta);
    float v_end = 1.0 / (from + beta);
    bool is_last_side = v_end == v_center;
    if (is_last_side) v_end = 1.0 / (to + beta);
    float v = v_center;
    float v_next = v_end;
    bool starts_at_zero = is_inside;
    for (int panel = 0; panel < EW_MAX_PANELS; ++panel) {
        float width = v_next - v;
        vec3 nodes = starts_at_zero ? vec3(0.21234054, 0.59053314, 0.91141204) : vec3(0.11270167, 0.5, 0.88729833);
        vec3 weights = starts_at_zero ? vec3(0.32884432, 0.38819347, 0.22046221) : vec3(0.27777778, 0.44444444, 0.27777778);
        vec3 at = v + width * nodes;
        vec3 place;
        vec3 rest = vec3(ew_reciprocal_difference(shape, passage, 1.0 / at.x - beta, place.x),
                         ew_reciprocal_difference(shape, passage, 1.0 / at.y - beta, place.y),
                         ew_reciprocal_difference(shape, passage, 1.0 / at.z - beta, place.z));
        // The second difference of rest, or of rest / x.
        float bend = dot(rest, starts_at_zero ? vec3(4.3232, -3.3868, 1.1872) : vec3(1.0, -2.0, 1.0));
        bool is_last_try = panel > EW_MAX_PANELS - 6;
        // Weights may wave inside of a panel, or jump; three values do not see that. But a panel may be too short to matter.
        bool is_fine = abs(bend * width) <= allowance &&
                       (abs(place.z - place.x) <= 1.0 || max(max(abs(rest.x), abs(rest.y)), abs(rest.z)) * abs(width) <= allowance);
        if (is_fine || is_last_try) {
            sum += abs(width) * dot(weights, rest);
            starts_at_zero = false;
            v = v_next;
            v_next = abs(v_end - v) < 2.5 * abs(width) || is_last_try ? v_end : v + 2.0 * width;
            if (v == v_end) {
                if (is_last_side) break;
                is_last_side = true;
                starts_at_zero = is_inside;
                v = v_center;
                v_end = 1.0 / (to + beta);
                v_next = v_end;
                if (v == v_end) break;
            }
        } else {
            v_next = v + 0.4 * width;
        }
    }
    return sum;
}
