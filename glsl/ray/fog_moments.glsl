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
const float EW_CUBIC_FAR = 24.0;

// How long a panel from s on may be. In the core it is no longer than half of what makes that as wide as it is. No panel holds both of the
// parts of a core that is around the light outside of it.
float ew_longest_cubic(const float s, const float k, const vec2 core, const vec4 glow)
{
#ifdef EW_FOG_HEIGHT
    float way = ew_cubic_length() / (ew_fog_extinction_at(s) + ew_body_extinction + abs(ew_fog_rise));
    way = max(way, ew_way_through_thin_fog(s, 1.0));
#else
    float way = ew_cubic_length() / (ew_fog_extinction + ew_body_extinction);
#endif
#ifdef EW_CORE_PIXELS
    float widening = ew_view_depth.x / ew_view_depth.y + s + sqrt(ew_core_radius2(glow) / max(ew_core_growth2(), 1e-30));
    float longest_in_core = mix(0.25, 0.5, ew_tolerance() > 3e-4) * widening;
    if (ew_is_around(k)) way = min(way, s < core.x ? min(longest_in_core, core.x - s) : s < core.y ? core.y - s : longest_in_core);
    else way = mix(way, min(way, max(longest_in_core, core.x - s)), core.x < core.y && s < core.y);
#endif
    return way;
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
    bool is_long = abs(rise) > 1.5;
    e = mix(e, 0.0, is_long);
    rise = mix(rise, 0.0, is_long);
    // Of the extinction e, that of the fog, f, changes: f' = -rise f.
    float bend = rise * radius * fog.y;
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
    return ew_transmittance_of(vec4(fog.x)).x * cubic;
}

// The moments about 0 of a light that is spread over `size` around `at`, evenly but for a tilt: that is what it adds to the first one.
vec4 ew_moments_of_spread(const float light, const float tilt, const float size, const float at)
{
    float spread = size * size * (1.0 / 12.0);
    float at2 = at * at;
    return vec4(light, light * at + tilt, light * (at2 + spread) + 2.0 * at * tilt,
                light * at * (at2 + 3.0 * spread) + tilt * (3.0 * at2 + 1.8 * spread));
}

// From moments about 0 to those about `place`.
vec4 ew_shift_moments(const vec4 moments, const float place)
{
    float second = moments.z + place * (place * moments.x - 2.0 * moments.y);
    float third = moments.w - place * (3.0 * moments.z + place * (place * moments.x - 3.0 * moments.y));
    return vec4(moments.x, moments.y - place * moments.x, second, third);
}

// Where the core is, by s.
vec2 ew_core_on_ray(const float b2, const float k, const float s0, const vec4 glow)
{
    return s0 + ew_core_of(b2, k, s0, glow);
}

// The light of a part of the core, in which 1 / r' is next to linear, and its tilt.
vec2 ew_light_of_core(const vec2 part, const vec4 glow)
{
    float size = part.y - part.x;
#ifdef EW_CORE_PIXELS
    float light = size / (sqrt(ew_core2(glow, part.x)) + sqrt(ew_core2(glow, part.y)));
    float depths = 2.0 * ew_view_depth.x + (part.x + part.y) * ew_view_depth.y;
    float tilt = (-1.0 / 3.0) * ew_frame.core_floor.x * ew_view_depth.y * depths * light * light * light;
    return vec2(light * ew_atanh_series(ew_core_growth2() * light * light), tilt);
#else
    return vec2(size / glow.x, 0.0);
#endif
}

