// What is mirrored of a point.
float ew_gloss_of(const ew_surface surface, const ew_gloss gloss, const ew_point_block point)
{
    vec3 offset = point.position.xyz - surface.position;
    float core = ew_light_core(point.glow);
    float distance_squared = max(ew_length_squared(offset), 1e-30);
    float cosine = dot(gloss.mirrored, offset) * inversesqrt(distance_squared);
    return dot(surface.normal, offset) > 0.0 ? core * ew_lobe(gloss, cosine) * ew_light_falloff(distance_squared, core) : 0.0;
}
