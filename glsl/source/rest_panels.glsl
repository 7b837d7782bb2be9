// The integral of the rest over a stretch, by adaptive quadrature.
//
// The variable is x = v - v(s0) with v = 1 / (s + beta), in which the decay is gone; without a decay it is s0 - s. x and the arc
// are counted from the passage: seen from the eye, an arc that is small and far away would be lost in the last digits. The passage cuts the stretch
// into a near side, x > 0, and a far side, x < 0. Each is divided into panels of four nodes from the passage outwards. A panel
// is shortened until its values lie on a parabola.

// The most panels of a stretch, refused ones included.
const int EW_MAX_PANELS = 400;
// The last panels are accepted as they come, so that every stretch is finished.
const int EW_LAST_TRIES = 5;
// Length of the first panel beside the passage, in half widths of the peak.
const float EW_FIRST_PANEL = 10.0;
// How much longer than one panel the next may be.
const float EW_PANEL_GROWTH = 3.0;
// How much shorter than a refused panel the next try is.
const float EW_PANEL_SHRINKAGE = 0.4;
// Share of the second difference of a panel's values in the estimate of its error; the third difference counts in full.
const float EW_CURVATURE_SHARE = 0.16;
// The same beside the passage.
const float EW_CURVATURE_SHARE_AT_PEAK = 0.3;

// A rule for four nodes in [0, 1], for panels of width 1.
struct ew_rule {
    vec4 nodes;
    vec4 weights;
    vec4 differences; // the third divided difference over 32: how far a cubic through the values is from all parabolas
    float curvature_share;
};

// Gauss-Legendre, exact up to x^7. If the rest `starts_at_zero`, it is x f(x), and Gauss-Jacobi is exact up to x^8; then the
// difference is that of f.
ew_rule ew_choose_rule(const bool starts_at_zero)
{
    bvec4 jacobi = bvec4(starts_at_zero);
    return ew_rule(mix(vec4(0.06943184, 0.33000948, 0.66999052, 0.93056816),
                       vec4(0.13975986, 0.41640957, 0.72315699, 0.94289580), jacobi),
                   mix(vec4(0.17392742, 0.32607258, 0.32607258, 0.17392742),
                       vec4(0.22310390, 0.31182653, 0.28135601, 0.14371356), jacobi),
                   mix(vec4(-0.2318919, 0.5873578, -0.5873578, 0.2318919),
                       vec4(-1.7249797, 1.6796979, -1.0989184, 0.3567003), jacobi),
                   mix(EW_CURVATURE_SHARE, EW_CURVATURE_SHARE_AT_PEAK, starts_at_zero));
}

// A stretch as seen from its passage, or from its end nearest to the passage if that is outside.
struct ew_stretch {
    float center; // s of x = 0
    float depth;  // center + beta; 1 without a decay
    float depth2;
    float x_from; // x of its two ends, x_from >= 0 >= x_to
    float x_to;
    vec2 starts; // x of where its near and its far side begin
#ifdef EW_REACH
    vec2 core; // x of the edges of the arc's core, core.x >= 0 >= core.y
#endif
    float peak;        // length of the first panel
    float first_panel; // the same, or to the edge of the core for a ray that passes it
    bool is_inside;    // the passage is inside, and the rest starts at 0 there
    bool is_wide;      // the peak is wide: the whole stretch is one side
};

// x of two places.
vec2 ew_x_at(const ew_stretch stretch, const vec2 s)
{
#ifdef EW_WORLD
    return stretch.center - s;
#else
    return (stretch.center - s) / ((s + ew_beta()) * stretch.depth);
#endif
}

