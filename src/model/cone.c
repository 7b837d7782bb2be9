/* Cones: see cone.h.
 *
 * A ray of the cone that is within R of a place p at depth z is beside the axis A(z), so that
 *
 *     |A(z) - p| <= R + width + growth z,
 *
 * which is a quadratic inequality in z. The same holds with the distance from an edge's line, where that is nearest inside the
 * edge. */
#include "model/cone.h"

#include "model/hull.h"
#include "model/vector.h"

ew_ray_field ew_make_ray_field(const ew_view *view, const ew_interval *depths)
{
    ew_ray_field field = {.axis.depths = *depths};
    double at_0[2], at_1[2];
    ew_ray_at(view, 0, 0, 0, field.axis.origin);
    ew_ray_at(view, 0, 0, 1, at_1);
    for (int i = 0; i < 2; ++i)
        field.axis.slope[i] = at_1[i] - field.axis.origin[i];
    for (int axis = 0; axis < 2; ++axis) {
        ew_ray_at(view, axis == 0, axis == 1, 0, at_0);
        ew_ray_at(view, axis == 0, axis == 1, 1, at_1);
        for (int i = 0; i < 2; ++i) {
            field.origin_growth[axis][i] = at_0[i] - field.axis.origin[i];
            field.slope_growth[axis][i] = at_1[i] - at_0[i] - field.axis.slope[i];
        }
    }
    return field;
}

/* How far the corners of a box are from its middle, where a step of half the box is `x` or `y`. */
static double half_diagonal(double half_width, const double x[2], double half_height, const double y[2])
{
    double a = half_width * x[0], b = half_height * y[0], c = half_width * x[1], d = half_height * y[1];
    double sum = (a + b) * (a + b) + (c + d) * (c + d), difference = (a - b) * (a - b) + (c - d) * (c - d);
    return sqrt(sum > difference ? sum : difference);
}

ew_cone ew_cone_of(const ew_ray_field *field, const double low[2], const double high[2])
{
    ew_cone cone = field->axis;
    double half[2];
    for (int axis = 0; axis < 2; ++axis) {
        half[axis] = 0.5 * (high[axis] - low[axis]);
        for (int i = 0; i < 2; ++i) {
            cone.origin[i] += 0.5 * (low[axis] + high[axis]) * field->origin_growth[axis][i];
            cone.slope[i] += 0.5 * (low[axis] + high[axis]) * field->slope_growth[axis][i];
        }
    }
    cone.width = half_diagonal(half[0], field->origin_growth[0], half[1], field->origin_growth[1]);
    cone.growth = half_diagonal(half[0], field->slope_growth[0], half[1], field->slope_growth[1]);
    return cone;
}

/* ---- Quadratic inequalities ---- */

/* x[2] z^2 + x[1] z + x[0]. */
typedef struct quadratic {
    double x[3];
} quadratic;

/* Whether it is <= 0 somewhere in the range. */
static bool is_reached(const quadratic *q, double start, double end)
{
    if (!(start <= end)) return false;
    const double *x = q->x;
    double vertex = x[2] > 0 ? fmin(fmax(-0.5 * x[1] / x[2], start), end) : start;
    return (x[2] * vertex + x[1]) * vertex + x[0] <= 0 || (x[2] * start + x[1]) * start + x[0] <= 0 ||
           (x[2] * end + x[1]) * end + x[0] <= 0;
}

/* The axis as seen from a place: start + z step. */
typedef struct offset_line {
    double start[3], step[3];
} offset_line;

static offset_line seen_from(const ew_cone *cone, const double place[3])
{
    return (offset_line){{cone->origin[0] - place[0], cone->origin[1] - place[1], -place[2]},
                         {cone->slope[0], cone->slope[1], 1}};
}

/* |A(z) - p|^2 - (radius + growth z)^2. */
static quadratic past_place(const offset_line *offset, double radius, double growth)
{
    return (quadratic){{ew_dot(offset->start, offset->start) - radius * radius,
                        2 * (ew_dot(offset->start, offset->step) - radius * growth),
                        ew_dot(offset->step, offset->step) - growth * growth}};
}

static bool meets_place(const ew_cone *cone, const double place[3], double radius)
{
    const offset_line offset = seen_from(cone, place);
    const quadratic q = past_place(&offset, radius, cone->growth);
    return is_reached(&q, cone->depths.start, cone->depths.end);
}

