// Curves: the integral over a segment of weight / max(epsilon, distance to the nearest point of an arc), equations (13) and
// (17).

// The most stretches of a ray: three beside the parts of the ends, split five times.
const int EW_MAX_STRETCHES = 8;

// Share of the other sources' light in what a curve's error is compared with. All of it would be too much: a panel that is fine
// beside much light may step over a narrow core.
const float EW_OTHERS_SHARE = 0.1;

// The integral over the part of the ray to which the end of the arc at `tau` is nearest: a point's, times the end's weight.
// Relative error 1e-6.
float ew_integrate_end(const ew_arc arc, const float tau, vec2 part)
{
    float sum = 0.0;
    if (EW_IS_NEEDED(part.x < part.y)) {
        ew_passage passage = ew_passage_at(arc, tau, true, false);
#ifdef EW_REACH
        if (ew_has_reach(arc.glow)) {
            vec2 chord = ew_chord_of(passage.b2, passage.k, passage.s0, arc.glow.y, part.y);
            part = vec2(max(part.x, chord.x), max(max(part.x, chord.x), chord.y));
        }
#endif
        sum = passage.weight * ew_integrate_by_rule(passage.b2, passage.k, passage.s0, part, arc.glow);
    }
    return sum;
}

// The passage for the stretch [from, to], on which arc.arm is nearest. Its weight is that of the arc's nearest point, even if
// the passage lies on the parabola beyond the arc: else parts of the arc with weights of 0 would be a difference of two large
// integrals.
ew_passage ew_passage_of_stretch(const ew_arc arc, const ew_approaches approaches, const float from, const float to)
{
    bool is_fold;
    ew_passage passage = ew_passage_of_arm(arc, approaches, 0.5 * (from + to), is_fold);
    passage.weight = ew_arc_weight(arc, mix(ew_tau_on_arm(arc, clamp(passage.s0, from, to)), 0.0, is_fold));
    return passage;
}

#ifdef EW_REACH
// The squared distance of the arc from L(s).
float ew_distance_squared_at(const ew_arc arc, const float s)
{
    return ew_arc_distance_squared(arc, arc.start + s * arc.direction, ew_tau_on_arm(arc, s));
}

// The squared radius of the arc's core or reach at s.
float ew_radius_squared(const ew_arc arc, const float s, const bool is_core)
{
    return mix(arc.glow.y * arc.glow.y, ew_arc_core2(arc, s), is_core);
}

// Where between `inner` and `outer` the arc comes out of its core or reach. `excess` is by how much the squared distance is
// beyond the squared radius: negative at `inner`; if it is not positive at `outer`, all is inside. It grows about with the
// square of s - inner; the regula falsi (Illinois) in that square takes few steps. An error of the place counts by its square.
float ew_edge_of(const ew_arc arc, const float inner, const float outer, vec2 excess, const bool is_core)
{
    float way = outer - inner;
    float tolerance = 1e-3 * abs(excess.x);
    vec2 square = vec2(0.0, 1.0);
    bool is_done = excess.y <= 0.0;
    float edge = 1.0;
    int step = 0;
    do {
        // A pixel that has left this loop while others of its group have not may see its values computed once more.
        float next = square.x - excess.x * (square.y - square.x) / max(excess.y - excess.x, 1e-30);
        edge = mix(max(next, 0.0), edge, is_done);
        float s = inner + way * sqrt(edge);
        float value = ew_distance_squared_at(arc, s) - ew_radius_squared(arc, s, is_core);
        bool is_outside = value > 0.0;
        square = mix(vec2(edge, square.y), vec2(square.x, edge), bvec2(is_outside));
        excess = mix(vec2(value, 0.5 * excess.y), vec2(0.5 * excess.x, value), bvec2(is_outside));
        is_done = is_done || abs(value) <= tolerance;
    } while (!is_done && ++step < 12);
    return inner + way * sqrt(edge);
}

// A stretch of a ray beside an arc, and the squared distance at its ends and where it is least, at `nearest`.
struct ew_portion {
    vec2 ends;
    vec2 at_ends;
    float nearest;
    float at_nearest;
};

