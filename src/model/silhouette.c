/* Silhouettes: see silhouette.h. */
#include "model/silhouette.h"

#include "model/hull.h"
#include "model/screen_axis.h"
#include "model/vector.h"

static bool find_depths(const ew_hull *seen, double radius, const ew_interval *depths, ew_interval *found)
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t i = 0; i < seen->corner_count; ++i) {
        least = fmin(least, seen->corners[i][2] - radius);
        most = fmax(most, seen->corners[i][2] + radius);
    }
    bool is_endless = fabs(seen->direction[2]) >= EW_LEAST_DRIFT;
    found->start = is_endless ? depths->start : fmax(least, depths->start);
    found->end = is_endless ? depths->end : fmin(most, depths->end);
    return found->start < found->end;
}

static void take_hull(ew_screen_axis *axis, const ew_hull *seen)
{
    double corners[EW_MAX_HULL_CORNERS][2], direction[2];
    for (size_t i = 0; i < seen->corner_count; ++i)
        ew_screen_axis_project(axis, seen->corners[i], false, corners[i]);
    if (ew_hull_is_line(seen)) {
        ew_screen_axis_project(axis, seen->direction, true, direction);
        ew_screen_axis_take_line(axis, corners[0], direction);
        return;
    }
    for (size_t i = 0; i < seen->corner_count; ++i) {
        ew_screen_axis_take_disc(axis, corners[i]);
        ew_screen_axis_take_edge(axis, corners[i], corners[(i + 1) % seen->corner_count]);
    }
}

/* ---- A line's outline ---- */

/* A line across the screen: what is seen has c + x X + y Y >= 0 in NDC. */
typedef struct border {
    double c, x, y;
} border;

/* The border that belongs to c + normal . (x, y, depth) >= 0, at a depth. */
static border make_border(const ew_view *view, double c, const double normal[3], double depth)
{
    double middle[2], right[2], up[2];
    ew_ray_at(view, 0, 0, depth, middle);
    ew_ray_at(view, 1, 0, depth, right);
    ew_ray_at(view, 0, 1, depth, up);
    return (border){c + normal[0] * middle[0] + normal[1] * middle[1] + normal[2] * depth,
                    normal[0] * (right[0] - middle[0]) + normal[1] * (right[1] - middle[1]),
                    normal[0] * (up[0] - middle[0]) + normal[1] * (up[1] - middle[1])};
}

/* Two planes through the eye touch the cylinder of the radius around the line. Returns false for an eye inside of it. */
static bool find_perspective_borders(const ew_view *view, const double place[3], const double along[3], double radius,
                                     border borders[2])
{
    double eye[3] = {0}, to_line[3], across[3];
    ew_ray_at(view, 0, 0, 0, eye);
    for (int i = 0; i < 3; ++i)
        to_line[i] = place[i] - eye[i];
    double shift = ew_dot(to_line, along);
    for (int i = 0; i < 3; ++i)
        to_line[i] -= shift * along[i];
    double distance = sqrt(ew_dot(to_line, to_line));
    if (!(distance > radius)) return false;
    ew_cross(along, to_line, across);
    double sine = radius / distance, cosine = sqrt((distance - radius) * (distance + radius)) / distance;
    for (int side = 0; side < 2; ++side) {
        double normal[3];
        for (int i = 0; i < 3; ++i)
            normal[i] = (sine * to_line[i] + (side ? -cosine : cosine) * across[i]) / distance;
        borders[side] = make_border(view, -ew_dot(normal, eye), normal, 1);
    }
    return true;
}

/* Rays are as far from the line as from a plane that it shares with their direction. Returns false for a line along them. */
static bool find_parallel_borders(const ew_view *view, const double place[3], const double along[3], double radius,
                                  border borders[2])
{
    double start[2], end[2], across[3];
    ew_ray_at(view, 0, 0, 0, start);
    ew_ray_at(view, 0, 0, 1, end);
    const double ray[3] = {end[0] - start[0], end[1] - start[1], 1};
    ew_cross(ray, along, across);
    double length = sqrt(ew_dot(across, across));
    if (!(length >= EW_LEAST_DRIFT)) return false;
    for (int side = 0; side < 2; ++side) {
        double normal[3];
        for (int i = 0; i < 3; ++i)
            normal[i] = (side ? -1 : 1) * across[i] / length;
        borders[side] = make_border(view, radius - ew_dot(normal, place), normal, 0);
    }
    return true;
}

/* ---- What its outline leaves of a box ---- */

/* Each cut adds half as many, though only 1 unless rounding puts places on the wrong side. */
enum { MAX_POLYGON = 9 };

typedef struct polygon {
    double places[MAX_POLYGON][2];
    size_t count;
} polygon;

static void add(polygon *p, double x, double y)
{
    p->places[p->count][0] = x;
    p->places[p->count++][1] = y;
}

static double height(const border *b, const double place[2])
{
    return b->c + b->x * place[0] + b->y * place[1];
}

/* Sutherland and Hodgman, "Reentrant polygon clipping", 1974. */
static polygon cut(const polygon *whole, const border *b)
{
    polygon left = {.count = 0};
    for (size_t i = 0; i < whole->count; ++i) {
        const double *here = whole->places[i], *next = whole->places[(i + 1) % whole->count];
        double at_here = height(b, here), at_next = height(b, next), t = at_here / (at_here - at_next);
        if (at_here >= 0) add(&left, here[0], here[1]);
        if ((at_here >= 0) != (at_next >= 0)) add(&left, here[0] + t * (next[0] - here[0]), here[1] + t * (next[1] - here[1]));
    }
    return left;
}

static bool cut_silhouette(ew_silhouette *s, const border borders[2])
{
    polygon left = {.count = 0};
    add(&left, s->low[0], s->low[1]);
    add(&left, s->high[0], s->low[1]);
    add(&left, s->high[0], s->high[1]);
    add(&left, s->low[0], s->high[1]);
    left = cut(&left, &borders[0]);
    left = cut(&left, &borders[1]);
    for (int k = 0; k < 2; ++k) {
        s->low[k] = HUGE_VAL;
        s->high[k] = -HUGE_VAL;
        for (size_t i = 0; i < left.count; ++i) {
            s->low[k] = fmin(s->low[k], left.places[i][k]);
            s->high[k] = fmax(s->high[k], left.places[i][k]);
        }
    }
    return left.count > 0;
}

/* ---- All of it ---- */

bool ew_find_silhouette(const ew_hull *seen, double radius, const ew_view *view, const ew_interval *depths,
                        ew_silhouette *silhouette)
{
    if (!find_depths(seen, radius, depths, &silhouette->depths)) return false;
    for (int k = 0; k < 2; ++k) {
        ew_screen_axis axis = ew_make_screen_axis(view, k, radius, depths);
        take_hull(&axis, seen);
        if (!(axis.low < 1 && axis.high > -1)) return false;
        silhouette->low[k] = fmax(axis.low, -1);
        silhouette->high[k] = fmin(axis.high, 1);
    }
    if (!ew_hull_is_line(seen)) return true;
    border borders[2];
    bool has_borders = ew_is_parallel(view)
                           ? find_parallel_borders(view, seen->corners[0], seen->direction, radius, borders)
                           : find_perspective_borders(view, seen->corners[0], seen->direction, radius, borders);
    return !has_borders || cut_silhouette(silhouette, borders);
}
