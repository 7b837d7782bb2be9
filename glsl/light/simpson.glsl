// The published method, kept as a baseline: Simpson's rule (23) with n divisions and n + 1 samples. (Thesis (4.7) misses f(1).)
//
// C puts this file into the shader once for each kind, with EW_SOURCE defined as the kind's block.

// The integral over a segment. `others` is for the adaptive integrator: equal divisions have no tolerance.
float ew_integrate(ew_segment segment, EW_SOURCE source, float others)
{
    int divisions = ew_simpson_divisions();
#ifdef EW_REACH
    vec2 part = ew_sampled_part(segment, ew_chord(segment, source), source.glow);
#else
    vec2 part = vec2(0.0, segment.end);
#endif
    float step_length = (part.y - part.x) / float(divisions);
    float sum = 0.0;
    for (int i = 0; i <= divisions; ++i) {
        float s = part.x + float(i) * step_length;
        float weight;
        float distance_squared = ew_distance_squared(source, segment.origin + s * segment.direction, weight);
        // 1, 4, 2, 4, ..., 4, 1
        float simpson_weight = i == 0 || i == divisions ? 1.0 : (i & 1) == 1 ? 4.0 : 2.0;
        sum += simpson_weight * ew_sample(distance_squared, s, source.glow) * weight;
    }
    return sum * step_length / 3.0;
}
