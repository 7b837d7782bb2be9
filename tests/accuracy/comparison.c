/* A picture's luminance against the reference: see comparison.h. */
#include "comparison.h"
#include "image.h"
#include "message.h"

#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- Choosing pixels ------------------------------------------------------------------------------------------------------
 */

typedef struct pixel_chooser {
    const drawn_picture *picture;
    unsigned char *chosen; /* one a pixel */
    true_pixels *truth;
} pixel_chooser;

static void choose(pixel_chooser *chooser, size_t index, bool representative)
{
    if (chooser->chosen[index]) return;
    chooser->chosen[index] = 1;
    chooser->truth->pixels[chooser->truth->count++] = (true_pixel){
        .x = (int)(index % (size_t)chooser->picture->width),
        .y = (int)(index / (size_t)chooser->picture->width),
        .representative = representative,
    };
}

static void choose_evenly(pixel_chooser *chooser, size_t count)
{
    int width = chooser->picture->width, height = chooser->picture->height;
    double side = sqrt((double)width * height / (double)count);
    int columns = (int)ceil(width / side), rows = (int)ceil(height / side);
    uint64_t random = 1;
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            int left = width * column / columns, right = width * (column + 1) / columns;
            int bottom = height * row / rows, top = height * (row + 1) / rows;
            if (left == right || bottom == top) continue;
            int x = left + (int)((random >> 33) % (uint64_t)(right - left));
            int y = bottom + (int)((random >> 48) % (uint64_t)(top - bottom));
            choose(chooser, (size_t)y * (size_t)width + (size_t)x, true);
        }
}

typedef struct ranked {
    float luminance;
    size_t index;
} ranked;

static int compare_ranked(const void *a, const void *b)
{
    const ranked *first = a, *second = b;
    if (first->luminance != second->luminance) return first->luminance < second->luminance ? -1 : 1;
    return first->index < second->index ? -1 : 1;
}

static void choose_brightest_and_darkest(pixel_chooser *chooser, ranked *ranking, size_t pixel_count, size_t brightest,
                                         size_t darkest)
{
    for (size_t i = 0; i < pixel_count; i++) {
        float luminance = chooser->picture->luminance[i];
        ranking[i] = (ranked){isfinite(luminance) ? luminance : 1e30f, i};
    }
    qsort(ranking, pixel_count, sizeof *ranking, compare_ranked);
    for (size_t i = 0; i < darkest && i < pixel_count; i++)
        choose(chooser, ranking[i].index, false);
    for (size_t i = 0; i < brightest && i < pixel_count; i++)
        choose(chooser, ranking[pixel_count - 1 - i].index, false);
}

/* Of the pixels whose right or upper neighbour lies elsewhere in depth, both, for every so many that `count` are chosen. */
static void choose_silhouettes(pixel_chooser *chooser, const scene_rays *rays, size_t count)
{
    const drawn_picture *picture = chooser->picture;
    size_t width = (size_t)picture->width, height = (size_t)picture->height, found = 0, stride = 1;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1) stride = 1 + 2 * found / count;
        found = 0;
        for (size_t i = 0; i + width < width * height; i++) {
            const size_t neighbours[] = {i + 1, i + width};
            double depth = scene_rays_stored_depth(rays, picture->depth[i]);
            for (int k = 0; k < 2; k++) {
                double other = scene_rays_stored_depth(rays, picture->depth[neighbours[k]]);
                if (fabs(other - depth) < 0.05 * fabs(depth) || found++ % stride != 0 || pass == 0) continue;
                choose(chooser, i, false);
                choose(chooser, neighbours[k], false);
            }
        }
    }
}

static bool choose_pixels(const scene_rays *rays, const drawn_picture *picture, size_t count, true_pixels *truth)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    *truth = (true_pixels){.pixels = malloc(pixel_count * sizeof *truth->pixels)};
    pixel_chooser chooser = {picture, calloc(pixel_count, 1), truth};
    ranked *ranking = malloc(pixel_count * sizeof *ranking);
    bool ok = truth->pixels && chooser.chosen && ranking;
    if (ok && (count == 0 || count >= pixel_count)) {
        for (size_t i = 0; i < pixel_count; i++)
            choose(&chooser, i, true);
    } else if (ok) {
        choose_evenly(&chooser, count / 2);
        choose_brightest_and_darkest(&chooser, ranking, pixel_count, count / 8, count / 8);
        choose_silhouettes(&chooser, rays, count / 4);
    }
    free(chooser.chosen);
    free(ranking);
    if (!ok) free(truth->pixels);
    return ok;
}

/* ---- The truth ------------------------------------------------------------------------------------------------------------
 */

typedef struct worker {
    pthread_t thread;
    reference_workspace *workspace;
    const scene_rays *rays;
    const drawn_picture *picture;
    true_pixels *truth;
    size_t first, stride;
} worker;

static void *work(void *argument)
{
    worker *self = argument;
    for (size_t i = self->first; i < self->truth->count; i += self->stride) {
        true_pixel *pixel = &self->truth->pixels[i];
        size_t index = (size_t)pixel->y * (size_t)self->picture->width + (size_t)pixel->x;
        double depth = scene_rays_stored_depth(self->rays, self->picture->depth[index]);
        reference_ray ray = scene_rays_ray(self->rays, pixel->x + 0.5, pixel->y + 0.5, depth);
        reference_value sum;
        pixel->reliable = reference_luminance(self->workspace, &self->rays->sources, &ray, &sum, NULL);
        pixel->luminance = sum.luminance;
    }
    return NULL;
}

