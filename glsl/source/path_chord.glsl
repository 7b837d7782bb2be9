// Where the segment may be within reach of a path: a sphere around its ball, and around a straight beam the cylinder, too.
vec2 ew_chord(const ew_segment segment, const ew_path_block path)
{
    vec2 chord = ew_sphere_chord(segment, path.ball.xyz, path.ball.w + path.glow.y);
    if (path.pieces.y == 0.0 && path.ball.w > 0.0) {
        vec3 axis = path.beam.xyz / path.ball.w;
        vec3 to_line = path.ball.xyz - segment.origin;
        to_line -= dot(to_line, axis) * axis;
        vec3 across = segment.direction - dot(segment.direction, axis) * axis;
        float k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
        float s0 = dot(to_line, across) / k;
        vec2 cylinder = ew_chord_of(ew_length_squared(to_line - s0 * across), k, s0, path.glow.y, segment.end);
        chord = vec2(max(chord.x, cylinder.x), min(chord.y, cylinder.y));
    }
#ifdef EW_PART
    chord = mix(vec2(0.0), chord, bvec2(ew_is_of_part(path)));
#endif
    return chord;
}
