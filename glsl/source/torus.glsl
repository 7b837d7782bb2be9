// Tori.

// More panels than any ray takes: they grow by factors, or are half an optical depth of fog.
#ifdef EW_FOG
const int EW_MAX_TORUS_PANELS = 120;
#else
const int EW_MAX_TORUS_PANELS = 40;
#endif

// direction2 times the integral over both sides of what is not in the cores, from the cut outwards: the near side first, if
// there is one, then the far side. Panels are no longer than a multiple of the distance from what is singular around them.
float ew_integrate_torus_panels(const ew_torus_side near, const vec2 near_core, const ew_torus_side far, const vec2 far_core)
{
    float longest = ew_tolerance() > 3e-3 ? 8.0 : ew_tolerance() > 3e-4 ? 4.0 : 0.6;
#ifdef EW_SHARPNESS
    // The relative error grows by the sharpness.
    longest /= max(far.glow.z, 1.0);
#endif
    bool is_near = near.end > 0.0;
    ew_torus_side side = far;
    if (is_near) side = near;
    vec2 core = is_near ? near_core : far_core;
    float from = core.x > side.begin ? side.begin : core.y;
    float stop = core.x > side.begin ? core.x : side.end;
    float sum = 0.0;
    for (int panel = 0; panel < EW_MAX_TORUS_PANELS; ++panel) {
        float clearance = max(length(vec2(from - side.other_zero.x, side.other_zero.y)), 1e-6);
        float depth = side.depth + side.depth_slope * from;
        float remaining = max(stop - from, 0.0);
#ifdef EW_WORLD
        float size = longest * clearance;
#else
        float size = min(longest * clearance, depth * (is_near ? longest / (4.0 + longest) : 0.5 * longest));
#endif
#ifdef EW_FOG
        size = min(size, ew_longest_in_fog(ew_s_on_side(side, from), side.depth_slope, 0.5));
#endif
        bool reaches_stop = size >= remaining;
        size = reaches_stop ? remaining : size;
        float light = ew_integrate_torus_panel(side, from, max(size, 1e-16), 1.5 * clearance);
        sum += remaining > 0.0 ? light : 0.0;
        bool is_side_done = reaches_stop && stop >= side.end;
        if (is_side_done && (!is_near || far.end <= 0.0)) break;

        from = reaches_stop ? core.y : from + size;
        stop = reaches_stop ? side.end : stop;
        if (is_side_done) {
            is_near = false;
            side = far;
            core = far_core;
            from = core.x > side.begin ? side.begin : core.y;
            stop = core.x > side.begin ? core.x : side.end;
        }
    }
    return sum;
}

#ifdef EW_FOG
// The integral over two parts of the ray, by s, that are in the core, of which the near one comes first; less 1 / R. One loop
// serves both, because a software rasteriser goes through each at least once.
float ew_integrate_torus_cores_in_fog(const vec4 cores, const vec4 glow)
{
    vec3 field = ew_field_in_core(glow, cores.x);
    const vec4 weight = vec4(1.0, 0.0, 0.0, 0.0);
    float sum = 0.0;
    float from = cores.x;
    int panel = 0;
    do {
        bool is_near = from < cores.y;
        from = mix(max(from, cores.z), from, is_near);
        float to = min(from + ew_longest_quintic(from, weight), mix(cores.w, cores.y, is_near));
        sum += ew_integrate_quintic(field.x, field.y, field.z, vec2(from, to), weight, ew_inverse_reach(glow));
        from = to;
    } while (from < cores.w && ++panel < EW_MAX_FOG_PANELS);
    return sum;
}
#endif

#ifdef EW_REACH
// The integral over a part of 1 / max(r', distance) - 1 / R, where that is positive.
float ew_integrate_torus_part(const ew_torus_ray ray, const ew_torus_zeros zeros, ew_torus_part part, const vec4 glow)
{
    float sum = 0.0;
    float reach = glow.y > 0.0 ? glow.y : 1e15;
    ew_torus_level reach2 = ew_torus_level(reach * reach, 0.0, 0.0, 0.0);
    vec2 lit = ew_torus_edges(part, reach2, ew_guess_torus_edge(ray, zeros, part.side.radius, reach));
    if (lit.x < lit.y) {
        part.side.begin = lit.x;
        part.side.end = lit.y;
        ew_torus_level core2 = ew_torus_core2(ray, part.side, glow);
        float radius = sqrt(ew_level_at(core2, part.nearest));
        vec2 core = ew_torus_edges(part, core2, ew_guess_torus_edge(ray, zeros, part.side.radius, radius));
        ew_torus_side none = part.side;
        none.end = 0.0;
        sum = ew_integrate_torus_panels(none, vec2(0.0), part.side, core) / ray.direction2;
#ifdef EW_FOG
        vec2 s = vec2(ew_s_on_side(part.side, core.x), ew_s_on_side(part.side, core.y));
        s = vec2(min(s.x, s.y), max(s.x, s.y));
        sum += ew_integrate_torus_cores_in_fog(vec4(s, s.yy), glow);
#else
#if defined(EW_WORLD) && defined(EW_CORE_PIXELS)
        vec2 radii = sqrt(vec2(ew_level_at(core2, core.x), ew_level_at(core2, core.y)));
        sum += ew_integrate_core(radii, core.y - core.x);
#else
        sum += ew_integrate_torus_core(part.side, core, radius);
#endif
        sum -= ew_integrate_torus_core(part.side, lit, reach);
#endif
    }
    return sum;
}

