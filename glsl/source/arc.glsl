// An arc of a parabola, and its point that is nearest to a place: equations (11) to (13). docs/method.md, section 6, has the
// derivations.

// An arc and a ray in the frame of the arc's plane: C(tau) = (slope_x tau, slope_y tau + bend tau^2, 0) with tau in [first,
// last], and L(s) = start + s direction. The nearest point's tau is a root of equation (12),
//
//     cubic tau^3 + quadratic tau^2 + equation.x tau = equation.y,   equation = equation_start + s equation_growth.
//
// (12) as printed lacks P in its linear coefficient, which is 2 C2.(C0 - P) + |C1|^2.
struct ew_arc {
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
    bool has_arms;   // the parabola's vertex is at tau = 0, where its two arms meet; otherwise the vertex is far away
    bool has_vertex; // the vertex is inside the arc
    float arm;       // the arm that is nearest: 1 or -1, the sign of its tau; 0: the one on the ray's side of the vertex
    float mean_weight;
    float share; // of the arc's light that is left in a path, where its pieces and joints cancel
    vec4 glow;
    float center; // the ray's s at which `start` is
#ifdef EW_WEIGHTS
    float first_piece;
    float piece_count; // 0: no weights
    float place;       // of the arc's start along all that the weights are for, in [0, 1]
    float place_slope; // growth of the place with tau
#endif
};

ew_arc ew_make_arc(const ew_segment segment, const ew_curve_block curve)
{
    mat3 frame = mat3(curve.axis_x.xyz, curve.axis_y.xyz, curve.axis_z.xyz);
    ew_arc arc;
    arc.start = (segment.origin - curve.origin.xyz) * frame;
    arc.direction = segment.direction * frame;
    arc.slope_x = ew_slope_x(curve);
    arc.slope_y = ew_slope_y(curve);
    arc.bend = ew_bend(curve);
    arc.first = ew_first_tau(curve);
    arc.last = ew_last_tau(curve);
    arc.cubic = 2.0 * arc.bend * arc.bend;
    arc.quadratic = 3.0 * arc.bend * arc.slope_y;
    arc.equation_start = vec2(arc.slope_x * arc.slope_x + arc.slope_y * arc.slope_y - 2.0 * arc.bend * arc.start.y,
                              arc.slope_x * arc.start.x + arc.slope_y * arc.start.y);
    arc.equation_growth = vec2(-2.0 * arc.bend * arc.direction.y,
                               arc.slope_x * arc.direction.x + arc.slope_y * arc.direction.y);
    arc.has_arms = arc.quadratic == 0.0;
    arc.has_vertex = arc.has_arms && arc.first < 0.0 && arc.last > 0.0;
    arc.arm = arc.has_arms && arc.last <= 0.0 ? -1.0 : 1.0;
    arc.mean_weight = ew_mean_weight(curve);
    arc.share = 1.0;
    arc.glow = curve.glow;
    arc.center = 0.0;
#ifdef EW_WEIGHTS
    arc.first_piece = ew_first_piece(curve);
    arc.piece_count = ew_piece_count(curve);
    arc.place = 0.0;
    arc.place_slope = 1.0;
#endif
    return arc;
}

// A step of Halley's method towards a zero of ((cubic tau + quadratic) tau + linear) tau - constant, but no longer than two
// steps of Newton's method: unless `quadratic` is 0, the start may be anywhere.
float ew_step_to_minimum(const float cubic, const float quadratic, const float linear, const float constant, const float tau)
{
    float cubic3 = 3.0 * cubic;
    float value = ((cubic * tau + quadratic) * tau + linear) * tau - constant;
    float slope = (cubic3 * tau + 2.0 * quadratic) * tau + linear;
    float slope2 = slope * slope + 1e-37;
    return tau - value * slope / max(slope2 - value * (cubic3 * tau + quadratic), 0.5 * slope2);
}

// The cube root of x > 0 with a relative error of 4e-2. The bits of a float are nearly its logarithm.
float ew_rough_cube_root(const float x)
{
    return intBitsToFloat(int(float(floatBitsToInt(x)) * (1.0 / 3.0)) + 709921077);
}

