// What is mirrored of a quadratic emitter: of its chords, which are shorter where it is near. They take even steps of theta as in
// bent_emitter.glsl, but with a width that is not so small that those far away get long. `weight_places`: where its ends are in the list of weights, of which `pieces` has the first piece and
// their number.

const int EW_GLOSS_CHORDS = 10;

float ew_gloss_of_arm(const ew_surface surface, const ew_gloss gloss, const ew_emitter emitter, const vec2 part, const float peak,
                      const float core)
{
    float speed = length(emitter.c1 + 2.0 * peak * emitter.c2);
    float width = max(length(ew_emitter_place(emitter, peak)) / max(speed, 1e-30), 0.15 * (part.y - part.x));
    vec2 angles = atan((part - peak) / width);
    float sum = 0.0;
    float tau = part.x;
    vec3 from = ew_emitter_place(emitter, tau);
    for (int i = 1; i <= EW_GLOSS_CHORDS; ++i) {
        float next = clamp(peak + width * tan(mix(angles.x, angles.y, float(i) / float(EW_GLOSS_CHORDS))), part.x, part.y);
        vec3 to = ew_emitter_place(emitter, next);
        vec4 weights = vec4(emitter.weight_place.x + vec2(tau, next) * emitter.weight_place.y, emitter.pieces);
        sum += ew_gloss_of_segment(surface, gloss, from, to, core, weights);
        from = to;
        tau = next;
    }
    return sum;
}

float ew_gloss_of_bend(const ew_surface surface, const ew_gloss gloss, const ew_curve_block block, const vec2 weight_places,
                       const vec2 pieces)
{
    ew_polynomial_curve curve = ew_make_polynomial_curve(block);
    float core = ew_light_core(block.glow);
    float slope = weight_places.y - weight_places.x;
    ew_emitter emitter = ew_emitter(curve.c0 - surface.position, curve.c1, curve.c2, vec2(curve.first, curve.last),
                                    vec2(weight_places.x - curve.first * slope, slope), pieces, vec2(0.0), vec2(0.0), vec2(0.0), 0.0);
    ew_find_peaks(emitter, curve.has_vertex, core);
    float vertex = clamp(emitter.vertex, curve.first, curve.last);
    float sum = 0.0;
    for (int arm = 0; arm < 2; ++arm) {
        vec2 part = mix(vec2(vertex, curve.last), vec2(curve.first, vertex), bvec2(arm == 0));
        float peak = clamp(mix(emitter.peaks.y, emitter.peaks.x, arm == 0), part.x, part.y);
        if (part.x < part.y) sum += ew_gloss_of_arm(surface, gloss, emitter, part, peak, core);
    }
    return sum;
}
