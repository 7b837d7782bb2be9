// The integral of a reciprocal distance whose square is quadratic along the ray, in fog: what the closed form of quadrature.glsl is
// without. docs/method.md, section 16, has the derivation.

// More panels than any part takes.
const int EW_MAX_FOG_PANELS = 64;

// Of moments about the middle of a panel whose source is so many half lengths away, little is left but rounding.
const float EW_QUINTIC_FAR = 8.0;

// How long a panel of ew_integrate_quintic may be from s on, for the polynomial to err by 4e-6 or, with a decay, by 4e-4 at worst and mostly
// by 1e-4. With a decay it errs most where the fog thickens.
float ew_longest_quintic(const float s, const vec4 weight)
{
    float steepness = ew_fog_extinction + ew_body_extinction;
#ifdef EW_FOG_HEIGHT
#ifdef EW_WORLD
    const float of_thinning = 1.0;
#else
    const float of_thinning = 0.4;
#endif
    steepness = ew_fog_extinction_at(s) + ew_body_extinction + max(of_thinning * ew_fog_rise, -1.5 * ew_fog_rise);
#endif
    float scale = 1.0 / steepness;
#ifdef EW_WORLD
    // The ends and joints of a path cancel but for little, so an error of one of them counts many times.
    float way = 0.9 * scale;
#else
    float way = 1.9 * scale;
    float depth = s + ew_beta();
    float near = depth;
#ifdef EW_FOG_HEIGHT
    near *= mix(0.6, 1.0, ew_fog_rise > 0.0);
#endif
    way = min(min(way, near + 0.3 * scale), 2.0 * depth);
#endif
    way *= mix(0.7, 1.0, ew_tolerance() > 3e-4);
#ifdef EW_WEIGHTS
    way *= mix(1.0, 0.4, weight.y != 0.0 || weight.z != 0.0);
#endif
#ifdef EW_FOG_HEIGHT
    way = max(min(way, 2.4 * abs(ew_fog_inverse_rise)), ew_way_through_thin_fog(s, 1.0));
#endif
    return way;
}

// exp(x) for |x| < 2. Relative error 4e-4 at the ends, and 3e-5 where |x| < 1.4. Fog may be so thick that the shortest panel is more; then it
// hides all that is in it, and x is bounded so that its powers are floats.
vec3 ew_small_power(vec3 x)
{
    x = clamp(0.5 * x, -1.0, 1.0);
    vec3 root = 1.0 + x * (1.0 + x * (0.5 + x * (0.16666667 + x * (0.041666667 + x * (0.0083333333 + x * 0.0013888889)))));
    return root * root;
}

// (exp(x) - 1) / x for |x| < 1.5: the mean of the extinction over x scales of height, relative to where they begin. Relative error 2e-5.
vec3 ew_small_mean(const vec3 x)
{
    return 1.0 + x * (0.5 + x * (0.16666667 + x * (0.041666667 + x * (0.0083333333 + x * (0.0013888889 +
                 x * (0.00019841270 + x * 0.000024801587))))));
}

#ifdef EW_FOG_HEIGHT
// The scales of height by which places of a panel that is so long, `way` from its middle, are below that. A panel of more of them than the
// series take is one in which there is next to no fog.
vec3 ew_scales_in_panel(const vec3 way, const float size)
{
    return mix(-ew_fog_rise * way, vec3(0.0), bvec3(abs(ew_fog_rise) * size > 2.5));
}
#endif

// The transmittance at places of a panel that is so long, `way` from its middle, where `fog` is, over that in the middle.
vec3 ew_transmittance_in_panel(const vec2 fog, const vec3 way, const float size)
{
#ifdef EW_FOG_HEIGHT
    float middle = mix(fog.y, 0.0, abs(ew_fog_rise) * size > 2.5);
    return ew_small_power(-way * (middle * ew_small_mean(ew_scales_in_panel(way, size)) + ew_body_extinction));
#else
    return ew_small_power(-way * (fog.y + ew_body_extinction));
#endif
}

