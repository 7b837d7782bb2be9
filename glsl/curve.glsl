// The integral over a segment of weight / distance to the nearest point of an arc, equations (13) and (17).

// An arc and a ray in the frame of the arc's plane: C(tau) = (a tau, g tau + b tau^2, 0), L(s) = start + s direction.
// The nearest point's tau is a root of equation (12), here
//
//     cubic tau^3 + quadratic tau^2 + linear(s) tau = constant(s),   linear = a^2 + g^2 - 2 b y(s),   constant = a x(s) + g y(s).
struct ew_arc {
    vec3 start;
    vec3 direction;
    float v2; // |direction|^2
    float a;
    float g;
    float b;
    float first;
    float last;
    float cubic;
    float quadratic;
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
        tau -= value * slope / max(slope * slope - value * curvature, 1e-37);
    }
    float discriminant = -3.0 * cubic * tau * tau - 4.0 * linear;
    float other = discriminant > 0.0 ? -0.5 * (tau + sqrt(discriminant / max(cubic, 1e-30))) : tau;
    return side * vec2(tau, other);
}

// Where the ray passes the point of the arc at tau: a distance d^2 = b2 + k (s - s0)^2 that osculates the arc's there, or is that
// from the arc's end.
struct ew_passage {
    float tau;
    float b2;
    float k;
    float s0;
};

ew_passage ew_passage_at(ew_arc arc, float tau)
{
    float slope_y = arc.g + 2.0 * arc.b * tau;
    vec3 difference = vec3(arc.a * tau, (arc.g + arc.b * tau) * tau, 0.0) - arc.start;
    float s0 = dot(difference, arc.direction) / arc.v2;
    vec3 across = difference - s0 * arc.direction;
    float k = arc.v2;
    if (tau > arc.first && tau < arc.last) {
        // The second derivative of d^2 / 2 along the ray: v2 minus (slope . direction)^2 / curvature, without the difference.
        float bending = 2.0 * arc.b * across.y;
        float slope2 = arc.a * arc.a + slope_y * slope_y;
        float curvature = slope2 + bending;
        float sine = ew_square(arc.a * arc.direction.y - slope_y * arc.direction.x) + slope2 * ew_square(arc.direction.z);
        k = clamp((sine + arc.v2 * bending) / max(curvature, 1e-30), 1e-7 * k, k);
    }
    return ew_passage(tau, ew_length_squared(across), k, s0);
}

// The minima over the whole arc of its distance from the ray: the same equation as for a point, in projection along the ray.
// All is scaled by v2, so that the products are cross products and nothing cancels.
vec2 ew_closest_approaches(ew_arc arc)
{
    vec3 moment = cross(arc.start, arc.direction);
    vec3 v = arc.direction;
    vec3 slope = vec3(arc.g * v.z, -arc.a * v.z, arc.a * v.y - arc.g * v.x);
    vec3 bend = arc.b * vec3(v.z, 0.0, -v.x);
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
    return clamp(shift + ew_distance_minima(cubic, quadratic, linear, abs(constant), side), arc.first, arc.last);
}

