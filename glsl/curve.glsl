// The integral over a segment of weight / distance to the nearest point of an arc, equations (13) and (17).

// The arc against one ray L(s): everything the nearest-point equation needs, with coefficients linear in s.
struct ew_arc_on_ray {
    vec3 offset;    // origin of the arc - origin of the ray
    vec3 tangent;
    vec3 bend;
    vec3 direction; // of the ray
    float first;    // tau at the ends of the arc
    float last;
    float cubic;     // the equation is cubic tau^3 + quadratic tau^2 + (linear.x + linear.y s) tau = constant.x + constant.y s
    float quadratic; // 0 at a vertex
    vec2 linear;
    vec2 constant;
};

// The real roots tau of cubic tau^3 + quadratic tau^2 + linear tau = constant at which the left side grows, the minima of the
// distance: x is the one of the sign of `constant`, which for quadratic = 0 is the nearest point of the whole parabola, y the
// other, or x again where there is none. cubic >= 0. The start is within 7 % of the root for quadratic = 0; each step of
// Halley's method cubes that.
vec2 ew_nearest_roots(float cubic, float quadratic, float linear, float constant)
{
    float side = constant < 0.0 ? -1.0 : 1.0;
    float a = abs(constant);
    float b = side * quadratic;
    float third = pow(max(cubic * a * a, 1e-37), 1.0 / 3.0);
    float tau = linear > 0.0 ? a * inversesqrt(linear * linear + third * third)
                             : sqrt((third - linear) / max(cubic, 1e-30));
    for (int i = 0; i < 2; ++i) {
        float value = ((cubic * tau + b) * tau + linear) * tau - a;
        float slope = (3.0 * cubic * tau + 2.0 * b) * tau + linear;
        float curvature = 3.0 * cubic * tau + b;
        tau -= value * slope / max(slope * slope - value * curvature, 1e-37);
    }
    float discriminant = -3.0 * cubic * tau * tau - 4.0 * linear;
    float other = discriminant > 0.0 ? -0.5 * (tau + sqrt(discriminant / max(cubic, 1e-30))) : tau;
    return side * vec2(tau, other);
}

vec3 ew_curve_difference(ew_arc_on_ray arc, float s, float tau)
{
    return arc.offset - s * arc.direction + tau * (arc.tangent + tau * arc.bend);
}

// tau of the nearest point of the arc to L(s), and the squared distance: the better of the two minima clamped to the arc.
vec2 ew_nearest(ew_arc_on_ray arc, float s)
{
    vec2 roots = ew_nearest_roots(arc.cubic, arc.quadratic, arc.linear.x + s * arc.linear.y, arc.constant.x + s * arc.constant.y);
    roots = clamp(roots, arc.first, arc.last);
    float d2_x = ew_length_squared(ew_curve_difference(arc, s, roots.x));
    float d2_y = ew_length_squared(ew_curve_difference(arc, s, roots.y));
    ew_evaluation_count += 1;
    return d2_x <= d2_y ? vec2(roots.x, d2_x) : vec2(roots.y, d2_y);
}

// A distance d^2 = b2 + k (s - s0)^2 that osculates the arc's where the ray passes it at tau.
struct ew_passage {
    float tau;
    float b2;
    float k;
    float s0;
};

ew_passage ew_passage_at(ew_arc_on_ray arc, float tau)
{
    float v2 = ew_length_squared(arc.direction);
    vec3 difference = ew_curve_difference(arc, 0.0, tau);
    float s0 = dot(difference, arc.direction) / v2;
    vec3 across = difference - s0 * arc.direction;
    vec3 slope = arc.tangent + 2.0 * tau * arc.bend;
    float along = dot(slope, arc.direction);
    float k = v2;
    if (tau > arc.first && tau < arc.last) {
        float curvature = ew_length_squared(slope) + 2.0 * dot(across, arc.bend);
        k = max(v2 - along * along / max(curvature, 1e-30), 1e-6 * v2);
    }
    return ew_passage(tau, ew_length_squared(across), k, s0);
}

