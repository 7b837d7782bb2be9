// The light of a path: the sum of its pieces', since an emitter's ends add nothing of their own.

float ew_light_of_straight_piece(ew_surface surface, ew_path_block path, vec4 start, vec4 end)
{
    vec3 from = start.xyz - surface.position;
    vec3 to = end.xyz - surface.position;
#ifdef EW_WEIGHTS
    if (path.weights.y > 0.0) {
        ew_emitter emitter =
            ew_emitter(from, to - from, vec3(0.0), vec2(0.0, 1.0), vec2(start.w, end.w - start.w), path.weights.xy, vec2(0.0),
                       vec2(0.0), 0.0);
        return ew_light_of_emitter(surface, emitter, false, ew_light_core(path.glow));
    }
#endif
    float light = ew_light_of_segment(surface, from, to, ew_light_core(path.glow));
    EW_PICK_BETWEEN(light, from, to);
    return light;
}

float ew_irradiance_of(ew_surface surface, ew_path_block path)
{
    if (length(path.ball.xyz - surface.position) >= path.ball.w + ew_light_reach()) return 0.0;
    vec4 start = vec4(path.ball.xyz - path.beam.xyz, 0.0);
    vec4 end = vec4(path.ball.xyz + path.beam.xyz, 1.0);
    float sum = 0.0;
#ifdef EW_JOINTS
    int count = int(path.pieces.y);
    int i = 0;
    do {
        if (path.pieces.z == 0.0) {
            if (count > 0) { start = ew_piece_unit(path, 2.0, i, 0); end = ew_piece_unit(path, 2.0, i, 1); }
            sum += ew_light_of_straight_piece(surface, path, start, end);
        }
#ifdef EW_BENDS
        else {
            vec4 domain = ew_piece_unit(path, 5.0, i, 4);
            sum += ew_light_of_bend(surface, ew_bent_piece(path, i), domain.zw, path.weights.xy);
        }
#endif
    } while (++i < count && i < EW_MAX_PATH_PIECES);
#else
    sum = ew_light_of_straight_piece(surface, path, start, end);
#endif
    return sum;
}
