// A point, equation (2).

// The squared distance from `position`, and the weight at the nearest point: for integrators that sample the field.
float ew_distance_squared(const ew_point_block point, const vec3 position, out float weight)
{
    weight = 1.0;
    return ew_length_squared(position - point.position.xyz);
}

// Where the segment may be within reach.
vec2 ew_chord(const ew_segment segment, const ew_point_block point)
{
    return ew_sphere_chord(segment, point.position.xyz, point.glow.y);
}

#ifndef EW_SAMPLING
// The integral over a segment of 1 / max(epsilon, distance to a point), equation (2), by the closed form. The ray's distance
// from the point is the length of a perpendicular vector, because the root of a difference of squares would cancel. Relative
// error 1e-6.
float ew_integrate(const ew_segment segment, const ew_point_block point, const vec2 chord, const float others)
{
    vec3 to_point = point.position.xyz - segment.origin;
    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_point, segment.direction) / k;
    float b2 = ew_length_squared(to_point - s0 * segment.direction);
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, chord, point.glow);
}
#endif
