// Shadows on surfaces, from the opaque depth: whether something stands between a surface and the places from which it gets light.
// Depth tells the front of what is seen and no more. What is off the picture or behind something else casts no shadow, and all
// things are taken to be as thick as the frame says.

// Steps from a surface towards a place.
const int EW_SHADOW_STEPS = 12;

// The pixel, relative to that of NDC (0, 0), at which a place in ray space is seen: the inverse of ew_pixel_segment. Its view
// depth must be positive.
vec2 ew_pixel_of(const vec3 position)
{
    vec2 center = ew_frame.ray_center.xy - position.z * ew_frame.ray_center.zw;
    vec2 right = ew_frame.ray_right.xy - position.z * ew_frame.ray_right.zw;
    vec2 up = ew_frame.ray_up.xy - position.z * ew_frame.ray_up.zw;
    vec2 offset = position.xy - center;
    return vec2(offset.x * up.y - offset.y * up.x, right.x * offset.y - right.y * offset.x) / (right.x * up.y - right.y * up.x);
}

// How large a pixel is at a place, in ray space.
float ew_pixel_size(const vec3 position)
{
    return length(ew_frame.ray_up.xy - position.z * ew_frame.ray_up.zw);
}

bool ew_is_on_picture(const vec2 pixel)
{
    return all(lessThan(abs(pixel), ew_frame.light.zw));
}

// Whether the opaque scene hides a place: it is in front of it, by no more than things are thick.
bool ew_is_hidden(const vec3 position)
{
    vec2 pixel = ew_pixel_of(position);
    if (!ew_is_on_picture(pixel)) return false;
    ivec2 place = ivec2(floor(pixel + ew_frame.pixel_center.xy));
    float opaque = ew_end_of_ray(ew_parameter_of_depth(pixel, ew_depth_of_sample(place, 0)));
    float behind = -position.z - opaque;
    return behind > ew_pixel_size(position) && behind < ew_shadow_thickness();
}

// Whether light comes to `from` from the place at `way` from there. `first`: where between steps this ray looks. The steps are
// short next to the surface, where contacts are seen. The source's own core hides nothing.
bool ew_is_lit_from(const vec3 from, const vec3 way, const float core, const float first)
{
    float depth = ew_frame.core_floor.y - from.z;
    // Rays towards places beside and behind the eye end close to its plane.
    float toward_eye = way.z / max(depth, 1e-30);
    float last = 1.0 - min(core / max(length(way), 1e-30), 1.0);
    if (ew_is_perspective()) last = min(last, 0.95 / max(toward_eye, 0.95));
    for (int i = 0; i < EW_SHADOW_STEPS; ++i) {
        float step = (float(i) + first) / float(EW_SHADOW_STEPS);
        if (ew_is_hidden(from + last * step * step * way)) return false;
    }
    return true;
}

float ew_visible_share(const ew_surface surface, const float core)
{
    // Off the surface by two pixels, which its own depth cannot hide.
    vec3 lift = 2.0 * ew_pixel_size(surface.position) * surface.normal;
    float count = 0.0;
    for (int i = 0; i < EW_PICK_COUNT; ++i)
        if (ew_is_lit_from(surface.position + lift, ew_picked[i] - lift, core, fract(ew_pick_offset + 0.618034 * float(i)))) count += 1.0;
    return count / float(EW_PICK_COUNT);
}
