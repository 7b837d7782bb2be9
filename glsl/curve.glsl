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
    bool has_arms;   // the parabola's two arms are apart at tau = 0; else its vertex is far away
    bool has_vertex; // which the arc has both of
    float arm;       // 1 or -1: the parabola's arm that is nearest, by the sign of tau; 0: the one on the ray's side of the vertex
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

float ew_integrate_rest(ew_arc arc, ew_passage passage, float from, float to, float allowance);

// The nearest point of the arc, seen from the ray at s.
float ew_nearest_tau(ew_arc arc, float s)
{
    vec3 position = arc.start + s * arc.direction;
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    vec2 taus = clamp(ew_distance_minima(arc.cubic, arc.quadratic, equation.x, equation.y), arc.first, arc.last);
    // Where the vertex is far away, so is one of the minima; an end may be nearer than the other.
    if (!arc.has_arms && taus.x == taus.y) taus.y = taus.x <= arc.first ? arc.last : arc.first;
    // In a plane of symmetry rounding errors would choose.
    float low = min(taus.x, taus.y);
    float high = max(taus.x, taus.y);
    return ew_arc_distance_squared(arc, position, low) < 0.999999 * ew_arc_distance_squared(arc, position, high) ? low : high;
}

// What of an arc is nearest: an end, the part on one of the parabola's arms, or the tip of an arc that is folded back on itself.
const int EW_FIRST_END = 0;
const int EW_NEGATIVE_ARM = 1;
const int EW_POSITIVE_ARM = 2;
const int EW_LAST_END = 3;
const int EW_FOLD = 4;

int ew_branch_of(ew_arc arc, float tau)
{
    if (tau <= arc.first) return EW_FIRST_END;
    if (tau >= arc.last) return EW_LAST_END;
    if (tau < 0.0) return EW_NEGATIVE_ARM;
    return tau > 0.0 || arc.slope_x > 0.0 ? EW_POSITIVE_ARM : EW_FOLD;
}

