// The integral over an interval of the ray inside which one smooth branch of an arc is nearest: what the closed form leaves.

// The most panels of an interval, refused ones included.
const int EW_MAX_PANELS = 400;
// The length of the first panel beside a peak, in half widths of the peak, and how much longer than one panel the next may be.
const float EW_FIRST_PANEL = 10.0;
const float EW_PANEL_GROWTH = 3.0;
// How much the second difference of a panel's values counts beside the third in the estimate of its error; next to a peak, where
// the rest is x f(x), how much f's.
const float EW_CURVATURE_PART = 0.16;
const float EW_CURVATURE_PART_AT_PEAK = 0.3;
// How much more it counts where the panel holds a kink,
const float EW_KINK = 6.0;
// and how much, for arcs with weights, the second difference of the nearest point's place.
const float EW_PLACE_PART = 0.35;

// 1 / max(epsilon, d) of the arc at s: x; of the passage: y; the nearest point: z.
vec3 ew_reciprocals(ew_arc arc, ew_passage passage, float epsilon2, float s)
{
    float tau = ew_tau_on_arm(arc, s);
    float model = passage.b2 + passage.k * ew_square(s - passage.s0);
    float distance_squared = ew_arc_distance_squared(arc, arc.start + s * arc.direction, tau);
    ew_evaluation_count += 1;
    return vec3(inversesqrt(max(distance_squared, epsilon2)), inversesqrt(max(model, epsilon2)), tau);
}

// The second difference of values at the nodes, up to a factor.
float ew_curvature(vec4 values)
{
    return abs(values.x - values.y - values.z + values.w);
}

#ifdef EW_WEIGHTS
// In which of the arc's weight pieces `tau` is.
float ew_piece_at(ew_arc arc, float tau)
{
    return clamp(floor((tau - arc.first) * arc.weights.y), 0.0, max(arc.weights.y - 1.0, 0.0));
}

// The s at which the nearest point, on its way from `piece` to `last_piece`, comes to the next knot: equation (12) is linear in s.
float ew_next_knot(ew_arc arc, float piece, float last_piece)
{
    float tau = arc.first + (piece + (last_piece > piece ? 1.0 : 0.0)) / max(arc.weights.y, 1.0);
    float left = ((arc.cubic * tau + arc.quadratic) * tau + arc.equation_start.x) * tau - arc.equation_start.y;
    return ew_zero(left, arc.equation_growth.x * tau - arc.equation_growth.y);
}
#endif

// What the passage leaves of weight / max(epsilon, distance), at four s; `piece` is the weight piece there, and `curvature` how far
// from straight lines all is that this consists of.
vec4 ew_rest_at(ew_arc arc, ew_passage passage, vec4 s, float piece, out float curvature)
{
    float epsilon2 = ew_square(ew_frame.decay.y);
    vec3 at_x = ew_reciprocals(arc, passage, epsilon2, s.x);
    vec3 at_y = ew_reciprocals(arc, passage, epsilon2, s.y);
    vec3 at_z = ew_reciprocals(arc, passage, epsilon2, s.z);
    vec3 at_w = ew_reciprocals(arc, passage, epsilon2, s.w);
    vec4 source = vec4(at_x.x, at_y.x, at_z.x, at_w.x);
    vec4 model = vec4(at_x.y, at_y.y, at_z.y, at_w.y);
    vec4 rest = source - model;
    curvature = ew_curvature(rest);
#ifdef EW_WEIGHTS
    if (arc.weights.y > 0.0) {
        vec3 polynomial = ew_weight_piece(int(arc.weights.x + piece)).polynomial.xyz;
        vec4 tau = vec4(at_x.z, at_y.z, at_z.z, at_w.z);
        vec4 place = clamp((tau - arc.first) * arc.weights.y - piece, 0.0, 1.0);
        vec4 weight = polynomial.x + place * (polynomial.y + place * polynomial.z);
        float slope = abs(polynomial.y) + abs(polynomial.z);
        curvature = curvature * max(max(weight.x, weight.y), max(weight.z, weight.w)) +
                    EW_PLACE_PART * slope * ew_curvature(place) * source.y;
        rest = weight * source - passage.weight * model;
    }
#endif
    // At the edge of the core there is a kink, which the second difference sees best.
    float core = 1.0 / ew_frame.decay.y;
    float nearest = max(max(source.x, source.y), max(source.z, source.w));
    float farthest = min(min(source.x, source.y), min(source.z, source.w));
    if (nearest > (1.0 - 1e-6) * core && farthest < (1.0 - 1e-6) * core) curvature *= EW_KINK;
    return rest;
}

