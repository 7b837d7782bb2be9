// The published method, kept as a baseline: Simpson's rule (23) with n divisions and n + 1 samples. (Thesis (4.7) misses f(1).)
//
// C puts this file into the shader once for each kind, with EW_SOURCE defined as the kind's block.

// The integral over a segment. `others` is for the adaptive integrator: equal divisions have no tolerance.
float ew_integrate(const ew_segment segment, const EW_SOURCE source, const vec2 chord, const float others)
{
    int divisions = ew_simpson_divisions();
    float step_length = (chord.y - chord.x) / float(divisions);
    float sum = 0.0;
    for (int i = 0; i <= divisions; ++i) {
        float s = chord.x + float(i) * step_length;
        // 1, 4, 2, 4, ..., 4, 1
        float simpson_weight = i == 0 || i == divisions ? 1.0 : (i & 1) == 1 ? 4.0 : 2.0;
        sum += simpson_weight * ew_sample_at(source, segment.origin + s * segment.direction, s);
    }
    return sum * step_length / 3.0;
}