// A panel. t goes from -1 to 1 along it, linear in s; or, with a decay, in v = 1 / (s + beta), as there the field in v is 1 / r with r^2
// quadratic, too: see ew_integrate_reciprocal.
struct ew_quintic_panel {
    vec3 s;    // at t = -1, 0 and 1
    vec3 rate; // the growth of s with t there
    float h;   // that of what t is linear in, without its sign
#ifndef EW_WORLD
    vec3 v;
#endif
};

ew_quintic_panel ew_map_quintic(const vec2 ends)
{
    ew_quintic_panel panel;
    float size = ends.y - ends.x;
#ifdef EW_WORLD
    panel.s = vec3(ends.x, 0.5 * (ends.x + ends.y), ends.y);
    panel.h = 0.5 * size;
    panel.rate = vec3(panel.h);
#else
    vec3 depth = vec3(ends.x + ew_beta(), 0.0, ends.y + ew_beta());
    float part = 1.0 / (depth.x + depth.z);
    panel.s = vec3(ends.x, ends.x + size * (depth.x * part), ends.y);
    depth.y = 2.0 * depth.x * depth.z * part;
    panel.v = vec3(1.0 / depth.x, 0.0, 1.0 / depth.z);
    panel.v.y = 0.5 * (panel.v.x + panel.v.z);
    panel.h = 0.5 * size * panel.v.x * panel.v.z;
    panel.rate = panel.h * depth * depth;
#endif
    return panel;
}

// What multiplies the field, at t = -1, 0 and 1.
struct ew_smooth_factor {
    vec3 value;
    vec3 slope; // with t
};

// The transmittance over that in the middle, where `fog` is, times the weight.
ew_smooth_factor ew_smooth_in_panel(const ew_quintic_panel panel, const vec2 fog, const vec4 weight)
{
    float size = panel.s.z - panel.s.x;
    vec3 way = panel.s - panel.s.y;
#ifdef EW_FOG_HEIGHT
    vec3 x = ew_scales_in_panel(way, size);
    float middle = mix(fog.y, 0.0, abs(ew_fog_rise) * size > 2.5);
    vec3 extinction = middle + middle * x * ew_small_mean(x) + ew_body_extinction;
#else
    float extinction = ew_fog_extinction + ew_body_extinction;
#endif
    vec3 value = ew_transmittance_in_panel(fog, way, size);
    vec3 slope = -value * extinction * panel.rate;
#ifdef EW_WEIGHTS
    vec3 along = panel.s - weight.w;
    vec3 weights = weight.x + along * (weight.y + along * weight.z);
    slope = slope * weights + value * panel.rate * (weight.y + 2.0 * along * weight.z);
    value *= weights;
#endif
    return ew_smooth_factor(value, slope);
}

// The integral over t of the polynomial that has the factor's values and slopes.
float ew_integrate_factor(const ew_smooth_factor factor)
{
    return (7.0 / 15.0) * (factor.value.x + factor.value.z) + (16.0 / 15.0) * factor.value.y +
           (1.0 / 15.0) * (factor.slope.x - factor.slope.z);
}

