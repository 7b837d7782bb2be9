// Paths with bent pieces.

#ifdef EW_BENDS
// ---- Bent pieces

// The sum over the pieces, each with both of its ends, less a whole point for each joint.
float ew_integrate_bends(ew_segment segment, ew_path_block path, vec2 chord, float others)
{
    int count = int(path.pieces.y);
    float sum = 0.0;
    int i = 0;
    do {
        vec4 origin = ew_piece_unit(path, 5.0, i, 0);
        vec4 axis_x = ew_piece_unit(path, 5.0, i, 1);
        vec4 axis_y = ew_piece_unit(path, 5.0, i, 2);
        vec4 axis_z = ew_piece_unit(path, 5.0, i, 3);
        vec4 domain = ew_piece_unit(path, 5.0, i, 4);
        ew_curve_block curve = ew_curve_block(vec4(origin.xyz, path.weights.z), axis_x, axis_y, axis_z,
                                              vec4(domain.xy, path.weights.xy), path.color, path.glow);
        ew_arc arc = ew_make_arc(segment, curve);
#ifdef EW_WEIGHTS
        arc.place = domain.z;
        arc.place_slope = domain.w - domain.z;
#endif
        vec2 part = chord;
#ifdef EW_REACH
        if (path.glow.y > 0.0) part = ew_chord(segment, curve);
#endif
        if (part.x < part.y) sum += ew_integrate_arc(arc, part, others + max(sum, 0.0));
        if (i > 0 || path.pieces.w > 0.0) {
            vec3 joint = origin.xyz + arc.slope_x * arc.first * axis_x.xyz
                         + (arc.slope_y + arc.bend * arc.first) * arc.first * axis_y.xyz;
            sum -= ew_path_weight(path, domain.z) * ew_integrate_point_over(segment, joint, chord, path.glow);
        }
    } while (++i < count && i < EW_MAX_PATH_PIECES);
    return sum;
}
#endif
