// What is mirrored of all sources.

#undef EW_SHINE
#define EW_SHINE(block, read, step) block source = read(i); sum += ew_shine(source.color, ew_gloss_of(surface, gloss, source)); i += step(i);

// G of gloss.glsl, as a colour.
vec3 ew_gloss_of_all(const ew_surface surface, const ew_gloss gloss)
{
    vec3 sum = vec3(0.0);
    EW_ADD_KINDS
    return min(ew_light_gain() * sum, vec3(EW_MAX_IRRADIANCE));
}