// Where in [from, to] the branch that is nearest just behind `from` ceases to be. Nothing but `from` is looked at where the branch
// `is_known` to last.
float ew_end_of_branch(ew_arc arc, float from, float to, bool is_known, out int branch)
{
    branch = EW_POSITIVE_ARM;
    float middle = 0.5 * (from + to);
    float nudge = 1e-3 * (to - from);
    float inside = from;
    float outside = to;
    for (int i = 0; i < 20; ++i) {
        // The first place is just inside, the second in the middle, the third at the end: there are few branches. Then bisection.
        bool is_at_end = i == 2 && inside == middle;
        float place = i == 0 ? from + nudge : is_at_end ? to - nudge : 0.5 * (inside + outside);
        int found = ew_branch_of(arc, ew_nearest_tau(arc, place));
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

bool ew_is_empty(vec2 part)
{
    return part.x >= part.y;
}

// By how much the left side of equation (12) exceeds the right at the first (x) and last end (y): excess_start + s excess_growth.
// Beyond the first end it is positive, beyond the last negative.
struct ew_end_excess {
    vec2 start;
    vec2 growth;
};

ew_end_excess ew_excess_at_ends(ew_arc arc)
{
    vec2 ends = vec2(arc.first, arc.last);
    ew_end_excess excess;
    excess.start = ((arc.cubic * ends + arc.quadratic) * ends + arc.equation_start.x) * ends - arc.equation_start.y;
    excess.growth = arc.equation_growth.x * ends - arc.equation_growth.y;
    // An arc that starts or ends where it folds back on itself stays on that end as long as the left side grows.
    bool is_folded = arc.has_arms && arc.slope_x == 0.0;
    if (is_folded && arc.first == 0.0) {
        excess.start.x = arc.equation_start.x;
        excess.growth.x = arc.equation_growth.x;
    }
    if (is_folded && arc.last == 0.0) {
        excess.start.y = -arc.equation_start.x;
        excess.growth.y = -arc.equation_growth.x;
    }
    return excess;
}

// The parts of the ray to which the ends of the arc are nearest, and the one between, to which what lies between them is.
struct ew_end_parts {
    bool are_settled; // else all of the ray is `between`, and the ends are to be found there
    vec2 first;
    vec2 last;
    vec2 between;
};

ew_end_parts ew_find_end_parts(ew_arc arc, ew_end_excess excess, float end)
{
    ew_end_parts parts;
    parts.first = ew_positive_part(excess.start.x, excess.growth.x, end);
    parts.last = ew_positive_part(-excess.start.y, -excess.growth.y, end);

    // Where the squared distance is not convex on all of the arc, as a function of tau, an end may compete with the other arm:
    // beyond an end for an arc that has both arms; on the other arm's side for an arc on one arm.
    float flattest = clamp(-arc.quadratic / max(3.0 * arc.cubic, 1e-30), arc.first, arc.last);
    float curvature = arc.equation_start.x + (3.0 * arc.cubic * flattest + 2.0 * arc.quadratic) * flattest;
    vec2 doubtful = ew_positive_part(-curvature, -arc.equation_growth.x, end);
    vec2 positive_side = ew_positive_part(arc.equation_start.y, arc.equation_growth.y, end);
    vec2 negative_side = ew_positive_part(-arc.equation_start.y, -arc.equation_growth.y, end);
    vec2 doubtful_first = doubtful;
    vec2 doubtful_last = doubtful;
    if (arc.has_vertex) {
        parts.first = ew_intersection(parts.first, negative_side);
        parts.last = ew_intersection(parts.last, positive_side);
        doubtful_first = ew_intersection(doubtful, parts.first);
        doubtful_last = ew_intersection(doubtful, parts.last);
    } else if (arc.has_arms) {
        doubtful_first = doubtful_last = ew_intersection(doubtful, arc.first >= 0.0 ? negative_side : positive_side);
    }

    // The points to which an end is nearest make a convex set: where it is nearest at both ends of a part, it is on all of it.
    parts.are_settled = !(arc.has_vertex && arc.slope_x == 0.0);
    bool is_first_doubtful = !ew_is_empty(doubtful_first);
    bool is_last_doubtful = !ew_is_empty(doubtful_last);
    int checks = is_first_doubtful && is_last_doubtful ? 4 : is_first_doubtful || is_last_doubtful ? 2 : 0;
    for (int i = 0; i < checks; ++i) {
        bool is_of_first = is_first_doubtful && i < 2;
        vec2 part = is_of_first ? doubtful_first : doubtful_last;
        int branch = ew_branch_of(arc, ew_nearest_tau(arc, i % 2 == 0 ? part.x : part.y));
        parts.are_settled = parts.are_settled && branch == (is_of_first ? EW_FIRST_END : EW_LAST_END);
    }

    // Both ends of a point are nearest.
    if (arc.cubic == 0.0 && arc.equation_start.x <= 0.0) parts.first = vec2(0.0, end);
    parts.between = vec2(0.0, end);
    if (!ew_is_empty(parts.first)) {
        if (parts.first.x <= 0.0) parts.between.x = parts.first.y;
        else if (parts.first.y >= end) parts.between.y = parts.first.x;
        else parts.are_settled = false;
    }
    if (!ew_is_empty(parts.last)) {
        if (parts.last.x <= 0.0) parts.between.x = max(parts.between.x, parts.last.y);
        else if (parts.last.y >= end) parts.between.y = min(parts.between.y, parts.last.x);
        else parts.are_settled = false;
    }
    if (!parts.are_settled) {
        parts.first = parts.last = vec2(0.0);
        parts.between = vec2(0.0, end);
    }
    return parts;
}

// The integral over a part of the ray to which the point of the arc at `tau`, an end, is nearest.
float ew_integrate_end(ew_arc arc, float tau, vec2 part)
{
    ew_passage passage = ew_passage_at(arc, tau, true, false);
    return passage.weight * ew_integrate_line_distance(passage.b2, passage.k, passage.s0, part.x, max(part.x, part.y));
}

// Where a ray passes the arc, or its extension: the two closest approaches, which may be one.
struct ew_approaches {
    vec2 tau;
    vec2 s;
};

ew_approaches ew_find_approaches(ew_arc arc)
{
    vec2 tau = ew_closest_approaches(arc);
    vec2 y = (arc.slope_y + arc.bend * tau) * tau;
    vec2 along = arc.slope_x * tau * arc.direction.x + y * arc.direction.y - dot(arc.start, arc.direction);
    return ew_approaches(tau, along / ew_length_squared(arc.direction));
}

// Where the ray is to be divided, so that the nearest point moves smoothly in between; behind the ray if nowhere.
struct ew_divisions {
    float split;
    vec2 planes;
    float bisector;
    vec2 neighbourhood;
};

ew_divisions ew_find_divisions(ew_arc arc, ew_end_excess excess, ew_approaches approaches, bool are_ends_settled)
{
    ew_divisions divisions = ew_divisions(-1.0, vec2(-1.0), -1.0, vec2(-1.0));
    // Where the nearest point jumps from one arm of the parabola to the other; or half way between two closest approaches.
    divisions.split = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    if (arc.equation_start.x + divisions.split * arc.equation_growth.x >= 0.0)
        divisions.split = approaches.tau.x == approaches.tau.y ? -1.0 : 0.5 * (approaches.s.x + approaches.s.y);
    // Around a sharp bend it slows down abruptly, where the bend's centre of curvature is passed.
    if (divisions.split < 0.0 && arc.slope_x < 0.1 * arc.bend)
        divisions.split = ew_zero(arc.equation_start.x, arc.equation_growth.x);
    if (are_ends_settled) return divisions;

    divisions.planes = vec2(ew_zero(excess.start.x, excess.growth.x), ew_zero(excess.start.y, excess.growth.y));
    // Where one end becomes nearer than the other, if the nearest point is at an end there.
    vec2 ends = vec2(arc.first, arc.last);
    vec2 ends_y = (arc.slope_y + arc.bend * ends) * ends;
    vec2 chord = vec2(arc.slope_x * (ends.y - ends.x), ends_y.y - ends_y.x);
    vec2 chord_middle = 0.5 * vec2(arc.slope_x * (ends.x + ends.y), ends_y.x + ends_y.y);
    divisions.bisector = ew_zero(dot(chord, arc.start.xy - chord_middle), dot(chord, arc.direction.xy));
    // All of this happens near the arc; the search for branches would miss it in a long ray.
    float extent = 4.0 * (arc.slope_x + abs(arc.slope_y) + 2.0 * arc.bend * max(-arc.first, arc.last));
    float nearest = dot(vec3(chord_middle, 0.0) - arc.start, arc.direction) / ew_length_squared(arc.direction);
    divisions.neighbourhood = nearest + vec2(-extent, extent);
    return divisions;
}

float ew_next_division(ew_divisions divisions, float from, float end)
{
    float margin = from + 1e-6;
    float to = end;
    if (divisions.split > margin) to = min(to, divisions.split);
    if (divisions.planes.x > margin) to = min(to, divisions.planes.x);
    if (divisions.planes.y > margin) to = min(to, divisions.planes.y);
    if (divisions.bisector > margin) to = min(to, divisions.bisector);
    if (divisions.neighbourhood.x > margin) to = min(to, divisions.neighbourhood.x);
    if (divisions.neighbourhood.y > margin) to = min(to, divisions.neighbourhood.y);
    return to;
}

// The passage for an interval around `middle` on which `arc.arm` is nearest: that by the nearer one of its closest approaches.
ew_passage ew_passage_of_arm(ew_arc arc, ew_approaches approaches, float middle)
{
    vec2 equation = arc.equation_start + middle * arc.equation_growth;
    float side = arc.arm != 0.0 ? arc.arm : equation.y;
    bool is_either_arm = !arc.has_arms || equation.x >= 0.0;
    vec2 remoteness = abs(approaches.s - middle);
    if (!is_either_arm && approaches.tau.x * side < 0.0) remoteness.x += 1e6;
    if (!is_either_arm && approaches.tau.y * side < 0.0) remoteness.y += 1e6;
    float tau = remoteness.y < remoteness.x ? approaches.tau.y : approaches.tau.x;
    bool is_far = abs(tau - 0.5 * (arc.first + arc.last)) > 1.0;
    return ew_passage_at(arc, is_far ? clamp(tau, arc.first, arc.last) : tau, false, is_far);
}

ew_arc ew_make_arc(ew_segment segment, ew_curve_block curve)
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
    arc.has_arms = arc.quadratic == 0.0;
    arc.has_vertex = arc.has_arms && arc.first < 0.0 && arc.last > 0.0;
    arc.arm = arc.has_arms && arc.last <= 0.0 ? -1.0 : 1.0;
#ifdef EW_WEIGHTS
    arc.weights = curve.domain.zw;
#endif
    return arc;
}

// The most intervals of a ray, the last of which takes all that is left.
const int EW_MAX_INTERVALS = 16;

float ew_integrate_curve(ew_segment segment, ew_curve_block curve)
{
    ew_arc arc = ew_make_arc(segment, curve);
    ew_end_excess excess = ew_excess_at_ends(arc);
    ew_end_parts parts = ew_find_end_parts(arc, excess, segment.end);
    float sum = ew_integrate_end(arc, arc.first, parts.first) + ew_integrate_end(arc, arc.last, parts.last);

    ew_approaches approaches = ew_find_approaches(arc);
    ew_divisions divisions = ew_find_divisions(arc, excess, approaches, parts.are_settled);
    float from = parts.between.x;
    float end = parts.between.y;
    for (int interval = 0; interval < EW_MAX_INTERVALS; ++interval) {
        if (from >= end) break;
        bool is_last = interval == EW_MAX_INTERVALS - 1;
        float to = is_last ? end : ew_next_division(divisions, from, end);
        int branch;
        to = ew_end_of_branch(arc, from, to, parts.are_settled || is_last, branch);
        if (arc.has_vertex) arc.arm = parts.are_settled ? 0.0 : branch == EW_NEGATIVE_ARM ? -1.0 : 1.0;

        ew_passage passage = ew_passage_of_arm(arc, approaches, 0.5 * (from + to));
        if (!parts.are_settled && branch != EW_NEGATIVE_ARM && branch != EW_POSITIVE_ARM) {
            float tau = branch == EW_FIRST_END ? arc.first : branch == EW_LAST_END ? arc.last : 0.0;
            passage = ew_passage_at(arc, tau, true, false);
        }
        float reciprocal = ew_integrate_line_distance(passage.b2, passage.k, passage.s0, from, to);
        float allowance = ew_frame.decay.z * (sum + max(passage.weight, 0.02 * arc.mean_weight) * reciprocal);
        sum += passage.weight * reciprocal;
        sum += ew_integrate_rest(arc, passage, from, to, allowance);
        from = to;
    }
    return sum;
}
