// An infinite line, equation (3).

float ew_distance_squared(ew_line_block line, vec3 position, out float weight)
{
    vec3 difference = position - line.position.xyz;
    difference -= dot(difference, line.direction.xyz) * line.direction.xyz;
    weight = 1.0;
    return ew_length_squared(difference);
}

#ifndef EW_SAMPLING
// The integral over a segment of 1 / distance to an infinite line, equation (3): seen along the line it is a point, and so the
// same closed form. A ray parallel to the line keeps its distance; then k is 0 up to rounding, and any s0 will do.
float ew_integrate(ew_segment segment, ew_line_block line, float others)
{
    vec3 axis = line.direction.xyz;
    vec3 to_line = line.position.xyz - segment.origin;
    to_line -= dot(to_line, axis) * axis;
    vec3 across = segment.direction - dot(segment.direction, axis) * axis;
    float k = max(ew_length_squared(across), 1e-12);
    float s0 = dot(to_line, across) / k;
    float b2 = ew_length_squared(to_line - s0 * across);
    ew_evaluation_count += 1;
    return ew_integrate_line_distance(b2, k, s0, 0.0, segment.end);
}
#endif
