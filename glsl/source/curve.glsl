// The integral over a segment of weight / distance to the nearest point of an arc, equations (13) and (17).

// The part of the ray's [0, end] on which start + s growth >= 0; empty, x >= y, where there is none.
vec2 ew_part_above_zero(float start, float growth, float end)
{
    bool is_constant = growth == 0.0;
    float zero = is_constant ? (start >= 0.0 ? 0.0 : end) : clamp(-start / growth, 0.0, end);
    return is_constant || growth > 0.0 ? vec2(zero, end) : vec2(0.0, zero);
}

// Of an end of the arc and of the points at u in [0, 1] from there to the other end, which is nearest to the ray's place s? With
// end - s direction the way from that place to the end, and u towards(u) the way from the end to u, the point at u is, in squared
// distances, by u h(u, s) farther off, where
//
//     h = towards(u) . (u towards(u) + 2 (end - s direction)) = bend^2 u^3 + 2 slope.y bend u^2 + (...) u + constant.x + s constant.y.
//
// The end is nearest where h >= 0 for all u. Each u gives a half-space, so this cell is convex, and its part of a ray an interval.
struct ew_cell {
    float inward;
    float tau;
    vec2 end;
    vec2 slope;
    vec2 constant;
};

// The cell of the arc's end at `tau`; `inward` is 1 for the first end and -1 for the last.
ew_cell ew_cell_of_end(ew_arc arc, float tau, float inward)
{
    ew_cell cell;
    cell.inward = inward;
    cell.tau = tau;
    cell.end = vec2(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau) - arc.start.xy;
    cell.slope = inward * vec2(arc.slope_x, arc.slope_y + 2.0 * arc.bend * tau);
    cell.constant = 2.0 * vec2(dot(cell.slope, cell.end), -dot(cell.slope, arc.direction.xy));
    return cell;
}

// h(u, s) and its growth with s. Between the arms of a hairpin, h is small; in this form it does not cancel.
vec2 ew_farther_off(ew_arc arc, ew_cell cell, float u, float s)
{
    vec2 towards = vec2(cell.inward * arc.slope_x, cell.inward * arc.slope_y + arc.bend * (2.0 * cell.inward * cell.tau + u));
    return vec2(dot(towards, u * towards + 2.0 * (cell.end - s * arc.direction.xy)), -2.0 * dot(towards, arc.direction.xy));
}

// From s on, in that direction, the first place that is as far from the end as from the point that is nearest to s: at s itself
// where that is the end.
float ew_cut(ew_arc arc, ew_cell cell, float s, float direction, float end)
{
    float bend2 = arc.bend * arc.bend;
    float quadratic = 2.0 * cell.slope.y * arc.bend;
    float linear = dot(cell.slope, cell.slope) + 2.0 * arc.bend * (cell.end.y - s * arc.direction.y);
    float root = sqrt(max(quadratic * quadratic - 3.0 * bend2 * linear, 0.0));
    // The larger zero of h's derivative, its minimum.
    float u = quadratic > 0.0 ? -linear / max(quadratic + root, 1e-30) : (root - quadratic) / max(3.0 * bend2, 1e-30);
    vec2 h = ew_farther_off(arc, cell, clamp(u, 0.0, 1.0), s);
    float place = direction * h.y > 0.0 ? s - h.x / h.y : direction > 0.0 ? end : 0.0;
    return h.x < 0.0 ? place : s;
}

// The cell's part of the ray, by cutting planes: Newton's method on h's minimum over u, a concave function of s. From outside it
// cannot miss, and converges quadratically.
vec2 ew_part_of_cell(ew_arc arc, ew_cell cell, float end)
{
    // u = 0, the plane of the end, and u = 1, the plane that bisects both ends. At the tip of an arc that is folded back on itself
    // the first is 0 everywhere, and the next order decides.
    bool is_fold = cell.slope == vec2(0.0);
    vec2 inside = is_fold ? vec2(cell.end.y, -arc.direction.y) : cell.constant;
    vec2 nearer = ew_farther_off(arc, cell, 1.0, 0.0);
    vec2 plane = ew_part_above_zero(inside.x, inside.y, end);
    vec2 bisector = ew_part_above_zero(nearer.x, nearer.y, end);
    vec2 part = vec2(max(plane.x, bisector.x), min(plane.y, bisector.y));
    // h is u q(u) + constant, with a parabola q whose vertex is at u = -slope.y / bend. If that is at 1 or beyond, q is no less
    // than at 1, and h no less than a mean of its values at 0 and 1. (Of a symmetric arc it is at 1 but for rounding.) Nor is h
    // negative where q is not: for both ends of the part, and so in between.
    vec2 least_q = ew_square(cell.slope.x) + ew_square(max(cell.slope.y, 0.0)) + 2.0 * arc.bend * (cell.end.y - part * arc.direction.y);
    bool is_settled = part.x >= part.y || -cell.slope.y >= 0.999999 * arc.bend || min(least_q.x, least_q.y) >= 0.0;
    if (EW_IS_NEEDED(!is_settled)) {
        for (int i = 0; i < 12; ++i) {
            vec2 cut = vec2(max(part.x, ew_cut(arc, cell, part.x, 1.0, end)), min(part.y, ew_cut(arc, cell, part.y, -1.0, end)));
            bool is_done = cut.x - part.x <= 1e-6 * cut.x && part.y - cut.y <= 1e-6 * part.y;
            part = cut;
            if (is_done || part.x >= part.y) break;
        }
    }
    return part.x < part.y ? part : vec2(end);
}

