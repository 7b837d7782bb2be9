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

/* Where the nearer part changes: returns how often it does, up to 2; with 1, *s is where, and *first the part that is nearer
 * before. With 0 that is nearest all the way. */
static int find_change(const ew_curve parts[2], const reference_ray *ray, double *s, int *first)
{
    double last_s = 0, last = 0;
    int changes = 0;
    *first = 0;
    for (int i = 0; i <= STEPS && changes < 2; i++) {
        /* Denser towards the eye, where the light is. */
        double here_s = ray->s_max * pow(i / (double)STEPS, 2), here = nearness(parts, ray, here_s);
        if (here == 0) continue;
        if (last == 0) {
            *first = here > 0;
        } else if ((here > 0) != (last > 0)) {
            double low = last_s, high = here_s;
            for (int k = 0; k < 60; k++) {
                double middle = 0.5 * (low + high), at_middle = nearness(parts, ray, middle);
                if (at_middle != 0 && (at_middle > 0) == (last > 0))
                    low = middle;
                else
                    high = middle;
            }
            *s = high;
            changes++;
        }
        last = here;
        last_s = here_s;
    }
    return changes;
}

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
    return part;
}

bool curve_splits(equation_stage *s, size_t index, const double ramp[2])
{
    const double *domain = s->scene->sources.curves[index].domain, middle = domain[0] + 0.4 * (domain[1] - domain[0]);
    const double ends[3][2] = {{domain[0], domain[1]}, {domain[0], middle}, {middle, domain[1]}};
    double weights[3][2];
    ew_curve seen[2], drawn[3];
    for (int i = 0; i < 3; i++)
        drawn[i] = part_of(&s->scene->sources.curves[index], ramp, ends[i], weights[i]);
    for (int i = 0; i < 2; i++)
        seen[i] = part_of(&s->rays.sources.curves[index], NULL, ends[i + 1], NULL);

    /* Which part comes first differs from pixel to pixel, so both ways are drawn; `order` says which one is meant. */
    static float depth_at_change[EQUATION_PIXEL_COUNT];
    static bool applies[2][EQUATION_PIXEL_COUNT];
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        double opaque_depth = scene_rays_stored_depth(&s->rays, (double)s->depth[i]), change = 0;
        reference_ray ray = scene_rays_ray(&s->rays, i % EQUATION_SIDE + 0.5, i / EQUATION_SIDE + 0.5, opaque_depth);
        int first, changes = find_change(seen, &ray, &change, &first);
        double depth = s->rays.interval_start + change * (s->rays.interval_end - s->rays.interval_start);
        depth_at_change[i] = scene_rays_depth_to_store(&s->rays, changes == 0 ? opaque_depth : depth);
        applies[0][i] = changes < 2 && first == 0;
        applies[1][i] = changes < 2 && first == 1;
    }
    luminance_sum whole = {{0}, {0}}, ordered[2] = {{{0}, {0}}, {{0}, {0}}}, parts;
    ew_frame_desc frame = equation_frame(s);
    ew_sources_desc arc = {.curves = &drawn[0], .curve_count = 1, .epsilon = s->scene->sources.epsilon};
    if (!equation_add_picture(s, &arc, &frame, s->depth, 1, &whole)) return false;
    for (int order = 0; order < 2; order++) {
        ew_sources_desc near = arc, far = arc;
        near.curves = &drawn[1 + order];
        far.curves = &drawn[2 - order];
        if (!equation_add_picture(s, &near, &frame, depth_at_change, 1, &ordered[order]) ||
            !equation_add_picture(s, &far, &frame, s->depth, 1, &ordered[order]) ||
            !equation_add_picture(s, &far, &frame, depth_at_change, -1, &ordered[order]))
            return false;
    }
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        const luminance_sum *meant = &ordered[applies[1][i]];
        parts.sum[i] = meant->sum[i];
        parts.allowance[i] = meant->allowance[i];
        applies[0][i] = applies[0][i] || applies[1][i];
    }
    char name[40];
    snprintf(name, sizeof name, "curve %zu split%s", index, ramp ? ", weighted" : "");
    equation_compare(s, name, &whole, &parts, applies[0]);
    return true;
}
