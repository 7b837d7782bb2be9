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
#ifdef EW_WEIGHTS
    vec2 weights; // the first piece and their number
#endif
};

// The roots tau at which cubic tau^3 + quadratic tau^2 + linear tau - side constant grows, where a distance has its minima:
// x is the one of the sign of `side`, y the other, or x again where there is none. cubic, constant >= 0. For quadratic = 0 (a
// vertex at tau = 0), x is the nearest point of the whole parabola. The start is within 7 % of it then; each step of Halley's
// method cubes that.
vec2 ew_distance_minima(float cubic, float quadratic, float linear, float constant, float side)
{
    float b = side * quadratic;
    float third = exp2(log2(max(cubic * constant * constant, 1e-37)) / 3.0);
    float tau = linear > 0.0 ? constant * inversesqrt(linear * linear + third * third)
                             : sqrt((third - linear) / max(cubic, 1e-30));
    for (int i = 0; i < 2; ++i) {
        float value = ((cubic * tau + b) * tau + linear) * tau - constant;
        float slope = (3.0 * cubic * tau + 2.0 * b) * tau + linear;
        float curvature = 3.0 * cubic * tau + b;
        // No more than two steps of Newton's method: where the quadratic term is not 0, the start may be anywhere.
        tau -= value * slope / max(slope * slope - value * curvature, 0.5 * slope * slope + 1e-37);
    }
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

// At each s the nearest point is the better of the two minima, clamped to the arc.
float ew_reciprocal_difference(ew_arc arc, ew_passage passage, float s, out float weight_piece)
{
    vec3 position = arc.start + s * arc.direction;
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    float side = equation.y < 0.0 ? -1.0 : 1.0;
    vec2 taus = clamp(ew_distance_minima(arc.cubic, arc.quadratic, equation.x, abs(equation.y), side), arc.first, arc.last);
    float distance_x = ew_arc_distance_squared(arc, position, taus.x);
    float distance_y = ew_arc_distance_squared(arc, position, taus.y);
    float tau = distance_x <= distance_y ? taus.x : taus.y;
    float weight = ew_arc_weight(arc, tau);
#ifdef EW_WEIGHTS
    weight_piece = tau * arc.weights.y;
#else
    weight_piece = 0.0;
#endif
    return ew_reciprocal_difference(passage, s, min(distance_x, distance_y), weight);
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
    return ew_passage(is_end || (tau > arc.first && tau < arc.last), ew_length_squared(across), k, s0, ew_arc_weight(arc, tau));
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
    float side = constant < 0.0 ? -1.0 : 1.0;
    return shift + ew_distance_minima(cubic, quadratic, linear, abs(constant), side);
}

float ew_integrate_interval(ew_arc shape, ew_passage passage, float from, float to, float probe, float so_far);

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
    // the right. Between these planes and the one in which the nearest point jumps from one arm of the parabola to the other,
    // or half way between two closest approaches of one arm, the nearest point moves smoothly.
    vec2 ends = vec2(arc.first, arc.last);
    vec2 excess_start = ((arc.cubic * ends + arc.quadratic) * ends + arc.equation_start.x) * ends - arc.equation_start.y;
    vec2 excess_growth = arc.equation_growth.x * ends - arc.equation_growth.y;
    vec2 planes = vec2(ew_zero(excess_start.x, excess_growth.x), ew_zero(excess_start.y, excess_growth.y));
    float jump = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    if (arc.equation_start.x + jump * arc.equation_growth.x >= 0.0)
        jump = closest.x == closest.y ? -1.0 : 0.5 * (passings.x + passings.y);
    // Around a sharp bend it slows down abruptly, where the bend's centre of curvature is passed.
    if (jump < 0.0 && arc.slope_x < 0.1 * arc.bend) jump = ew_zero(arc.equation_start.x, arc.equation_growth.x);

    // Where one end becomes nearer than the other, if the nearest point is at an end there.
    vec2 ends_y = (arc.slope_y + arc.bend * ends) * ends;
    vec2 chord = vec2(arc.slope_x * (ends.y - ends.x), ends_y.y - ends_y.x);
    vec2 chord_middle = 0.5 * vec2(arc.slope_x * (ends.x + ends.y), ends_y.x + ends_y.y);
    float bisector = ew_zero(dot(chord, arc.start.xy - chord_middle), dot(chord, arc.direction.xy));
    vec2 bisector_excess = excess_start + bisector * excess_growth;
    if (bisector_excess.x <= 0.0 || bisector_excess.y >= 0.0) bisector = -1.0;

    float sum = 0.0;
    float from = 0.0;
    for (int interval = 0; interval < 5; ++interval) {
        float margin = from + 1e-6;
        float to = segment.end;
        if (planes.x > margin) to = min(to, planes.x);
        if (planes.y > margin) to = min(to, planes.y);
        if (jump > margin) to = min(to, jump);
        if (bisector > margin) to = min(to, bisector);

        float middle = 0.5 * (from + to);
        float side = arc.equation_start.y + middle * arc.equation_growth.y < 0.0 ? -1.0 : 1.0;
        vec2 excess = excess_start + middle * excess_growth;
        // An arc that starts or ends where it folds back on itself stays on its end as long as the equation's left side grows.
        float growth = arc.equation_start.x + middle * arc.equation_growth.x;
        if (excess.x == 0.0) excess.x = growth;
        if (excess.y == 0.0) excess.y = -growth;
        bool is_first = side > 0.0 ? excess.x > 0.0 && arc.first >= 0.0 && excess.y >= 0.0 : excess.x > 0.0 || arc.first > 0.0;
        bool is_last = side > 0.0 ? excess.y < 0.0 || arc.last < 0.0 : excess.y < 0.0 && arc.last <= 0.0 && excess.x <= 0.0;
        // Of the closest approaches, the nearer one of those on this arm.
        vec2 remoteness = abs(passings - middle) + vec2(closest.x * side < 0.0 ? 1e6 : 0.0, closest.y * side < 0.0 ? 1e6 : 0.0);
        float tau = is_first ? arc.first : is_last ? arc.last : remoteness.y < remoteness.x ? closest.y : closest.x;
        bool is_end = is_first || is_last;
        bool is_far = abs(tau - 0.5 * (arc.first + arc.last)) > 1.0;
        float probe = -1.0;
        if (is_end) probe = remoteness.x < remoteness.y ? passings.x : passings.y;
        if (is_end) probe = probe > from && probe < to ? probe : middle;
        sum += ew_integrate_interval(arc, ew_passage_at(arc, is_far ? clamp(tau, arc.first, arc.last) : tau, is_end, is_far), from, to, probe, sum);
        from = to;
        if (from >= segment.end) break;
    }
    return sum;
}