// Where sources may have a reach, no panel holds an edge of the arc's core: four nodes may not see a kink.
//
// The first panel is at most EW_FIRST_PANEL half widths of the peak long, or it would not see how the arc's peak differs from
// the passage's. Nor is it much longer than the arc, because a bent arc's passage is of no use there.
ew_stretch ew_make_stretch(const ew_arc arc, const ew_passage passage, const float from, const float to)
{
    float epsilon2 = ew_arc_core2(arc, passage.s0);
    ew_stretch stretch;
    stretch.center = clamp(passage.s0, from, to);
#ifdef EW_REACH
    bool has_core = passage.core.x < passage.core.y;
    stretch.center = mix(stretch.center, clamp(stretch.center, passage.core.x, passage.core.y), has_core);
#endif
#ifdef EW_WORLD
    stretch.depth = 1.0;
#else
    stretch.depth = stretch.center + ew_beta();
#endif
    stretch.depth2 = stretch.depth * stretch.depth;
    vec2 ends = ew_x_at(stretch, vec2(from, to));
    stretch.x_from = ends.x;
    stretch.x_to = ends.y;
#ifdef EW_REACH
    // In the core the model is the arc itself, and without weights there is no rest.
    stretch.core = mix(vec2(0.0), ew_x_at(stretch, passage.core), bvec2(has_core));
    stretch.starts = mix(stretch.core, vec2(0.0), bvec2(ew_has_weights(arc)));
#else
    stretch.starts = vec2(0.0);
#endif
    float scale = inversesqrt(passage.k) / stretch.depth2;
    float extent = arc.slope_x + abs(arc.slope_y) + 2.0 * arc.bend * max(-arc.first, arc.last);
    stretch.peak = min(EW_FIRST_PANEL * scale * sqrt(max(passage.b2, epsilon2)),
                       4.0 * sqrt((passage.b2 + extent * extent) / ew_length_squared(arc.direction)) / stretch.depth2);
#ifdef EW_REACH
    stretch.first_panel = stretch.peak;
    stretch.is_inside = !has_core && passage.is_touching && passage.s0 > from && passage.s0 < to;
    stretch.is_wide = stretch.peak >= 8.0 * (stretch.x_from - stretch.x_to) && !has_core;
#else
    bool passes_core = passage.b2 < epsilon2;
    float half_core = scale * sqrt(max(epsilon2 - passage.b2, 0.04 * epsilon2));
    stretch.first_panel = mix(stretch.peak, half_core, passes_core);
    stretch.is_inside = passage.is_touching && passage.s0 > from && passage.s0 < to;
    stretch.is_wide = stretch.peak >= 8.0 * (stretch.x_from - stretch.x_to)
                      && (!passes_core || half_core > stretch.x_from - stretch.x_to);
#endif
    return stretch;
}

// How far the integration has come on one side of a stretch.
struct ew_progress {
    float x;          // where the next panel begins
    float remaining;  // from there to the side's end; < 0 on the far side
    float proposal;   // width of the next panel, unless there is a knot in it
    float piece;      // the weight piece at x
    float last_piece; // the weight piece at the side's end
    bool starts_at_zero;
    bool is_last_side;
};

// The first side: the near one, if there is one, or the whole of a stretch with a wide peak.
// `pieces` are the weight pieces at its beginning, its center and its end.
ew_progress ew_start_stretch(const ew_stretch stretch, const vec3 pieces)
{
    bool has_near_side = stretch.x_from > stretch.starts.x;
    bool ends_at_from = has_near_side || stretch.is_wide;
    ew_progress progress;
    progress.x = mix(mix(stretch.starts.y, stretch.starts.x, has_near_side), stretch.x_to, stretch.is_wide);
    progress.remaining = mix(stretch.x_to, stretch.x_from, ends_at_from) - progress.x;
    progress.proposal = clamp(progress.remaining, -stretch.first_panel, stretch.first_panel);
    progress.piece = mix(pieces.y, pieces.z, stretch.is_wide);
    progress.last_piece = mix(pieces.z, pieces.x, ends_at_from);
    progress.starts_at_zero = stretch.is_inside && !stretch.is_wide;
    progress.is_last_side = stretch.is_wide || !has_near_side || stretch.x_to == stretch.starts.y;
    return progress;
}

ew_progress ew_start_far_side(const ew_stretch stretch, const vec3 pieces)
{
    ew_progress progress;
    progress.x = stretch.starts.y;
    progress.remaining = stretch.x_to - progress.x;
    progress.proposal = max(progress.remaining, -stretch.first_panel);
    progress.piece = pieces.y;
    progress.last_piece = pieces.z;
    progress.starts_at_zero = stretch.is_inside;
    progress.is_last_side = true;
    return progress;
}

// The width of a panel that ends at the next knot: between two knots the weight is one polynomial.
float ew_width_to_knot(const ew_arc arc, const ew_stretch stretch, const ew_progress progress)
{
    float knot = max(ew_next_knot(arc, progress.piece, progress.last_piece), -stretch.center);
#ifdef EW_WORLD
    float width = -knot - progress.x;
#else
    float width = -knot / ((knot + stretch.depth) * stretch.depth) - progress.x;
#endif
    return clamp(width, min(progress.remaining, 0.0), max(progress.remaining, 0.0));
}

#ifdef EW_REACH
// The width of a panel that ends at the edge of the core, of a side that begins in it; 0 for one beyond.
float ew_width_to_edge(const ew_stretch stretch, const ew_progress progress)
{
    float width = mix(stretch.core.y, stretch.core.x, progress.remaining >= 0.0) - progress.x;
    return mix(0.0, width, width * progress.remaining > 0.0);
}
#endif

#ifdef EW_FOG
// The optical depth of a panel of four nodes; with a weight, half of that.
#ifdef EW_WEIGHTS
const float EW_REST_FOG = 0.5;
#else
const float EW_REST_FOG = 1.0;
#endif

