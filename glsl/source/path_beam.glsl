// Paths of one straight piece.

// A straight beam as a ray meets it. To what is before the plane through the end that the ray comes to first, that end is nearest; to
// what is beyond the other plane, the last end; in between, a point of the line. The squared distance from each along the ray is
// b2 + k (s - s0)^2.
struct ew_beam {
    vec3 b2; // of the first end, the line and the last end
    vec3 k;
    vec3 s0;
    vec2 planes;    // s, in the chord
    bool is_turned; // the path's end is the first
};

// What lies across the ray is found for the middle and for the axis, and from these for both ends.
ew_beam ew_meet_beam(const ew_segment segment, const ew_path_block path, const vec2 chord)
{
    float size = path.ball.w;
    vec3 axis = path.beam.xyz / max(size, 1e-30);
    float growth = dot(segment.direction, axis);
    bool is_turned = growth < 0.0;
    axis *= mix(1.0, -1.0, is_turned);
    growth = abs(growth);
    vec3 to_middle = path.ball.xyz - segment.origin;
    float along = dot(to_middle, axis);
    // A ray parallel to the planes is before or beyond each all the way.
    vec2 planes = clamp((along + vec2(-size, size)) / max(growth, 1e-30), chord.x, chord.y);

    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_middle, segment.direction) / k;
    float step = growth / k;
    vec3 middle_across = to_middle - s0 * segment.direction;
    vec3 end_across = size * (axis - step * segment.direction);
    vec3 to_line = to_middle - along * axis;
    vec3 across = segment.direction - growth * axis;
    float line_k = max(ew_length_squared(across), 1e-12 * k);
    float line_s0 = dot(to_line, across) / line_k;
    return ew_beam(vec3(ew_length_squared(middle_across - end_across), ew_length_squared(to_line - line_s0 * across),
                        ew_length_squared(middle_across + end_across)),
                   vec3(k, line_k, k), vec3(s0 - size * step, line_s0, s0 + size * step), planes, is_turned);
}

#if defined(EW_FOG) || !defined(EW_WORLD)
// What the ray has of the reach of each of a beam's parts: the first end, the line and the last end.
void ew_clip_beam_parts(const ew_beam beam, const vec2 chord, const vec4 glow, out vec3 from, out vec3 to)
{
    from = vec3(chord.x, beam.planes);
    to = vec3(beam.planes, chord.y);
#ifdef EW_REACH
    if (ew_has_reach(glow)) {
        vec3 b = sqrt(beam.b2);
        vec3 half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0) / beam.k);
        from = clamp(from, beam.s0 - half_chord, beam.s0 + half_chord);
        to = clamp(to, beam.s0 - half_chord, beam.s0 + half_chord);
    }
#endif
}
#endif

