// What lights a surface: sources as thin emitters along their shapes. A piece dl of a source, of coefficient c and weight w, has
// the radiant intensity c w dl, evenly in all directions; a point has c r, r its core's radius. A surface at P with the unit normal
// n receives the irradiance
//
//     E(P) = gain * sum over the sources of  color c integral of  w max(0, n . l) k(|C - P|)  |dC|,    l the unit vector from P to C,
//     k(d) = (1 / m - m / L^2)^2,    m = max(r, d),    and 0 beyond the distance L, the light's reach:
//
// the inverse square of the distance, constant in the core, cut so that it comes to 0 with its slope. In ray space, whose unit of
// length the gain of the uniform block makes up for.

// Of Gauss and Legendre, on [-1, 1].
const float EW_EMITTER_NODES[6] = float[6](-0.9324695142, -0.6612093865, -0.2386191861, 0.2386191861, 0.6612093865, 0.9324695142);
const float EW_EMITTER_WEIGHTS[6] =
    float[6](0.1713244924, 0.3607615730, 0.4679139346, 0.4679139346, 0.3607615730, 0.1713244924);

struct ew_surface {
    vec3 position;
    vec3 normal;
};

// Gain, in the unit of ray space.
float ew_light_gain()
{
    return ew_frame.light.x;
}

// L.
float ew_light_reach()
{
    return ew_frame.light.y;
}

#ifdef EW_SHADOWS
// How thick things are taken to be that cast shadows.
float ew_shadow_thickness()
{
    return ew_frame.core_floor.w;
}
#endif

// r. Where it is hardly a number beside the unit of ray space, its square would be 0.
float ew_light_core(const vec4 glow)
{
    return max(glow.x, 1e-8);
}

// k(d), from d^2.
float ew_light_falloff(const float distance_squared, const float core)
{
    float reach2 = ew_square(ew_light_reach());
    float least = max(distance_squared, core * core);
    return ew_square(max(1.0 - least / reach2, 0.0)) / least;
}

// max(0, n . l) k(d) for the place at `offset` from the surface.
float ew_light_at(const ew_surface surface, const vec3 offset, const float core)
{
    float distance_squared = ew_length_squared(offset);
    return max(dot(surface.normal, offset), 0.0) * inversesqrt(max(distance_squared, 1e-30)) * ew_light_falloff(distance_squared, core);
}

#ifdef EW_SHADOWS
// Places of a source that shed equal shares of its light: shadows are looked for on the way to these. A source's integral runs
// twice. The first time says how much there is, and the second picks the places where the sum passes the shares' middles.
const int EW_PICK_COUNT = 4;
vec4 ew_pick_sums = vec4(-1.0); // at which to pick
float ew_pick_sum = 0.0;        // of all parts so far
vec3 ew_picked[EW_PICK_COUNT];  // relative to the surface

// How far into a part of that much light each place lies, as a share of the light; beyond [0, 1) if in none of it.
vec4 ew_shares_in_part(const float light)
{
    vec4 shares = (ew_pick_sums - ew_pick_sum) / max(light, 1e-30);
    ew_pick_sum += light;
    return mix(shares, vec4(-1.0), lessThan(ew_pick_sums, vec4(0.0)));
}

// Picks from a straight part, whose light is about even over the angle under which it is seen.
void ew_pick_between(const float light, const vec3 start, const vec3 end)
{
    vec4 shares = ew_shares_in_part(light);
    vec3 way = end - start;
    float way2 = max(ew_length_squared(way), 1e-30);
    float foot = -dot(start, way) / way2;
    float width = max(length(start + foot * way) / sqrt(way2), 1e-6);
    vec2 angles = atan((vec2(0.0, 1.0) - foot) / width);
    for (int i = 0; i < EW_PICK_COUNT; ++i) {
        float t = clamp(foot + width * tan(mix(angles.x, angles.y, shares[i])), 0.0, 1.0);
        if (shares[i] >= 0.0 && shares[i] < 1.0) ew_picked[i] = start + t * way;
    }
}

// Picks from a part that is small beside its distance, whose light is about even along it.
void ew_pick_along(const float light, const vec3 start, const vec3 way)
{
    vec4 shares = ew_shares_in_part(light);
    for (int i = 0; i < EW_PICK_COUNT; ++i)
        if (shares[i] >= 0.0 && shares[i] < 1.0) ew_picked[i] = start + shares[i] * way;
}
#define EW_PICK_BETWEEN(light, start, end) ew_pick_between(light, start, end)
#define EW_PICK_ALONG(light, start, way) ew_pick_along(light, start, way)
#else
#define EW_PICK_ALONG(light, start, way)
#define EW_PICK_BETWEEN(light, start, end)
#endif
