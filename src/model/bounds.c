/* What sources can light of a view: see bounds.h. */
#include "model/bounds.h"

#include "model/vector.h"

/* How many times as far as the nearest thing that matters the interval goes for a source without an end. A ray that is not
 * along an infinite line leaves its reach long before. */
#define ENDLESS_RATIO 1e4

static void to_view(const ew_view *view, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        out[row] = ew_element(view->view, row, 3);
        for (int column = 0; column < 3; ++column)
            out[row] += ew_element(view->view, row, column) * world[column];
    }
}

/* The near plane's view depth of a parallel projection; 0, the eye, of a perspective one. */
static double first_depth(const ew_view *view)
{
    if (!ew_is_parallel(view)) return 0;
    double at_0 = ew_window_depth_at(view, 0, 0, 0), growth = ew_window_depth_at(view, 0, 0, 1) - at_0;
    /* Window depth 0 is the near plane, or 1 if depth is reversed. */
    return growth != 0 ? ((growth > 0 ? 0 : 1) - at_0) / growth : 0;
}

/* ---- The interval ---- */

typedef struct depth_range {
    const ew_view *view;
    double core_growth;
    double least, most; /* the least of all, the most of the balls that have an end */
    double endless;     /* the largest depth at which one that has none may shine; < 0: there is none */
} depth_range;

/* Where cores are as wide as the reach, nothing is left of the light. */
static double last_depth(const depth_range *range, double reach)
{
    return range->core_growth > 0 ? reach / range->core_growth : HUGE_VAL;
}

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

static void take_depths(void *user, const ew_ball *ball, double reach)
{
    depth_range *range = user;
    double center[3], last = last_depth(range, reach);
    to_view(range->view, ball->center, center);
    if (isinf(ball->radius)) {
        double far = ENDLESS_RATIO * (sqrt(ew_dot(center, center)) + reach);
        range->endless = fmax(range->endless, fmin(far, last));
        range->least = fmin(range->least, first_depth_of_line(range->view, ball, center, reach));
        return;
    }
    range->least = fmin(range->least, -center[2] - ball->radius);
    range->most = fmax(range->most, fmin(-center[2] + ball->radius, last));
}

ew_interval ew_lit_interval(const ew_sources *sources, const ew_view *view, double core_growth)
{
    double first = first_depth(view);
    depth_range range = {view, ew_is_parallel(view) ? 0 : core_growth, HUGE_VAL, -HUGE_VAL, -1};
    ew_sources_for_each_lit_ball(sources, take_depths, &range);
    ew_interval interval = {fmax(range.least, first), range.most};
    if (range.endless >= 0) interval.end = fmax(range.most, first + range.endless);
    if (!(interval.end > interval.start)) return (ew_interval){first + 1, first + 2};
    if (!ew_is_parallel(view) && interval.start < EW_MIN_DEPTH_RATIO * interval.end) interval.start = 0;
    return interval;
}

typedef struct distance_range {
    const ew_view *view;
    double farthest;
} distance_range;

static void take_distance(void *user, const ew_ball *ball, double reach)
{
    distance_range *range = user;
    double center[3];
    to_view(range->view, ball->center, center);
    double radius = isinf(ball->radius) ? 0 : ball->radius - reach;
    range->farthest = fmax(range->farthest, sqrt(ew_dot(center, center)) + radius);
}

double ew_lit_scale(const ew_sources *sources, const ew_view *view)
{
    distance_range range = {view, 0};
    ew_sources_for_each_lit_ball(sources, take_distance, &range);
    return range.farthest > 0 ? range.farthest : 1;
}

/* ---- Bounds for the host ---- */

typedef struct screen_range {
    const ew_view *view;
    double first_depth;
    const ew_interval *interval;
    double left, bottom, right, top; /* NDC */
    double depth_start, depth_end;
} screen_range;

/* NDC of a point in front of the eye. */
static void take_point(screen_range *range, double x, double y, double depth)
{
    const double *p = range->view->projection;
    double w = ew_is_parallel(range->view) ? ew_element(p, 3, 3) : -ew_element(p, 3, 2) * depth;
    double ndc[2];
    for (int row = 0; row < 2; ++row)
        ndc[row] =
            (ew_element(p, row, 0) * x + ew_element(p, row, 1) * y - ew_element(p, row, 2) * depth + ew_element(p, row, 3)) / w;
    range->left = fmin(range->left, ndc[0]);
    range->right = fmax(range->right, ndc[0]);
    range->bottom = fmin(range->bottom, ndc[1]);
    range->top = fmax(range->top, ndc[1]);
}

static void take_all(screen_range *range)
{
    range->left = range->bottom = -1;
    range->right = range->top = 1;
}

/* The ball's box in view space, cut at the first depth: what is seen of its corners bounds what is seen of the ball. */
static void take_ball(void *user, const ew_ball *ball, double reach)
{
    (void)reach;
    screen_range *range = user;
    if (isinf(ball->radius)) {
        take_all(range);
        range->depth_start = range->interval ? fmin(range->depth_start, range->interval->start) : range->first_depth;
        range->depth_end = range->interval ? fmax(range->depth_end, range->interval->end) : HUGE_VAL;
        return;
    }
    double center[3], radius = ball->radius;
    to_view(range->view, ball->center, center);
    double start = fmax(-center[2] - radius, range->interval ? range->interval->start : range->first_depth);
    double end = range->interval ? fmin(-center[2] + radius, range->interval->end) : -center[2] + radius;
    if (!(start < end)) return;
    range->depth_start = fmin(range->depth_start, start);
    range->depth_end = fmax(range->depth_end, end);
    if (!ew_is_parallel(range->view) && start <= 1e-6 * end) {
        take_all(range);
        return;
    }
    for (int corner = 0; corner < 8; ++corner)
        take_point(range, center[0] + (corner & 1 ? radius : -radius), center[1] + (corner & 2 ? radius : -radius),
                   corner & 4 ? end : start);
}

/* The pixels from NDC `low` to `high` of `size` pixels from `start` on. */
static void to_pixels(double low, double high, int start, int size, int *first, int *count)
{
    double from = floor((fmax(low, -1) * 0.5 + 0.5) * size), to = ceil((fmin(high, 1) * 0.5 + 0.5) * size);
    *first = start + (int)from;
    *count = to > from ? (int)(to - from) : 0;
}

ew_bounds ew_find_bounds(const ew_sources *sources, const ew_view *view, const ew_interval *interval,
                         const ew_viewport *viewport)
{
    screen_range range = {view, first_depth(view), interval, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    ew_sources_for_each_lit_ball(sources, take_ball, &range);
    ew_bounds bounds = {.x = viewport->x, .y = viewport->y};
    if (!(range.left < 1 && range.right > -1 && range.bottom < 1 && range.top > -1)) return bounds;
    to_pixels(range.left, range.right, viewport->x, viewport->width, &bounds.x, &bounds.width);
    to_pixels(range.bottom, range.top, viewport->y, viewport->height, &bounds.y, &bounds.height);
    bounds.depth_start = range.depth_start;
    bounds.depth_end = range.depth_end;
    return bounds;
}
