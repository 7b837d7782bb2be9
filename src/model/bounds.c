/* What sources can light of a view: see bounds.h. */
#include "model/bounds.h"

#include "model/hull.h"
#include "model/silhouette.h"

#include <limits.h>

static const ew_silhouette nothing = {{HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, -HUGE_VAL}};

static bool is_nothing(const ew_silhouette *silhouette)
{
    return !(silhouette->depths.start < silhouette->depths.end);
}

static void unite(ew_silhouette *all, const ew_silhouette *one)
{
    for (int k = 0; k < 2; ++k) {
        all->low[k] = fmin(all->low[k], one->low[k]);
        all->high[k] = fmax(all->high[k], one->high[k]);
    }
    all->depths.start = fmin(all->depths.start, one->depths.start);
    all->depths.end = fmax(all->depths.end, one->depths.end);
}

static ew_silhouette silhouette_of(const ew_lit_source *lit, const ew_view *view, const ew_interval *depths)
{
    if (lit->reach == 0) return (ew_silhouette){{-1, -1}, {1, 1}, *depths};
    ew_silhouette all = nothing, one;
    for (size_t i = 0; i < ew_count_hulls(lit); ++i) {
        const ew_hull hull = ew_hull_of_source(lit, i), seen = ew_see_hull(&hull, view);
        if (ew_find_silhouette(&seen, lit->reach, view, depths, &one)) unite(&all, &one);
    }
    return all;
}

/* The pixels from NDC `low` to `high` of `size` pixels from `start` on, as far as an int can count them. */
static void to_pixels(double low, double high, int start, int size, int *first, int *count)
{
    double from = start + floor((low * 0.5 + 0.5) * size), to = start + ceil((high * 0.5 + 0.5) * size);
    *first = (int)fmin(from, INT_MAX);
    *count = (int)(to - *first);
}

static ew_bounds to_bounds(const ew_silhouette *silhouette, const ew_viewport *viewport)
{
    ew_bounds bounds = {.x = viewport->x, .y = viewport->y};
    if (is_nothing(silhouette)) return bounds;
    to_pixels(silhouette->low[0], silhouette->high[0], viewport->x, viewport->width, &bounds.x, &bounds.width);
    to_pixels(silhouette->low[1], silhouette->high[1], viewport->y, viewport->height, &bounds.y, &bounds.height);
    bounds.depth_start = silhouette->depths.start;
    bounds.depth_end = silhouette->depths.end;
    return bounds;
}

ew_bounds ew_find_source_bounds(const ew_lit_source *lit, const ew_view *view, const ew_interval *depths,
                                const ew_viewport *viewport)
{
    const ew_silhouette silhouette = silhouette_of(lit, view, depths);
    return to_bounds(&silhouette, viewport);
}

ew_bounds ew_find_bounds(const ew_sources *sources, double light_reach, const ew_view *view, const ew_interval *depths,
                         const ew_viewport *viewport)
{
    ew_silhouette all = nothing;
    for (size_t i = 0; i < sources->lit_count; ++i) {
        const ew_lit_source lit = ew_lit_source_at(sources, i, light_reach);
        const ew_silhouette one = silhouette_of(&lit, view, depths);
        unite(&all, &one);
    }
    return to_bounds(&all, viewport);
}

ew_bounds ew_find_media_bounds(const ew_medium *media, size_t count, const ew_view *view, const ew_viewport *viewport)
{
    const ew_interval depths = {ew_first_depth(view), HUGE_VAL};
    ew_silhouette all = nothing, one;
    for (size_t i = 0; i < count; ++i)
        for (int face = 0; face < EW_MEDIUM_FACES; ++face) {
            const ew_hull hull = ew_face_of_medium(&media[i], face), seen = ew_see_hull(&hull, view);
            /* A face that is seen from straight ahead would have no depths. */
            const double thickness = 1e-9 * sqrt(ew_dot(media[i].half_axes[face / 2], media[i].half_axes[face / 2]));
            if (ew_find_silhouette(&seen, thickness, view, &depths, &one)) unite(&all, &one);
        }
    return to_bounds(&all, viewport);
}

ew_bounds ew_unite_bounds(const ew_bounds *a, const ew_bounds *b)
{
    if (a->width == 0 || a->height == 0) return *b;
    if (b->width == 0 || b->height == 0) return *a;
    int x = a->x < b->x ? a->x : b->x, y = a->y < b->y ? a->y : b->y;
    int right_a = a->x + a->width, right_b = b->x + b->width, top_a = a->y + a->height, top_b = b->y + b->height;
    return (ew_bounds){.x = x,
                       .y = y,
                       .width = (right_a > right_b ? right_a : right_b) - x,
                       .height = (top_a > top_b ? top_a : top_b) - y,
                       .depth_start = fmin(a->depth_start, b->depth_start),
                       .depth_end = fmax(a->depth_end, b->depth_end)};
}
