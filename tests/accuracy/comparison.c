/* A picture's luminance against the reference: see comparison.h. */
#include "comparison.h"
#include "sort.h"

#include <math.h>
#include <stdlib.h>

bool comparison_make(const true_pixels *truth, const drawn_picture *picture, picture_comparison *comparison)
{
    *comparison = (picture_comparison){0};
    double *errors = malloc((truth->count + 1) * sizeof *errors);
    if (!errors) return false;
    size_t count = 0;
    for (size_t i = 0; i < truth->count; i++) {
        const true_pixel *pixel = &truth->pixels[i];
        if (!pixel->reliable) continue;
        double error = true_pixel_error(truth, picture, pixel);
        if (pixel->representative) errors[count++] = error;
        if (error <= comparison->largest_error) continue;
        comparison->largest_error = error;
        comparison->worst_x = pixel->x;
        comparison->worst_y = pixel->y;
        comparison->worst_luminance = true_pixel_luminance(picture, pixel);
        comparison->worst_truth = pixel->luminance;
    }
    sort_numbers(errors, count);
    if (count > 0) comparison->percentile_99 = errors[(count - 1) * 99 / 100];
    free(errors);
    for (size_t i = 0; i < (size_t)picture->width * (size_t)picture->height; i++)
        if (!(picture->luminance[i] >= 0 && isfinite(picture->luminance[i]))) comparison->bad_count++;
    return true;
}

size_t depth_misses(const scene_rays *rays, const true_pixels *truth, const drawn_picture *picture)
{
    enum { CHECKS = 400 };
    size_t misses = 0, stride = 1 + truth->count / CHECKS;
    for (size_t i = 0; i < truth->count; i += stride) {
        const true_pixel *pixel = &truth->pixels[i];
        double nearest = HUGE_VAL, farthest = 0;
        for (int k = 0; k < 4; k++) {
            double x = pixel->x + 0.5 + (k % 2 ? 1 : -1) / 32.0, y = pixel->y + 0.5 + (k / 2 ? 1 : -1) / 32.0;
            double depth = fmin(scene_rays_cast(rays, x, y), rays->camera.far_depth);
            nearest = fmin(nearest, depth);
            farthest = fmax(farthest, depth);
        }
        float stored = picture->depth[true_pixel_index(picture, pixel)];
        /* The buffer's own steps, and those of the vertices' floats. */
        double low = scene_rays_stored_depth(rays, (double)stored - 5e-7),
               high = scene_rays_stored_depth(rays, (double)stored + 5e-7);
        /* Where edges meet, as in the corner of a room, the nearest or farthest place may be in between. */
        double slack = 1e-5 * fabs(farthest) + (farthest - nearest);
        if (!(high >= nearest - slack && low <= farthest + slack)) misses++;
    }
    return misses;
}
