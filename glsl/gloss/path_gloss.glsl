// What is mirrored of a path: of its pieces.
float ew_gloss_of_straight_piece(const ew_surface surface, const ew_gloss gloss, const ew_path_block path, const vec4 start,
                                 const vec4 end)
{
    vec4 weights = vec4(start.w, end.w, path.weights.xy);
    return ew_gloss_of_segment(surface, gloss, start.xyz - surface.position, end.xyz - surface.position, ew_light_core(path.glow),
                               weights);
}

#ifdef EW_PIECES
float ew_gloss_of_piece(const ew_surface surface, const ew_gloss gloss, const ew_path_block path, const int i)
{
#ifdef EW_BENDS
    if (EW_HAS_BENDS(path))
        return ew_gloss_of_bend(surface, gloss, ew_bent_piece(path, i), ew_bent_unit(path, i, 4).zw, path.weights.xy);
#endif
    return ew_gloss_of_straight_piece(surface, gloss, path, ew_straight_unit(path, i, 0), ew_straight_unit(path, i, 1));
}
#endif

float ew_gloss_of(const ew_surface surface, const ew_gloss gloss, const ew_path_block path)
{
    if (length(path.ball.xyz - surface.position) >= path.ball.w + ew_light_reach()) return 0.0;
#ifdef EW_PIECES
    int count = int(path.pieces.y);
    int i = 0;
    float sum = 0.0;
    if (!EW_IS_BEAM(path)) {
        do {
            sum += ew_gloss_of_piece(surface, gloss, path, i);
        } while (++i < count && i < EW_MAX_PATH_PIECES);
        return sum;
    }
#endif
    vec4 start = vec4(path.ball.xyz - path.beam.xyz, 0.0);
    vec4 end = vec4(path.ball.xyz + path.beam.xyz, 1.0);
    return ew_gloss_of_straight_piece(surface, gloss, path, start, end);
}
