// The irradiance of all sources.

// Irradiances are cut here, far above what any target shows, so that sums and products of them stay finite.
const float EW_MAX_IRRADIANCE = 1e30;

#ifdef EW_SHADOWS
// Less light than this, of a source on a white surface, casts no shadow: it is less than the step of a target of 8 bits.
const float EW_LEAST_SHADED = 2e-3;

// Where between their ends this pixel picks from equal shares of the light.
float ew_pick_offset = 0.5;

// The light that there would be without shadows, in the sources' units.
vec3 ew_unshaded = vec3(0.0);

// The share of the picked places from which light gets to the surface: see shadow.glsl.
float ew_visible_share(const ew_surface surface, const float core);

void ew_start_picking(const float light)
{
    for (int i = 0; i < EW_PICK_COUNT; ++i)
        ew_pick_sums[i] = light * (float(i) + ew_pick_offset) / float(EW_PICK_COUNT);
    ew_pick_sum = 0.0;
}
#define EW_IS_SHADED(source) (light * source.color.w * ew_light_gain() > EW_LEAST_SHADED)
// The light, and where it casts a shadow once more, to pick from it. A loop, because compilers put the light into the shader for every
// place that calls it.
#define EW_LIGHT_OR_PICK(source) light = mix(ew_irradiance_of(surface, source), light, picks); picks = !picks && EW_IS_SHADED(source);
#define EW_LIGHT_AND_PICK(source) do { EW_LIGHT_OR_PICK(source) if (picks) ew_start_picking(light); } while (picks);
#define EW_SHADE(source) ew_pick_sums = vec4(-1.0); light *= ew_visible_share(surface, ew_light_core(source.glow));
#define EW_UNSHADED(source) ew_unshaded += ew_shine(source.color, light);
#define EW_CAST(source) EW_LIGHT_AND_PICK(source) EW_UNSHADED(source) if (EW_IS_SHADED(source)) { EW_SHADE(source) }
#define EW_FIND_LIGHT(source) float light = 0.0; bool picks = false; EW_CAST(source)
#else
#define EW_FIND_LIGHT(source) float light = ew_irradiance_of(surface, source);
#endif

#define EW_RECEIVE(source) EW_FIND_LIGHT(source) sum += ew_shine(source.color, light);
#define EW_SHINE(block, read, step) block source = read(i); EW_RECEIVE(source) i += step(i);
#undef EW_ADD_KIND
#define EW_RECEIVE_ALL(block, read, step) if (i < end) { do { EW_SHINE(block, read, step) } while (i < end); }
#define EW_ADD_KIND(block, read, step, first, last, count) EW_EACH(first, last, count, EW_RECEIVE_ALL(block, read, step))

// `color` is a source's: its w is the coefficient.
vec3 ew_shine(const vec4 color, const float irradiance)
{
    return clamp(color.w * irradiance, 0.0, EW_MAX_IRRADIANCE) * color.rgb;
}

// E(P) of emitter.glsl, as a colour. Error 1e-2 of the largest of the picture, but for rare places: see docs/method.md.
vec3 ew_irradiance_of_all(const ew_surface surface)
{
    vec3 sum = vec3(0.0);
    EW_ADD_KINDS
    return min(ew_light_gain() * sum, vec3(EW_MAX_IRRADIANCE));
}
