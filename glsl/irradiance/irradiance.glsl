// The irradiance of all sources.

// Irradiances are cut here, far above what any target shows, so that sums and products of them stay finite.
const float EW_MAX_IRRADIANCE = 1e30;

#define EW_SHINE(block, read) block source = read(EW_PLACE(i)); sum += ew_shine(source.color, ew_irradiance_of(surface, source)); ++i;
#undef EW_ADD_KIND
#define EW_ADD_KIND(block, read, kind, count) EW_EACH(kind, count, if (i < end) { do { EW_SHINE(block, read) } while (i < end); })

// `color` is a source's: its w is the coefficient.
vec3 ew_shine(vec4 color, float irradiance)
{
    return clamp(color.w * irradiance, 0.0, EW_MAX_IRRADIANCE) * color.rgb;
}

// E(P) of emitter.glsl, as a colour. Error 1e-2 of the largest of the picture.
vec3 ew_irradiance_of_all(ew_surface surface)
{
    vec3 sum = vec3(0.0);
    EW_ADD_KINDS
    return min(ew_light_gain() * sum, vec3(EW_MAX_IRRADIANCE));
}