// A root tau of cubic tau^3 + quadratic tau^2 + linear tau = constant, for cubic >= 0, at which the left side grows, so that a
// distance has its minimum there. For linear > 0 it is the only one; otherwise, the outermost on the side of `arm`, 1 or -1.
//
// For quadratic = 0 and the arm on the side of `constant`, the start is within 11 %, and each step cubes the error: 2e-10 after two,
// if it were not for rounding. On the other arm it lies beyond the root, from where the steps come down even where the root is about
// to vanish: 5e-6 after two, up to 0.99 of the constant at which it does, and 2 % there. docs/method.md, section 6.
float ew_distance_minimum(const float cubic, const float quadratic, const float linear, const float constant, const float arm)
{
    float third = ew_rough_cube_root(max(cubic * constant * constant, 1e-37));
    float excess = max(mix(-1.1 * third, third, arm * constant >= 0.0) - linear, 0.0);
    // The start is constant / sqrt(linear^2 + third^2), or arm sqrt(excess / cubic). Both share one reciprocal root, without a
    // branch.
    bool is_only = linear > 0.0;
    float start = mix(arm * excess, constant, is_only) *
                  inversesqrt(max(mix(excess * cubic, linear * linear + third * third, is_only), 1e-37));
    float tau = ew_step_to_minimum(cubic, quadratic, linear, constant, start);
    tau = ew_step_to_minimum(cubic, quadratic, linear, constant, tau);
    // Beyond where the root on the other arm vanishes, the slope may be 0, and a step lead anywhere.
    float limit = mix(1e30, 1.25 * abs(start), quadratic == 0.0);
    return clamp(tau, -limit, limit);
}

// Both such roots: x is the one on the side of `constant`; y is the other one, or x again if there is none. For quadratic = 0,
// x is the nearest point of the whole parabola.
vec2 ew_distance_minima(const float cubic, const float quadratic, const float linear, const float constant)
{
    float arm = mix(1.0, -1.0, constant < 0.0);
    float tau = ew_distance_minimum(cubic, quadratic, linear, constant, arm);
    float discriminant = -3.0 * cubic * tau * tau - 4.0 * linear;
    float other = -0.5 * (tau + arm * sqrt(max(discriminant, 0.0) / max(cubic, 1e-30)));
    return vec2(tau, mix(tau, other, discriminant > 0.0));
}

// The squared distance from the place `position` in the arc's frame to the parabola's point at `tau`.
float ew_arc_distance_squared(const ew_arc arc, const vec3 position, const float tau)
{
    vec2 difference = position.xy - vec2(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau);
    return dot(difference, difference) + position.z * position.z;
}

// tau of the point on arc.arm that is nearest to L(s), clamped to the arc.
float ew_tau_on_arm(const ew_arc arc, const float s)
{
    vec2 equation = arc.equation_start + s * arc.equation_growth;
    float arm = mix(mix(1.0, -1.0, equation.y < 0.0), arc.arm, arc.arm != 0.0);
    float tau = ew_distance_minimum(arc.cubic, arc.quadratic, equation.x, equation.y, arm);
    return clamp(tau, arc.first, arc.last);
}

bool ew_has_weights(const ew_arc arc)
{
#ifdef EW_WEIGHTS
    return arc.piece_count > 0.0;
#else
    return false;
#endif
}

// The weight at `tau`, equation (15); 1 without weights.
float ew_arc_weight(const ew_arc arc, const float tau)
{
    float weight = 1.0;
#ifdef EW_WEIGHTS
    float place = arc.place + (tau - arc.first) * arc.place_slope;
    if (arc.piece_count > 0.0) weight = ew_weight(place, arc.first_piece, arc.piece_count);
#endif
    return weight;
}

// The squared radius of the arc's core at s.
float ew_arc_core2(const ew_arc arc, const float s)
{
    return ew_core2(arc.glow, arc.center + s);
}