// The integral over a segment of 1 / max(r', distance to a torus) - 1 / R, where that is positive. From the cut on, the
// distance falls on one side of it and grows on the other, on which it may fall once more: so there are three parts at the
// most. Relative error 3e-4 at worst in the scenes of tori at a tolerance of 1e-3.
float ew_integrate(const ew_segment segment, const ew_torus_block torus, const vec2 chord, const float others)
{
    float radius = ew_radius(torus);
    ew_torus_ray ray = ew_make_torus_ray(segment, torus, chord);
    ew_torus_zeros zeros = ew_find_torus_zeros(ray, radius);
    ew_torus_side far = ew_make_torus_side(ray, radius, torus.glow, 1.0, chord.y - ray.center, zeros.plus, zeros.minus);
    ew_torus_side near = ew_make_torus_side(ray, radius, torus.glow, -1.0, ray.center - chord.x, zeros.minus, zeros.plus);
    bool far_falls = far.end > 0.0 ? ew_torus_slope(ray, far, 0.0).x < 0.0 : ew_torus_slope(ray, near, 0.0).x >= 0.0;
    ew_torus_side rising = far;
    ew_torus_side falling = near;
    if (far_falls) {
        rising = near;
        falling = far;
    }
    float nearest = ew_last_approach_to_torus(ray, rising);
    float farthest = ew_farthest_from_torus(ray, rising, nearest);
    float sum = 0.0;
    int part = 0;
    do {
        ew_torus_side side = rising;
        if (part == 0) side = falling;
        side.begin = part == 1 ? farthest : 0.0;
        side.end = part == 2 ? farthest : side.end;
        float place = part == 0 ? ew_last_approach_to_torus(ray, falling) : part == 1 ? nearest : 0.0;
        sum += ew_integrate_torus_part(ray, zeros, ew_make_torus_part(ray, side, place), torus.glow);
    } while (++part < (farthest > 0.0 ? 3 : 2));
    return sum;
}
#else
// The integral over a segment of 1 / max(epsilon, distance to a torus), equation (7). Relative error 3.5e-4 at worst in the
// scenes of tori at a tolerance of 1e-3, except for rounding in tori much larger than the interval.
float ew_integrate(const ew_segment segment, const ew_torus_block torus, const vec2 chord, const float others)
{
    float radius = ew_radius(torus);
    ew_torus_ray ray = ew_make_torus_ray(segment, torus, chord);
    ew_torus_zeros zeros = ew_find_torus_zeros(ray, radius);
    ew_torus_side far = ew_make_torus_side(ray, radius, torus.glow, 1.0, chord.y - ray.center, zeros.plus, zeros.minus);
    ew_torus_side near = ew_make_torus_side(ray, radius, torus.glow, -1.0, ray.center - chord.x, zeros.minus, zeros.plus);

    vec2 far_nearest = ew_nearest_to_torus(ray, far);
    vec2 near_nearest = ew_nearest_to_torus(ray, near);
#ifdef EW_CORE_PIXELS
    // The core's radius where each side is nearest to the torus: over the core it changes by next to nothing.
    float far_epsilon = sqrt(ew_core2(torus.glow, ray.center + min(far_nearest.x, far.end)));
    float near_epsilon = sqrt(ew_core2(torus.glow, ray.center - min(near_nearest.x, near.end)));
#else
    float far_epsilon = torus.glow.x;
    float near_epsilon = torus.glow.x;
#endif
    float distance2_at_cut = ew_square(sqrt(ray.from_axis2) - radius) + ray.height * ray.height;
    float far_guess = ew_guess_torus_edge(ray, zeros, radius, far_epsilon);
    float near_guess = ew_guess_torus_edge(ray, zeros, radius, near_epsilon);
    vec2 far_core = ew_torus_core(far, far_nearest, distance2_at_cut, far_guess, ew_square(far_epsilon));
    vec2 near_core = ew_torus_core(near, near_nearest, distance2_at_cut, near_guess, ew_square(near_epsilon));
    // The two parts of the ray that are in the core, by x of the far side. Without a gap they meet at the cut.
    vec4 cores = vec4(-near_core.yx, far_core);
    bool is_on_both_sides = max(near_core.y, far_core.y) < 1e30;
    if (is_on_both_sides) cores.yz = ew_torus_gap(ray, far, cores.x, cores.w, distance2_at_cut, ew_square(far_epsilon));
    cores = clamp(cores, -near.end, far.end);
    far.begin = max(cores.y, 0.0);
    near.begin = max(-cores.z, 0.0);
    float sum = ew_integrate_torus_panels(near, max(-cores.yx, 0.0), far, max(cores.zw, 0.0)) / ray.direction2;
#ifdef EW_FOG
    sum += ew_integrate_torus_cores_in_fog(ray.center + cores, torus.glow);
#else
    sum += ew_integrate_torus_core(far, cores.xy, near_epsilon) + ew_integrate_torus_core(far, cores.zw, far_epsilon);
#endif
    return sum;
}
#endif
