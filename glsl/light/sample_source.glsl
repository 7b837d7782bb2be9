// A sample of the field of one source. C puts this file into the shader once for each kind that has an ew_distance_squared, with
// EW_SOURCE defined as the kind's block.
float ew_sample_at(const EW_SOURCE source, const vec3 position, const float s)
{
    float weight;
    float distance_squared = ew_distance_squared(source, position, weight);
    return ew_sample(distance_squared, s, source.glow) * weight;
}