// One node of the smooth rest: 1 / d - 1 / d of the model, at v. On entry `tau` is near the nearest point's, on return it is it,
// and `slope` is d tau / d s there.
float ew_rest(ew_arc arc, ew_passage passage, bool is_end, float epsilon2, float v, inout float s, inout float tau, inout float slope)
{
    float at = 1.0 / v - ew_frame.decay.x;
    tau += clamp(slope * (at - s), -0.3, 0.3);
    s = at;
    vec3 position = arc.start + at * arc.direction;
    float linear = arc.a * arc.a + arc.g * arc.g - 2.0 * arc.b * position.y;
    float constant = arc.a * position.x + arc.g * position.y;
    float value = ((arc.cubic * tau + arc.quadratic) * tau + linear) * tau - constant;
    float growth = (3.0 * arc.cubic * tau + 2.0 * arc.quadratic) * tau + linear;
    float curvature = 3.0 * arc.cubic * tau + arc.quadratic;
    float inverse = 1.0 / max(growth * growth - value * curvature, 1e-37);
    tau = clamp(tau - value * growth * inverse, arc.first, arc.last);
    slope = (arc.a * arc.direction.x + arc.g * arc.direction.y + 2.0 * arc.b * arc.direction.y * tau) * growth * inverse;
    vec2 difference = position.xy - vec2(arc.a * tau, (arc.g + arc.b * tau) * tau);
    float d2 = dot(difference, difference) + position.z * position.z;
    float model = passage.b2 + passage.k * ew_square(at - passage.s0);
    if (is_end) d2 = min(d2, model);
    ew_evaluation_count += 1;
    return inversesqrt(max(d2, epsilon2)) - inversesqrt(max(model, epsilon2));
}

