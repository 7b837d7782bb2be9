// The light that opaque surfaces receive, for a blend that takes the target's colour as their albedo; or that of a part of the sources:
// see part.frag.

out vec4 ew_color;

// Of the surface at a sample of a pixel; dark where there is none within the light's reach.
vec3 ew_light_on(const ivec2 place, const int sample_index)
{
    float depth = ew_depth_of_sample(place, sample_index);
    vec2 pixel = vec2(place) + 0.5 - ew_frame.pixel_center.xy;
    float share = ew_parameter_of_depth(pixel, depth);
    if (share <= 0.0 || share >= 1.0) return vec3(0.0);
    vec3 position = ew_position_of(pixel, depth);
    return ew_irradiance_of_all(ew_surface(position, ew_normal_of(place, position, sample_index)));
}

#ifdef EW_SHADOWS
// The mean of a value over a pair of the 2 x 2 pixels that are shaded together, where both get about the same light without shadows.
vec3 ew_mean_of_pair(const vec3 share, const vec3 growth, const vec3 unshaded_growth, const vec3 unshaded, const int place)
{
    bool is_alike = all(lessThanEqual(abs(unshaded_growth), 0.25 * unshaded));
    return is_alike ? share + ((place & 1) == 0 ? 0.5 : -0.5) * growth : share;
}

// Light in which the share that shadows leave is the mean over 2 x 2 pixels. Each of them picked other places of the sources, so together
// they know four times as many, and the grain is half as strong.
vec3 ew_smooth_shadows(const vec3 light, const vec3 unshaded, const ivec2 place)
{
    vec3 share = mix(light / max(unshaded, vec3(1e-30)), vec3(1.0), equal(unshaded, vec3(0.0)));
    share = ew_mean_of_pair(share, dFdx(share), dFdx(unshaded), unshaded, place.x);
    share = ew_mean_of_pair(share, dFdy(share), dFdy(unshaded), unshaded, place.y);
    return unshaded * clamp(share, 0.0, 1.0);
}
#endif

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
#ifdef EW_PART
    place += ew_grid.viewport.xy;
#endif
#ifdef EW_LISTS
    ew_tile_row = ew_find_tile_row(place - ew_grid.viewport.xy);
#endif
#ifdef EW_SHADOWS
    ew_pick_offset = ew_gradient_noise(vec2(place) + 0.5);
#endif
    vec3 light = vec3(0.0);
#ifdef EW_DEPTH_MULTISAMPLE
    ew_shaded_samples shaded = ew_samples_to_shade(place);
    int i = shaded.first;
    do {
        light += ew_light_on(place, i);
    } while (++i < shaded.end);
    light /= float(shaded.end - shaded.first);
#else
    light = ew_light_on(place, 0);
#endif
#ifdef EW_SHADOWS
    vec3 unshaded = ew_light_gain() * ew_unshaded;
#ifdef EW_DEPTH_MULTISAMPLE
    unshaded /= float(shaded.end - shaded.first);
    // Of a second surface, the pixels beside may have been discarded.
    if (ew_surface_rank <= 0)
#endif
        light = ew_smooth_shadows(light, min(unshaded, vec3(EW_MAX_IRRADIANCE)), ivec2(gl_FragCoord.xy));
#endif
    ew_color = vec4(min(light, EW_MAX_RADIANCE), 0.0);
}
