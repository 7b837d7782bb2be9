/*
 * A curve split at a point of the arc: see curve_split.h.
 *
 * The field of an arc is not the sum of its parts': the distance to the arc is that to the nearer part. But a ray of which one
 * stretch is nearer to one part, and the rest to the other, sees the one until where that changes, and the other from there on.
 * What lies beyond is cut off by depth, the same for both, so that its rounding does not matter:
 *
 *     B(arc) = B(near part, up to the change) + B(far part) - B(far part, up to the change)
 */
#include "curve_split.h"
#include "reference_arc.h"
#include "vector.h"

#include <math.h>
#include <stdio.h>

enum { STEPS = 160 };

/* The difference of the squared distances at the ray's parameter s, 0 where it is but rounding. */
static double nearness(const ew_curve parts[2], const reference_ray *ray, double s)
{
    double place[3], distances[2];
    for (int i = 0; i < 3; i++)
        place[i] = ray->start[i] + s * (ray->end[i] - ray->start[i]);
    for (int i = 0; i < 2; i++)
        distances[i] = reference_curve_distance(&parts[i], place, NULL);
    double difference = distances[0] - distances[1];
    return fabs(difference) < 1e-9 * (distances[0] + distances[1]) ? 0 : difference;
}

/* Where the sign of nearness changes between low, where it is that of `before`, and high. */
static double bisect_change(const ew_curve parts[2], const reference_ray *ray, double low, double high, double before)
{
    for (int k = 0; k < 60; k++) {
        double middle = 0.5 * (low + high), at_middle = nearness(parts, ray, middle);
        if (at_middle != 0 && (at_middle > 0) == (before > 0))
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Where along a ray the nearer part changes. */
typedef struct part_order {
    int changes; /* how often it does, up to 2 */
    double s;    /* of the last change */
    int first;   /* the part that is nearer before */
} part_order;

static part_order find_order(const ew_curve parts[2], const reference_ray *ray)
{
    double last_s = 0, last = 0;
    part_order order = {0};
    for (int i = 0; i <= STEPS && order.changes < 2; i++) {
        /* Denser towards the eye, where the light is. */
        double here_s = ray->s_max * pow(i / (double)STEPS, 2), here = nearness(parts, ray, here_s);
        if (here == 0) continue;
        if (last == 0) {
            order.first = here > 0;
        } else if ((here > 0) != (last > 0)) {
            order.s = bisect_change(parts, ray, last_s, here_s, last);
            order.changes++;
        }
        last = here;
        last_s = here_s;
    }
    return order;
}

/* Sharpness shapes the light of the whole, which is then no sum. */
static ew_curve part_of(const ew_curve *curve, const double ramp[2], const double ends[2], double weights[2])
{
    ew_curve part = *curve;
    for (int i = 0; i < 2; i++) {
        part.domain[i] = ends[i];
        double u = (ends[i] - curve->domain[0]) / (curve->domain[1] - curve->domain[0]);
        if (ramp) weights[i] = (1 - u) * ramp[0] + u * ramp[1];
    }
    part.weights = ramp ? weights : NULL;
    part.weight_count = ramp ? 2 : 0;
    part.sharpness = 0;
    return part;
}

/* At each pixel, what hides the light behind the change, and whether the equation says something, with which part first. */
typedef struct change_map {
    float depth[EQUATION_PIXEL_COUNT];
    bool applies[EQUATION_PIXEL_COUNT];
    int first[EQUATION_PIXEL_COUNT];
} change_map;

static void map_changes(const equation_stage *s, const ew_curve parts[2], change_map *map)
{
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        double opaque_depth = scene_rays_stored_depth(&s->rays, (double)s->depth[i]);
        reference_ray ray = scene_rays_ray(&s->rays, i % EQUATION_SIDE + 0.5, i / EQUATION_SIDE + 0.5, opaque_depth);
        part_order order = find_order(parts, &ray);
        double depth = (1 - order.s) * vector_dot(s->rays.forward, ray.start) + order.s * vector_dot(s->rays.forward, ray.end);
        map->depth[i] = scene_rays_depth_to_store(&s->rays, order.changes == 0 ? opaque_depth : depth);
        map->applies[i] = order.changes < 2;
        map->first[i] = order.first;
    }
}

/* The right side of the equation, as if the same part came first everywhere. */
static bool add_parts(equation_stage *s, const ew_curve *near, const ew_curve *far, const float *depth_at_change,
                      luminance_sum *sum)
{
    ew_frame_desc frame = equation_frame(s);
    double epsilon = s->scene->sources.epsilon;
    ew_sources_desc near_part = {.curves = near, .curve_count = 1, .epsilon = epsilon};
    ew_sources_desc far_part = {.curves = far, .curve_count = 1, .epsilon = epsilon};
    return equation_add_picture(s, &near_part, &frame, depth_at_change, 1, sum) &&
           equation_add_picture(s, &far_part, &frame, s->depth, 1, sum) &&
           equation_add_picture(s, &far_part, &frame, depth_at_change, -1, sum);
}

bool curve_splits(equation_stage *s, size_t index, const double ramp[2])
{
    const ew_curve *curve = &s->scene->sources.curves[index], *seen = &s->rays.sources.curves[index];
    const double *domain = curve->domain, middle = domain[0] + 0.4 * (domain[1] - domain[0]);
    const double ends[2][2] = {{domain[0], middle}, {middle, domain[1]}};
    double weights[3][2];
    ew_curve arc = part_of(curve, ramp, domain, weights[2]), drawn_parts[2], seen_parts[2];
    for (int i = 0; i < 2; i++) {
        drawn_parts[i] = part_of(curve, ramp, ends[i], weights[i]);
        seen_parts[i] = part_of(seen, NULL, ends[i], NULL);
    }
    static change_map map;
    map_changes(s, seen_parts, &map);

    luminance_sum whole = {{0}, {0}}, by_first[2] = {{{0}, {0}}, {{0}, {0}}}, parts;
    ew_frame_desc frame = equation_frame(s);
    ew_sources_desc whole_arc = {.curves = &arc, .curve_count = 1, .epsilon = s->scene->sources.epsilon};
    if (!equation_add_picture(s, &whole_arc, &frame, s->depth, 1, &whole)) return false;
    /* Which part comes first differs from pixel to pixel, so both ways are drawn. */
    for (int first = 0; first < 2; first++)
        if (!add_parts(s, &drawn_parts[first], &drawn_parts[1 - first], map.depth, &by_first[first])) return false;
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        parts.sum[i] = by_first[map.first[i]].sum[i];
        parts.allowance[i] = by_first[map.first[i]].allowance[i];
    }
    char name[40];
    snprintf(name, sizeof name, "curve %zu split%s", index, ramp ? ", weighted" : "");
    equation_compare(s, name, &whole, &parts, map.applies);
    return true;
}
