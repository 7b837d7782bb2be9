// The light that opaque surfaces receive, for a blend that takes the target's colour as their albedo.

out vec4 ew_color;

// Of the surface at a sample of a pixel; dark where there is none within the light's reach.
vec3 ew_light_on(ivec2 place, int sample_index)
{
    float depth = ew_depth_of_sample(place, sample_index);
    vec2 pixel = vec2(place) + 0.5 - ew_frame.pixel_center.xy;
    float share = ew_parameter_of_depth(pixel, depth);
    if (share <= 0.0 || share >= 1.0) return vec3(0.0);
    vec3 position = ew_position_of(pixel, depth);
    return ew_irradiance_of_all(ew_surface(position, ew_normal_of(place, position, sample_index)));
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
#ifdef EW_LISTS
    ew_tile_row = ew_find_tile_row(place - ew_grid.viewport.xy);
#endif
#ifdef EW_SHADOWS
    ew_pick_offset = ew_gradient_noise(gl_FragCoord.xy);
#endif
    vec3 light = vec3(0.0);
#ifdef EW_DEPTH_MULTISAMPLE
    for (int i = ew_samples.x; i < ew_samples.y; ++i)
        light += ew_light_on(place, i);
    light /= float(ew_samples.y - ew_samples.x);
#else
    light = ew_light_on(place, 0);
#endif
    ew_color = vec4(min(light, EW_MAX_RADIANCE), 0.0);
}
