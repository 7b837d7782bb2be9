/* One axis of the screen: see screen_axis.h.
 *
 * What is seen of a plane has its extremes where a line of sight, from the eye on or parallel, touches a disc, or where the
 * first or the last depth cuts the outline. */
#include "model/screen_axis.h"

#include "model/vector.h"

ew_screen_axis ew_make_screen_axis(const ew_view *view, int index, double radius, const ew_interval *depths)
{
    const double *p = view->projection;
    double right = ew_element(p, index, 0), up = ew_element(p, index, 1), length = hypot(right, up);
    bool is_parallel = ew_is_parallel(view);
    double w = is_parallel ? ew_element(p, 3, 3) : -ew_element(p, 3, 2);
    return (ew_screen_axis){.is_parallel = is_parallel,
                            .depths = *depths,
                            .radius = radius,
                            .toward = {right / length, up / length},
                            .offset = ew_element(p, index, 3) / length,
                            .scale = length / w,
                            .drift = ew_element(p, index, 2) / length,
                            .low = HUGE_VAL,
                            .high = -HUGE_VAL};
}

void ew_screen_axis_project(const ew_screen_axis *axis, const double view[3], bool is_direction, double out[2])
{
    out[0] = axis->toward[0] * view[0] + axis->toward[1] * view[1] + (is_direction ? 0 : axis->offset);
    out[1] = view[2];
}

static void take(ew_screen_axis *axis, double ndc)
{
    axis->low = fmin(axis->low, ndc);
    axis->high = fmax(axis->high, ndc);
}

static void take_all(ew_screen_axis *axis)
{
    take(axis, -HUGE_VAL);
    take(axis, HUGE_VAL);
}

static void take_place(ew_screen_axis *axis, double x, double depth)
{
    double seen = axis->scale * (x - axis->drift * depth);
    if (axis->is_parallel)
        take(axis, seen);
    else if (depth > 0 || seen != 0)
        take(axis, seen / depth);
    else
        take_all(axis);
}

/* ---- A corner ---- */

static void take_chord(ew_screen_axis *axis, const double center[2], double depth)
{
    double away = fabs(depth - center[1]);
    if (!(away <= axis->radius)) return;
    double half = sqrt((axis->radius - away) * (axis->radius + away));
    take_place(axis, center[0] - half, depth);
    take_place(axis, center[0] + half, depth);
}

static void take_if_between(ew_screen_axis *axis, double x, double depth)
{
    if (depth >= axis->depths.start && depth <= axis->depths.end) take_place(axis, x, depth);
}

/* The lines from the eye, (0, 0), that touch a disc: Thales. */
static void take_tangents_from_eye(ew_screen_axis *axis, const double center[2])
{
    double distance = hypot(center[0], center[1]);
    if (!(distance > axis->radius)) return;
    double cosine = sqrt((distance - axis->radius) * (distance + axis->radius)) / distance, sine = axis->radius / distance;
    for (int side = -1; side <= 1; side += 2)
        take_if_between(axis, cosine * (cosine * center[0] - side * sine * center[1]),
                        cosine * (cosine * center[1] + side * sine * center[0]));
}

static void take_parallel_tangents(ew_screen_axis *axis, const double center[2])
{
    double step = axis->radius / hypot(1, axis->drift);
    for (int side = -1; side <= 1; side += 2)
        take_if_between(axis, center[0] + side * step, center[1] - side * step * axis->drift);
}

void ew_screen_axis_take_disc(ew_screen_axis *axis, const double center[2])
{
    if (axis->is_parallel)
        take_parallel_tangents(axis, center);
    else
        take_tangents_from_eye(axis, center);
    take_chord(axis, center, axis->depths.start);
    take_chord(axis, center, axis->depths.end);
}

/* ---- An edge and a line ---- */

/* Extremes on it are only where a depth cuts it. */
void ew_screen_axis_take_edge(ew_screen_axis *axis, const double start[2], const double end[2])
{
    const double edge[2] = {end[0] - start[0], end[1] - start[1]}, depths[2] = {axis->depths.start, axis->depths.end};
    double length = hypot(edge[0], edge[1]);
    if (length == 0) return;
    for (int side = -1; side <= 1; side += 2)
        for (int cut = 0; cut < 2; ++cut) {
            double step = side * axis->radius / length;
            double along = (depths[cut] - (start[1] - step * edge[0])) / edge[1];
            if (along >= 0 && along <= 1) take_place(axis, start[0] + step * edge[1] + along * edge[0], depths[cut]);
        }
}

/* The last that is seen of a side of a line, x = x_at_0 + slope depth. */
static void take_last(ew_screen_axis *axis, double x_at_0, double slope)
{
    double drift = slope - axis->drift;
    if (isfinite(axis->depths.end))
        take_place(axis, x_at_0 + slope * axis->depths.end, axis->depths.end);
    else if (!axis->is_parallel)
        take(axis, axis->scale * drift);
    else if (fabs(drift) < EW_LEAST_DRIFT)
        take(axis, axis->scale * x_at_0);
    else
        take(axis, copysign(HUGE_VAL, drift));
}

void ew_screen_axis_take_line(ew_screen_axis *axis, const double place[2], const double direction[2])
{
    double length = hypot(direction[0], direction[1]), slope = direction[0] / direction[1];
    if (length < EW_LEAST_DRIFT)
        ew_screen_axis_take_disc(axis, place);
    else if (fabs(direction[1]) < EW_LEAST_DRIFT * length)
        take_all(axis);
    else
        for (int side = -1; side <= 1; side += 2) {
            double x_at_0 = place[0] + side * axis->radius * length / direction[1] - slope * place[1];
            take_place(axis, x_at_0 + slope * axis->depths.start, axis->depths.start);
            take_last(axis, x_at_0, slope);
        }
}
