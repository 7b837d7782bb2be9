// The world integral of what is nearest to the ray as a point or a line is, in fog: closed forms for the moments of its field, against a
// cubic that stands for the transmittance. docs/method.md, section 16, has the derivation.

#ifdef EW_WORLD
// A panel's length, times extinction and growth of that. The cubic's error is at most 2e-4 of the transmittance in its middle; for the
// quality of 1e-4, a quarter of that.
float ew_cubic_length()
{
    return mix(0.53, 0.76, ew_tolerance() > 3e-4);
}

// Of a source's light, what has so small a share of the transmittance where it begins does not count.
const float EW_FOG_HIDDEN = 2e-9;
// Of moments about a place that is so many half lengths away, little is left but rounding.
const float EW_FOG_FAR = 24.0;
// Of a panel that is so many half lengths away from the source, even the light is a small difference.
const float EW_FOG_VERY_FAR = 1000.0;

// How long a panel from s on may be. Where the field is of a core that widens, it is no longer than half of what makes that as wide as it
// is, unless there is next to no fog in it.
float ew_longest_cubic(const float s, const vec4 glow)
{
#ifdef EW_FOG_HEIGHT
    float way = ew_cubic_length() / (ew_fog_extinction_at(s) + ew_body_extinction + abs(ew_fog_rise));
#else
    float way = ew_cubic_length() / (ew_fog_extinction + ew_body_extinction);
#endif
#ifdef EW_CORE_PIXELS
    float widening = ew_view_depth.x / ew_view_depth.y + s + sqrt(ew_core_radius2(glow) / max(ew_core_growth2(), 1e-30));
    way = max(min(way, 0.5 * widening), 0.02 * way);
#endif
    return max(way, ew_way_through_thin_fog(s, 1.0));
}

// The transmittance at y from the middle of a panel, |y| <= radius: x + y (y + y (z + y w)). It is Taylor's series of order five, whose last
// two terms are economized. In a panel that is too long for it there is next to no fog, and one that is too short for powers of it is a
// place.
vec4 ew_transmittance_cubic(const float middle, const float radius)
{
    vec2 fog = ew_fog_at(middle);
    float e = (fog.y + ew_body_extinction) * radius;
#ifdef EW_FOG_HEIGHT
    float rise = ew_fog_rise * radius;
    e = mix(e, 0.0, abs(rise) > 1.5);
    // Of the extinction e, that of the fog, f, changes: f' = -rise f.
    float f = mix(fog.y * radius, 0.0, abs(rise) > 1.5);
    rise = mix(rise, 0.0, abs(rise) > 1.5);
    float bend = rise * f;
    float second = bend + e * e;
    float third = -(rise * bend + e * (3.0 * bend + e * e));
    float fourth = bend * (rise * rise + 3.0 * bend) + e * (4.0 * rise * bend + e * (6.0 * bend + e * e));
    float fifth = -(rise * bend * (rise * rise + 10.0 * bend) + e * (bend * (5.0 * rise * rise + 15.0 * bend) +
                                                                     e * (10.0 * rise * bend + e * (10.0 * bend + e * e))));
#else
    float second = e * e;
    float third = -e * second;
    float fourth = second * second;
    float fifth = e * -fourth;
#endif
    float inverse = mix(1.0 / radius, 0.0, radius < 1e-10);
    float inverse2 = inverse * inverse;
    vec4 cubic = vec4(1.0, inverse * (-e - fifth * (0.3125 / 120.0)), inverse2 * (0.5 * second + fourth * (0.8 / 24.0)),
                      inverse * inverse2 * ((1.0 / 6.0) * third + fifth * (1.25 / 120.0)));
    return exp2(-1.44269504 * clamp(fog.x, 0.0, 100.0)) * cubic;
}

// The integrals of 1, y, y^2 and y^3 from y.x to y.y.
vec4 ew_moments_of_one(const vec2 y)
{
    vec2 y2 = y * y;
    float way = y.y - y.x;
    float sum = y.y + y.x;
    return way * vec4(1.0, 0.5 * sum, (1.0 / 3.0) * (y2.x + y2.y + y.x * y.y), 0.25 * sum * (y2.x + y2.y));
}

// From moments about 0 to those about `place`.
vec4 ew_shift_moments(const vec4 moments, const float place)
{
    float second = moments.z + place * (place * moments.x - 2.0 * moments.y);
    float third = moments.w - place * (3.0 * moments.z + place * (place * moments.x - 3.0 * moments.y));
    return vec4(moments.x, moments.y - place * moments.x, second, third);
}