// The integral over a panel of h / r times the polynomial in t that has the factor's values and slopes, with r^2 = b2 + k (s - s0)^2, or
// that times v^2.
float ew_integrate_over_distance(const ew_quintic_panel panel, const float b2, const float k, const float s0, const ew_smooth_factor factor)
{
    float even = 0.5 * (factor.value.z + factor.value.x) - factor.value.y;
    float odd = 0.5 * (factor.value.z - factor.value.x) - factor.slope.y;
    float fourth = 0.25 * (factor.slope.z - factor.slope.x) - even;
    float fifth = 0.25 * (factor.slope.z + factor.slope.x) - 0.5 * factor.slope.y - 1.5 * odd;
    float third = odd - fifth;
    float second = even - fourth;

    // r and, times c, how far the place is from where r is least.
    vec3 y = panel.s - s0;
    vec3 r = sqrt(b2 + k * y * y);
#ifdef EW_WORLD
    float c = k;
    vec3 away = k * y;
    float inverse_root = inversesqrt(max(c, 1e-30));
    float least2 = b2;
#else
    r *= panel.v;
    float g = k * (s0 + ew_beta());
    float c = b2 + g * (s0 + ew_beta());
    vec3 away = (g * y - b2) * panel.v;
    float inverse_root = inversesqrt(max(c, 1e-30));
    float least2 = k * b2 * inverse_root * inverse_root;
#endif
    // The moments of h / r, as in ew_find_moments.
    float unit = inverse_root / max(panel.h, 1e-30);
    vec2 sum = r.xz + abs(away.xz) * inverse_root;
    bool is_beside = away.x * away.z < 0.0;
    float larger = mix(max(sum.x, sum.y), sum.x * sum.y, is_beside);
    float smaller = mix(min(sum.x, sum.y), max(least2, 1e-30), is_beside);
    float place = -away.y * inverse_root * unit;
    float square = r.y * r.y * unit * unit;
    float r_sum = (r.z + r.x) * unit;
    float r_difference = (r.z - r.x) * unit;
    float moment0 = 0.69314718 * log2(larger / smaller);
    float moment1 = r_difference + place * moment0;
    float moment2 = 0.5 * (r_sum + 3.0 * place * moment1 - square * moment0);
    float moment3 = (1.0 / 3.0) * (r_difference + 5.0 * place * moment2 - 2.0 * square * moment1);
    float moment4 = 0.25 * (r_sum + 7.0 * place * moment3 - 3.0 * square * moment2);
    float moment5 = 0.2 * (r_difference + 9.0 * place * moment4 - 4.0 * square * moment3);
    float light = inverse_root * (factor.value.y * moment0 + factor.slope.y * moment1 + second * moment2 + third * moment3 +
                                  fourth * moment4 + fifth * moment5);
    // Far away, the quotient is next to a polynomial, too.
    vec3 inverse_r = 1.0 / max(r, 1e-30);
    ew_smooth_factor quotient = ew_smooth_factor(factor.value * inverse_r, vec3(0.0));
    quotient.slope = (factor.slope - panel.h * away * quotient.value * inverse_r) * inverse_r;
    return mix(light, panel.h * ew_integrate_factor(quotient), square > EW_QUINTIC_FAR * EW_QUINTIC_FAR);
}

// The integral over a panel of weight (1 / sqrt(b2 + k (s - s0)^2) - 1 / R) in fog, and with the decay. The weight is
// weight.x + weight.y y + weight.z y^2 with y = s - weight.w. What multiplies 1 / r is taken for the polynomial that has its values and
// slopes at t = -1, 0 and 1.
float ew_integrate_quintic(const float b2, const float k, const float s0, const vec2 ends, const vec4 weight, const float inverse_reach)
{
    ew_quintic_panel panel = ew_map_quintic(ends);
    vec2 fog = ew_fog_at(panel.s.y);
    ew_smooth_factor factor = ew_smooth_in_panel(panel, fog, weight);
#ifdef EW_REACH
    float at_reach = inverse_reach * panel.h * ew_integrate_factor(factor);
#endif
#ifndef EW_WORLD
    factor.slope = factor.slope * panel.v - panel.h * factor.value;
    factor.value *= panel.v;
#endif
    float light = ew_integrate_over_distance(panel, b2, k, s0, factor);
#ifdef EW_REACH
    light -= at_reach;
#endif
    return mix(0.0, light * ew_transmittance_of(vec4(fog.x)).x, ends.y > ends.x);
}

// The same over a part, with the core, in which 1 / r' takes the place of the reciprocal distance. Panels end at the core's edges. Between core.x
// and core.y is the core or, if that `is_around` it, the light outside.
float ew_integrate_in_fog(const float b2, const float k, const float s0, const vec2 part, vec2 core, const bool is_around, const vec4 weight,
                          const vec4 glow)
{
    core = mix(part.yy, clamp(core, part.x, part.y), bvec2(core.x < core.y));
    vec3 in_core = ew_field_in_core(glow, s0);
    float sum = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        bool is_between = from >= core.x && from < core.y;
        float stop = mix(mix(part.y, core.y, is_between), core.x, from < core.x);
        vec3 field = mix(vec3(b2, k, s0), in_core, bvec3(is_between != is_around));
        float to = min(from + ew_longest_quintic(from, weight), stop);
        sum += ew_integrate_quintic(field.x, field.y, field.z, vec2(from, to), weight, ew_inverse_reach(glow));
        from = to;
    } while (from < part.y && ++panel < EW_MAX_FOG_PANELS);
    return sum;
}
