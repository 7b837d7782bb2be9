// The integral over one panel beside a torus, by a product rule: the peak 1 / |x - own_zero| is integrated exactly against the
// polynomial that interpolates the rest of the integrand. docs/method.md, section 5, has the derivation.

// Gauss's six nodes on [-1, 1] are +-EW_TORUS_NODES, with EW_TORUS_WEIGHTS.
const vec3 EW_TORUS_NODES = vec3(0.23861919, 0.66120939, 0.93246951);
const vec3 EW_TORUS_NODES2 = EW_TORUS_NODES * EW_TORUS_NODES;
const vec3 EW_TORUS_WEIGHTS = vec3(0.46791393, 0.36076157, 0.17132449);
// Lagrange's polynomials for the squares of the nodes: from moments of 1, t^2, t^4 to weights.
const mat3 EW_TORUS_LAGRANGE = mat3(1.23030422, -0.301171601, 0.0708673784, -4.22902436, 5.63573565, -1.40671129, 3.23642249,
                                    -6.08322688, 2.84680439);

// A panel, x in [from, from + size], mapped to t in [-1, 1] by x - from = scale (1 + t) / (1 - m t). A polynomial of x, times a
// power of 1 - m t, is a polynomial of t.
struct ew_torus_panel {
    float from;
    float size;
    float m;            // in (-1, 1)
    float m_complement; // 1 - m^2
    float scale;        // size (1 - m) / 2
    float depth;        // s + beta at `from`
};

// m is chosen so that the nearest singularities before and beyond the panel are equally far away in t. They are other_zero,
// which is `clearance` before the panel, and depth = 0. On the way away from the eye, depth = 0 lies before the panel too: it
// counts as beyond the panel's end, seen through infinity.
ew_torus_panel ew_map_torus_panel(ew_torus_side side, float from, float size, float clearance)
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
    return ew_torus_panel(from, size, m, 1.0 - m * m, 0.5 * size * (1.0 - m), depth);
}

// own_zero in t: t = place +- i height.
struct ew_mapped_zero {
    float place;
    float height2;
    float square; // place^2 + height^2
    float scale2; // |x - own_zero| = |t - zero| sqrt(scale2) / (2 (1 - m t))
};

ew_mapped_zero ew_map_own_zero(ew_torus_side side, ew_torus_panel panel)
{
    vec2 own = vec2(2.0 * (side.own_zero.x - panel.from) - panel.size, 2.0 * side.own_zero.y);
    vec2 own_scale = vec2(panel.size + panel.m * own.x, panel.m * own.y);
    ew_mapped_zero zero;
    zero.scale2 = dot(own_scale, own_scale);
    zero.place = ((own.x + panel.m * panel.size) * own_scale.x + own.y * own_scale.y) / zero.scale2;
    zero.height2 = ew_square(max(abs(own.y) * panel.size * panel.m_complement / zero.scale2, 1e-9));
    zero.square = zero.place * zero.place + zero.height2;
    return zero;
}

// The integrals over t in [-1, 1] of t^i / |t - zero|.
struct ew_torus_moments {
    vec3 even; // i = 0, 2, 4
    vec3 odd;  // i = 1, 3, 5
};

// By the recursion i M_i = [t^(i-1) r] + (2 i - 1) place M_(i-1) - (i - 1) square M_(i-2) with r = |t - zero|. Beyond
// |zero| = 2 it subtracts large numbers.
ew_torus_moments ew_find_torus_moments(ew_mapped_zero zero)
{
    vec2 to_ends = abs(vec2(1.0 + zero.place, 1.0 - zero.place));
    vec2 r = sqrt(to_ends * to_ends + zero.height2);
    vec2 sum = r + to_ends;
    float ratio = abs(zero.place) < 1.0 ? sum.x * sum.y / zero.height2 : max(sum.x, sum.y) / min(sum.x, sum.y);
    float r_sum = r.y + r.x;
    float r_difference = r.y - r.x;
    float moment0 = 0.69314718 * log2(ratio);
    float moment1 = r_difference + zero.place * moment0;
    float moment2 = 0.5 * (r_sum + 3.0 * zero.place * moment1 - zero.square * moment0);
    float moment3 = (1.0 / 3.0) * (r_difference + 5.0 * zero.place * moment2 - 2.0 * zero.square * moment1);
    float moment4 = 0.25 * (r_sum + 7.0 * zero.place * moment3 - 3.0 * zero.square * moment2);
    float moment5 = 0.2 * (r_difference + 9.0 * zero.place * moment4 - 4.0 * zero.square * moment3);
    return ew_torus_moments(vec3(moment0, moment2, moment4), vec3(moment1, moment3, moment5));
}

