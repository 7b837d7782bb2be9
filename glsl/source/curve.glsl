// Curves: the integral over a segment of weight / max(epsilon, distance to the nearest point of an arc), equations (13) and
// (17).

// The most stretches of a ray: three beside the parts of the ends, split four times.
const int EW_MAX_STRETCHES = 7;

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
        sum = passage.weight * ew_integrate_floored_reciprocal(passage.b2, passage.k, passage.s0, part.x, part.y);
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

// The integral over the stretch [from, to], on which arc.arm is nearest: closed form and rest. `sum` is the curve's light so
// far.
float ew_integrate_stretch(ew_arc arc, ew_approaches approaches, float from, float to, float sum, float others)
{
    ew_passage passage = ew_passage_of_stretch(arc, approaches, from, to);
    float reciprocal = ew_integrate_floored_reciprocal(passage.b2, passage.k, passage.s0, from, to);
    float light = sum + max(passage.weight, 0.02 * arc.mean_weight) * reciprocal;
    float allowance = ew_tolerance() * (light + EW_OTHERS_SHARE * others);
    return passage.weight * reciprocal + ew_integrate_rest(arc, passage, from, to, allowance);
}

// The integral over a segment; `others`, >= 0 and in the same unit, is what other sources are known to add to it. Relative
// error 1e-3 at a tolerance of 1e-3, mostly far less; docs/method.md, section 10, has the exceptions.
float ew_integrate(ew_segment segment, ew_curve_block curve, float others)
{
    ew_arc arc = ew_make_arc(segment, curve);
    ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
    ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
    vec2 first = ew_part_of_cell(arc, first_cell, segment.end);
    vec2 last = ew_part_of_cell(arc, last_cell, segment.end);
    // If both ends are one point, their parts are the same.
    if (first.x < last.y && last.x < first.y) {
        if (first.x <= last.x) last.x = min(first.y, last.y);
        else last.y = first.x;
    }
    float sum = ew_integrate_end(arc, arc.first, first) + ew_integrate_end(arc, arc.last, last);

    ew_approaches approaches = ew_find_approaches(arc);
    vec4 splits = ew_find_splits(arc, first_cell, last_cell);
    float from = ew_skip_parts(0.0, first, last);
    int stretch = 0;
    do {
        float to = ew_end_of_stretch(from, segment.end, first, last, splits);
        arc.arm = ew_nearest_arm(arc, first_cell, last_cell, from, to);
        sum += ew_integrate_stretch(arc, approaches, from, to, sum, others);
        from = ew_skip_parts(to, first, last);
    } while (from < segment.end && ++stretch < EW_MAX_STRETCHES);
    return sum;
}
