// An arc of a parabola and a ray: nearest points and closest approaches, equations (11) to (13).

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

ew_arc ew_make_arc(ew_segment segment, ew_curve_block curve)
{
    mat3 frame = mat3(curve.axis_x.xyz, curve.axis_y.xyz, curve.axis_z.xyz);
    ew_arc arc;
    arc.mean_weight = curve.origin.w;
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

// A step of Halley's method towards a zero of ((cubic tau + quadratic) tau + linear) tau - constant.
float ew_step_to_minimum(float cubic, float quadratic, float linear, float constant, float tau)
{
    float cubic3 = 3.0 * cubic;
    float value = ((cubic * tau + quadratic) * tau + linear) * tau - constant;
    float slope = (cubic3 * tau + 2.0 * quadratic) * tau + linear;
    float slope2 = slope * slope + 1e-37;
    // No more than two steps of Newton's method: where the quadratic term is not 0, the start may be anywhere.
    return tau - value * slope / max(slope2 - value * (cubic3 * tau + quadratic), 0.5 * slope2);
}

// The cube root of x > 0 within 4 %: a float's bits are nearly its logarithm.
float ew_rough_cube_root(float x)
{
    return intBitsToFloat(int(float(floatBitsToInt(x)) * (1.0 / 3.0)) + 709921077);
}

// A root tau of cubic tau^3 + quadratic tau^2 + linear tau = constant at which the left side grows, so that a distance has its
// minimum there: the only one for linear > 0, and for linear <= 0 the outermost on the side of `arm`, 1 or -1. cubic >= 0. For
// quadratic = 0 (a vertex at tau = 0) the start is within 11 %; each step of Halley's method cubes that.
float ew_distance_minimum(float cubic, float quadratic, float linear, float constant, float arm)
{
    float third = ew_rough_cube_root(max(cubic * constant * constant, 1e-37));
    float excess = max((arm * constant >= 0.0 ? third : -1.26 * third) - linear, 0.0);
    // constant / sqrt(linear^2 + third^2), or arm sqrt(excess / cubic): one reciprocal root for both, and no branch between nodes.
    bool is_only = linear > 0.0;
    float tau = (is_only ? constant : arm * excess) *
                inversesqrt(max(is_only ? linear * linear + third * third : excess * cubic, 1e-37));
    tau = ew_step_to_minimum(cubic, quadratic, linear, constant, tau);
    return ew_step_to_minimum(cubic, quadratic, linear, constant, tau);
}

// Both such roots: x is the one on the side of `constant`, y the other, or x again where there is none. For quadratic = 0, x is the
// nearest point of the whole parabola.
vec2 ew_distance_minima(float cubic, float quadratic, float linear, float constant)
{
    float side = constant < 0.0 ? -1.0 : 1.0;
    float tau = ew_distance_minimum(cubic, quadratic, linear, constant, side);
    float discriminant = -3.0 * cubic * tau * tau - 4.0 * linear;
    float other = discriminant > 0.0 ? -0.5 * (tau + side * sqrt(discriminant / max(cubic, 1e-30))) : tau;
    return vec2(tau, other);
}

// The squared distance from the arc at `tau`, clamped to its ends, to the place `position` in its frame.
float ew_arc_distance_squared(ew_arc arc, vec3 position, float tau)
{
    vec2 difference = position.xy - vec2(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau);
    return dot(difference, difference) + position.z * position.z;
}

// The nearest point on the arc's arm.
float ew_tau_on_arm(ew_arc arc, float s)
{
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    float arm = arc.arm != 0.0 ? arc.arm : equation.y < 0.0 ? -1.0 : 1.0;
    float tau = ew_distance_minimum(arc.cubic, arc.quadratic, equation.x, equation.y, arm);
    return clamp(tau, arc.first, arc.last);
}

float ew_arc_weight(ew_arc arc, float tau)
{
#ifdef EW_WEIGHTS
    if (arc.weights.y > 0.0) return ew_weight(tau - arc.first, arc.weights.x, arc.weights.y);
#endif
    return 1.0;
}

// Where start + s growth is 0; behind the ray if nowhere.
float ew_zero(float start, float growth)
{
    return growth != 0.0 ? -start / growth : -1.0;
}

// Where a ray passes the arc closely: the squared distance b2 + k (s - s0)^2 that agrees with the arc's there in value, slope and
// curvature, and the arc's weight.
struct ew_passage {
    bool is_touching; // it does agree; else it is just another part of the arc
    float b2;
    float k;
    float s0;
    float weight;
};

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
    // Two cores that end in different places would leave a rest between these two, which the quadrature may not see.
    float b2 = ew_length_squared(across);
    if (!is_touching) b2 = max(b2, ew_square(ew_frame.decay.y));
    return ew_passage(is_touching, b2, k, s0, ew_arc_weight(arc, tau));
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