// The moments about `middle` of 1 / max(r', sqrt(b2 + k (s - s0)^2)) - 1 / R over a part of the ray: with d the root and y = s - s0,
//
//     y / d  has the antiderivative  d / k,
//     y^2 / d  (y d - b2 (that of 1 / d)) / 2 k,  and  y^3 / d  (y^2 d - 2 b2 (that of y / d)) / 3 k.
vec4 ew_moments_of_part(const float b2, const float k, float s0, const vec2 part, const float middle, const vec4 glow)
{
    // Of empty parts, whose source may be anywhere, powers must be floats, too.
    s0 = clamp(s0, middle - 1e9, middle + 1e9);
    vec2 y = part - s0;
    vec2 core = ew_core_of(b2, k, s0, glow);
    vec2 inside = clamp(core, y.xx, y.yy);
    float place = middle - s0;
    vec2 from = vec2(y.x, inside.y);
    vec2 to = vec2(inside.x, y.y);
    vec2 d_from = sqrt(b2 + k * from * from);
    vec2 d_to = sqrt(b2 + k * to * to);
    vec2 first = (to - from) * (to + from) / max(d_from + d_to, 1e-30);
    vec2 second = to * d_to - from * d_from;
    vec2 third = to * to * d_to - from * from * d_from;
    vec4 outside;
    outside.x = ew_integrate_outside(b2, k, y, core);
    outside.y = first.x + first.y;
    outside.z = (second.x + second.y - b2 * outside.x) * 0.5 / k;
    outside.w = (third.x + third.y - 2.0 * b2 * outside.y) * (1.0 / 3.0) / k;
    outside = ew_shift_moments(outside, place);

    // The core, in which 1 / r' is next to linear.
    float size = inside.y - inside.x;
    float at = 0.5 * (inside.x + inside.y) - place;
    vec2 slope = inversesqrt(vec2(ew_core2(glow, s0 + inside.x), ew_core2(glow, s0 + inside.y)));
    float in_core = ew_integrate_core(s0 + inside.x, s0 + inside.y, glow);
    vec4 moments = outside + in_core * vec4(1.0, at, at * at + size * size * (1.0 / 12.0), at * (at * at + 0.25 * size * size));
    moments.y += (slope.y - slope.x) * size * size * (1.0 / 12.0);
    moments -= ew_inverse_reach(glow) * ew_moments_of_one(part - middle);

    // Far away the field is smooth but for the core's edge, and Gauss's rule serves.
    float radius = 0.5 * (part.y - part.x);
    float center = 0.5 * (part.y + part.x);
    vec3 node = radius * vec3(-0.77459667, 0.0, 0.77459667);
    vec3 to_source = center - s0 + node;
    vec3 core2 = vec3(ew_core2(glow, center + node.x), ew_core2(glow, center), ew_core2(glow, center + node.z));
    vec3 field = inversesqrt(max(b2 + k * to_source * to_source, core2)) - ew_inverse_reach(glow);
    field *= radius * vec3(0.55555556, 0.88888889, 0.55555556);
    vec3 from_middle = center - middle + node;
    vec3 square = from_middle * from_middle;
    float distance2 = b2 + k * to_source.y * to_source.y;
    bool is_very_far = distance2 > EW_FOG_VERY_FAR * EW_FOG_VERY_FAR * k * radius * radius;
    float light = mix(moments.x, field.x + field.y + field.z, is_very_far);
    vec4 by_gauss = vec4(light, dot(field, from_middle), dot(field, square), dot(field, square * from_middle));
    bool is_far = distance2 > EW_FOG_FAR * EW_FOG_FAR * k * radius * radius;
    return mix(moments, by_gauss, bvec4(is_far));
}
#endif

// What ew_integrate_within_reach is, by the product rule.
float ew_integrate_by_rule(const float b2, const float k, const float s0, const vec2 part, const vec4 glow)
{
    return ew_integrate_in_fog(b2, k, s0, part, s0 + ew_core_of(b2, k, s0, glow), vec4(1.0, 0.0, 0.0, 0.0), glow);
}

// What ew_integrate_floored_reciprocal is, less 1 / R, in fog.
float ew_integrate_within_reach(const float b2, const float k, const float s0, const vec2 part, const vec4 glow)
{
#ifdef EW_WORLD
    float sum = 0.0;
    float first = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        float to = min(from + ew_longest_cubic(from, glow), part.y);
        float middle = 0.5 * (from + to);
        vec4 moments = ew_moments_of_part(b2, k, s0, vec2(from, to), middle, glow);
        vec4 transmittance = ew_transmittance_cubic(middle, 0.5 * (to - from));
        sum += dot(moments, transmittance);
        first = mix(first, transmittance.x, panel == 0);
        from = mix(to, part.y, transmittance.x < EW_FOG_HIDDEN * first);
    } while (from < part.y && ++panel < EW_MAX_FOG_PANELS);
    return sum;
#else
    return ew_integrate_by_rule(b2, k, s0, part, glow);
#endif
}
