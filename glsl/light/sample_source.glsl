// A sample of the field of one source. C puts this file into the shader once for each kind that has an ew_distance_squared, with
// EW_SOURCE defined as the kind's block.
float ew_sample_at(EW_SOURCE source, vec3 position, float s)
{
    float weight;
    float distance_squared = ew_distance_squared(source, position, weight);
    return ew_sample(distance_squared, s, source.glow) * weight;
}