// The integral over a part of the ray to which the point of the arc at `tau`, an end, is nearest.
float ew_integrate_end(ew_arc arc, float tau, vec2 part)
{
    float sum = 0.0;
    if (EW_IS_NEEDED(part.x < part.y)) {
        ew_passage passage = ew_passage_at(arc, tau, true, false);
        sum = passage.weight * ew_integrate_floored_reciprocal(passage.b2, passage.k, passage.s0, part.x, part.y);
    }
    return sum;
}

// Where a ray passes the arc, or its extension: the two closest approaches, which may be one.
struct ew_approaches {
    vec2 tau;
    vec2 s;
};

ew_approaches ew_find_approaches(ew_arc arc)
{
    vec2 tau = ew_closest_approaches(arc);
    vec2 y = (arc.slope_y + arc.bend * tau) * tau;
    vec2 along = arc.slope_x * tau * arc.direction.x + y * arc.direction.y - dot(arc.start, arc.direction);
    return ew_approaches(tau, along / ew_length_squared(arc.direction));
}

// Where the ray is to be divided: where the nearest point jumps, or nearly so, from one arm of the parabola to the other; and around
// a sharp bend where the bend's centre of curvature is passed, and at the planes of the ends, where one arm goes on beside the
// other. Behind the ray if nowhere.
vec4 ew_find_splits(ew_arc arc, ew_cell first, ew_cell last)
{
    float vertex = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    float bend = ew_zero(arc.equation_start.x, arc.equation_growth.x);
    bool is_jump = arc.equation_start.x + vertex * arc.equation_growth.x < 0.1 * arc.cubic;
    bool is_sharp = arc.has_arms && arc.slope_x < 0.1 * arc.bend;
    // As sudden is the way from the vertex to an arm for a ray that passes the vertex's centre of curvature closely.
    bool is_close = arc.has_arms && abs(arc.equation_start.y + bend * arc.equation_growth.y) < 1e-3 * arc.cubic;
    vec2 planes = vec2(ew_zero(first.constant.x, first.constant.y), ew_zero(last.constant.x, last.constant.y));
    return vec4(is_jump ? vertex : -1.0, is_sharp || is_close ? bend : -1.0, is_sharp ? planes : vec2(-1.0));
}

// Which arm of the parabola is nearest in [from, to], on which neither an end is nor the nearest point jumps. The arms are two
// where equation.x < 0. There the side of the vertex decides, unless the arc has no minimum on that arm.
float ew_nearest_arm(ew_arc arc, ew_cell first, ew_cell last, float from, float to)
{
    float arm = arc.arm;
    if (arc.has_vertex) {
        float bend = clamp(ew_zero(arc.equation_start.x, arc.equation_growth.x), from, to);
        float two_arms_from = arc.equation_start.x + from * arc.equation_growth.x < 0.0 ? from : bend;
        float two_arms_to = arc.equation_start.x + to * arc.equation_growth.x < 0.0 ? to : bend;
        float place = 0.5 * (two_arms_from + two_arms_to);
        vec2 equation = arc.equation_start + place * arc.equation_growth;
        // In a plane of symmetry rounding errors would choose.
        vec3 size = abs(arc.start);
        bool is_negative = equation.y < -1e-6 * arc.slope_x * (size.x + size.y + size.z);
        vec2 excess = is_negative ? first.constant : last.constant;
        bool is_lacking = excess.x + place * excess.y > 0.0;
        arm = is_negative == is_lacking ? 1.0 : -1.0;
        if (two_arms_to - two_arms_from <= 1e-6 * two_arms_to) arm = 0.0;
        // Folded back on itself, an arc is as long as its longer arm.
        if (arc.slope_x == 0.0) arm = -arc.first > arc.last ? -1.0 : 1.0;
    }
    return arm;
}

