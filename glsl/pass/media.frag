// Media over the opaque scene: their own light, and the share of the scene's that they stop, for a blend that is premultiplied "over".

out vec4 ew_color;

vec4 ew_media_up_to(const vec2 pixel, const float share)
{
    ew_segment segment = ew_pixel_segment(pixel);
    segment.end = ew_end_of_ray(share);
    return ew_integrate_media(segment);
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - ew_frame.pixel_center.xy;
#ifdef EW_DEPTH_MULTISAMPLE
    ivec2 place = ivec2(gl_FragCoord.xy);
    ew_shaded_samples shaded = ew_samples_to_shade(place);
    int i = shaded.first;
    ew_color = vec4(0.0);
    do {
        ew_color += ew_media_up_to(pixel, ew_parameter_of_depth(pixel, ew_depth_to_shade(shaded, place, i)));
    } while (++i < shaded.end);
    ew_color /= float(shaded.end - shaded.first);
#elif defined(EW_DEPTH)
    ew_color = ew_media_up_to(pixel, ew_parameter_of_depth(pixel, ew_window_depth(ivec2(gl_FragCoord.xy))));
#else
    ew_color = ew_media_up_to(pixel, 1.0);
#endif
#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
}
