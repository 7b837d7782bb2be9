// Equiangular sampling, what Cycles ships: samples at equal angles, seen from the light (Kulla and Fajardo, "Importance Sampling
// Techniques for Path Tracing in Participating Media", 2012), here stratified and jittered by peer_noise. It is made for points;
// any other source is taken for its point that is nearest to the ray. The distance to it counts as epsilon where it is less:
// the density would be infinite on the source otherwise.

#define PEER_EQUIANGULAR

// s = center + distance tan(angle), all angles equally likely.
struct peer_distribution {
    float center;
    float distance; // in units of s
    float first;    // angles
    float last;
};

peer_distribution peer_distribute(ew_segment segment, vec2 chord, vec3 nearest)
{
    vec3 to_nearest = nearest - segment.origin;
    float k = ew_length_squared(segment.direction);
    float center = dot(to_nearest, segment.direction) / k;
    float distance = max(length(to_nearest - center * segment.direction), ew_plain_glow().x) * inversesqrt(k);
    return peer_distribution(center, distance, atan((chord.x - center) / distance), atan((chord.y - center) / distance));
}

// x: s at u in [0, 1), y: 1 / the density of samples there.
vec2 peer_place(peer_distribution distribution, float u)
{
    float y = distribution.distance * tan(mix(distribution.first, distribution.last, u));
    float range = distribution.last - distribution.first;
    return vec2(max(distribution.center + y, 0.0), range * (distribution.distance + y * y / distribution.distance));
}

// The squared distance from a position to the segment.
float peer_distance_squared(ew_segment segment, vec3 position)
{
    vec3 to_position = position - segment.origin;
    float s = clamp(dot(to_position, segment.direction) / ew_length_squared(segment.direction), 0.0, segment.end);
    return ew_length_squared(to_position - s * segment.direction);
}

// A vector's part across the ray.
vec3 peer_across(ew_segment segment, vec3 v)
{
    return v - dot(v, segment.direction) / ew_length_squared(segment.direction) * segment.direction;
}

// Newton's step towards the least length of a vector with the given first and second derivative, downhill in any case.
float peer_newton_step(vec3 difference, vec3 first, vec3 second)
{
    float slope_squared = ew_length_squared(first);
    float curvature = slope_squared + dot(difference, second);
    return -dot(difference, first) / max(curvature > 0.0 ? curvature : slope_squared, 1e-30);
}

const int PEER_CANDIDATES = 16;
const int PEER_NEWTON_STEPS = 3;

vec3 peer_nearest(ew_segment segment, ew_point_block point)
{
    return point.position.xyz;
}

vec3 peer_nearest(ew_segment segment, ew_line_block line)
{
    vec3 axis = line.direction.xyz;
    vec3 to_line = line.position.xyz - segment.origin;
    vec3 across = segment.direction - dot(segment.direction, axis) * axis;
    float s = clamp(dot(to_line, across) / max(ew_length_squared(across), 1e-12), 0.0, segment.end);
    return line.position.xyz + dot(s * segment.direction - to_line, axis) * axis;
}

vec3 peer_nearest(ew_segment segment, ew_torus_block torus)
{
    vec3 axis = torus.axis.xyz;
    vec3 u = torus.axis.w * normalize(cross(axis, abs(axis.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 v = cross(axis, u);
    float angle = 0.0;
    float least = 1e38;
    for (int i = 0; i < PEER_CANDIDATES; ++i) {
        float candidate = 6.28318530718 * float(i) / float(PEER_CANDIDATES);
        float distance_squared = peer_distance_squared(segment, torus.center.xyz + cos(candidate) * u + sin(candidate) * v);
        if (distance_squared < least) {
            least = distance_squared;
            angle = candidate;
        }
    }
    vec3 center = peer_across(segment, torus.center.xyz - segment.origin);
    vec3 across_u = peer_across(segment, u);
    vec3 across_v = peer_across(segment, v);
    for (int i = 0; i < PEER_NEWTON_STEPS; ++i) {
        vec3 radius = cos(angle) * across_u + sin(angle) * across_v;
        angle += peer_newton_step(center + radius, cos(angle) * across_v - sin(angle) * across_u, -radius);
    }
    return torus.center.xyz + cos(angle) * u + sin(angle) * v;
}

vec3 peer_nearest(ew_segment segment, ew_curve_block curve)
{
    vec3 c0 = curve.origin.xyz;
    vec3 c1 = curve.axis_x.w * curve.axis_x.xyz + curve.axis_y.w * curve.axis_y.xyz;
    vec3 c2 = curve.axis_z.w * curve.axis_y.xyz;
    float first = curve.domain.x;
    float last = curve.domain.y;
    float tau = first;
    float least = 1e38;
    for (int i = 0; i < PEER_CANDIDATES; ++i) {
        float candidate = mix(first, last, float(i) / float(PEER_CANDIDATES - 1));
        float distance_squared = peer_distance_squared(segment, c0 + candidate * (c1 + candidate * c2));
        if (distance_squared < least) {
            least = distance_squared;
            tau = candidate;
        }
    }
    vec3 across_c0 = peer_across(segment, c0 - segment.origin);
    vec3 across_c1 = peer_across(segment, c1);
    vec3 across_c2 = peer_across(segment, c2);
    for (int i = 0; i < PEER_NEWTON_STEPS; ++i) {
        vec3 difference = across_c0 + tau * (across_c1 + tau * across_c2);
        tau += peer_newton_step(difference, across_c1 + 2.0 * tau * across_c2, 2.0 * across_c2);
        tau = clamp(tau, first, last);
    }
    return c0 + tau * (c1 + tau * c2);
}
