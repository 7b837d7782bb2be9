// The integral over a segment of weight / distance to the nearest point of an arc, equations (13) and (17).

// An arc and a ray in the frame of the arc's plane: C(tau) = (slope_x tau, slope_y tau + bend tau^2, 0), and
// L(s) = start + s direction. The nearest point's tau is a root of equation (12),
//
//     cubic tau^3 + quadratic tau^2 + equation.x tau = equation.y,   equation = equation_start + s equation_growth:
//
// (12) lacks P in its linear coefficient; it is 2 C2.(C0 - P) + |C1|^2.
struct ew_arc {
    float mean_weight;
    vec3 start;
    vec3 direction;
    float slope_x;
    float slope_y;
    float bend;
    float first;
    float last;
    float cubic;
    float quadratic;
    vec2 equation_start;
    vec2 equation_growth;
    float arm; // 1 or -1: the parabola's arm that is nearest, by the sign of tau; 0: the one on the ray's side of the vertex
#ifdef EW_WEIGHTS
    vec2 weights; // the first piece and their number
#endif
};

// The cube root of x > 0 within 4 %: a float's bits are nearly its logarithm.
float ew_rough_cube_root(float x)
{
    return intBitsToFloat(int(float(floatBitsToInt(x)) * (1.0 / 3.0)) + 709921077);
}

// A root tau of cubic tau^3 + quadratic tau^2 + linear tau = constant at which the left side grows, so that a distance has its
// minimum there: the only one for linear >= 0, and the largest for linear < 0. cubic >= 0. For quadratic = 0 (a vertex at
// tau = 0) the start is within 10 %; each step of Halley's method cubes that.
float ew_distance_minimum(float cubic, float quadratic, float linear, float constant)
{
    float third = ew_rough_cube_root(max(cubic * constant * constant, 1e-37));
    float tau = linear > 0.0 ? constant * inversesqrt(linear * linear + third * third)
                             : sqrt(max((constant >= 0.0 ? third : -1.26 * third) - linear, 0.0) / max(cubic, 1e-30));
    for (int i = 0; i < 2; ++i) {
        float value = ((cubic * tau + quadratic) * tau + linear) * tau - constant;
        float slope = (3.0 * cubic * tau + 2.0 * quadratic) * tau + linear;
        float curvature = 3.0 * cubic * tau + quadratic;
        // No more than two steps of Newton's method: where the quadratic term is not 0, the start may be anywhere.
        tau -= value * slope / max(slope * slope - value * curvature, 0.5 * slope * slope + 1e-37);
    }
    return tau;
}

// Both such roots: x is the one of the sign of `constant`, y the other, or x again where there is none. For quadratic = 0, x is the
// nearest point of the whole parabola.
vec2 ew_distance_minima(float cubic, float quadratic, float linear, float constant)
{
    float side = constant < 0.0 ? -1.0 : 1.0;
    float tau = ew_distance_minimum(cubic, side * quadratic, linear, abs(constant));
    float discriminant = -3.0 * cubic * tau * tau - 4.0 * linear;
    float other = discriminant > 0.0 ? -0.5 * (tau + sqrt(discriminant / max(cubic, 1e-30))) : tau;
    return side * vec2(tau, other);
}

// The squared distance from the arc at `tau`, clamped to its ends, to the place `position` in its frame.
float ew_arc_distance_squared(ew_arc arc, vec3 position, float tau)
{
    vec2 difference = position.xy - vec2(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau);
    return dot(difference, difference) + position.z * position.z;
}

float ew_arc_weight(ew_arc arc, float tau)
{
#ifdef EW_WEIGHTS
    if (arc.weights.y > 0.0) return ew_weight(tau - arc.first, arc.weights.x, arc.weights.y);
#endif
    return 1.0;
}

// The nearest point on one arm of the arc.
float ew_reciprocal_difference(ew_arc arc, ew_passage passage, float s, out float weight_piece)
{
    vec3 position = arc.start + s * arc.direction;
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    float arm = arc.arm != 0.0 ? arc.arm : equation.y < 0.0 ? -1.0 : 1.0;
    float tau = arm * ew_distance_minimum(arc.cubic, arm * arc.quadratic, equation.x, arm * equation.y);
    tau = clamp(tau, arc.first, arc.last);
    float weight = ew_arc_weight(arc, tau);
#ifdef EW_WEIGHTS
    weight_piece = tau * arc.weights.y;
#else
    weight_piece = 0.0;
#endif
    return ew_reciprocal_difference(passage, s, ew_arc_distance_squared(arc, position, tau), weight);
}