float ew_integrate_curve(ew_segment segment, ew_curve_block curve)
{
    ew_arc arc;
    mat3 frame = mat3(curve.axis_x.xyz, curve.axis_y.xyz, curve.axis_z.xyz);
    arc.start = (segment.origin - curve.origin.xyz) * frame;
    arc.direction = segment.direction * frame;
    arc.v2 = ew_length_squared(segment.direction);
    arc.a = curve.axis_x.w;
    arc.g = curve.axis_y.w;
    arc.b = curve.axis_z.w;
    arc.first = curve.domain.x;
    arc.last = curve.domain.y;
    arc.cubic = 2.0 * arc.b * arc.b;
    arc.quadratic = 3.0 * arc.b * arc.g;

    float linear_0 = arc.a * arc.a + arc.g * arc.g - 2.0 * arc.b * arc.start.y;
    float linear_1 = -2.0 * arc.b * arc.direction.y;
    float constant_0 = arc.a * arc.start.x + arc.g * arc.start.y;
    float constant_1 = arc.a * arc.direction.x + arc.g * arc.direction.y;

    vec2 closest = ew_closest_approaches(arc);
    vec2 passings = (arc.a * closest * arc.direction.x + (arc.g + arc.b * closest) * closest * arc.direction.y - dot(arc.start, arc.direction)) / arc.v2;

    // The equation's value at the ends, linear in s: negative at the first and positive at the last inside of the arc.
    float f_first_0 = ((arc.cubic * arc.first + arc.quadratic) * arc.first + linear_0) * arc.first - constant_0;
    float f_first_1 = linear_1 * arc.first - constant_1;
    float f_last_0 = ((arc.cubic * arc.last + arc.quadratic) * arc.last + linear_0) * arc.last - constant_0;
    float f_last_1 = linear_1 * arc.last - constant_1;
    float plane_first = -f_first_0 / f_first_1;
    float plane_last = -f_last_0 / f_last_1;
    // Where the nearest point jumps across the vertex, or half way between two closest approaches.
    float jump = -constant_0 / constant_1;
    if (!(linear_0 + jump * linear_1 < 0.0)) jump = closest.x != closest.y ? 0.5 * (passings.x + passings.y) : -1.0;

    float epsilon2 = ew_square(ew_frame.decay.z);
    float beta = ew_frame.decay.x;
    float tolerance = (ew_frame.decay.w <= 2e-4 ? 0.01 : ew_frame.decay.w <= 2e-3 ? 0.03 : 0.1);
    float sum = 0.0;
    float s = 0.0;
    for (int interval = 0; interval < 5; ++interval) {
        float next = segment.end;
        float margin = s + 1e-6;
        if (plane_first > margin) next = min(next, plane_first);
        if (plane_last > margin) next = min(next, plane_last);
        if (jump > margin) next = min(next, jump);

        // Which branch: decided in the middle.
        float middle = 0.5 * (s + next);
        float side = constant_0 + middle * constant_1 < 0.0 ? -1.0 : 1.0;
        float end = side;
        bool beyond_first = f_first_0 + middle * f_first_1 > 0.0;
        bool beyond_last = f_last_0 + middle * f_last_1 < 0.0;
        bool is_end;
        float end_tau;
        if (side > 0.0) {
            is_end = beyond_last || (beyond_first && arc.first > 0.0) || arc.last < 0.0;
            end_tau = beyond_last || arc.last < 0.0 ? arc.last : arc.first;
        } else {
            is_end = beyond_first || (beyond_last && arc.last < 0.0) || arc.first > 0.0;
            end_tau = beyond_first || arc.first > 0.0 ? arc.first : arc.last;
        }
        float cost_x = abs(passings.x - middle) + (closest.x * side < 0.0 ? 1e6 : 0.0);
        float cost_y = abs(passings.y - middle) + (closest.y * side < 0.0 ? 1e6 : 0.0);
        ew_passage passage = ew_passage_at(arc, is_end ? end_tau : (cost_y < cost_x ? closest.y : closest.x));
        bool inside = passage.s0 > s && passage.s0 < next;
        float centre = clamp(passage.s0, s, next);
        vec2 roots = ew_distance_minima(arc.cubic, arc.quadratic, linear_0 + centre * linear_1,
                                        max(side * (constant_0 + centre * constant_1), 0.0), side);
        float tau = clamp(is_end ? roots.y : roots.x, arc.first, arc.last);
        if (inside && !is_end) tau = passage.tau;
        ew_evaluation_count += 1;

        float closed = ew_integrate_line_distance(passage.b2, passage.k, passage.s0, s, next);
        sum += closed;
        float slope = 0.0;
        float v_0 = 1.0 / (centre + beta);
        float v_1 = 1.0 / (s + beta);
        bool last_side = v_1 == v_0;
        if (last_side) v_1 = 1.0 / (next + beta);
        float v = v_0;
        float v_next = v_1;
        bool singular = inside;
        float start_tau = tau;
        float start_slope = 0.0;
        float start_s = centre;
        for (int step = 0; step < 24; ++step) {
            float tau_1 = start_tau;
            float slope_1 = start_slope;
            float s_1 = start_s;
            float width = v_next - v;
            vec3 nodes = singular ? vec3(0.21234054, 0.59053314, 0.91141204) : vec3(0.11270167, 0.5, 0.88729833);
            vec3 weights = singular ? vec3(0.32884432, 0.38819347, 0.22046221) : vec3(0.27777778, 0.44444444, 0.27777778);
            vec3 f;
            f.x = ew_rest(arc, passage, is_end, epsilon2, v + width * nodes.x, s_1, tau_1, slope_1);
            f.y = ew_rest(arc, passage, is_end, epsilon2, v + width * nodes.y, s_1, tau_1, slope_1);
            f.z = ew_rest(arc, passage, is_end, epsilon2, v + width * nodes.z, s_1, tau_1, slope_1);
            vec3 h = f * weights;
            float second = abs(singular ? f.x/nodes.x * 1.09 - 2.0*f.y/nodes.y + f.z/nodes.z*0.91 : f.x - 2.0 * f.y + f.z) * abs(width);
            if (second <= tolerance * sum || step > 20) {
                sum += abs(width) * (h.x + h.y + h.z);
                v = v_next;
                v_next = v_1;
                singular = false;
                start_tau = tau_1;
                start_slope = slope_1;
                start_s = s_1;
                if (v == v_1) {
                    if (last_side) break;
                    last_side = true;
                    v = v_0;
                    v_1 = 1.0 / (next + beta);
                    v_next = v_1;
                    singular = inside;
                    start_tau = tau;
                    start_slope = 0.0;
                    start_s = centre;
                    if (v == v_1) break;
                }
            } else {
                v_next = 0.5 * (v + v_next);
            }
        }
        s = next;
        if (s >= segment.end) break;
    }
    return sum;
}
