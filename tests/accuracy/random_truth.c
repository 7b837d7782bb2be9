/* The truth about random scenes: see random_truth.h. */
#include "random_truth.h"
#include "reference_threads.h"
#include "true_pixels.h"

#include <math.h>
#include <unistd.h>

/* Errors are relative to the truth or, where it is darker, to this share of the largest truth of the scene. */
#define DARK 1e-3

static void round_to_float(double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = (double)(float)place[i];
}

static double luminance_error(const random_pixel *pixel, double floor)
{
    double difference = fabs((double)pixel->luminance - pixel->truth);
    if (!isfinite(pixel->luminance) || pixel->luminance < 0) return HUGE_VAL;
    return difference == 0 ? 0 : difference / fmax(pixel->truth, floor);
}

/* How much the truth itself changes when the ray's ends are rounded to single precision. */
static double truth_sensitivity(reference_workspace *workspace, const scene_rays *rays, const random_pixel *pixel, double floor)
{
    reference_value sum;
    reference_ray ray = scene_rays_pixel(rays, pixel->x, pixel->y, (double)pixel->depth);
    round_to_float(ray.start);
    round_to_float(ray.end);
    reference_luminance(workspace, &rays->sources, &ray, &sum, NULL);
    return sum.luminance == pixel->truth ? 0 : fabs(sum.luminance - pixel->truth) / fmax(pixel->truth, floor);
}

static void compute_truth(reference_workspace *workspace, const scene_rays *rays, random_picture *picture)
{
    double largest = 0;
    for (int i = 0; i < RANDOM_PIXEL_COUNT; i++) {
        random_pixel *pixel = &picture->pixels[i];
        reference_value sum;
        reference_ray ray = scene_rays_pixel(rays, pixel->x, pixel->y, (double)pixel->depth);
        pixel->reliable = reference_luminance(workspace, &rays->sources, &ray, &sum, NULL);
        pixel->truth = sum.luminance;
        largest = fmax(largest, pixel->truth);
    }
    double floor = fmax(DARK * largest, rays->fog.extinction > 0 || rays->medium_count > 0 ? TRUTH_INVISIBLE : 0);
    picture->worst = &picture->pixels[0];
    for (int i = 0; i < RANDOM_PIXEL_COUNT; i++) {
        random_pixel *pixel = &picture->pixels[i];
        pixel->error = luminance_error(pixel, floor);
        if (!pixel->reliable && isfinite(pixel->error)) pixel->error = 0;
        if (pixel->error > picture->worst->error) picture->worst = pixel;
    }
    picture->sensitivity = truth_sensitivity(workspace, rays, picture->worst, floor);
}

static bool compute_picture(void *user, reference_workspace *workspace, size_t index)
{
    random_picture *picture = (random_picture *)user + index;
    random_picture_scene scene;
    char message[300];
    if (!random_picture_load(picture->seed, &scene, message, sizeof message)) return false;
    compute_truth(workspace, &scene.rays, picture);
    random_picture_unload(&scene);
    return true;
}

bool random_truths_compute(random_picture *pictures, size_t count)
{
    return reference_threads_run(compute_picture, pictures, count, (int)sysconf(_SC_NPROCESSORS_ONLN));
}
