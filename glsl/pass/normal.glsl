// The normals of opaque surfaces: the host's, or from their depth.

// In ray space.
vec3 ew_position_of(const vec2 pixel, const float depth)
{
    ew_segment segment = ew_pixel_segment(pixel);
    return segment.origin + ew_end_of_ray(ew_parameter_of_depth(pixel, depth)) * segment.direction;
}

// The window depth of a sample of a pixel.
float ew_depth_of_sample(const ivec2 place, const int sample_index)
{
#ifdef EW_DEPTH_MULTISAMPLE
    return ew_window_depth(place, sample_index);
#else
    return ew_window_depth(place);
#endif
}

#ifdef EW_NORMALS
uniform sampler2D ew_normal_texture;

// The unit normal of the surface at a pixel, as the host has it; 0 where that is none.
vec3 ew_normal_of(const ivec2 place, const vec3 position, const int sample_index)
{
    vec3 normal = texelFetch(ew_normal_texture, place, 0).xyz;
    if (ew_frame.choices.y >= 2) normal = 2.0 * normal - 1.0;
    vec3 turned = vec3(dot(ew_frame.ray_space_x.xyz, normal), dot(ew_frame.ray_space_y.xyz, normal), dot(ew_frame.ray_space_z.xyz, normal));
    if ((ew_frame.choices.y & 1) == 0) normal = turned;
    float length_squared = dot(normal, normal);
    // A NaN, which is recognised by its bits, is none either.
    bool is_normal = length_squared > 0.0 && (floatBitsToInt(length_squared) & 0x7fffffff) < 0x7f800000;
    return is_normal ? normal * inversesqrt(length_squared) : vec3(0.0);
}
#else
// What is linear across the picture of a plane: the inverse of the view depth, or in a parallel view the depth itself.
float ew_flat_depth(const ivec2 place, const int sample_index)
{
    vec2 pixel = vec2(place) + 0.5 - ew_frame.pixel_center.xy;
    float along = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_depth_of_sample(place, sample_index)));
    return ew_is_perspective() ? 1.0 / max(ew_frame.core_floor.y + along, 1e-30) : along;
}

// How much the surface bends from `place`, of the flat depth `here`, to the second pixel at `step`. Beyond the viewport there is none
// of this picture.
float ew_bend_of_surface(const ivec2 place, const ivec2 step, const float here, const int sample_index)
{
    vec2 from_center = abs(vec2(place + 2 * step) + 0.5 - ew_frame.pixel_center.xy);
    if (from_center.x >= ew_frame.light.z || from_center.y >= ew_frame.light.w) return 1e30;
    float near = ew_flat_depth(place + step, sample_index);
    return abs(here - 2.0 * near + ew_flat_depth(place + 2 * step, sample_index));
}

vec3 ew_position_beside(const ivec2 place, const int sample_index)
{
    return ew_position_of(vec2(place) + 0.5 - ew_frame.pixel_center.xy, ew_depth_of_sample(place, sample_index));
}

// Along the surface at a pixel towards `axis`: from the pixel before to the one behind. Where the surface ends or bends sharply on
// either side, from the parabola through the pixel and two on the other.
vec3 ew_tangent_of(const ivec2 place, const ivec2 axis, const float here, const vec3 position, const int sample_index)
{
    float back = ew_bend_of_surface(place, -axis, here, sample_index);
    float ahead = ew_bend_of_surface(place, axis, here, sample_index);
    ivec2 side = back < ahead ? -axis : axis;
    vec3 beside = ew_position_beside(place + side, sample_index) - position;
    bool has_both = max(back, ahead) < 1e30 && max(back, ahead) <= 4.0 * min(back, ahead);
    vec3 other = ew_position_beside(has_both ? place - side : place + 2 * side, sample_index) - position;
    vec3 tangent = has_both ? beside - other : 4.0 * beside - other;
    return back < ahead ? -tangent : tangent;
}

// The unit normal of the surface at a pixel, towards the eye.
vec3 ew_normal_of(const ivec2 place, const vec3 position, const int sample_index)
{
    float here = ew_flat_depth(place, sample_index);
    vec3 right = ew_tangent_of(place, ivec2(1, 0), here, position, sample_index);
    vec3 up = ew_tangent_of(place, ivec2(0, 1), here, position, sample_index);
    vec3 normal = cross(right, up);
    float facing = dot(normal, ew_pixel_segment(vec2(place) + 0.5 - ew_frame.pixel_center.xy).direction);
    return normal * (facing > 0.0 ? -1.0 : 1.0) * inversesqrt(max(dot(normal, normal), 1e-30));
}
#endif
