// The integral of a reciprocal distance whose square is quadratic along the ray, in fog: what the closed form of quadrature.glsl is
// without. docs/method.md, section 16, has the derivation.

// The optical depth of a panel: over so little the transmittance is a polynomial within 1e-4 of its mean; with a weight, which takes
// two of the five degrees, over half of it.
#ifdef EW_WEIGHTS
const float EW_FOG_PANEL = 1.0;
#else
const float EW_FOG_PANEL = 2.0;
#endif
// More panels than any part takes.
const int EW_MAX_FOG_PANELS = 64;

// The longest panel from s on. With a decay, 1 / v must be a polynomial of v, too: see ew_map_fog_panel.
float ew_longest_fog_panel(const float s, const float along, const float optical_depth)
{
    float way = ew_longest_in_fog(s, along, optical_depth);
#ifndef EW_WORLD
    way = max(min(way, 0.5 * (s + ew_beta())), ew_way_through_thin_fog(s, along));
#endif
    return way;
}

// Of moments about the middle of a panel whose source is so many half lengths away, little is left but rounding.
const float EW_QUINTIC_FAR = 8.0;

// How long a panel of ew_integrate_quintic may be from s on, for the polynomial to err by 4e-4 at worst, and mostly by 1e-4. With a decay it
// errs most where the fog thickens.
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
    float way = 1.9 * scale;
#ifndef EW_WORLD
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