#if defined(EW_FOG) && defined(EW_WORLD)
// `weights` are those of the first end, the line and the last end. The panels of all three are one loop's, because where a group of
// pixels meets one of them, a software rasteriser need not go through the others.
float ew_integrate_beam_parts(const ew_beam beam, const vec2 chord, const vec3 weights, const vec4 glow)
{
    vec3 from, to;
    ew_clip_beam_parts(beam, chord, glow, from, to);
    bvec3 is_lit = lessThan(from, to);
    int part = is_lit.x ? 0 : is_lit.y ? 1 : 2;
    float start = mix(mix(from.z, from.y, is_lit.y), from.x, is_lit.x);
    float sum = 0.0;
    float first = 0.0;
    int panel = 0;
    do {
        bvec3 is_part = bvec3(part == 0, part == 1, part == 2);
        vec4 of_part = mix(vec4(beam.b2.z, beam.k.z, beam.s0.z, to.z), vec4(beam.b2.y, beam.k.y, beam.s0.y, to.y), bvec4(is_part.y));
        of_part = mix(of_part, vec4(beam.b2.x, beam.k.x, beam.s0.x, to.x), bvec4(is_part.x));
        vec2 core = ew_core_on_ray(of_part.x, of_part.y, of_part.z, glow);
        float end = min(start + ew_longest_cubic(start, of_part.y, core, glow), of_part.w);
        vec2 light = ew_integrate_panel(of_part.x, of_part.y, of_part.z, core, vec2(start, end), glow);
        sum += mix(mix(weights.z, weights.y, is_part.y), weights.x, is_part.x) * light.x;
        first = mix(first, light.y, panel == 0);
        bool is_over = end >= of_part.w;
        bool is_line_next = is_part.x && is_lit.y;
        bool is_last = !(is_line_next || (part < 2 && is_lit.z));
        part = is_over ? is_last ? 3 : is_line_next ? 1 : 2 : part;
        start = mix(end, mix(from.z, from.y, is_line_next), is_over);
        if (light.y <= EW_FOG_HIDDEN * first) part = 3;
    } while (part < 3 && ++panel < EW_MAX_FOG_PANELS);
    ew_evaluation_count += 3;
    return sum;
}
#elif defined(EW_WORLD)
// Both ends of a beam at once, by the form of ew_integrate_node: of each, from the edge of its cap to the end of what the ray has of
// its reach. With y = sqrt(k) (s - s0) the squared distance is b2 + y^2.
vec2 ew_integrate_beam_ends(const ew_beam beam, const vec2 chord, const vec4 glow)
{
    float root_k = sqrt(beam.k.x);
    float inverse_root_k = 1.0 / root_k;
    vec2 s0 = beam.s0.xz;
    vec2 b2 = beam.b2.xz;
    vec2 b = sqrt(b2);
    vec2 half_chord = sqrt(max((glow.y - b) * (glow.y + b), 0.0));
    vec4 y = clamp(root_k * (vec4(chord.x, beam.planes, chord.y) - s0.xxyy), -half_chord.xxyy, half_chord.xxyy);
    vec2 core2 = vec2(ew_core2(glow, max(s0.x, 0.0)), ew_core2(glow, max(s0.y, 0.0)));
    vec2 half_core = sqrt(max(core2 - b2, 0.0));
    vec4 outside = max(abs(y), half_core.xxyy);
    vec4 power = sqrt(b2.xxyy + outside * outside) + outside;
    vec2 at_core = sqrt(max(core2, b2)) + half_core;
    // The antiderivative is odd in y, and of its values at both ends of a part the logarithms are one, of a quotient.
    bvec4 is_after = greaterThan(y, vec4(0.0));
    vec4 above = mix(at_core.xxyy, power, is_after);
    vec4 below = mix(power, at_core.xxyy, is_after);
    vec2 sides = 0.69314718 * log2((above.yw * below.xz) / (below.yw * above.xz));
    vec2 tilt = vec2(ew_core_tilt(glow, max(s0.x, 0.0)), ew_core_tilt(glow, max(s0.y, 0.0)));
    vec2 at_point = 1.0 + tilt * max(-s0, 0.0);
    vec4 inside = clamp(y, -half_core.xxyy, half_core.xxyy);
    inside *= at_point.xxyy - 0.5 * inverse_root_k * tilt.xxyy * inside;
    ew_evaluation_count += 2;
    return inverse_root_k * (sides + (inside.yw - inside.xz) * inversesqrt(core2) - (y.yw - y.xz) * ew_inverse_reach(glow));
}