float ew_integrate_curve(ew_segment segment, ew_curve_block curve)
{
    ew_arc_on_ray arc;
    arc.offset = curve.origin.xyz - segment.origin;
    arc.tangent = curve.tangent.xyz;
    arc.bend = curve.bend.xyz;
    arc.direction = segment.direction;
    arc.first = curve.tangent.w;
    arc.last = curve.bend.w;
    arc.cubic = 2.0 * ew_length_squared(arc.bend);
    arc.quadratic = curve.weights.x;
    arc.linear = vec2(ew_length_squared(arc.tangent) + 2.0 * dot(arc.bend, arc.offset), -2.0 * dot(arc.bend, arc.direction));
    arc.constant = vec2(-dot(arc.tangent, arc.offset), dot(arc.tangent, arc.direction));

    // The closest approaches: the same equation in the plane across the ray.
    float v2 = ew_length_squared(arc.direction);
    vec3 across_offset = arc.offset - dot(arc.offset, arc.direction) / v2 * arc.direction;
    vec3 across_tangent = arc.tangent - dot(arc.tangent, arc.direction) / v2 * arc.direction;
    vec3 across_bend = arc.bend - dot(arc.bend, arc.direction) / v2 * arc.direction;
    float cubic = 2.0 * ew_length_squared(across_bend);
    float quadratic = 3.0 * dot(across_tangent, across_bend);
    float linear = ew_length_squared(across_tangent) + 2.0 * dot(across_bend, across_offset);
    float constant = dot(across_tangent, across_offset);
    float middle = 0.5 * (arc.first + arc.last);
    float shift = clamp(-quadratic / max(3.0 * cubic, 1e-30), middle - 4.5, middle + 4.5);
    vec2 taus = shift + ew_nearest_roots(cubic, quadratic + 3.0 * cubic * shift,
                                         linear + shift * (2.0 * quadratic + shift * 3.0 * cubic),
                                         -(constant + shift * (linear + shift * (quadratic + shift * cubic))));
    ew_passage passage_x = ew_passage_at(arc, clamp(taus.x, arc.first, arc.last));
    ew_passage passage_y = ew_passage_at(arc, clamp(taus.y, arc.first, arc.last));

    // Where the nearest point reaches an end of the arc.
    vec3 slope_first = arc.tangent + 2.0 * arc.first * arc.bend;
    vec3 slope_last = arc.tangent + 2.0 * arc.last * arc.bend;
    float plane_first = dot(ew_curve_difference(arc, 0.0, arc.first), slope_first) / dot(arc.direction, slope_first);
    float plane_last = dot(ew_curve_difference(arc, 0.0, arc.last), slope_last) / dot(arc.direction, slope_last);
    ew_passage ends[2];
    ends[0] = ew_passage_at(arc, arc.first);
    ends[1] = ew_passage_at(arc, arc.last);

    float epsilon = ew_frame.decay.z;
    float beta = ew_frame.decay.x;
    float sum = 0.0;
    float s = 0.0;
    for (int panel = 0; panel < 8; ++panel) {
        float next = segment.end;
        float margin = s + 1e-6;
        if (passage_x.s0 > margin) next = min(next, passage_x.s0);
        if (passage_y.s0 > margin) next = min(next, passage_y.s0);
        if (plane_first > margin) next = min(next, plane_first);
        if (plane_last > margin) next = min(next, plane_last);

        float tau = ew_nearest(arc, 0.5 * (s + next)).x;
        ew_passage passage = passage_x;
        if (abs(passage_y.tau - tau) < abs(passage_x.tau - tau)) passage = passage_y;
        if (tau <= arc.first) passage = ends[0];
        if (tau >= arc.last) passage = ends[1];

        sum += ew_integrate_line_distance(passage.b2, passage.k, passage.s0, s, next);
        // The rest is smooth: Gauss-Legendre in y, v = v_closest + (v_other - v_closest) y^2.
        float v_a = 1.0 / (s + beta);
        float v_b = 1.0 / (next + beta);
        bool forwards = abs(s - passage.s0) < abs(next - passage.s0);
        float v_0 = forwards ? v_a : v_b;
        float v_1 = forwards ? v_b : v_a;
        const vec4 nodes = vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816);
        const vec4 weights = vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742);
        float rest = 0.0;
        for (int i = 0; i < 4; ++i) {
            float v = v_0 + (v_1 - v_0) * nodes[i] * nodes[i];
            float at = 1.0 / v - beta;
            float d2 = ew_nearest(arc, at).y;
            float model = passage.b2 + passage.k * ew_square(at - passage.s0);
            rest += weights[i] * nodes[i] * (inversesqrt(max(d2, epsilon * epsilon)) - inversesqrt(max(model, epsilon * epsilon)));
        }
        sum += 2.0 * abs(v_1 - v_0) * rest;
        s = next;
        if (s >= segment.end) break;
    }
    return sum;
}
