// The part of a ray on which an end of an arc is its nearest point.

// The part of the ray's [0, end] on which start + s growth >= 0; empty, x >= y, if there is none.
vec2 ew_part_above_zero(const float start, const float growth, const float end)
{
    bool is_constant = growth == 0.0;
    float zero = mix(clamp(-start / growth, 0.0, end), mix(end, 0.0, start >= 0.0), is_constant);
    bool is_above_behind = is_constant || growth > 0.0;
    return vec2(mix(0.0, zero, is_above_behind), mix(zero, end, is_above_behind));
}

// The cell of an end of the arc (its Voronoi cell): the places that are nearer to that end than to the rest of the arc. Let the
// arc's point at u in [0, 1], on the way to the other end, be u towards(u) away from the end, and L(s) be s direction - end
// away from it. In squared distance from L(s), that point is farther away than the end by u h(u, s), where
//
//     h = towards(u) . (u towards(u) + 2 (end - s direction))
//       = bend^2 u^3 + 2 slope.y bend u^2 + (...) u + constant.x + s constant.y.
//
// The end is nearest where h >= 0 for all u. Each u gives a half-space, so the cell is convex, and its part of a ray is an
// interval.
struct ew_cell {
    float inward; // 1 for the first end, -1 for the last: the sign of tau's way into the arc
    float tau;
    vec2 end;
    vec2 slope;
    vec2 constant;
};

ew_cell ew_cell_of_end(const ew_arc arc, const float tau, const float inward)
{
    ew_cell cell;
    cell.inward = inward;
    cell.tau = tau;
    cell.end = vec2(arc.slope_x * tau, (arc.slope_y + arc.bend * tau) * tau) - arc.start.xy;
    cell.slope = inward * vec2(arc.slope_x, arc.slope_y + 2.0 * arc.bend * tau);
    cell.constant = 2.0 * vec2(dot(cell.slope, cell.end), -dot(cell.slope, arc.direction.xy));
    return cell;
}

// h(u, s) and its derivative by s. Between the arms of a hairpin h is small; in this form it does not cancel.
vec2 ew_farther_off(const ew_arc arc, const ew_cell cell, const float u, const float s)
{
    vec2 towards = vec2(cell.inward * arc.slope_x, cell.inward * arc.slope_y + arc.bend * (2.0 * cell.inward * cell.tau + u));
    return vec2(dot(towards, u * towards + 2.0 * (cell.end - s * arc.direction.xy)), -2.0 * dot(towards, arc.direction.xy));
}

// One cut with the plane between the end and the arc's point that is nearest to L(s): the first place from s on, in
// `direction`, that is as far from both. If the end itself is nearest to L(s), that is s.
float ew_cut(const ew_arc arc, const ew_cell cell, const float s, const float direction, const float end)
{
    float bend2 = arc.bend * arc.bend;
    float quadratic = 2.0 * cell.slope.y * arc.bend;
    float linear = dot(cell.slope, cell.slope) + 2.0 * arc.bend * (cell.end.y - s * arc.direction.y);
    float root = sqrt(max(quadratic * quadratic - 3.0 * bend2 * linear, 0.0));
    // The larger zero of h's derivative by u, where h has its minimum.
    float u = mix((root - quadratic) / max(3.0 * bend2, 1e-30), -linear / max(quadratic + root, 1e-30), quadratic > 0.0);
    vec2 h = ew_farther_off(arc, cell, clamp(u, 0.0, 1.0), s);
    float place = mix(mix(0.0, end, direction > 0.0), s - h.x / h.y, direction * h.y > 0.0);
    return mix(s, place, h.x < 0.0);
}

// What two planes leave of the ray: that of u = 0, through the end, and that of u = 1, which bisects the two ends.
vec2 ew_part_between_planes(const ew_arc arc, const ew_cell cell, const float end)
{
    // At the tip of an arc that is folded back on itself, h(0, s) is 0 everywhere, and the next order of u decides.
    bool is_fold = cell.slope == vec2(0.0);
    vec2 inside = mix(cell.constant, vec2(cell.end.y, -arc.direction.y), bvec2(is_fold));
    vec2 nearer = ew_farther_off(arc, cell, 1.0, 0.0);
    vec2 plane = ew_part_above_zero(inside.x, inside.y, end);
    vec2 bisector = ew_part_above_zero(nearer.x, nearer.y, end);
    return vec2(max(plane.x, bisector.x), min(plane.y, bisector.y));
}

// Whether h cannot be negative in `part`, so that no cut will change it.
//
// h is u q(u) + constant, and q is a parabola with its vertex at u = -slope.y / bend. If that is at 1 or beyond, h is at least
// a mean of its values at 0 and 1. (Of a symmetric arc it is at 1 up to rounding.) Nor is h negative where q is not: it is
// enough to know q at both ends of the part.
bool ew_needs_no_cut(const ew_arc arc, const ew_cell cell, const vec2 part)
{
    vec2 least_q = ew_square(cell.slope.x) + ew_square(max(cell.slope.y, 0.0)) +
                   2.0 * arc.bend * (cell.end.y - part * arc.direction.y);
    return part.x >= part.y || -cell.slope.y >= 0.999999 * arc.bend || min(least_q.x, least_q.y) >= 0.0;
}

// The cell's part of the ray, exact up to rounding; [end, end] if empty. Cutting planes from both ends are Newton's method on
// the minimum of h over u, a concave function of s: from outside it cannot miss, and converges quadratically.
vec2 ew_part_of_cell(const ew_arc arc, const ew_cell cell, const float end)
{
    vec2 part = ew_part_between_planes(arc, cell, end);
    if (EW_IS_NEEDED(!ew_needs_no_cut(arc, cell, part))) {
        for (int i = 0; i < 12; ++i) {
            vec2 cut = vec2(max(part.x, ew_cut(arc, cell, part.x, 1.0, end)),
                            min(part.y, ew_cut(arc, cell, part.y, -1.0, end)));
            bool is_done = cut.x - part.x <= 1e-6 * cut.x && part.y - cut.y <= 1e-6 * part.y;
            part = cut;
            if (is_done || part.x >= part.y) break;
        }
    }
    return mix(vec2(end), part, bvec2(part.x < part.y));
}
