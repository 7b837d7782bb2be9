// What shaders of the host's call.
//
// Rays start at `origin`, relative to the eye, along the axes of the world, and reach origin + x direction at their parameter
// x. S is at x = interval.x and E at x = interval.y > interval.x; the opaque scene is at x = opaque. With a direction of unit
// view depth, x is the view depth, as it is in ew_frame_desc; with a unit direction, it is the distance.

// Brings a point (w = 1) or a vector (w = 0) from the host's space to ray space.
vec3 ew_to_ray_space(vec3 v, float w)
{
    vec4 place = vec4(v, w);
    return vec3(dot(ew_frame.ray_space_x, place), dot(ew_frame.ray_space_y, place), dot(ew_frame.ray_space_z, place));
}

#ifdef EW_IRRADIANCE
// The light of all sources that a surface at `position` with the unit normal `normal` receives: see emitter.glsl.
vec3 ew_irradiance(vec3 position, vec3 normal)
{
    return ew_irradiance_of_all(ew_surface(ew_to_ray_space(position, 1.0), normalize(ew_to_ray_space(normal, 0.0))));
}

// What such a surface mirrors of all sources towards `to_eye`, which need not be unit: see gloss.glsl. The lobe of a roughness, from
// 0.1 to 1, has the exponent 2 / roughness^4 - 2, as the usual match of Phong's lobe to GGX's does.
vec3 ew_specular(vec3 position, vec3 normal, vec3 to_eye, float roughness)
{
    ew_surface surface = ew_surface(ew_to_ray_space(position, 1.0), normalize(ew_to_ray_space(normal, 0.0)));
    vec3 mirrored = reflect(-normalize(ew_to_ray_space(to_eye, 0.0)), surface.normal);
    float exponent = max(2.0 / pow(clamp(roughness, 0.1, 1.0), 4.0) - 2.0, 1.0);
    return ew_gloss_of_all(surface, ew_gloss(mirrored, exponent));
}
#endif

#ifdef EW_MEDIA
// What the media do to what is opaque at x = `opaque`: their own light, and the share of its light that they let through.
vec4 ew_media_light(vec3 origin, vec3 direction, float opaque)
{
    ew_fog_begin = 0.0;
    vec4 over = ew_integrate_media(ew_segment(ew_to_ray_space(origin, 1.0), ew_to_ray_space(direction, 0.0), clamp(opaque, 0.0, 1e15)));
    return vec4(over.rgb, 1.0 - over.a);
}
#endif

#ifdef EW_WORLD
// The light of the ray from `origin` on, sum B_i color_i, and B as the fourth component. Cores are as wide as pixels by the view depth
// along the ray, which is taken not to fall.
vec4 ew_light(vec3 origin, vec3 direction, float opaque)
{
    vec3 start = ew_to_ray_space(origin, 1.0);
    vec3 step = ew_to_ray_space(direction, 0.0);
    ew_view_depth = vec2(ew_frame.core_floor.y - start.z, max(-step.z, 1e-6));
    return ew_integrate_all(ew_segment(start, step, clamp(opaque, 0.0, 1e15)));
}

// B.
float ew_luminance(vec3 origin, vec3 direction, float opaque)
{
    return ew_light(origin, direction, opaque).a;
}
#else
// sum B_i color_i, and B as the fourth component.
vec4 ew_light(vec3 origin, vec3 direction, vec2 interval, float opaque)
{
    float interval_length = interval.y - interval.x;
    vec3 start = ew_to_ray_space(origin + interval.x * direction, 1.0);
    vec3 to_end = ew_to_ray_space(interval_length * direction, 0.0);
    ew_view_depth = vec2(ew_frame.core_floor.y - start.z, max(-to_end.z, 1e-6));
#ifdef EW_FOG
    ew_fog_begin = -interval.x / interval_length;
#endif
    return ew_integrate_all(ew_segment(start, to_end, clamp((opaque - interval.x) / interval_length, 0.0, 1.0)));
}

// B.
float ew_luminance(vec3 origin, vec3 direction, vec2 interval, float opaque)
{
    return ew_light(origin, direction, interval, opaque).a;
}
#endif
