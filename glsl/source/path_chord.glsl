// The part of the segment that is within a ball around `center` and within a cylinder whose axis goes through it along the unit
// vector `axis`. Where there is none, x >= y.
vec2 ew_capsule_chord(const ew_segment segment, const vec3 center, const vec3 axis, const float ball_radius,
                      const float cylinder_radius)
{
    vec2 ball = ew_sphere_chord(segment, center, ball_radius);
    vec3 to_line = center - segment.origin;
    to_line -= dot(to_line, axis) * axis;
    vec3 across = segment.direction - dot(segment.direction, axis) * axis;
    float k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
    float s0 = dot(to_line, across) / k;
    vec2 cylinder = ew_chord_of(ew_length_squared(to_line - s0 * across), k, s0, cylinder_radius, segment.end);
    return vec2(max(ball.x, cylinder.x), min(ball.y, cylinder.y));
}

// Where the segment may be within reach of a path: a sphere around its ball, and around a straight beam the cylinder, too.
vec2 ew_chord(const ew_segment segment, const ew_path_block path)
{
    bool is_beam = EW_IS_BEAM(path) && path.ball.w > 0.0;
    vec3 axis = mix(vec3(1.0, 0.0, 0.0), path.beam.xyz / max(path.ball.w, 1e-30), bvec3(is_beam));
    float reach = path.ball.w + path.glow.y;
    vec2 chord = ew_capsule_chord(segment, path.ball.xyz, axis, reach, mix(reach, path.glow.y, is_beam));
#ifdef EW_PART
    chord = mix(vec2(0.0), chord, bvec2(ew_is_of_part(path)));
#endif
    return chord;
}