// The moments about `middle` of 1 / max(r', sqrt(b2 + k (s - s0)^2)) - 1 / R over a part of the ray: with d the root and y = s - s0,
//
//     y / d  has the antiderivative  d / k,
//     y^2 / d  (y d - b2 (that of 1 / d)) / 2 k,  and  y^3 / d  (y^2 d - 2 b2 (that of y / d)) / 3 k.
//
// Far away these would be small differences. But there the field is next to a parabola.
vec4 ew_moments_of_part(const float b2, const float k, float s0, const vec2 core, const vec2 part, const float middle, const vec4 glow)
{
    // Of empty parts, whose source may be anywhere, powers must be floats, too.
    s0 = clamp(s0, middle - 1e9, middle + 1e9);
    vec2 inner = clamp(core, part.x, part.y);
    vec4 ends = vec4(part.x, inner, part.y);
#ifdef EW_CORE_PIXELS
    // Of a core around the light outside of it, the part holds what is before or behind that light, which s0 divides.
    if (ew_is_around(k)) {
        ends = vec4(inner.x, vec2(clamp(s0, inner.x, inner.y)), inner.y);
        inner = mix(vec2(inner.y, part.y), vec2(part.x, inner.x), bvec2(part.x < inner.x));
    }
#endif
    vec4 y = ends - s0;
    vec4 d = sqrt(max(b2 + k * y * y, 1e-30));
    vec2 inverse_sum = 1.0 / (d.yw + d.xz);
    vec2 size = ends.yw - ends.xz;
    // The light outside of the core: as in ew_integrate_outside. The core may be beside s0, where a ray looks nearly along a line. Then
    // d - sqrt(k) y counts, too, of which rounding would leave little: it is b2 / (d + sqrt(k) y).
    float root_k = sqrt(k);
    float inverse_k = 1.0 / k;
    vec4 power = d + root_k * abs(y);
    power = mix(power, max(b2, 1e-30) / power, lessThan(vec4(-y.xy, y.zw), vec4(0.0)));
    vec2 q = size * inverse_sum;
    float both = (q.x + q.y) / (1.0 + k * q.x * q.y);
    float x2 = k * both * both;
    float logarithm = 0.69314718 * log2(power.x * power.w / (power.y * power.z)) * (root_k * inverse_k);
    float light = mix(logarithm, both * ew_atanh_series(x2), x2 < 0.1);

    vec4 y_d = y * d;
    vec4 y2_d = y * y_d;
    float first = dot(q, y.yw + y.xz);
    vec4 moments = vec4(light, first, (y_d.y - y_d.x + y_d.w - y_d.z - b2 * light) * 0.5 * inverse_k,
                        (y2_d.y - y2_d.x + y2_d.w - y2_d.z - 2.0 * b2 * first) * (1.0 / 3.0) * inverse_k);
    moments = ew_shift_moments(moments, middle - s0);

    // Far away the field bends but little. If both sides are far away, that of the core between them is next to theirs.
    bvec2 is_lit = greaterThan(size, vec2(0.0));
    vec2 outside = mix(ends.zy, ends.xw, is_lit);
    float width = outside.y - outside.x;
    float center = 0.5 * (outside.x + outside.y);
    float inverse = mix(inverse_sum.x, inverse_sum.y, is_lit.y);
    bool is_far = 4.0 > EW_CUBIC_FAR * EW_CUBIC_FAR * k * width * width * inverse * inverse;
    vec2 of_core = ew_light_of_core(inner, glow);
    bool is_one = is_far && is_lit.x && is_lit.y && ends.y < ends.z;
    light += mix(0.0, of_core.x, is_one);
    float closeness = k * inverse * inverse * width * width;
    float away = center - s0;
    float tilt = light * closeness * away * (-1.0 / 3.0);
    // The second derivative of 1 / d is k (2 k y^2 - b2) / d^4 times itself, and what it adds to the second moment its 360th part, times
    // the light and the fourth power of the width.
    float bend = light * closeness * closeness * (16.0 / 360.0) * (2.0 * away * away - b2 * inverse_k);
    center -= middle;
    vec4 far_moments = ew_moments_of_spread(light, tilt, width, center) + vec4(0.0, 0.0, bend, 3.0 * center * bend);
    moments = mix(moments, far_moments, bvec4(is_far));
    of_core = mix(of_core, vec2(0.0), bvec2(is_one));
    moments += ew_moments_of_spread(of_core.x, of_core.y, inner.y - inner.x, 0.5 * (inner.x + inner.y) - middle);
    float whole = part.y - part.x;
    return moments - ew_moments_of_spread(ew_inverse_reach(glow) * whole, 0.0, whole, 0.5 * (part.x + part.y) - middle);
}

// The light of a panel, and the transmittance in its middle.
vec2 ew_integrate_panel(const float b2, const float k, const float s0, const vec2 core, const vec2 panel, const vec4 glow)
{
    float middle = 0.5 * (panel.x + panel.y);
    vec4 transmittance = ew_transmittance_cubic(middle, 0.5 * (panel.y - panel.x));
    return vec2(dot(ew_moments_of_part(b2, k, s0, core, panel, middle, glow), transmittance), transmittance.x);
}
#endif

// What ew_integrate_within_reach is, by quintics.
float ew_integrate_by_rule(const float b2, const float k, const float s0, const vec2 part, const vec4 glow)
{
    vec2 core = s0 + ew_core_of(b2, k, s0, glow);
    return ew_integrate_in_fog(b2, k, s0, part, core, ew_is_around(k), vec4(1.0, 0.0, 0.0, 0.0), glow);
}

// What ew_integrate_floored_reciprocal is, less 1 / R, in fog.
float ew_integrate_within_reach(const float b2, const float k, const float s0, const vec2 part, const vec4 glow)
{
#ifdef EW_WORLD
    vec2 core = ew_core_on_ray(b2, k, s0, glow);
    float sum = 0.0;
    float first = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        float to = min(from + ew_longest_cubic(from, k, core, glow), part.y);
        vec2 light = ew_integrate_panel(b2, k, s0, core, vec2(from, to), glow);
        sum += light.x;
        first = mix(first, light.y, panel == 0);
        from = mix(to, part.y, light.y <= EW_FOG_HIDDEN * first);
    } while (from < part.y && ++panel < EW_MAX_FOG_PANELS);
    return sum;
#else
    return ew_integrate_by_rule(b2, k, s0, part, glow);
#endif
}
