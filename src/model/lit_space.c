/* The space of the world integral: see lit_space.h. */
#include "model/lit_space.h"

#include "model/limits.h"
#include "model/vector.h"

/* How many times as far as the nearest thing that matters the interval goes for a source without an end. A ray that is not
 * along an infinite line leaves its reach long before. */
#define ENDLESS_RATIO 1e4

typedef struct lit_range {
    double least, most; /* depths: the least of all, the most of what has an end */
    double endless;     /* the largest depth at which what has none may shine; < 0: there is none */
    double farthest;    /* distance from the eye, without reaches */
} lit_range;

/* How long a ray of the picture is at the most, per unit of view depth. */
static double longest_ray(const ew_view *view)
{
    double longest = 0;
    for (int corner = 0; corner < 4; ++corner) {
        double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, start[2], end[2];
        ew_ray_at(view, x, y, 0, start);
        ew_ray_at(view, x, y, 1, end);
        longest = fmax(longest, sqrt(1 + pow(end[0] - start[0], 2) + pow(end[1] - start[1], 2)));
    }
    return longest;
}

/* No ray of a perspective view is lit by a line before it is as long as the line's light is far away. */
static double first_depth_of_line(const ew_view *view, const ew_ball *line, const double center[3], double reach)
{
    double axis[3], start[2];
    if (ew_is_parallel(view)) return -HUGE_VAL;
    for (int row = 0; row < 3; ++row)
        axis[row] = ew_element(view->view, row, 0) * line->axis[0] + ew_element(view->view, row, 1) * line->axis[1] +
                    ew_element(view->view, row, 2) * line->axis[2];
    double along = ew_dot(center, axis), square = 0;
    for (int i = 0; i < 3; ++i)
        square += pow(center[i] - along * axis[i], 2);
    ew_ray_at(view, 0, 0, 0, start);
    return (sqrt(square) - reach - hypot(start[0], start[1])) / longest_ray(view);
}

static void take(lit_range *range, const ew_lit_source *lit, const ew_view *view, double core_growth)
{
    double center[3];
    ew_to_view(view, lit->ball.center, center);
    double distance = sqrt(ew_dot(center, center));
    /* Where cores are as wide as the reach, nothing is left of the light. */
    double last = core_growth > 0 ? lit->reach / core_growth : HUGE_VAL;
    if (isinf(lit->ball.radius)) {
        range->endless = fmax(range->endless, fmin(ENDLESS_RATIO * (distance + lit->reach), last));
        range->least = fmin(range->least, first_depth_of_line(view, &lit->ball, center, lit->reach));
        range->farthest = fmax(range->farthest, distance);
        return;
    }
    double radius = lit->ball.radius + lit->reach;
    range->least = fmin(range->least, -center[2] - radius);
    range->most = fmax(range->most, fmin(-center[2] + radius, last));
    range->farthest = fmax(range->farthest, distance + lit->ball.radius);
}

/* Where nothing is lit along view rays, surfaces may be: the interval is about as far away as the sources, `unit`. */
static ew_interval interval_of(const lit_range *range, double unit, const ew_view *view)
{
    double first = ew_first_depth(view);
    ew_interval interval = {fmax(range->least, first), range->most};
    if (range->endless >= 0) interval.end = fmax(range->most, first + range->endless);
    if (!(interval.end > interval.start)) return (ew_interval){first + unit, first + 2 * unit};
    if (!ew_is_parallel(view) && interval.start < EW_MIN_DEPTH_RATIO * interval.end) interval.start = 0;
    return interval;
}

ew_lit_space ew_find_lit_space(const ew_sources *sources, double light_reach, const ew_view *view, double core_growth)
{
    lit_range range = {HUGE_VAL, -HUGE_VAL, -1, 0};
    if (ew_is_parallel(view)) core_growth = 0;
    for (size_t i = 0; i < sources->lit_count; ++i) {
        const ew_lit_source lit = ew_lit_source_at(sources, i, light_reach);
        take(&range, &lit, view, core_growth);
    }
    double unit = range.farthest > 0 ? range.farthest : 1;
    return (ew_lit_space){interval_of(&range, unit, view), unit};
}