// The values of a function of t at the nodes: right at +EW_TORUS_NODES, left at -EW_TORUS_NODES.
struct ew_at_nodes {
    vec3 right;
    vec3 left;
};

ew_at_nodes ew_even_plus_odd(vec3 even, vec3 odd)
{
    return ew_at_nodes(even + odd, even - odd);
}

// (1 - m t) f for f = value + slope (1 + t) / (1 - m t), a linear function of x.
ew_at_nodes ew_linear_at_nodes(float value, float slope, float m)
{
    return ew_even_plus_odd(vec3(value + slope), (slope - value * m) * EW_TORUS_NODES);
}

// (1 - m t)^2 times the squared distance from the axis.
ew_at_nodes ew_from_axis2_at_nodes(ew_torus_side side, ew_torus_panel panel)
{
    float from_axis2 = side.from_axis2 + panel.from * (2.0 * side.outward + side.across2 * panel.from);
    float outward = (side.outward + side.across2 * panel.from) * panel.scale;
    float across2 = side.across2 * panel.scale * panel.scale;
    float m = panel.m;
    vec3 even = (from_axis2 + 2.0 * outward + across2) + (from_axis2 * m * m - 2.0 * outward * m + across2) * EW_TORUS_NODES2;
    vec3 odd = (2.0 * (across2 - from_axis2 * m + outward * (1.0 - m))) * EW_TORUS_NODES;
    return ew_even_plus_odd(even, odd);
}

// 4 (1 - m t)^2 |x - other_zero|^2.
ew_at_nodes ew_other_zero_at_nodes(ew_torus_side side, ew_torus_panel panel)
{
    vec2 other = 2.0 * vec2(panel.from - side.other_zero.x, side.other_zero.y);
    vec2 constant = vec2(other.x + 2.0 * panel.scale, other.y);
    vec2 slope = vec2(2.0 * panel.scale - other.x * panel.m, -other.y * panel.m);
    return ew_even_plus_odd(dot(constant, constant) + dot(slope, slope) * EW_TORUS_NODES2,
                            2.0 * dot(constant, slope) * EW_TORUS_NODES);
}

// direction2 times the integral over x in [from, from + size] of 1 / (distance depth^2), where other_zero is `clearance` away
// from `from`. Multiplied by 1 - m t and by |t - zero|, the integrand is smooth; through its values at six nodes goes the
// polynomial. Relative error mostly far below 1e-4, at worst 3.5e-4 for panels no longer than ew_integrate_torus_panels makes
// them.
float ew_integrate_torus_panel(ew_torus_side side, float from, float size, float clearance)
{
    ew_torus_panel panel = ew_map_torus_panel(side, from, size, clearance);
    ew_mapped_zero zero = ew_map_own_zero(side, panel);

    // If the zero is far away, the moments would cancel; but then 1 / |t - zero| is smooth too, and Gauss's weights serve.
    ew_torus_moments moments = ew_find_torus_moments(zero);
    bool is_far = zero.square > 4.0;
    vec3 even = is_far ? EW_TORUS_WEIGHTS : 0.5 * (EW_TORUS_LAGRANGE * moments.even);
    vec3 odd = is_far ? vec3(0.0) : (0.5 / EW_TORUS_NODES) * (EW_TORUS_LAGRANGE * moments.odd);
    ew_at_nodes own2 = ew_even_plus_odd(zero.square + EW_TORUS_NODES2, -2.0 * zero.place * EW_TORUS_NODES);

    ew_at_nodes shrink = ew_even_plus_odd(vec3(1.0), -panel.m * EW_TORUS_NODES);
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
    ew_evaluation_count += 6;
    return 2.0 * size * panel.m_complement * inversesqrt(zero.scale2) * (dot(even, right + left) + dot(odd, right - left));
}
