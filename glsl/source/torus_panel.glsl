// The integral over one panel beside a torus, by a product rule: the peak 1 / |x - own_zero| is integrated exactly against the
// polynomial that interpolates the rest of the integrand. docs/method.md, section 5, has the derivation.

// m is chosen so that the nearest singularities before and beyond the panel are equally far away in t. They are other_zero,
// which is `clearance` before the panel, and depth = 0. On the way away from the eye, depth = 0 lies before the panel too: it
// counts as beyond the panel's end, seen through infinity.
ew_panel ew_map_torus_panel(const ew_torus_side side, const float from, const float size, const float clearance)
{
#ifdef EW_WORLD
    // Without a decay only other_zero is singular, before the panel; beyond it, a place so far away that it does not matter.
    float depth = 1e3 * (size + clearance);
    bool is_nearing = false;
#else
    float depth = side.depth + side.depth_slope * from;
    bool is_nearing = side.depth_slope < 0.0;
#endif
    float before = is_nearing ? clearance : min(clearance, depth);
    float beyond = is_nearing ? depth - size : max(clearance, depth);
    float from_before = size + 2.0 * before;
    float to_beyond = is_nearing ? size + 2.0 * beyond : -size - 2.0 * beyond;
    float mean = 4.0 * sqrt(before * (before + size) * beyond * (beyond + size));
    float m = size * (to_beyond - from_before) / (from_before * to_beyond - size * size + (is_nearing ? mean : -mean));
    return ew_panel(from, size, m, 1.0 - m * m, 0.5 * size * (1.0 - m), depth);
}

// The values of a function of t at the nodes: right at +EW_PANEL_NODES, left at -EW_PANEL_NODES.
struct ew_at_nodes {
    vec3 right;
    vec3 left;
};

ew_at_nodes ew_even_plus_odd(const vec3 even, const vec3 odd)
{
    return ew_at_nodes(even + odd, even - odd);
}

// (1 - m t) f for f = value + slope (1 + t) / (1 - m t), a linear function of x.
ew_at_nodes ew_linear_at_nodes(const float value, const float slope, const float m)
{
    return ew_even_plus_odd(vec3(value + slope), (slope - value * m) * EW_PANEL_NODES);
}

// (1 - m t)^2 times the squared distance from the axis.
ew_at_nodes ew_from_axis2_at_nodes(const ew_torus_side side, const ew_panel panel)
{
    float from_axis2 = side.from_axis2 + panel.from * (2.0 * side.outward + side.across2 * panel.from);
    float outward = (side.outward + side.across2 * panel.from) * panel.scale;
    float across2 = side.across2 * panel.scale * panel.scale;
    float m = panel.m;
    vec3 even = (from_axis2 + 2.0 * outward + across2) + (from_axis2 * m * m - 2.0 * outward * m + across2) * EW_PANEL_NODES2;
    vec3 odd = (2.0 * (across2 - from_axis2 * m + outward * (1.0 - m))) * EW_PANEL_NODES;
    return ew_even_plus_odd(even, odd);
}

// 4 (1 - m t)^2 |x - other_zero|^2.
ew_at_nodes ew_other_zero_at_nodes(const ew_torus_side side, const ew_panel panel)
{
    vec2 other = 2.0 * vec2(panel.from - side.other_zero.x, side.other_zero.y);
    vec2 constant = vec2(other.x + 2.0 * panel.scale, other.y);
    vec2 slope = vec2(2.0 * panel.scale - other.x * panel.m, -other.y * panel.m);
    return ew_even_plus_odd(dot(constant, constant) + dot(slope, slope) * EW_PANEL_NODES2,
                            2.0 * dot(constant, slope) * EW_PANEL_NODES);
}

#ifdef EW_FOG
// The s at x on a side.
float ew_s_on_side(const ew_torus_side side, const float x)
{
    return side.center + side.depth_slope * x;
}

// How far places of a panel are from its middle, by s.
vec3 ew_way_in_panel(const ew_torus_side side, const ew_panel panel, const vec3 t)
{
    return side.depth_slope * (panel.scale * (1.0 + t) / (1.0 - panel.m * t) - 0.5 * panel.size);
}
#endif

