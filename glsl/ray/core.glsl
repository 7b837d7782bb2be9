// Cores, in which the field is constant, and reaches, at which it ends. `glow` is a source's: see layout.glsl.

// The view depth at s is x + s y, in units of ray space.
vec2 ew_view_depth = vec2(0.0);

#ifdef EW_CORE_PIXELS
// The squared radius that a core has at the eye.
float ew_core_radius2(const vec4 glow)
{
    return glow.x * glow.x + ew_frame.core_floor.z;
}

// The squared growth of its radius with s.
float ew_core_growth2()
{
    return ew_frame.core_floor.x * ew_view_depth.y * ew_view_depth.y;
}

// The squared radius at s: r^2 + (k / 2 rho z)^2, so that no core is thinner than the pixels it is seen by.
float ew_core2(const vec4 glow, const float s)
{
    float depth = ew_view_depth.x + s * ew_view_depth.y;
    return ew_core_radius2(glow) + ew_frame.core_floor.x * depth * depth;
}

// How fast it grows there: half of the squared radius's growth, relative to that.
float ew_core_tilt(const vec4 glow, const float s)
{
    float depth = ew_view_depth.x + s * ew_view_depth.y;
    return ew_frame.core_floor.x * depth * ew_view_depth.y / ew_core2(glow, s);
}
#else
float ew_core2(const vec4 glow, const float s)
{
    return glow.x * glow.x;
}

float ew_core_tilt(const vec4 glow, const float s)
{
    return 0.0;
}
#endif

// b2, k and s0 of the field in the core: 1 / r' is a reciprocal distance whose square is quadratic along the ray, too.
vec3 ew_field_in_core(const vec4 glow, const float s0)
{
#ifdef EW_CORE_PIXELS
    return vec3(ew_core_radius2(glow), max(ew_core_growth2(), 1e-30), -ew_view_depth.x / ew_view_depth.y);
#else
    return vec3(glow.x * glow.x, 1e-30, s0);
#endif
}

// Whether a ray whose squared distance grows by k y^2 looks along a line, so that between the edges of its core is the light outside. See
// ew_find_core.
bool ew_is_around(const float k)
{
#ifdef EW_CORE_PIXELS
    return k < ew_core_growth2();
#else
    return false;
#endif
}

// Where the core is as wide as the reach, nothing is left of the light: the s at which that begins.
float ew_last_lit(const vec4 glow)
{
#ifdef EW_CORE_PIXELS
    float radius2 = glow.y * glow.y - ew_core_radius2(glow);
    float depth = sqrt(max(radius2, 0.0) / max(ew_frame.core_floor.x, 1e-30));
    return mix(-1.0, (depth - ew_view_depth.x) / ew_view_depth.y, radius2 > 0.0);
#else
    return 1e30;
#endif
}

// In the world integral every source has a reach, and compilers need not ask.
bool ew_has_reach(const vec4 glow)
{
#ifdef EW_WORLD
    return true;
#else
    return glow.y > 0.0;
#endif
}

// 1 / R; 0 without a reach.
float ew_inverse_reach(const vec4 glow)
{
#ifdef EW_REACH
    return mix(0.0, 1.0 / glow.y, glow.y > 0.0);
#else
    return 0.0;
#endif
}

// The part of [0, end] on which b2 + k (s - s0)^2 < radius^2; empty, x >= y, where there is none.
vec2 ew_chord_of(const float b2, const float k, const float s0, const float radius, const float end)
{
    float half_chord = sqrt(max((radius - sqrt(b2)) * (radius + sqrt(b2)), 0.0) / k);
    return vec2(clamp(s0 - half_chord, 0.0, end), clamp(s0 + half_chord, 0.0, end));
}

// The part of a segment that is within `radius` of `center`.
vec2 ew_sphere_chord(const ew_segment segment, const vec3 center, const float radius)
{
    vec3 to_center = center - segment.origin;
    float k = ew_length_squared(segment.direction);
    float s0 = dot(to_center, segment.direction) / k;
    float b2 = ew_length_squared(to_center - s0 * segment.direction);
    return ew_chord_of(b2, k, s0, radius, segment.end);
}
