// A product rule of six nodes: a peak 1 / |x - zero| is integrated exactly against the polynomial that interpolates what it multiplies.
// docs/method.md, section 5, has the derivation.

// Gauss's six nodes on [-1, 1] are +-EW_PANEL_NODES, with EW_PANEL_WEIGHTS.
const vec3 EW_PANEL_NODES = vec3(0.23861919, 0.66120939, 0.93246951);
const vec3 EW_PANEL_NODES2 = EW_PANEL_NODES * EW_PANEL_NODES;
const vec3 EW_PANEL_WEIGHTS = vec3(0.46791393, 0.36076157, 0.17132449);
// Lagrange's polynomials for the squares of the nodes: from moments of 1, t^2, t^4 to weights.
const mat3 EW_PANEL_LAGRANGE = mat3(1.23030422, -0.301171601, 0.0708673784, -4.22902436, 5.63573565, -1.40671129, 3.23642249,
                                    -6.08322688, 2.84680439);

// A panel, x in [from, from + size], mapped to t in [-1, 1] by x - from = scale (1 + t) / (1 - m t). A polynomial of x, times a
// power of 1 - m t, is a polynomial of t.
struct ew_panel {
    float from;
    float size;
    float m;            // in (-1, 1)
    float m_complement; // 1 - m^2
    float scale;        // size (1 - m) / 2
    float depth;        // s + beta at `from`
};

// A complex zero of a squared distance, in t: t = place +- i height.
struct ew_mapped_zero {
    float place;
    float height2;
    float square; // place^2 + height^2
    float scale2; // |x - zero| = |t - zero| sqrt(scale2) / (2 (1 - m t))
};

ew_mapped_zero ew_map_zero(const vec2 zero_x, const ew_panel panel)
{
    vec2 own = vec2(2.0 * (zero_x.x - panel.from) - panel.size, 2.0 * zero_x.y);
    vec2 own_scale = vec2(panel.size + panel.m * own.x, panel.m * own.y);
    ew_mapped_zero zero;
    zero.scale2 = dot(own_scale, own_scale);
    zero.place = ((own.x + panel.m * panel.size) * own_scale.x + own.y * own_scale.y) / zero.scale2;
    zero.height2 = ew_square(max(abs(own.y) * panel.size * panel.m_complement / zero.scale2, 1e-9));
    zero.square = zero.place * zero.place + zero.height2;
    return zero;
}

// The integrals over t in [-1, 1] of t^i / |t - zero|.
struct ew_moments {
    vec3 even; // i = 0, 2, 4
    vec3 odd;  // i = 1, 3, 5
};

// By the recursion i M_i = [t^(i-1) r] + (2 i - 1) place M_(i-1) - (i - 1) square M_(i-2) with r = |t - zero|. Beyond
// |zero| = 2 it subtracts large numbers.
ew_moments ew_find_moments(const ew_mapped_zero zero)
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
    return ew_moments(vec3(moment0, moment2, moment4), vec3(moment1, moment3, moment5));
}