/* Whether the cone meets what is around the line from a place along a unit vector, between 0 and `length` along it. */
static bool meets_line(const ew_cone *cone, const double place[3], const double along[3], double length, double radius)
{
    const offset_line offset = seen_from(cone, place);
    quadratic q = past_place(&offset, radius, cone->growth);
    double t = ew_dot(offset.start, along), t_step = ew_dot(offset.step, along);
    q.x[0] -= t * t;
    q.x[1] -= 2 * t * t_step;
    q.x[2] -= t_step * t_step;
    double start = cone->depths.start, end = cone->depths.end;
    if (isinf(length)) return is_reached(&q, start, end);
    if (t_step == 0) return t >= 0 && t <= length && is_reached(&q, start, end);
    double at_place = -t / t_step, at_end = (length - t) / t_step;
    return is_reached(&q, fmax(start, fmin(at_place, at_end)), fmin(end, fmax(at_place, at_end)));
}

/* ---- Hulls ---- */

static bool meets_edge(const ew_cone *cone, const double from[3], const double to[3], double radius)
{
    double along[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]}, unit[3];
    double length = sqrt(ew_dot(along, along));
    return ew_normalize(along, unit) && meets_line(cone, from, unit, length, radius);
}

/* Whether the axis goes through a polygon: it passes all edges on the same side. */
static bool goes_through(const ew_cone *cone, const ew_hull *seen)
{
    const double step[3] = {cone->slope[0], cone->slope[1], 1};
    bool is_left = true, is_right = true;
    for (size_t i = 0; i < seen->corner_count; ++i) {
        const offset_line from = seen_from(cone, seen->corners[i]),
                          to = seen_from(cone, seen->corners[(i + 1) % seen->corner_count]);
        double across[3];
        ew_cross(from.start, to.start, across);
        double side = ew_dot(across, step);
        is_left = is_left && side > 0;
        is_right = is_right && side < 0;
    }
    return is_left || is_right;
}

/* Whether the axis, at a depth, is over or below the inside of a polygon and within reach of it. */
static bool is_over(const ew_cone *cone, const ew_hull *seen, double depth, double radius)
{
    double normal[3] = {0}, unit[3];
    const double *first = seen->corners[0], place[3] = {cone->origin[0] + depth * cone->slope[0] - first[0],
                                                        cone->origin[1] + depth * cone->slope[1] - first[1], depth - first[2]};
    for (size_t i = 1; i + 1 < seen->corner_count; ++i) {
        double a[3], b[3], across[3];
        for (int k = 0; k < 3; ++k) {
            a[k] = seen->corners[i][k] - first[k];
            b[k] = seen->corners[i + 1][k] - first[k];
        }
        ew_cross(a, b, across);
        for (int k = 0; k < 3; ++k)
            normal[k] += across[k];
    }
    if (!ew_normalize(normal, unit) || fabs(ew_dot(place, unit)) > radius + cone->growth * depth) return false;
    for (size_t i = 0; i < seen->corner_count; ++i) {
        const double *from = seen->corners[i], *to = seen->corners[(i + 1) % seen->corner_count];
        const double edge[3] = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        double to_place[3], across[3];
        for (int k = 0; k < 3; ++k)
            to_place[k] = place[k] + first[k] - from[k];
        ew_cross(edge, to_place, across);
        if (ew_dot(across, unit) < 0) return false;
    }
    return true;
}

/* Whether the cone comes within `reach` of a corner or an edge of the hull, or of the line that it is. */
static bool meets_outline(const ew_cone *cone, const ew_hull *seen, double reach)
{
    if (ew_hull_is_line(seen)) return meets_line(cone, seen->corners[0], seen->direction, HUGE_VAL, reach);
    for (size_t i = 0; i < seen->corner_count; ++i)
        if (meets_place(cone, seen->corners[i], reach)) return true;
    for (size_t i = 0; i + (seen->corner_count == 2 ? 1 : 0) < seen->corner_count && seen->corner_count > 1; ++i)
        if (meets_edge(cone, seen->corners[i], seen->corners[(i + 1) % seen->corner_count], reach)) return true;
    return false;
}

/* Polygons are met at an edge, or else where the axis goes through or ends over them. */
bool ew_cone_meets(const ew_cone *cone, const ew_hull *seen, double radius)
{
    double reach = radius + cone->width;
    if (meets_outline(cone, seen, reach)) return true;
    return seen->corner_count > 2 && (goes_through(cone, seen) || is_over(cone, seen, cone->depths.start, reach) ||
                                      is_over(cone, seen, cone->depths.end, reach));
}

/* At a depth where the axis is so close to a place of the outline, |A(z) - p| <= R - width - growth z, all rays are close to
 * it. */
bool ew_cone_is_covered(const ew_cone *cone, const ew_hull *seen, double radius)
{
    ew_cone inner = *cone;
    inner.growth = -cone->growth;
    double last = cone->growth > 0 ? (radius - cone->width) / cone->growth : HUGE_VAL;
    if (last < inner.depths.end) inner.depths.end = last;
    return radius > cone->width && meets_outline(&inner, seen, radius - cone->width);
}
