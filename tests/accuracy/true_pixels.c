/* Pixels and the truth about them: see true_pixels.h. */
#include "true_pixels.h"
#include "pixel_choice.h"
#include "reference_threads.h"

#include <math.h>
#include <stdlib.h>

size_t true_pixel_index(const drawn_picture *picture, const true_pixel *pixel)
{
    return (size_t)pixel->y * (size_t)picture->width + (size_t)pixel->x;
}

typedef struct truth_job {
    const scene_rays *rays;
    const drawn_picture *picture;
    true_pixel *pixels; /* those to compute */
} truth_job;

static bool compute_pixel(void *user, reference_workspace *workspace, size_t index)
{
    const truth_job *job = user;
    true_pixel *pixel = &job->pixels[index];
    double stored = (double)job->picture->depth[true_pixel_index(job->picture, pixel)];
    reference_ray ray = scene_rays_pixel(job->rays, pixel->x, pixel->y, stored);
    reference_value sum;
    pixel->reliable = reference_luminance(workspace, &job->rays->sources, &ray, &sum, NULL);
    pixel->luminance = sum.luminance;
    return true;
}

/* Computes the luminance of the pixels from `first` on. */
static bool compute_truth(const scene_rays *rays, const drawn_picture *picture, int threads, true_pixels *truth, size_t first)
{
    truth_job job = {rays, picture, truth->pixels + first};
    if (!reference_threads_run(compute_pixel, &job, truth->count - first, threads)) return false;
    for (size_t i = first; i < truth->count; i++) {
        if (!truth->pixels[i].reliable) truth->unreliable_count++;
        truth->largest = fmax(truth->largest, truth->pixels[i].luminance);
    }
    return true;
}

bool true_pixels_compute(const scene_rays *rays, const drawn_picture *picture, size_t count, int threads, true_pixels *truth)
{
    if (!choose_pixels(rays, picture, count, truth)) return false;
    truth->dark = TRUTH_DARK;
    truth->darkest = rays->fog.extinction > 0 || rays->medium_count > 0 ? TRUTH_INVISIBLE : 0;
    if (compute_truth(rays, picture, threads, truth, 0)) return true;
    true_pixels_free(truth);
    return false;
}

void true_pixels_free(true_pixels *truth)
{
    free(truth->pixels);
    free(truth->chosen);
    *truth = (true_pixels){0};
}

double true_pixel_luminance(const drawn_picture *picture, const true_pixel *pixel)
{
    return (double)picture->luminance[true_pixel_index(picture, pixel)];
}

double true_pixel_error(const true_pixels *truth, const drawn_picture *picture, const true_pixel *pixel)
{
    double luminance = true_pixel_luminance(picture, pixel);
    if (!isfinite(luminance)) return HUGE_VAL;
    double difference = fabs(luminance - pixel->luminance);
    /* A dark picture (no sources, or all of them behind walls) is right if it is dark. */
    double dark = fmax(truth->dark * truth->largest, truth->darkest);
    return difference == 0 ? 0 : difference / fmax(pixel->luminance, dark);
}

/* Adds the neighbours of the pixels at which the picture is most wrong. */
static void choose_around_the_worst(true_pixels *truth, const drawn_picture *picture)
{
    enum { WORST = 12, REACH = 2 };
    size_t worst[WORST], worst_count = 0;
    for (size_t i = 0; i < truth->count; i++) {
        size_t rank = worst_count;
        double error = true_pixel_error(truth, picture, &truth->pixels[i]);
        while (rank > 0 && error > true_pixel_error(truth, picture, &truth->pixels[worst[rank - 1]])) {
            if (rank < WORST) worst[rank] = worst[rank - 1];
            rank--;
        }
        if (rank < WORST) worst[rank] = i;
        if (worst_count < WORST) worst_count++;
    }
    for (size_t i = 0; i < worst_count; i++)
        for (int dy = -REACH; dy <= REACH; dy++)
            for (int dx = -REACH; dx <= REACH; dx++) {
                int x = truth->pixels[worst[i]].x + dx, y = truth->pixels[worst[i]].y + dy;
                if (x < 0 || y < 0 || x >= picture->width || y >= picture->height) continue;
                choose_pixel(truth, picture, (size_t)y * (size_t)picture->width + (size_t)x, false);
            }
}

bool true_pixels_refine(const scene_rays *rays, const drawn_picture *picture, const drawn_picture *other, int threads,
                        true_pixels *truth)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    size_t before = truth->count, limit = before + truth->first_count / 2;
    ranked_pixel *ranking = rank_pixels(picture, other, truth->dark);
    if (!ranking) return false;
    for (size_t i = 0; i < pixel_count && i < truth->first_count / 8; i++)
        choose_pixel(truth, picture, ranking[pixel_count - 1 - i].index, false);
    free(ranking);
    while (before < truth->count) {
        if (!compute_truth(rays, picture, threads, truth, before)) return false;
        before = truth->count;
        if (truth->count < limit) choose_around_the_worst(truth, picture);
    }
    return true;
}