// Integral over s in [from, to] of what the passage leaves of weight / (max(epsilon, distance) (s + beta)^2): a smooth rest, by
// Gauss quadrature in v = 1 / (s + beta), to either side of the passage, or all at once where its peak is wide. A panel is
// shortened until its values lie on a parabola, up to `allowance`. Next to the passage the rest starts at 0, and a Gauss-Jacobi
// rule for x f(x) is exact for one power more. Between two knots the weight is one polynomial, and no panel crosses a knot.
//
// Places are counted from the passage: x is v minus its v there, and the arc and the passage are seen from its s, `center`. From the
// eye, an arc that is small and far away would be a matter of the last digits.
float ew_integrate_rest(ew_arc arc, ew_passage passage, float from, float to, float allowance)
{
    float beta = ew_frame.decay.x;
    float epsilon2 = ew_square(ew_frame.decay.y);
    float center = clamp(passage.s0, from, to);
    arc.start += center * arc.direction;
    arc.equation_start += center * arc.equation_growth;
    bool is_inside = passage.is_touching && passage.s0 > from && passage.s0 < to;
    passage.s0 -= center;
    float depth = center + beta;
    float depth2 = depth * depth;
    float x_from = (center - from) / ((from + beta) * depth);
    float x_to = (center - to) / ((to + beta) * depth);
    // The first panel is no longer than the peak is wide, or it would not see how the arc's peak differs from the passage's; nor, as
    // a bent arc's passage is of no use there, much longer than the arc. In the core it ends at the core's edge.
    float scale = inversesqrt(passage.k) / depth2;
    float size = arc.slope_x + abs(arc.slope_y) + 2.0 * arc.bend * max(-arc.first, arc.last);
    float peak = min(EW_FIRST_PANEL * scale * sqrt(max(passage.b2, epsilon2)),
                     4.0 * sqrt((passage.b2 + size * size) / ew_length_squared(arc.direction)) / depth2);
    bool passes_core = passage.b2 < epsilon2;
    float half_core = scale * sqrt(max(epsilon2 - passage.b2, 0.04 * epsilon2));
    float first_panel = passes_core ? half_core : peak;
    bool is_wide = peak >= 8.0 * (x_from - x_to) && (!passes_core || half_core > x_from - x_to);
    bool has_near_side = x_from > 0.0;
    bool is_last_side = is_wide || !has_near_side || x_to == 0.0;
    bool starts_at_zero = is_inside && !is_wide;
    float x = is_wide ? x_to : 0.0;
    float remaining = (has_near_side || is_wide ? x_from : x_to) - x;
    float reach = clamp(remaining, -first_panel, first_panel);
    float piece = 0.0;
#ifdef EW_WEIGHTS
    // The nearest point moves along its arm one way.
    float from_piece = ew_piece_at(arc, ew_tau_on_arm(arc, from - center));
    float to_piece = ew_piece_at(arc, ew_tau_on_arm(arc, to - center));
    float center_piece = ew_piece_at(arc, ew_tau_on_arm(arc, 0.0));
    float last_piece = has_near_side || is_wide ? from_piece : to_piece;
    piece = is_wide ? to_piece : center_piece;
#endif
    float sum = 0.0;
    for (int panel = 0; panel < EW_MAX_PANELS; ++panel) {
        bool is_last_try = panel > EW_MAX_PANELS - 6;
        float width = reach;
#ifdef EW_WEIGHTS
        float knot = max(ew_next_knot(arc, piece, last_piece), -center);
        float to_knot = -knot / ((knot + depth) * depth) - x;
        to_knot = remaining >= 0.0 ? clamp(to_knot, 0.0, remaining) : clamp(to_knot, remaining, 0.0);
        bool is_at_knot = piece != last_piece && abs(to_knot) <= abs(reach) && !is_last_try;
        width = is_at_knot ? to_knot : reach;
#endif
        vec4 nodes = vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
        vec4 weights = vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);
        // The third divided difference of rest, or of rest / x, over 32: how far a cubic would be from all parabolas.
        vec4 differences = vec4(-0.2318919, 0.5873578, -0.5873578, 0.2318919);
        float part = EW_CURVATURE_PART;
        if (starts_at_zero) {
            nodes = vec4(0.13975986, 0.41640957, 0.72315699, 0.94289580);
            weights = vec4(0.22310390, 0.31182653, 0.28135601, 0.14371356);
            differences = vec4(-1.7249797, 1.6796979, -1.0989184, 0.3567003);
            part = EW_CURVATURE_PART_AT_PEAK;
        }
        vec4 x_at_nodes = x + width * nodes;
        float curvature;
        vec4 rest = ew_rest_at(arc, passage, -depth2 * x_at_nodes / (1.0 + depth * x_at_nodes), piece, curvature);
        float error = (abs(dot(rest, differences)) + part * curvature) * abs(width);
        // Shorter panels than places have digits for would only add up noise.
        bool is_fine = error <= allowance || is_last_try || abs(width) * depth2 < 1e-6 * center;
        bool is_side_done = is_fine && width == remaining;
        sum += is_fine ? abs(width) * dot(weights, rest) : 0.0;
        if (is_side_done && is_last_side) break;

        float left = remaining - width;
        float next = EW_PANEL_GROWTH * width;
        if (starts_at_zero) next = width >= 0.0 ? max(next, peak) : min(next, -peak);
#ifdef EW_WEIGHTS
        if (is_at_knot) next = reach;
        if (is_at_knot && is_fine) piece += last_piece > piece ? 1.0 : -1.0;
#endif
        if (abs(left) < 1.5 * abs(next) || is_last_try) next = left;
        x = is_fine ? x + width : x;
        remaining = is_fine ? left : remaining;
        reach = is_fine ? next : 0.4 * width;
        starts_at_zero = starts_at_zero && !is_fine;
        if (is_side_done) {
            is_last_side = true;
            x = 0.0;
            remaining = x_to;
            reach = max(remaining, -first_panel);
            starts_at_zero = is_inside;
#ifdef EW_WEIGHTS
            piece = center_piece;
            last_piece = to_piece;
#endif
        }
    }
    return sum;
}