// Where start + s growth is 0; behind the ray if nowhere.
float ew_zero(float start, float growth)
{
    return growth != 0.0 ? -start / growth : -1.0;
}

#ifdef EW_WEIGHTS
// The s at which the nearest point, on its way from one weight piece to another, comes to the first knot: equation (12) is linear
// in s. (Pieces count from tau = 0.)
float ew_next_knot(ew_arc arc, float from_piece, float to_piece)
{
    float start = arc.first * arc.weights.y;
    float knot = to_piece > from_piece ? floor(from_piece - start) + 1.0 : ceil(from_piece - start) - 1.0;
    float tau = arc.first + knot / max(arc.weights.y, 1.0);
    float left = ((arc.cubic * tau + arc.quadratic) * tau + arc.equation_start.x) * tau - arc.equation_start.y;
    return ew_zero(left, arc.equation_growth.x * tau - arc.equation_growth.y);
}
#endif

// Where the ray passes the point of the arc, or of its extension, at `tau`. Where that `is_end`, the nearest point all along, or
// `is_far` from any closest approach, the passage is that by the one point.
ew_passage ew_passage_at(ew_arc arc, float tau, bool is_end, bool is_far)
{
    float slope_y = arc.slope_y + 2.0 * arc.bend * tau;
    vec3 difference = vec3(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau, 0.0) - arc.start;
    float v2 = ew_length_squared(arc.direction);
    float s0 = dot(difference, arc.direction) / v2;
    vec3 across = difference - s0 * arc.direction;
    float k = v2;
    if (!is_end && !is_far) {
        // The second derivative of d^2 / 2 along the ray, v2 - (slope . direction)^2 / curvature, without the difference.
        float bending = 2.0 * arc.bend * across.y;
        float slope2 = arc.slope_x * arc.slope_x + slope_y * slope_y;
        float sine2 = ew_square(arc.slope_x * arc.direction.y - slope_y * arc.direction.x) + slope2 * ew_square(arc.direction.z);
        k = clamp((sine2 + v2 * bending) / max(slope2 + bending, 1e-30), 1e-7 * v2, v2);
    }
    bool is_touching = is_end || (tau > arc.first && tau < arc.last);
    return ew_passage(is_end, is_touching, ew_length_squared(across), k, s0, ew_arc_weight(arc, tau));
}

// The minima over the whole arc of its distance from the ray: the same equation as for a point, in projection along the ray.
// All is scaled by v2, so that the products are cross products and nothing cancels.
vec2 ew_closest_approaches(ew_arc arc)
{
    vec3 moment = cross(arc.start, arc.direction);
    vec3 v = arc.direction;
    vec3 slope = vec3(arc.slope_y * v.z, -arc.slope_x * v.z, arc.slope_x * v.y - arc.slope_y * v.x);
    vec3 bend = arc.bend * vec3(v.z, 0.0, -v.x);
    float cubic = 2.0 * ew_length_squared(bend);
    float quadratic = 3.0 * dot(slope, bend);
    float linear = ew_length_squared(slope) - 2.0 * dot(bend, moment);
    float constant = dot(slope, moment);
    // Shifted to where the quadratic term vanishes, if that is near the arc.
    float middle = 0.5 * (arc.first + arc.last);
    float shift = clamp(-quadratic / max(3.0 * cubic, 1e-30), middle - 4.5, middle + 4.5);
    constant -= shift * (linear + shift * (quadratic + shift * cubic));
    linear += shift * (2.0 * quadratic + shift * 3.0 * cubic);
    quadratic += 3.0 * cubic * shift;
    return shift + ew_distance_minima(cubic, quadratic, linear, constant);
}

float ew_integrate_rest(ew_arc shape, ew_passage passage, float from, float to, float allowance);

