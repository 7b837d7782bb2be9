// Paths of straight pieces.

// The line's part of a straight piece without weights: what lies between the planes.
float ew_integrate_slab(const ew_segment segment, const ew_slab slab, vec2 part, const vec4 glow)
{
    float b2, k, s0;
    ew_find_line(segment, slab, glow, part, b2, k, s0);
    ew_evaluation_count += 1;
    return ew_integrate_within_reach(b2, k, s0, part, glow);
}

float ew_integrate_line_of_piece(const ew_segment segment, const ew_slab slab, const ew_path_block path, const ew_planes planes)
{
    vec2 between = mix(vec2(planes.end, planes.start), vec2(planes.start, planes.end), bvec2(planes.is_along));
#ifdef EW_WEIGHTS
    float sum = 0.0;
    if (path.weights.y > 0.0) sum = ew_integrate_weighted_slab(segment, slab, path, between);
    else sum = ew_integrate_slab(segment, slab, between, path.glow);
    return sum;
#else
    return ew_integrate_slab(segment, slab, between, path.glow);
#endif
}

#ifdef EW_POLYLINES
#if defined(EW_WORLD) && defined(EW_FOG)
// The light between the planes of a piece, unless it has weights, and `weight` times that of the point at its start or end, against one
// transmittance in panels that both share.
float ew_integrate_piece_in_fog(const ew_segment segment, const ew_slab slab, const ew_path_block path, const ew_planes planes,
                                const bool has_line, const vec3 position, const ew_node node, const float weight)
{
    vec2 part = mix(vec2(planes.end, planes.start), vec2(planes.start, planes.end), bvec2(planes.is_along));
    float b2, k, s0;
    ew_find_line(segment, slab, path.glow, part, b2, k, s0);
    vec2 core = ew_core_on_ray(b2, k, s0, path.glow);
    ew_point_ray ray = ew_make_point_ray(segment, position, path.glow);
    vec4 ends = ray.s0 + clamp(vec4(node.to, node.from) - ray.s0, -ray.half_chord, ray.half_chord);
    bool is_lit = has_line && part.x < part.y;
    part = mix(part.xx, part, bvec2(is_lit));
    bvec4 is_empty = equal(ends, ends.zwxy);
    vec4 least = mix(ends, vec4(1e30), is_empty);
    vec4 most = mix(ends, vec4(-1e30), is_empty);
    float from = min(min(min(least.x, least.y), min(least.z, least.w)), mix(1e30, part.x, is_lit));
    float stop = max(max(max(most.x, most.y), max(most.z, most.w)), mix(-1e30, part.y, is_lit));
    float sum = 0.0;
    float first = 0.0;
    int panel = 0;
    while (from < stop && panel < EW_MAX_FOG_PANELS) {
        float to = min(from + ew_longest_cubic(from, k, core, path.glow), stop);
        float middle = 0.5 * (from + to);
        vec4 moments = ew_moments_of_part(b2, k, s0, core, clamp(part, from, to), middle, path.glow);
        vec4 ways = clamp(clamp(ends, from, to) - ray.s0, -ray.half_chord, ray.half_chord);
        moments += weight * ew_moments_of_ways(ray, ways.xy, ways.zw, middle - ray.s0, path.glow);
        vec4 transmittance = ew_transmittance_cubic(middle, 0.5 * (to - from));
        sum += dot(moments, transmittance);
        first = mix(first, transmittance.x, panel == 0);
        from = mix(to, stop, transmittance.x <= EW_FOG_HIDDEN * first);
        ++panel;
    }
    ew_evaluation_count += 2;
    return sum;
}
#endif

float ew_integrate_polyline(const ew_segment segment, const ew_path_block path, const vec2 chord)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    int before = is_closed ? count - 1 : 0;
    ew_slab slab = ew_make_slab(segment, ew_straight_unit(path, before, 0), ew_straight_unit(path, before, 1));
    ew_planes planes = ew_find_planes(slab, chord);
    float end = planes.end;
    bool is_end_ahead = planes.is_along;
    // The joint that closes a path has its first weight. If the last one differs, the cap beyond the last piece has the difference
    // in addition; an open path's has all of the last one.
    float closing_weight = mix(0.0, ew_path_weight(path, 0.0), is_closed);
    bool has_end = !is_closed;
#ifdef EW_WEIGHTS
    has_end = has_end || ew_path_weight(path, 1.0) != closing_weight;
#endif
    float sum = 0.0;
    int i = 0;
#if defined(EW_WORLD) && defined(EW_FOG)
    // The end counts as a start behind it, so that compilers put the integral into the shader once.
    int node_count = count + int(has_end);
    do {
        bool is_end = i == count;
        int piece = min(i, count - 1);
        slab = ew_make_slab(segment, ew_straight_unit(path, piece, 0), ew_straight_unit(path, piece, 1));
        planes = ew_find_planes(slab, chord);
        ew_node node = ew_make_joint(end, is_end_ahead, planes.start, !planes.is_along, chord);
        if (i == 0 && !is_closed) node = ew_make_end(planes.start, !planes.is_along, chord);
        if (is_end) node = ew_make_end(end, is_end_ahead, chord);
        vec3 position = mix(slab.start, slab.end, bvec3(is_end));
        float weight = ew_path_weight(path, mix(slab.t.x, slab.t.y, is_end)) - mix(0.0, closing_weight, is_end);
        bool has_line = !is_end;
#ifdef EW_WEIGHTS
        if (has_line && path.weights.y > 0.0) sum += ew_integrate_line_of_piece(segment, slab, path, planes);
        has_line = has_line && path.weights.y == 0.0;
#endif
        sum += ew_integrate_piece_in_fog(segment, slab, path, planes, has_line, position, node, weight);
        end = planes.end;
        is_end_ahead = planes.is_along;
    } while (++i < node_count && i <= EW_MAX_PATH_PIECES);
#else
    do {
        slab = ew_make_slab(segment, ew_straight_unit(path, i, 0), ew_straight_unit(path, i, 1));
        planes = ew_find_planes(slab, chord);
        sum += ew_integrate_line_of_piece(segment, slab, path, planes);
        // What is before the start is ahead on the ray if the ray runs against the piece.
        ew_node node = ew_make_joint(end, is_end_ahead, planes.start, !planes.is_along, chord);
        if (i == 0 && !is_closed) node = ew_make_end(planes.start, !planes.is_along, chord);
        sum += ew_path_weight(path, slab.t.x) * ew_integrate_node(segment, slab.start, node, path.glow);
        end = planes.end;
        is_end_ahead = planes.is_along;
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    if (has_end)
        sum += (ew_path_weight(path, slab.t.y) - closing_weight) *
               ew_integrate_node(segment, slab.end, ew_make_end(end, is_end_ahead, chord), path.glow);
#endif
    return sum;
}
#endif
