// An infinite line, equation (3).

// The squared distance from `position`, and the weight at the nearest point: for integrators that sample the field.
float ew_distance_squared(const ew_line_block line, const vec3 position, out float weight)
{
    vec3 difference = position - line.position.xyz;
    difference -= dot(difference, line.direction.xyz) * line.direction.xyz;
    weight = 1.0;
    return ew_length_squared(difference);
}

// Where the segment may be within reach.
vec2 ew_chord(const ew_segment segment, const ew_line_block line)
{
    vec3 axis = line.direction.xyz;
    vec3 to_line = line.position.xyz - segment.origin;
    to_line -= dot(to_line, axis) * axis;
    vec3 across = segment.direction - dot(segment.direction, axis) * axis;
    float k = max(ew_length_squared(across), 1e-12);
    float s0 = dot(to_line, across) / k;
    return ew_chord_of(ew_length_squared(to_line - s0 * across), k, s0, line.glow.y, segment.end);
}

#ifndef EW_SAMPLING
// The integral over a segment of 1 / max(epsilon, distance to a line), equation (3). Seen along the line, the line is a point,
// so the closed form serves. A ray parallel to the line keeps its distance from it: then k is 0 up to rounding, and any s0 will
// do. Relative error 1e-6.
float ew_integrate(const ew_segment segment, const ew_line_block line, const vec2 chord, const float others)
{
    vec3 axis = line.direction.xyz;
    vec3 to_line = line.position.xyz - segment.origin;
    to_line -= dot(to_line, axis) * axis;
    vec3 across = segment.direction - dot(segment.direction, axis) * axis;
    float k = max(ew_length_squared(across), 1e-12);
    float s0 = dot(to_line, across) / k;
    float b2 = ew_length_squared(to_line - s0 * across);
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, chord, line.glow);
}
#endif
