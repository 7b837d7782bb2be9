// Paths of straight pieces.

// The line's part of a straight piece without weights: what lies between the planes.
float ew_integrate_slab(ew_segment segment, ew_slab slab, vec2 part, vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, part, glow);
}

float ew_integrate_line_of_piece(ew_segment segment, ew_slab slab, ew_path_block path, ew_planes planes)
{
    vec2 between = planes.is_along ? vec2(planes.start, planes.end) : vec2(planes.end, planes.start);
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) return ew_integrate_weighted_slab(segment, slab, path, between);
#endif
    return ew_integrate_slab(segment, slab, between, path.glow);
}

#ifdef EW_WORLD
// Both ends of a straight beam at once, by the form of ew_integrate_node: of each, from the edge of its cap to the end of what
// the ray has of its reach.
float ew_integrate_beam_ends(ew_segment segment, ew_slab slab, ew_planes planes, vec2 chord, vec2 weights, vec4 glow)
{
    float k = ew_length_squared(segment.direction);
    float root_k = sqrt(k);
    vec3 to_start = slab.start - segment.origin;
    vec3 to_end = slab.end - segment.origin;
    vec2 s0 = vec2(dot(to_start, segment.direction), dot(to_end, segment.direction)) / k;
    vec2 b2 = vec2(ew_length_squared(to_start - s0.x * segment.direction), ew_length_squared(to_end - s0.y * segment.direction));
    vec2 b = sqrt(b2);
    vec2 half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0) / k);
    // Along the piece the start's cap lies from the chord's start to the start's plane, and the end's from its plane on.
    vec4 y = planes.is_along ? vec4(chord.x, planes.start, planes.end, chord.y) : vec4(planes.start, chord.y, chord.x, planes.end);
    y = clamp(y - s0.xxyy, -half_chord.xxyy, half_chord.xxyy);
    vec2 core2 = vec2(ew_core2(glow, max(s0.x, 0.0)), ew_core2(glow, max(s0.y, 0.0)));
    vec2 half_core = sqrt(max(core2 - b2, 0.0) / k);
    vec4 outside = max(abs(y), half_core.xxyy);
    vec4 power = sqrt(b2.xxyy + k * outside * outside) + root_k * outside;
    vec2 at_core = sqrt(max(core2, b2)) + root_k * half_core;
    power /= at_core.xxyy;
    // The antiderivative is odd in y.
    vec4 odd = mix(power, 1.0 / power, lessThan(y, vec4(0.0)));
    vec4 inside = clamp(y, -half_core.xxyy, half_core.xxyy);
    vec2 tilt = vec2(ew_core_tilt(glow, max(s0.x, 0.0)), ew_core_tilt(glow, max(s0.y, 0.0)));
    vec2 at_point = 1.0 + tilt * max(-s0, 0.0);
    inside *= at_point.xxyy - 0.5 * tilt.xxyy * inside;
    vec2 sides = (0.69314718 / root_k) * log2(vec2(odd.y / odd.x, odd.w / odd.z));
    vec2 parts = sides + vec2(inside.y - inside.x, inside.w - inside.z) * inversesqrt(core2) -
                 vec2(y.y - y.x, y.w - y.z) * ew_inverse_reach(glow);
    ew_evaluation_count += 2;
    return dot(weights, parts);
}
#else
float ew_integrate_beam_ends(ew_segment segment, ew_slab slab, ew_planes planes, vec2 chord, vec2 weights, vec4 glow)
{
    vec2 before = planes.is_along ? vec2(chord.x, planes.start) : vec2(planes.start, chord.y);
    vec2 beyond = planes.is_along ? vec2(planes.end, chord.y) : vec2(chord.x, planes.end);
    return weights.x * ew_integrate_point_over(segment, slab.start, before, glow) +
           weights.y * ew_integrate_point_over(segment, slab.end, beyond, glow);
}
#endif

float ew_integrate_beam(ew_segment segment, ew_path_block path, vec2 chord)
{
    ew_slab slab = ew_make_slab(segment, vec4(path.ball.xyz - path.beam.xyz, 0.0), vec4(path.ball.xyz + path.beam.xyz, 1.0));
    ew_planes planes = ew_find_planes(slab, chord);
    vec2 weights = vec2(ew_path_weight(path, 0.0), ew_path_weight(path, 1.0));
    return ew_integrate_line_of_piece(segment, slab, path, planes) +
           ew_integrate_beam_ends(segment, slab, planes, chord, weights, path.glow);
}

#ifdef EW_JOINTS
float ew_integrate_polyline(ew_segment segment, ew_path_block path, vec2 chord)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    int before = is_closed ? count - 1 : 0;
    ew_slab slab = ew_make_slab(segment, ew_piece_unit(path, 2.0, before, 0), ew_piece_unit(path, 2.0, before, 1));
    ew_planes planes = ew_find_planes(slab, chord);
    float end = planes.end;
    bool is_end_ahead = planes.is_along;
    float sum = 0.0;
    int i = 0;
    do {
        slab = ew_make_slab(segment, ew_piece_unit(path, 2.0, i, 0), ew_piece_unit(path, 2.0, i, 1));
        planes = ew_find_planes(slab, chord);
        sum += ew_integrate_line_of_piece(segment, slab, path, planes);
        // What is before the start is ahead on the ray if the ray runs against the piece.
        ew_node node = ew_make_joint(end, is_end_ahead, planes.start, !planes.is_along, chord);
        if (i == 0 && !is_closed) node = ew_make_end(planes.start, !planes.is_along, chord);
        sum += ew_path_weight(path, slab.t.x) * ew_integrate_node(segment, slab.start, node, path.glow);
        end = planes.end;
        is_end_ahead = planes.is_along;
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    if (!is_closed)
        sum += ew_path_weight(path, slab.t.y) *
               ew_integrate_node(segment, slab.end, ew_make_end(end, is_end_ahead, chord), path.glow);
    return sum;
}
#endif
