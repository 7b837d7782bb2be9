// Curves: the integral over a segment of weight / max(epsilon, distance to the nearest point of an arc), equations (13) and
// (17).

// The most stretches of a ray: three beside the parts of the ends, split five times.
const int EW_MAX_STRETCHES = 8;

// Share of the other sources' light in what a curve's error is compared with. All of it would be too much: a panel that is fine
// beside much light may step over a narrow core.
const float EW_OTHERS_SHARE = 0.1;

// The integral over the part of the ray to which the end of the arc at `tau` is nearest: a point's, times the end's weight.
// Relative error 1e-6.
float ew_integrate_end(ew_arc arc, float tau, vec2 part)
{
    float sum = 0.0;
    if (EW_IS_NEEDED(part.x < part.y)) {
        ew_passage passage = ew_passage_at(arc, tau, true, false);
#ifdef EW_REACH
        if (arc.glow.y > 0.0) {
            vec2 chord = ew_chord_of(passage.b2, passage.k, passage.s0, arc.glow.y, part.y);
            part = vec2(max(part.x, chord.x), max(max(part.x, chord.x), chord.y));
        }
#endif
        sum = passage.weight * ew_integrate_within_reach(passage.b2, passage.k, passage.s0, part, arc.glow);
    }
    return sum;
}

// The passage for the stretch [from, to], on which arc.arm is nearest. Its weight is that of the arc's nearest point, even if
// the passage lies on the parabola beyond the arc: else parts of the arc with weights of 0 would be a difference of two large
// integrals.
ew_passage ew_passage_of_stretch(ew_arc arc, ew_approaches approaches, float from, float to)
{
    float middle = 0.5 * (from + to);
    ew_passage passage = ew_passage_of_arm(arc, approaches, middle);
    passage.weight = ew_arc_weight(arc, ew_tau_on_arm(arc, clamp(passage.s0, from, to)));
    // The tip of an arc that is folded back on itself is one point all along, like an end.
    bool is_fold = arc.has_vertex && arc.slope_x == 0.0 && arc.equation_start.x + middle * arc.equation_growth.x > 0.0;
    if (is_fold) passage = ew_passage_at(arc, 0.0, true, false);
    return passage;
}

#ifdef EW_REACH
// How far outside of its reach the arc is at s, in squared distances.
float ew_arc_excess(ew_arc arc, float s)
{
    float distance_squared = ew_arc_distance_squared(arc, arc.start + s * arc.direction, ew_tau_on_arm(arc, s));
    return distance_squared - arc.glow.y * arc.glow.y;
}

// Where between `inner` and `outer` the arc comes to its reach, if the excess is negative at `inner` and positive at `outer`. It
// grows about with the square of s - inner; the regula falsi (Illinois) in that square takes few steps. An error of the place counts
// by its square.
float ew_edge_of_reach(ew_arc arc, float inner, float outer, float inner_excess, float outer_excess)
{
    float way = outer - inner;
    vec2 square = vec2(0.0, 1.0);
    vec2 excess = vec2(inner_excess, outer_excess);
    float edge = 0.0;
    int step = 0;
    do {
        edge = square.x - excess.x * (square.y - square.x) / max(excess.y - excess.x, 1e-30);
        float value = ew_arc_excess(arc, inner + way * sqrt(max(edge, 0.0)));
        bool is_outside = value > 0.0;
        square = is_outside ? vec2(square.x, edge) : vec2(edge, square.y);
        excess = is_outside ? vec2(0.5 * excess.x, value) : vec2(value, 0.5 * excess.y);
    } while (++step < 8);
    return inner + way * sqrt(max(edge, 0.0));
}

// The part of a stretch that is within reach: the distance falls up to `nearest` and grows from there on.
vec2 ew_stretch_within_reach(ew_arc arc, float nearest, vec2 stretch)
{
    float center = clamp(nearest, stretch.x, stretch.y);
    float at_from = ew_arc_excess(arc, stretch.x);
    float at_center = ew_arc_excess(arc, center);
    float at_to = ew_arc_excess(arc, stretch.y);
    // Where rounding or a passage beyond the arc puts the least distance elsewhere, an end of the stretch stands in.
    if (at_from < at_center) { center = stretch.x; at_center = at_from; }
    if (at_to < at_center) { center = stretch.y; at_center = at_to; }
    vec2 part = vec2(center);
    if (at_center < 0.0) {
        part = stretch;
        if (at_from > 0.0) part.x = ew_edge_of_reach(arc, center, stretch.x, at_center, at_from);
        if (at_to > 0.0) part.y = ew_edge_of_reach(arc, center, stretch.y, at_center, at_to);
    }
    return part;
}
#endif

// The integral over the stretch [from, to], on which arc.arm is nearest: closed form and rest. `sum` is the curve's light so
// far.
float ew_integrate_stretch(ew_arc arc, ew_approaches approaches, float from, float to, float sum, float others)
{
    ew_passage passage = ew_passage_of_stretch(arc, approaches, from, to);
    vec2 part = vec2(from, to);
#ifdef EW_REACH
    if (arc.glow.y > 0.0) part = ew_stretch_within_reach(arc, passage.s0, part);
#endif
    float reciprocal = ew_integrate_within_reach(passage.b2, passage.k, passage.s0, part, arc.glow);
    float light = sum + max(passage.weight, 0.02 * arc.mean_weight) * max(reciprocal, 0.0);
    float allowance = ew_tolerance() * (light + EW_OTHERS_SHARE * others);
    float rest = 0.0;
    if (part.x < part.y) rest = ew_integrate_rest(arc, passage, part.x, part.y, allowance);
    return passage.weight * reciprocal + rest;
}

// The parts of `chord` to which the arc's ends are nearest.
void ew_find_parts(ew_arc arc, ew_cell first_cell, ew_cell last_cell, vec2 chord, out vec2 first, out vec2 last)
{
    first = ew_part_of_cell(arc, first_cell, chord.y);
    last = ew_part_of_cell(arc, last_cell, chord.y);
#ifdef EW_REACH
    first = max(first, chord.xx);
    last = max(last, chord.xx);
#endif
    // If both ends are one point, their parts are the same.
    if (first.x < last.y && last.x < first.y) {
        if (first.x <= last.x) last.x = min(first.y, last.y);
        else last.y = first.x;
    }
}

// Adds to `sum`, the curve's light so far, that of what the ends' parts `first` and `last` leave of `chord`. `others`, >= 0 and in the
// same unit, is what other sources are known to add to it. Relative error 1e-3 at a tolerance of 1e-3, mostly far less;
// docs/method.md, section 10, has the exceptions.
float ew_add_stretches(ew_arc arc, ew_cell first_cell, ew_cell last_cell, vec2 first, vec2 last, vec2 chord, float sum, float others)
{
#ifdef EW_REACH
    // The brightness is known, and light that is a thousandth of it need not be exact to a thousandth of itself.
    if (arc.glow.y > 0.0) others += 1e-3 / EW_OTHERS_SHARE * 1.386 * log2(max(arc.glow.y / arc.glow.x, 1.0001));
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

float ew_integrate(ew_segment segment, ew_curve_block curve, vec2 chord, float others)
{
    ew_arc arc = ew_make_arc(segment, curve);
    ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
    ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
    vec2 first, last;
    ew_find_parts(arc, first_cell, last_cell, chord, first, last);
    float sum = ew_integrate_end(arc, arc.first, first) + ew_integrate_end(arc, arc.last, last);
    return ew_add_stretches(arc, first_cell, last_cell, first, last, chord, sum, others);
}