// direction2 times the integral over x in [from, from + size] of 1 / (distance depth^2), in fog less 1 / R, where other_zero is `clearance` away
// from `from`. Multiplied by 1 - m t and by |t - zero|, the integrand is smooth; through its values at six nodes goes the
// polynomial. Relative error mostly far below 1e-4, at worst 3.5e-4 for panels no longer than ew_integrate_torus_panels makes
// them.
float ew_integrate_torus_panel(const ew_torus_side side, const float from, const float size, const float clearance)
{
    ew_panel panel = ew_map_torus_panel(side, from, size, clearance);
    ew_mapped_zero zero = ew_map_zero(side.own_zero, panel);

    // If the zero is far away, the moments would cancel; but then 1 / |t - zero| is smooth too, and Gauss's weights serve.
    ew_moments moments = ew_find_moments(zero);
    bool is_far = zero.square > 4.0;
    vec3 even = is_far ? EW_PANEL_WEIGHTS : 0.5 * (EW_PANEL_LAGRANGE * moments.even);
    vec3 odd = is_far ? vec3(0.0) : (0.5 / EW_PANEL_NODES) * (EW_PANEL_LAGRANGE * moments.odd);
    ew_at_nodes own2 = ew_even_plus_odd(zero.square + EW_PANEL_NODES2, -2.0 * zero.place * EW_PANEL_NODES);

    ew_at_nodes shrink = ew_even_plus_odd(vec3(1.0), -panel.m * EW_PANEL_NODES);
    ew_at_nodes from_axis2 = ew_from_axis2_at_nodes(side, panel);
    vec3 beyond_right = sqrt(max(from_axis2.right, 0.0)) + side.radius * shrink.right;
    vec3 beyond_left = sqrt(max(from_axis2.left, 0.0)) + side.radius * shrink.left;
    ew_at_nodes height = ew_linear_at_nodes(side.height + side.height_slope * from, side.height_slope * panel.scale, panel.m);
    ew_at_nodes divisor = ew_other_zero_at_nodes(side, panel);
    divisor.right *= is_far ? own2.right : vec3(1.0);
    divisor.left *= is_far ? own2.left : vec3(1.0);
#ifdef EW_WORLD
    vec3 right = sqrt((beyond_right * beyond_right + height.right * height.right) / divisor.right) / shrink.right;
    vec3 left = sqrt((beyond_left * beyond_left + height.left * height.left) / divisor.left) / shrink.left;
#else
    ew_at_nodes depth = ew_linear_at_nodes(panel.depth, side.depth_slope * panel.scale, panel.m);
    vec3 depth2_right = depth.right * depth.right;
    vec3 depth2_left = depth.left * depth.left;
    divisor.right *= depth2_right * depth2_right;
    divisor.left *= depth2_left * depth2_left;
    vec3 right = shrink.right * sqrt((beyond_right * beyond_right + height.right * height.right) / divisor.right);
    vec3 left = shrink.left * sqrt((beyond_left * beyond_left + height.left * height.left) / divisor.left);
#endif
#ifdef EW_FOG
    vec2 fog = ew_fog_at(ew_s_on_side(side, from + 0.5 * size));
    float in_middle = ew_transmittance_of(vec4(fog.x)).x;
    vec3 transmittance_right = in_middle * ew_transmittance_in_panel(fog, ew_way_in_panel(side, panel, EW_PANEL_NODES), size);
    vec3 transmittance_left = in_middle * ew_transmittance_in_panel(fog, ew_way_in_panel(side, panel, -EW_PANEL_NODES), size);
    right *= transmittance_right;
    left *= transmittance_left;
#endif
    ew_evaluation_count += 6;
#ifdef EW_FOG
    // What is taken away at the reach, by Gauss's rule.
    vec3 measure_right = transmittance_right / (shrink.right * shrink.right);
    vec3 measure_left = transmittance_left / (shrink.left * shrink.left);
#ifndef EW_WORLD
    measure_right *= shrink.right * shrink.right / depth2_right;
    measure_left *= shrink.left * shrink.left / depth2_left;
#endif
    float direction2 = side.across2 + side.height_slope * side.height_slope;
    float at_reach = 0.5 * size * panel.m_complement * dot(EW_PANEL_WEIGHTS, measure_right + measure_left);
    return 2.0 * size * panel.m_complement * inversesqrt(zero.scale2) * (dot(even, right + left) + dot(odd, right - left))
           - direction2 * ew_inverse_reach(side.glow) * at_reach;
#else
    return 2.0 * size * panel.m_complement * inversesqrt(zero.scale2) * (dot(even, right + left) + dot(odd, right - left));
#endif
}