enum { MAX_THREADS = 64 };

static bool compute_truth(const scene_rays *rays, const drawn_picture *picture, int threads, true_pixels *truth)
{
    worker workers[MAX_THREADS];
    int count = threads < 1 ? 1 : threads > MAX_THREADS ? MAX_THREADS : threads, made = 0, started = 1;
    while (made < count && (workers[made].workspace = reference_create_workspace())) {
        workers[made].rays = rays;
        workers[made].picture = picture;
        workers[made].truth = truth;
        workers[made].first = (size_t)made;
        workers[made].stride = (size_t)count;
        made++;
    }
    bool ok = made == count;
    if (ok) {
        while (started < count && pthread_create(&workers[started].thread, NULL, work, &workers[started]) == 0)
            started++;
        work(&workers[0]);
        for (int i = started; i < count; i++) /* what no thread could be had for */
            work(&workers[i]);
        for (int i = 1; i < started; i++)
            pthread_join(workers[i].thread, NULL);
    }
    for (int i = 0; i < made; i++)
        reference_destroy_workspace(workers[i].workspace);
    return ok;
}

bool true_pixels_compute(const scene_rays *rays, const drawn_picture *picture, size_t count, int threads, true_pixels *truth)
{
    if (!choose_pixels(rays, picture, count, truth)) return false;
    if (!compute_truth(rays, picture, threads, truth)) {
        true_pixels_free(truth);
        return false;
    }
    for (size_t i = 0; i < truth->count; i++) {
        if (!truth->pixels[i].reliable) truth->unreliable_count++;
        truth->largest = fmax(truth->largest, truth->pixels[i].luminance);
    }
    return true;
}

void true_pixels_free(true_pixels *truth)
{
    free(truth->pixels);
    *truth = (true_pixels){0};
}

/* ---- Comparing ------------------------------------------------------------------------------------------------------------
 */

static double luminance_at(const drawn_picture *picture, const true_pixel *pixel)
{
    return (double)picture->luminance[(size_t)pixel->y * (size_t)picture->width + (size_t)pixel->x];
}

static double error_at(const true_pixels *truth, const drawn_picture *picture, const true_pixel *pixel)
{
    double luminance = luminance_at(picture, pixel);
    if (!isfinite(luminance)) return HUGE_VAL;
    double difference = fabs(luminance - pixel->luminance);
    /* A dark picture (no sources, or all of them behind walls) is right if it is dark. */
    return difference == 0 ? 0 : difference / fmax(pixel->luminance, COMPARISON_DARK * truth->largest);
}

static int compare_numbers(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

bool comparison_make(const true_pixels *truth, const drawn_picture *picture, picture_comparison *comparison)
{
    *comparison = (picture_comparison){0};
    double *errors = malloc((truth->count + 1) * sizeof *errors);
    if (!errors) return false;
    size_t count = 0;
    for (size_t i = 0; i < truth->count; i++) {
        const true_pixel *pixel = &truth->pixels[i];
        if (!pixel->reliable) continue;
        double error = error_at(truth, picture, pixel);
        if (pixel->representative) errors[count++] = error;
        if (error <= comparison->largest_error) continue;
        comparison->largest_error = error;
        comparison->worst_x = pixel->x;
        comparison->worst_y = pixel->y;
        comparison->worst_luminance = luminance_at(picture, pixel);
        comparison->worst_truth = pixel->luminance;
    }
    qsort(errors, count, sizeof *errors, compare_numbers);
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
        float stored = picture->depth[(size_t)pixel->y * (size_t)picture->width + (size_t)pixel->x];
        /* The buffer's own steps, and those of the vertices' floats. */
        double low = scene_rays_stored_depth(rays, (double)stored - 5e-7),
               high = scene_rays_stored_depth(rays, (double)stored + 5e-7);
        double slack = 1e-5 * fabs(farthest);
        if (!(high >= nearest - slack && low <= farthest + slack)) misses++;
    }
    return misses;
}

bool heatmap_write(const char *path, const true_pixels *truth, const drawn_picture *picture, char *message, size_t size)
{
    static const float ramp[][3] = {{0, 0, 0}, {0, 0, 0.6f}, {0, 0.5f, 0.2f}, {1, 0.8f, 0}, {1, 0, 0}, {1, 1, 1}};
    enum { LAST = sizeof ramp / sizeof *ramp - 1 };
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    float *colors = malloc(pixel_count * 4 * sizeof *colors);
    if (!colors) {
        message_write(message, size, "%s: does not fit into memory", path);
        return false;
    }
    for (size_t i = 0; i < pixel_count * 4; i++)
        colors[i] = 0.2f;
    for (size_t i = 0; i < truth->count; i++) {
        const true_pixel *pixel = &truth->pixels[i];
        if (!pixel->reliable) continue;
        double position = fmin(LAST, fmax(0, log10(error_at(truth, picture, pixel)) + 6));
        int step = position < LAST ? (int)position : LAST - 1;
        for (int k = 0; k < 3; k++)
            colors[((size_t)pixel->y * (size_t)picture->width + (size_t)pixel->x) * 4 + (size_t)k] =
                ramp[step][k] + (float)(position - step) * (ramp[step + 1][k] - ramp[step][k]);
    }
    image_pixels image = {picture->width, picture->height, 4, colors};
    bool ok = image_write(path, &image, message, size);
    free(colors);
    return ok;
}