// exp(x) for |x| < 2. Relative error 4e-4 at the ends, and 3e-5 where |x| < 1.4.
vec3 ew_small_power(vec3 x)
{
    x *= 0.5;
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

// The integral over a panel of weight (1 / sqrt(b2 + k (s - s0)^2) - 1 / R) in fog, and with the decay. The weight is
// weight.x + weight.y y + weight.z y^2 with y = s - weight.w. t goes from -1 to 1 along the panel, linear in s; or, with a decay, in
// v = 1 / (s + beta), as there the field in v is 1 / r with r^2 quadratic, too: see ew_integrate_reciprocal. What multiplies 1 / r is taken for the
// polynomial that has its values and slopes at -1, 0 and 1.
float ew_integrate_quintic(const float b2, const float k, const float s0, const vec2 panel, const vec4 weight, const float inverse_reach)
{
    float size = panel.y - panel.x;
#ifdef EW_WORLD
    vec3 s = vec3(panel.x, 0.5 * (panel.x + panel.y), panel.y);
    float h = 0.5 * size;
    // The growth of s with t.
    vec3 rate = vec3(h);
#else
    vec3 depth = vec3(panel.x + ew_beta(), 0.0, panel.y + ew_beta());
    float part = 1.0 / (depth.x + depth.z);
    vec3 s = vec3(panel.x, panel.x + size * (depth.x * part), panel.y);
    depth.y = 2.0 * depth.x * depth.z * part;
    vec3 v = vec3(1.0 / depth.x, 0.0, 1.0 / depth.z);
    v.y = 0.5 * (v.x + v.z);
    float h = 0.5 * size * v.x * v.z;
#if defined(EW_REACH) || defined(EW_WEIGHTS)
    vec3 rate = h * depth * depth;
#endif
#endif

    // The transmittance over that in the middle, and its slope.
    vec2 fog = ew_fog_at(s.y);
    vec3 way = s - s.y;
#ifdef EW_FOG_HEIGHT
    vec3 x = ew_scales_in_panel(way, size);
    float middle = mix(fog.y, 0.0, abs(ew_fog_rise) * size > 2.5);
    vec3 extinction = middle + middle * x * ew_small_mean(x) + ew_body_extinction;
#else
    float extinction = ew_fog_extinction + ew_body_extinction;
#endif
    vec3 smooth_at = ew_transmittance_in_panel(fog, way, size);
#if defined(EW_WORLD) || defined(EW_REACH) || defined(EW_WEIGHTS)
    vec3 slope = -smooth_at * extinction * rate;
#endif
#ifdef EW_WEIGHTS
    vec3 along = s - weight.w;
    vec3 weights = weight.x + along * (weight.y + along * weight.z);
    slope = slope * weights + smooth_at * rate * (weight.y + 2.0 * along * weight.z);
    smooth_at *= weights;
#endif
#ifdef EW_REACH
    float at_reach = inverse_reach * ((16.0 / 15.0) * smooth_at.y + (7.0 / 15.0) * (smooth_at.x + smooth_at.z) +
                                      (1.0 / 15.0) * (slope.x - slope.z));
#endif
#ifndef EW_WORLD
#if defined(EW_REACH) || defined(EW_WEIGHTS)
    slope = slope * v - h * smooth_at;
#else
    vec3 slope = -h * smooth_at * (1.0 + extinction * depth);
#endif
    smooth_at *= v;
#endif
    float even = 0.5 * (smooth_at.z + smooth_at.x) - smooth_at.y;
    float odd = 0.5 * (smooth_at.z - smooth_at.x) - slope.y;
    float fourth = 0.25 * (slope.z - slope.x) - even;
    float fifth = 0.25 * (slope.z + slope.x) - 0.5 * slope.y - 1.5 * odd;
    float third = odd - fifth;
    float second = even - fourth;

    // r and, times c, how far the place is from where r is least.
    vec3 y = s - s0;
    vec3 r = sqrt(b2 + k * y * y);
#ifdef EW_WORLD
    float c = k;
    vec3 away = k * y;
#else
    r *= v;
    float g = k * (s0 + ew_beta());
    float c = b2 + g * (s0 + ew_beta());
    vec3 away = (g * y - b2) * v;
#endif
    // The moments of h / r, as in ew_find_moments.
    float inverse_root = inversesqrt(max(c, 1e-30));
#ifdef EW_WORLD
    float least2 = b2;
#else
    float least2 = k * b2 * inverse_root * inverse_root;
#endif
    float unit = inverse_root / max(h, 1e-30);
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
    float light = inverse_root * (smooth_at.y * moment0 + slope.y * moment1 + second * moment2 + third * moment3 + fourth * moment4 +
                                  fifth * moment5);
    // Far away, the quotient is next to a polynomial, too.
    vec3 inverse_r = 1.0 / max(r, 1e-30);
    vec3 quotient = smooth_at * inverse_r;
    vec2 bend = (slope.xz - h * away.xz * quotient.xz * inverse_r.xz) * inverse_r.xz;
    float far_light = h * ((7.0 / 15.0) * (quotient.x + quotient.z) + (16.0 / 15.0) * quotient.y + (1.0 / 15.0) * (bend.x - bend.y));
    light = mix(light, far_light, square > EW_QUINTIC_FAR * EW_QUINTIC_FAR);
#ifdef EW_REACH
    light -= h * at_reach;
#endif
    return mix(0.0, light * ew_transmittance_of(vec4(fog.x)).x, size > 0.0);
}

// b2, k and s0 of the field in the core, 1 / r'.
vec3 ew_field_in_core(const vec4 glow, const float s0)
{
#ifdef EW_CORE_PIXELS
    return vec3(ew_core_radius2(glow), max(ew_core_growth2(), 1e-30), -ew_view_depth.x / ew_view_depth.y);
#else
    return vec3(glow.x * glow.x, 1e-30, s0);
#endif
}

// The same over a part, with the core, in which 1 / r' takes the place of the reciprocal distance: it is of the same form. Panels end at the
// core's edges.
float ew_integrate_in_fog(const float b2, const float k, const float s0, const vec2 part, vec2 core, const vec4 weight, const vec4 glow)
{
    core = mix(part.yy, clamp(core, part.x, part.y), bvec2(core.x < core.y));
    vec3 in_core = ew_field_in_core(glow, s0);
    float sum = 0.0;
    float from = part.x;
    int panel = 0;
    do {
        bool is_in_core = from >= core.x && from < core.y;
        float stop = mix(mix(part.y, core.y, is_in_core), core.x, from < core.x);
        vec3 field = mix(vec3(b2, k, s0), in_core, bvec3(is_in_core));
        float to = min(from + ew_longest_quintic(from, weight), stop);
        sum += ew_integrate_quintic(field.x, field.y, field.z, vec2(from, to), weight, ew_inverse_reach(glow));
        from = to;
    } while (from < part.y && ++panel < EW_MAX_FOG_PANELS);
    return sum;
}
