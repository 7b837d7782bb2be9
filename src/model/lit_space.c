/* The space of the world integral: see lit_space.h. */
#include "model/lit_space.h"

#include "model/vector.h"

/* How many times as far as the nearest thing that matters the interval goes for a source without an end. A ray that is not
 * along an infinite line leaves its reach long before. */
#define ENDLESS_RATIO 1e4
/* The first depth of a perspective view over the last: the eye itself has no window depth. */
#define MIN_DEPTH_RATIO 1e-9

typedef struct lit_range {
    double least, most; /* depths of what has an end */
    double endless;     /* the largest depth at which what has none may shine; < 0: there is none */
    double farthest;    /* distance from the eye, without reaches */
} lit_range;

static void take(lit_range *range, const ew_lit_source *lit, const ew_view *view, double core_growth)
{
    double center[3];
    ew_to_view(view, lit->ball.center, center);
    double distance = sqrt(ew_dot(center, center));
    /* Where cores are as wide as the reach, nothing is left of the light. */
    double last = core_growth > 0 ? lit->reach / core_growth : HUGE_VAL;
    if (isinf(lit->ball.radius)) {
        range->endless = fmax(range->endless, fmin(ENDLESS_RATIO * (distance + lit->reach), last));
        range->farthest = fmax(range->farthest, distance);
        return;
    }
    double radius = lit->ball.radius + lit->reach;
    range->least = fmin(range->least, -center[2] - radius);
    range->most = fmax(range->most, fmin(-center[2] + radius, last));
    range->farthest = fmax(range->farthest, distance + lit->ball.radius);
}

static ew_interval interval_of(const lit_range *range, const ew_view *view)
{
    double first = ew_first_depth(view);
    ew_interval interval = {fmax(range->least, first), range->most};
    if (range->endless >= 0) {
        interval.start = first;
        interval.end = fmax(range->most, first + range->endless);
    }
    if (!(interval.end > interval.start)) return (ew_interval){first + 1, first + 2};
    if (!ew_is_parallel(view)) interval.start = fmax(interval.start, MIN_DEPTH_RATIO * interval.end);
    return interval;
}

ew_lit_space ew_find_lit_space(const ew_sources *sources, const ew_view *view, double core_growth)
{
    lit_range range = {HUGE_VAL, -HUGE_VAL, -1, 0};
    if (ew_is_parallel(view)) core_growth = 0;
    for (size_t i = 0; i < sources->lit_count; ++i)
        take(&range, &sources->lit[i], view, core_growth);
    return (ew_lit_space){interval_of(&range, view), range.farthest > 0 ? range.farthest : 1};
}