// The nearest point of the arc, seen from the ray at s.
float ew_nearest_tau(ew_arc arc, float s)
{
    vec3 position = arc.start + s * arc.direction;
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    vec2 taus = clamp(ew_distance_minima(arc.cubic, arc.quadratic, equation.x, equation.y), arc.first, arc.last);
    // Where the vertex is far away, so is one of the minima; an end may be nearer than the other.
    if (arc.quadratic != 0.0 && taus.x == taus.y) taus.y = taus.x <= arc.first ? arc.last : arc.first;
    // In a plane of symmetry rounding errors would choose.
    float low = min(taus.x, taus.y);
    float high = max(taus.x, taus.y);
    return ew_arc_distance_squared(arc, position, low) < 0.999999 * ew_arc_distance_squared(arc, position, high) ? low : high;
}

// Where in [from, to] the branch that is nearest just behind `from` ceases to be: `branch` is 0 or 3 for the first or last end, 1
// or 2 for the parabola's arms of negative or positive tau, 4 for the tip of an arc that is folded back on itself. Nothing but
// `from` is looked at where the branch `is_known` to last.
float ew_end_of_branch(ew_arc arc, float from, float to, bool is_known, out int branch)
{
    branch = 2;
    float middle = 0.5 * (from + to);
    float nudge = 1e-3 * (to - from);
    float inside = from;
    float outside = to;
    for (int i = 0; i < 20; ++i) {
        // The first place is just inside, the second in the middle, the third at the end: there are few branches. Then bisection.
        bool is_at_end = i == 2 && inside == middle;
        float place = i == 0 ? from + nudge : is_at_end ? to - nudge : 0.5 * (inside + outside);
        float tau = ew_nearest_tau(arc, place);
        int found = tau <= arc.first ? 0 : tau >= arc.last ? 3 : tau < 0.0 ? 1 : tau > 0.0 || arc.slope_x > 0.0 ? 2 : 4;
        branch = i == 0 ? found : branch;
        bool is_same = found == branch;
        inside = is_same && i > 0 ? place : inside;
        outside = is_same ? outside : place;
        if (is_known || (is_at_end && is_same)) break;
    }
    return outside;
}

// The part of the ray's [0, end] on which start + s growth > 0; x >= y where there is none.
vec2 ew_positive_part(float start, float growth, float end)
{
    if (growth == 0.0) return vec2(0.0, start > 0.0 ? end : 0.0);
    float zero = clamp(-start / growth, 0.0, end);
    return growth > 0.0 ? vec2(zero, end) : vec2(0.0, zero);
}

vec2 ew_intersection(vec2 a, vec2 b)
{
    return vec2(max(a.x, b.x), min(a.y, b.y));
}

// More than there are: planes, splits and changes of branches.
const int EW_MAX_INTERVALS = 16;

