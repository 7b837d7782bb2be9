// Paths with bent pieces.

#ifdef EW_BENDS
// The i-th piece of a path, as a curve. `domain` is the last of its units.
ew_curve_block ew_bent_piece(ew_path_block path, int i, vec4 domain)
{
    vec4 origin = ew_piece_unit(path, 5.0, i, 0);
    vec4 axis_x = ew_piece_unit(path, 5.0, i, 1);
    vec4 axis_y = ew_piece_unit(path, 5.0, i, 2);
    vec4 axis_z = ew_piece_unit(path, 5.0, i, 3);
    return ew_curve_block(vec4(origin.xyz, path.weights.z), axis_x, axis_y, axis_z, vec4(domain.xy, path.weights.xy), path.color,
                          path.glow);
}

vec3 ew_place_at(ew_curve_block curve, float tau)
{
    return curve.origin.xyz + ew_slope_x(curve) * tau * curve.axis_x.xyz +
           (ew_slope_y(curve) + ew_bend(curve) * tau) * tau * curve.axis_y.xyz;
}

// The sum over the pieces: each where no end is nearest, and its start together with the end of the piece before.
float ew_integrate_bends(ew_segment segment, ew_path_block path, vec2 chord, float others)
{
    int count = int(path.pieces.y);
    bool is_closed = path.pieces.w > 0.0;
    vec2 none = chord.xx;
    vec2 start = none; // of a closed path, the part to which its start is nearest
    vec2 last = none;
    vec3 end = vec3(0.0);
    float last_weight = 1.0;
    float sum = 0.0;
    int i = 0;
    do {
        vec4 domain = ew_piece_unit(path, 5.0, i, 4);
        ew_curve_block curve = ew_bent_piece(path, i, domain);
        ew_arc arc = ew_make_arc(segment, curve);
#ifdef EW_WEIGHTS
        arc.place = domain.z;
        arc.place_slope = domain.w - domain.z;
#endif
        vec2 part = chord;
#ifdef EW_REACH
        if (path.glow.y > 0.0) part = ew_chord(segment, curve);
#endif
        vec2 first = none;
        vec2 next_last = none;
        if (part.x < part.y) {
            ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
            ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
            ew_find_parts(arc, first_cell, last_cell, part, first, next_last);
            sum += ew_add_stretches(arc, first_cell, last_cell, first, next_last, part, 0.0, others + max(sum, 0.0));
        }
        bool is_joint = i > 0;
        if (i == 0) start = first;
        vec2 weights = vec2(last_weight, ew_path_weight(path, domain.z));
        if (is_joint || !is_closed)
            sum += ew_integrate_meeting(segment, ew_place_at(curve, arc.first), is_joint ? last : first.xx, first,
                                        is_joint ? chord : first.xx, weights, path.glow);
        last = next_last;
        last_weight = ew_path_weight(path, domain.w);
        end = ew_place_at(curve, arc.last);
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    vec2 weights = vec2(last_weight, is_closed ? ew_path_weight(path, 0.0) : last_weight);
    return sum + ew_integrate_meeting(segment, end, last, is_closed ? start : last.xx, is_closed ? chord : last.xx, weights, path.glow);
}
#endif