// The passage for an interval around `middle` on which `arc.arm` is nearest: that by the nearer one of its closest approaches.
ew_passage ew_passage_of_arm(ew_arc arc, ew_approaches approaches, float middle)
{
    vec2 equation = arc.equation_start + middle * arc.equation_growth;
    bool is_either_arm = !arc.has_arms || equation.x >= 0.0;
    vec2 remoteness = abs(approaches.s - middle);
    if (!is_either_arm && approaches.tau.x * arc.arm < 0.0) remoteness.x += 1e6;
    if (!is_either_arm && approaches.tau.y * arc.arm < 0.0) remoteness.y += 1e6;
    float tau = remoteness.y < remoteness.x ? approaches.tau.y : approaches.tau.x;
    bool is_far = abs(tau - 0.5 * (arc.first + arc.last)) > 1.0;
    return ew_passage_at(arc, is_far ? clamp(tau, arc.first, arc.last) : tau, false, is_far);
}

// The most intervals of a ray: three beside the ends' parts, divided four times.
const int EW_MAX_INTERVALS = 7;

// The first place from `s` on that is in neither end's part.
float ew_skip_parts(float s, vec2 first, vec2 last)
{
    if (s >= last.x && s < last.y) s = last.y;
    if (s >= first.x && s < first.y) s = first.y;
    if (s >= last.x && s < last.y) s = last.y;
    return s;
}

// How much the light of other sources counts beside the curve's own in what its error is compared with. All of it would be too
// much: a panel that is fine beside much light may step over a narrow core.
const float EW_OTHERS_PART = 0.1;

// The integral over a segment. `others`, >= 0 and in the same unit, is what other sources are known to add to it.
float ew_integrate_curve(ew_segment segment, ew_curve_block curve, float others)
{
    ew_arc arc = ew_make_arc(segment, curve);
    ew_cell first_cell = ew_cell_of_end(arc, arc.first, 1.0);
    ew_cell last_cell = ew_cell_of_end(arc, arc.last, -1.0);
    vec2 first = ew_part_of_cell(arc, first_cell, segment.end);
    vec2 last = ew_part_of_cell(arc, last_cell, segment.end);
    // Where both ends are one point, so are their parts.
    if (first.x < last.y && last.x < first.y) {
        if (first.x <= last.x) last.x = min(first.y, last.y);
        else last.y = first.x;
    }
    float sum = ew_integrate_end(arc, arc.first, first) + ew_integrate_end(arc, arc.last, last);

    ew_approaches approaches = ew_find_approaches(arc);
    vec4 splits = ew_find_splits(arc, first_cell, last_cell);
    float from = ew_skip_parts(0.0, first, last);
    int interval = 0;
    do {
        float to = segment.end;
        if (first.x > from) to = min(to, first.x);
        if (last.x > from) to = min(to, last.x);
        if (splits.x > from * (1.0 + 1e-6)) to = min(to, splits.x);
        if (splits.y > from * (1.0 + 1e-6)) to = min(to, splits.y);
        if (splits.z > from * (1.0 + 1e-6)) to = min(to, splits.z);
        if (splits.w > from * (1.0 + 1e-6)) to = min(to, splits.w);
        float middle = 0.5 * (from + to);

        arc.arm = ew_nearest_arm(arc, first_cell, last_cell, from, to);
        ew_passage passage = ew_passage_of_arm(arc, approaches, middle);
        passage.weight = ew_arc_weight(arc, ew_tau_on_arm(arc, clamp(passage.s0, from, to)));
        bool is_fold = arc.has_vertex && arc.slope_x == 0.0 && arc.equation_start.x + middle * arc.equation_growth.x > 0.0;
        if (is_fold) passage = ew_passage_at(arc, 0.0, true, false);
        float reciprocal = ew_integrate_floored_reciprocal(passage.b2, passage.k, passage.s0, from, to);
        float light = sum + max(passage.weight, 0.02 * arc.mean_weight) * reciprocal;
        float allowance = ew_frame.decay.z * (light + EW_OTHERS_PART * others);
        sum += passage.weight * reciprocal + ew_integrate_rest(arc, passage, from, to, allowance);
        from = ew_skip_parts(to, first, last);
    } while (from < segment.end && ++interval < EW_MAX_INTERVALS);
    return sum;
}