// The longest panel, in x, for the fog.
float ew_longest_rest(const ew_stretch stretch, const ew_progress progress)
{
    bool is_near = progress.remaining >= 0.0;
#ifdef EW_WORLD
    return ew_longest_in_fog(stretch.center - progress.x, mix(1.0, -1.0, is_near), EW_REST_FOG);
#else
    float depth = stretch.depth / (1.0 + stretch.depth * progress.x);
    float s = depth - ew_beta();
    float along = mix(1.0, -1.0, is_near);
    float way = max(min(ew_longest_in_fog(s, along, EW_REST_FOG), 0.5 * depth), ew_way_through_thin_fog(s, along));
    return way / (depth * mix(depth + way, max(depth - way, 1e-3 * depth), is_near));
#endif
}
#endif

// The step control: goes on behind a panel that `is_fine`, or back to a shorter one.
ew_progress ew_advance(const ew_stretch stretch, ew_progress progress, const float width, const bool is_at_knot,
                       const bool is_fine, const bool is_last_try)
{
    float left = progress.remaining - width;
    float next = EW_PANEL_GROWTH * width;
    float past_peak = mix(min(next, -stretch.peak), max(next, stretch.peak), width >= 0.0);
    next = mix(next, past_peak, progress.starts_at_zero);
    next = mix(next, progress.proposal, is_at_knot);
    float next_piece = progress.piece + mix(-1.0, 1.0, progress.last_piece > progress.piece);
    progress.piece = mix(progress.piece, next_piece, is_at_knot && is_fine);
    next = mix(next, left, abs(left) < 1.5 * abs(next) || is_last_try);
    progress.x = mix(progress.x, progress.x + width, is_fine);
    progress.remaining = mix(progress.remaining, left, is_fine);
    progress.proposal = mix(EW_PANEL_SHRINKAGE * width, next, is_fine);
    progress.starts_at_zero = progress.starts_at_zero && !is_fine;
    return progress;
}

// The integral over s in [from, to] of the rest / (s + beta)^2, each panel's error below `allowance` by an estimate: four nodes
// see what four nodes see.
float ew_integrate_rest(ew_arc arc, ew_passage passage, const float from, const float to, const float allowance)
{
    ew_stretch stretch = ew_make_stretch(arc, passage, from, to);
    arc.start += stretch.center * arc.direction;
    arc.equation_start += stretch.center * arc.equation_growth;
    arc.center += stretch.center;
    passage.s0 -= stretch.center;
#ifdef EW_REACH
    passage.core -= stretch.center;
#endif
    vec3 pieces = ew_pieces_at(arc, vec3(from - stretch.center, 0.0, to - stretch.center));

    ew_progress progress = ew_start_stretch(stretch, pieces);
    float sum = 0.0;
    for (int panel = 0; panel < EW_MAX_PANELS; ++panel) {
        bool is_last_try = panel >= EW_MAX_PANELS - EW_LAST_TRIES;
        float to_knot = ew_width_to_knot(arc, stretch, progress);
#ifdef EW_FOG
        float longest = mix(ew_longest_rest(stretch, progress), abs(progress.proposal), is_last_try);
        progress.proposal = clamp(progress.proposal, -longest, longest);
#endif
        bool has_knot = ew_has_knot(progress.piece, progress.last_piece) && !is_last_try;
        bool is_at_knot = has_knot && abs(to_knot) <= abs(progress.proposal);
        float width = mix(progress.proposal, to_knot, is_at_knot);
#ifdef EW_REACH
        float to_edge = ew_width_to_edge(stretch, progress);
        bool is_at_edge = to_edge != 0.0 && abs(to_edge) <= abs(width);
        width = mix(width, to_edge, is_at_edge);
        is_at_knot = is_at_knot && (!is_at_edge || to_knot == to_edge);
#endif

        ew_rule rule = ew_choose_rule(progress.starts_at_zero);
        vec4 x = progress.x + width * rule.nodes;
#ifdef EW_WORLD
        vec4 s = -x;
#else
        vec4 s = -stretch.depth2 * x / (1.0 + stretch.depth * x);
#endif
        ew_rest rest = ew_rest_at(arc, passage, s, progress.piece);
#ifdef EW_FOG
        vec4 transmittance = ew_transmittance(stretch.center + s);
        rest.values *= transmittance;
        rest.curvature *= max(max(transmittance.x, transmittance.y), max(transmittance.z, transmittance.w));
#endif
        float error = (abs(dot(rest.values, rule.differences)) + rule.curvature_share * rest.curvature) * abs(width);
        // Panels shorter than the digits of s would only add up noise.
        bool is_fine = error <= allowance || is_last_try || abs(width) * stretch.depth2 < 1e-6 * stretch.center;
        sum += mix(0.0, abs(width) * dot(rule.weights, rest.values), is_fine);

        bool is_side_done = is_fine && width == progress.remaining;
        if (is_side_done && progress.is_last_side) break;
        progress = ew_advance(stretch, progress, width, is_at_knot, is_fine, is_last_try);
        if (is_side_done) progress = ew_start_far_side(stretch, pieces);
    }
    return sum;
}
