// The ray through a place of the target.

bool ew_is_perspective()
{
    return ew_frame.choices.z == 1;
}

// The segment of the ray from S to E. `pixel` is relative to the pixel of NDC (0, 0).
ew_segment ew_pixel_segment(const vec2 pixel)
{
    vec4 ray = ew_frame.ray_center + pixel.x * ew_frame.ray_right + pixel.y * ew_frame.ray_up;
#ifdef EW_WORLD
    float span = ew_span();
#else
    const float span = 1.0;
#endif
    ew_view_depth = vec2(ew_frame.core_floor.y, 1.0);
#ifdef EW_FOG
    ew_fog_begin = ew_fog.density.y;
#endif
    return ew_segment(vec3(ray.xy, 0.0), vec3(ray.zw, -1.0), span);
}
