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
    vec2 between = mix(vec2(planes.end, planes.start), vec2(planes.start, planes.end), bvec2(planes.is_along));
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) return ew_integrate_weighted_slab(segment, slab, path, between);
#endif
    return ew_integrate_slab(segment, slab, between, path.glow);
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