// `weights` are those of the first end, the line and the last end.
float ew_integrate_beam_parts(const ew_beam beam, const vec2 chord, const vec3 weights, const vec4 glow)
{
    vec2 ends = ew_integrate_beam_ends(beam, chord, glow);
    ew_evaluation_count += 1;
    return dot(weights.xz, ends) +
           weights.y * ew_integrate_within_reach(beam.b2.y, beam.k.y, beam.s0.y, beam.planes, glow);
}
#elif defined(EW_FOG)
// `weights` are those of the first end, the line and the last end.
float ew_integrate_beam_parts(const ew_beam beam, const vec2 chord, const vec3 weights, const vec4 glow)
{
    vec3 from, to;
    ew_clip_beam_parts(beam, chord, glow, from, to);
    float sum = 0.0;
    // A loop, because compilers put the integral into the shader for every place that calls it.
    for (int i = 0; i < 3; ++i)
        if (from[i] < to[i]) sum += weights[i] * ew_integrate_within_reach(beam.b2[i], beam.k[i], beam.s0[i], vec2(from[i], to[i]), glow);
    ew_evaluation_count += 3;
    return sum;
}
#elif defined(EW_CORE_PIXELS)
// Each part by itself, since a core that grows with depth may be anywhere along it, or around its light. `weights` are those of the first end,
// the line and the last end.
float ew_integrate_beam_parts(const ew_beam beam, const vec2 chord, const vec3 weights, const vec4 glow)
{
    vec3 from, to;
    ew_clip_beam_parts(beam, chord, glow, from, to);
    ew_evaluation_count += 3;
    return weights.x * ew_integrate_within_reach(beam.b2.x, beam.k.x, beam.s0.x, vec2(from.x, to.x), glow) +
           weights.y * ew_integrate_within_reach(beam.b2.y, beam.k.y, beam.s0.y, vec2(from.y, to.y), glow) +
           weights.z * ew_integrate_within_reach(beam.b2.z, beam.k.z, beam.s0.z, vec2(from.z, to.z), glow);
}
#else
// Along the ray a beam's distance falls up to the core, or to its least, and then grows. So of the three parts' six sides of the core
// two are always empty, but for rounding: behind the core in the first part, or before it in the second; and the same mirrored.
float ew_integrate_beam_parts(const ew_beam beam, const vec2 chord, const vec3 weights, const vec4 glow)
{
    vec3 from, to;
    ew_clip_beam_parts(beam, chord, glow, from, to);
    vec3 half_core = sqrt(max(glow.x * glow.x - beam.b2, 0.0) / beam.k);
    vec3 core_from = clamp(beam.s0 - half_core, from, to);
    vec3 core_to = clamp(beam.s0 + half_core, from, to);
    bool is_first = to.x - core_to.x > core_from.y - from.y;
    bool is_last = core_from.z - from.z > to.y - core_to.y;
    bvec2 is_end = bvec2(is_first, is_last);
    vec4 side_from = vec4(from.x, mix(vec2(from.y, core_to.y), vec2(core_to.x, from.z), is_end), core_to.z);
    vec4 side_to = vec4(core_from.x, mix(vec2(core_from.y, to.y), vec2(to.x, core_from.z), is_end), to.z);
    vec4 b2 = vec4(beam.b2.x, mix(beam.b2.yy, beam.b2.xz, is_end), beam.b2.z);
    vec2 s0 = mix(beam.s0.yy, beam.s0.xz, is_end);
    vec2 k = mix(beam.k.yy, beam.k.xz, is_end);
    vec4 weight = vec4(weights.x, mix(weights.yy, weights.xz, is_end), weights.z);
    ew_evaluation_count += 3;
    float sum = weight.x * ew_integrate_reciprocal(b2.x, beam.k.x, beam.s0.x, side_from.x, side_to.x);
    sum += weight.y * ew_integrate_reciprocal(b2.y, k.x, s0.x, side_from.y, side_to.y);
    sum += weight.z * ew_integrate_reciprocal(b2.z, k.y, s0.y, side_from.z, side_to.z);
    sum += weight.w * ew_integrate_reciprocal(b2.w, beam.k.z, beam.s0.z, side_from.w, side_to.w);
    sum += weights.x * ew_integrate_core(core_from.x, core_to.x, glow);
    sum += weights.y * ew_integrate_core(core_from.y, core_to.y, glow);
    sum += weights.z * ew_integrate_core(core_from.z, core_to.z, glow);
#ifdef EW_REACH
    sum -= ew_inverse_reach(glow) * (weights.x * ew_measure(from.x, to.x) + weights.y * ew_measure(from.y, to.y) +
                                     weights.z * ew_measure(from.z, to.z));
#endif
    return sum;
}
#endif

float ew_integrate_beam(const ew_segment segment, const ew_path_block path, const vec2 chord)
{
    ew_beam beam = ew_meet_beam(segment, path, chord);
    float sum = 0.0;
    vec3 weights = vec3(1.0);
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) {
        vec2 ends = vec2(ew_path_weight(path, 0.0), ew_path_weight(path, 1.0));
        weights = mix(vec3(ends.x, 0.0, ends.y), vec3(ends.y, 0.0, ends.x), bvec3(beam.is_turned));
        vec3 half_way = path.beam.xyz;
        ew_slab slab = ew_make_slab(segment, vec4(path.ball.xyz - half_way, 0.0), vec4(path.ball.xyz + half_way, 1.0));
        sum = ew_integrate_weighted_slab(segment, slab, path, beam.planes);
    }
#endif
    return sum + ew_integrate_beam_parts(beam, chord, weights, path.glow);
}