// The distance falls up to `nearest` and grows from there on. Where rounding or a passage beyond the arc puts the least
// distance elsewhere, an end of the stretch stands in.
ew_portion ew_make_portion(const ew_arc arc, float nearest, const vec2 ends)
{
    nearest = clamp(nearest, ends.x, ends.y);
    vec2 at_ends = vec2(0.0);
    float at_nearest = 0.0;
    // A loop over the three places, because compilers put the distance into the shader for every place that calls it.
    for (int i = 0; i < 3; ++i) {
        at_nearest = ew_distance_squared_at(arc, mix(mix(nearest, ends.y, i == 1), ends.x, i == 0));
        at_ends = mix(at_ends, vec2(at_nearest), bvec2(i == 0, i == 1));
    }
    ew_portion portion = ew_portion(ends, at_ends, nearest, at_nearest);
    portion.nearest = mix(portion.nearest, ends.x, portion.at_ends.x < portion.at_nearest);
    portion.at_nearest = min(portion.at_nearest, portion.at_ends.x);
    portion.nearest = mix(portion.nearest, ends.y, portion.at_ends.y < portion.at_nearest);
    portion.at_nearest = min(portion.at_nearest, portion.at_ends.y);
    return portion;
}

// What of it is within the arc's core or reach.
ew_portion ew_clip(const ew_arc arc, const ew_portion portion, const bool is_core)
{
    float inner = portion.at_nearest - ew_radius_squared(arc, portion.nearest, is_core);
    vec2 radius2 = vec2(ew_radius_squared(arc, portion.ends.x, is_core), ew_radius_squared(arc, portion.ends.y, is_core));
    vec2 outer = portion.at_ends - radius2;
    vec2 ends = vec2(portion.nearest);
    // A loop over both sides, because compilers put the search into the shader for every place that calls it.
    for (int side = 0; side < 2 && inner < 0.0; ++side) {
        bool is_far = side > 0;
        float end = mix(portion.ends.x, portion.ends.y, is_far);
        float edge = ew_edge_of(arc, portion.nearest, end, vec2(inner, mix(outer.x, outer.y, is_far)), is_core);
        ends = mix(ends, vec2(edge), bvec2(!is_far, is_far));
    }
    return ew_portion(ends, min(portion.at_ends, radius2), portion.nearest, portion.at_nearest);
}
#endif

#ifdef EW_REACH
// The passage's squared distance at s0, so that where the arc is outside of its core, in `part`, the passage is, too.
float ew_least_b2(const ew_arc arc, const ew_passage passage, const vec2 part)
{
    bool is_in_core = passage.s0 > passage.core.x && passage.s0 < passage.core.y;
    vec2 way = abs(passage.core - passage.s0);
    way = mix(way, vec2(1e9), bvec2(passage.core.x <= part.x, passage.core.y >= part.y));
    float nearest_edge = mix(0.0, min(way.x, way.y), is_in_core);
    return max(passage.b2, ew_arc_core2(arc, passage.s0) - passage.k * nearest_edge * nearest_edge);
}
#endif

// The integral over the stretch [from, to], on which arc.arm is nearest: closed form and rest. `sum` is the curve's light so far.
// Where sources may have a reach, the closed form in the core is the arc's own.
float ew_integrate_stretch(const ew_arc arc, const ew_approaches approaches, const float from, const float to, const float sum,
                           const float others)
{
    ew_passage passage = ew_passage_of_stretch(arc, approaches, from, to);
    vec2 part = vec2(from, to);
#ifdef EW_REACH
    ew_portion portion = ew_make_portion(arc, passage.s0, part);
    if (ew_has_reach(arc.glow)) portion = ew_clip(arc, portion, false);
    part = portion.ends;
    passage.core = ew_clip(arc, portion, true).ends;
    passage.b2 = ew_least_b2(arc, passage, part);
#ifdef EW_FOG
    float reciprocal = ew_integrate_in_fog(passage.b2, passage.k, passage.s0, part, passage.core, false, vec4(1.0, 0.0, 0.0, 0.0),
                                           arc.glow);
#else
    float reciprocal = ew_integrate_core(passage.core.x, passage.core.y, arc.glow);
    reciprocal -= ew_inverse_reach(arc.glow) * ew_measure(part.x, part.y);
    reciprocal += ew_integrate_reciprocal(passage.b2, passage.k, passage.s0, part.x, passage.core.x);
    reciprocal += ew_integrate_reciprocal(passage.b2, passage.k, passage.s0, passage.core.y, part.y);
#endif
#else
    float reciprocal = ew_integrate_by_rule(passage.b2, passage.k, passage.s0, part, arc.glow);
#endif
    float light = sum + max(passage.weight, 0.02 * arc.mean_weight) * max(reciprocal, 0.0);
    float allowance = ew_tolerance() * (arc.share * light + EW_OTHERS_SHARE * others);
    float rest = 0.0;
    if (part.x < part.y) rest = ew_integrate_rest(arc, passage, part.x, part.y, allowance);
    return passage.weight * reciprocal + rest;
}