float ew_integrate_curve(ew_segment segment, ew_curve_block curve)
{
    mat3 frame = mat3(curve.axis_x.xyz, curve.axis_y.xyz, curve.axis_z.xyz);
    ew_arc arc;
    arc.mean_weight = curve.color.w;
    arc.start = (segment.origin - curve.origin.xyz) * frame;
    arc.direction = segment.direction * frame;
    arc.slope_x = curve.axis_x.w;
    arc.slope_y = curve.axis_y.w;
    arc.bend = curve.axis_z.w;
    arc.first = curve.domain.x;
    arc.last = curve.domain.y;
    arc.cubic = 2.0 * arc.bend * arc.bend;
    arc.quadratic = 3.0 * arc.bend * arc.slope_y;
    arc.equation_start = vec2(arc.slope_x * arc.slope_x + arc.slope_y * arc.slope_y - 2.0 * arc.bend * arc.start.y,
                              arc.slope_x * arc.start.x + arc.slope_y * arc.start.y);
    arc.equation_growth = vec2(-2.0 * arc.bend * arc.direction.y, arc.slope_x * arc.direction.x + arc.slope_y * arc.direction.y);
#ifdef EW_WEIGHTS
    arc.weights = curve.domain.zw;
#endif

    vec2 closest = ew_closest_approaches(arc);
    vec2 closest_y = (arc.slope_y + arc.bend * closest) * closest;
    vec2 passings = (arc.slope_x * closest * arc.direction.x + closest_y * arc.direction.y - dot(arc.start, arc.direction)) /
                    ew_length_squared(arc.direction);

    // The equation's two sides at the ends of the arc, linear in s: beyond the first end the left is greater, beyond the last
    // the right. `flatness` is how much the squared distance curves, as a function of tau, where it does so least on the arc: where
    // that is positive there is one minimum only.
    vec2 ends = vec2(arc.first, arc.last);
    vec2 excess_start = ((arc.cubic * ends + arc.quadratic) * ends + arc.equation_start.x) * ends - arc.equation_start.y;
    vec2 excess_growth = arc.equation_growth.x * ends - arc.equation_growth.y;
    bool has_arms = arc.quadratic == 0.0;
    bool has_vertex = has_arms && arc.first < 0.0 && arc.last > 0.0;
    // An arc that starts or ends where it folds back on itself stays on that end as long as the left side grows.
    if (arc.slope_x == 0.0 && has_arms) {
        if (arc.first == 0.0) {
            excess_start.x = arc.equation_start.x;
            excess_growth.x = arc.equation_growth.x;
        }
        if (arc.last == 0.0) {
            excess_start.y = -arc.equation_start.x;
            excess_growth.y = -arc.equation_growth.x;
        }
    }
    float flattest = clamp(-arc.quadratic / max(3.0 * arc.cubic, 1e-30), arc.first, arc.last);
    float flatness_start = arc.equation_start.x + (3.0 * arc.cubic * flattest + 2.0 * arc.quadratic) * flattest;

    // The parts of the ray to which an end is nearest. An end may compete with the other arm, where there is more than one minimum:
    // beyond an end for an arc that has both arms; on the other arm's side for an arc on one arm.
    vec2 positive_side = ew_positive_part(arc.equation_start.y, arc.equation_growth.y, segment.end);
    vec2 negative_side = ew_positive_part(-arc.equation_start.y, -arc.equation_growth.y, segment.end);
    vec2 flat_part = ew_positive_part(-flatness_start, -arc.equation_growth.x, segment.end);
    vec2 first_cap = ew_positive_part(excess_start.x, excess_growth.x, segment.end);
    vec2 last_cap = ew_positive_part(-excess_start.y, -excess_growth.y, segment.end);
    vec2 doubtful_first = flat_part;
    vec2 doubtful_last = flat_part;
    if (has_vertex) {
        first_cap = ew_intersection(first_cap, negative_side);
        last_cap = ew_intersection(last_cap, positive_side);
        doubtful_first = ew_intersection(flat_part, first_cap);
        doubtful_last = ew_intersection(flat_part, last_cap);
    } else if (has_arms) {
        doubtful_first = doubtful_last = ew_intersection(flat_part, arc.first >= 0.0 ? negative_side : positive_side);
    }
    // The points to which an end is nearest make a convex set: where it is nearest at both ends of a part, it is on all of it.
    bool is_simple = !(has_vertex && arc.slope_x == 0.0);
    bool is_first_doubtful = doubtful_first.x < doubtful_first.y;
    bool is_last_doubtful = doubtful_last.x < doubtful_last.y;
    int checks = is_first_doubtful && is_last_doubtful ? 4 : is_first_doubtful || is_last_doubtful ? 2 : 0;
    for (int i = 0; i < checks; ++i) {
        bool is_of_first = is_first_doubtful && i < 2;
        vec2 doubtful = is_of_first ? doubtful_first : doubtful_last;
        float tau = ew_nearest_tau(arc, i % 2 == 0 ? doubtful.x : doubtful.y);
        is_simple = is_simple && (is_of_first ? tau <= arc.first : tau >= arc.last);
    }
    // Both ends of a point are nearest.
    if (arc.cubic == 0.0 && arc.equation_start.x <= 0.0) first_cap = vec2(0.0, segment.end);

    float from = 0.0;
    float end = segment.end;
    if (first_cap.x < first_cap.y) {
        if (first_cap.x <= 0.0) from = first_cap.y;
        else if (first_cap.y >= end) end = first_cap.x;
        else is_simple = false;
    }
    if (last_cap.x < last_cap.y) {
        if (last_cap.x <= 0.0) from = max(from, last_cap.y);
        else if (last_cap.y >= segment.end) end = min(end, last_cap.x);
        else is_simple = false;
    }
    ew_passage first = ew_passage_at(arc, arc.first, true, false);
    ew_passage last = ew_passage_at(arc, arc.last, true, false);
    if (!is_simple) {
        from = 0.0;
        end = segment.end;
        first_cap = last_cap = vec2(0.0);
    }
    float sum = first.weight * ew_integrate_line_distance(first.b2, first.k, first.s0, first_cap.x, max(first_cap.x, first_cap.y));
    sum += last.weight * ew_integrate_line_distance(last.b2, last.k, last.s0, last_cap.x, max(last_cap.x, last_cap.y));

    // Where the nearest point jumps from one arm of the parabola to the other; or half way between two closest approaches.
    float split = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    if (arc.equation_start.x + split * arc.equation_growth.x >= 0.0)
        split = closest.x == closest.y ? -1.0 : 0.5 * (passings.x + passings.y);
    // Around a sharp bend it slows down abruptly, where the bend's centre of curvature is passed.
    if (split < 0.0 && arc.slope_x < 0.1 * arc.bend) split = ew_zero(arc.equation_start.x, arc.equation_growth.x);
    // Where one end becomes nearer than the other, if the nearest point is at an end there.
    vec2 ends_y = (arc.slope_y + arc.bend * ends) * ends;
    vec2 chord = vec2(arc.slope_x * (ends.y - ends.x), ends_y.y - ends_y.x);
    vec2 chord_middle = 0.5 * vec2(arc.slope_x * (ends.x + ends.y), ends_y.x + ends_y.y);
    float bisector = ew_zero(dot(chord, arc.start.xy - chord_middle), dot(chord, arc.direction.xy));
    vec2 planes = vec2(ew_zero(excess_start.x, excess_growth.x), ew_zero(excess_start.y, excess_growth.y));
    // All that is not simple happens near the arc; the search for branches would miss it in a long ray.
    float extent = 4.0 * (arc.slope_x + abs(arc.slope_y) + 2.0 * arc.bend * max(-arc.first, arc.last));
    float nearest = dot(vec3(chord_middle, 0.0) - arc.start, arc.direction) / ew_length_squared(arc.direction);
    vec2 neighbourhood = nearest + vec2(-extent, extent);
    if (is_simple) {
        planes = vec2(-1.0);
        neighbourhood = vec2(-1.0);
        bisector = -1.0;
    }

    for (int interval = 0; interval < EW_MAX_INTERVALS; ++interval) {
        if (from >= end) break;
        float margin = from + 1e-6;
        float to = end;
        if (planes.x > margin) to = min(to, planes.x);
        if (planes.y > margin) to = min(to, planes.y);
        if (split > margin) to = min(to, split);
        if (bisector > margin) to = min(to, bisector);
        if (neighbourhood.x > margin) to = min(to, neighbourhood.x);
        if (neighbourhood.y > margin) to = min(to, neighbourhood.y);

        if (interval == EW_MAX_INTERVALS - 1) to = end;

        int branch;
        to = ew_end_of_branch(arc, from, to, is_simple || interval == EW_MAX_INTERVALS - 1, branch);
        float middle = 0.5 * (from + to);
        arc.arm = is_simple && has_vertex ? 0.0 : branch == 1 ? -1.0 : 1.0;
        if (!has_vertex) arc.arm = has_arms && arc.last <= 0.0 ? -1.0 : 1.0;
        bool is_end = !is_simple && branch != 1 && branch != 2;
        // Of the closest approaches, the nearer one of those on this arm.
        float side = arc.arm != 0.0 ? arc.arm : arc.equation_start.y + middle * arc.equation_growth.y;
        bool is_either_arm = !has_arms || arc.equation_start.x + middle * arc.equation_growth.x >= 0.0;
        vec2 remoteness = abs(passings - middle);
        if (!is_either_arm) remoteness += vec2(closest.x * side < 0.0 ? 1e6 : 0.0, closest.y * side < 0.0 ? 1e6 : 0.0);
        float tau = remoteness.y < remoteness.x ? closest.y : closest.x;
        if (is_end) tau = branch == 0 ? arc.first : branch == 3 ? arc.last : 0.0;
        bool is_far = abs(tau - 0.5 * (arc.first + arc.last)) > 1.0;
        ew_passage passage = ew_passage_at(arc, is_far ? clamp(tau, arc.first, arc.last) : tau, is_end, is_far);

        float reciprocal = ew_integrate_line_distance(passage.b2, passage.k, passage.s0, from, to);
        float allowance = ew_frame.decay.z * (sum + max(passage.weight, 0.02 * arc.mean_weight) * reciprocal);
        sum += passage.weight * reciprocal;
        sum += ew_integrate_rest(arc, passage, from, to, allowance);
        from = to;
    }
    return sum;
}