// The parts of `chord` to which the arc's ends are nearest.
void ew_find_parts(const ew_arc arc, const ew_cell first_cell, const ew_cell last_cell, const vec2 chord, out vec2 first,
                   out vec2 last)
{
    // A loop, because compilers put the cuts into the shader for every place that calls for them.
    for (int end = 0; end < 2; ++end) {
        ew_cell cell = first_cell;
        if (end == 1) cell = last_cell;
        last = ew_part_of_cell(arc, cell, chord.y);
        if (end == 0) first = last;
    }
#if defined(EW_REACH) || defined(EW_MEDIA)
    first = max(first, chord.xx);
    last = max(last, chord.xx);
#endif
    // If both ends are one point, their parts are the same.
    if (first.x < last.y && last.x < first.y) {
        if (first.x <= last.x) last.x = min(first.y, last.y);
        else last.y = first.x;
    }
}

// Adds to `sum`, the curve's light so far, that of what the ends' parts `first` and `last` leave of `chord`. `others`, >= 0 and
// in the same unit, is what other sources are known to add to it. Relative error 1e-3 at a tolerance of 1e-3, mostly far less;
// docs/method.md, section 10, has the exceptions.
float ew_add_stretches(ew_arc arc, const ew_cell first_cell, const ew_cell last_cell, const vec2 first, const vec2 last,
                       const vec2 chord, float sum, float others)
{
#ifdef EW_REACH
    // The brightness is known, and light that is a thousandth of it need not be exact to a thousandth of itself.
    float faint = 1e-3 / EW_OTHERS_SHARE * 1.386 * log2(max(arc.glow.y / arc.glow.x, 1.0001));
#ifdef EW_FOG
    faint *= ew_transmittance(chord.x);
#endif
    if (ew_has_reach(arc.glow)) others += faint;
#endif
    ew_approaches approaches = ew_find_approaches(arc);
    vec4 splits = ew_find_splits(arc, first_cell, last_cell);
    float from = ew_skip_parts(chord.x, first, last);
    int stretch = 0;
    do {
        float to = ew_end_of_stretch(from, chord.y, first, last, splits, approaches.farthest);
        arc.arm = ew_nearest_arm(arc, first_cell, last_cell, from, to);
        sum += ew_integrate_stretch(arc, approaches, from, to, sum, others);
        from = ew_skip_parts(to, first, last);
    } while (from < chord.y && ++stretch < EW_MAX_STRETCHES);
    return sum;
}

float ew_integrate(const ew_segment segment, const ew_curve_block curve, const vec2 chord, const float others)
{
    ew_arc arc = ew_make_arc(segment, curve);
    ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
    ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
    vec2 first, last;
    ew_find_parts(arc, first_cell, last_cell, chord, first, last);
    float sum = 0.0;
    // A loop, because compilers put the integral into the shader for every place that calls it.
    for (int end = 0; end < 2; ++end)
        sum += ew_integrate_end(arc, mix(arc.first, arc.last, end == 1), mix(first, last, bvec2(end == 1)));
    return ew_add_stretches(arc, first_cell, last_cell, first, last, chord, sum, others);
}
