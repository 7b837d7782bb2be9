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

static void choose(true_pixels *truth, const drawn_picture *picture, size_t index, bool representative)
{
    if (truth->chosen[index]) return;
    truth->chosen[index] = 1;
    truth->pixels[truth->count++] = (true_pixel){
        .x = (int)(index % (size_t)picture->width),
        .y = (int)(index / (size_t)picture->width),
        .representative = representative,
    };
}

static void choose_evenly(true_pixels *truth, const drawn_picture *picture, size_t count)
{
    int width = picture->width, height = picture->height;
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
            choose(truth, picture, (size_t)y * (size_t)width + (size_t)x, true);
        }
}

typedef struct ranked {
    double value;
    size_t index;
} ranked;

static int compare_ranked(const void *a, const void *b)
{
    const ranked *first = a, *second = b;
    if (first->value != second->value) return first->value < second->value ? -1 : 1;
    return first->index < second->index ? -1 : 1;
}

/* The picture's luminance or, with another picture of the scene, by how much of it they differ, from the least to the
 * largest. What is no number counts as large. NULL where memory is exhausted. */
static ranked *rank_pixels(const drawn_picture *picture, const drawn_picture *other)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    ranked *ranking = malloc(pixel_count * sizeof *ranking);
    double largest = 0;
    for (size_t i = 0; i < pixel_count; i++)
        if (isfinite(picture->luminance[i])) largest = fmax(largest, (double)picture->luminance[i]);
    for (size_t i = 0; ranking && i < pixel_count; i++) {
        double value = (double)picture->luminance[i];
        if (other) value = fabs((double)other->luminance[i] - value) / fmax(value, COMPARISON_DARK * largest + 1e-30);
        ranking[i] = (ranked){isfinite(value) ? value : HUGE_VAL, i};
    }
    if (ranking) qsort(ranking, pixel_count, sizeof *ranking, compare_ranked);
    return ranking;
}

/* Of the pixels whose right or upper neighbour lies elsewhere in depth, both, for every so many that `count` are chosen. */
static void choose_silhouettes(true_pixels *truth, const drawn_picture *picture, const scene_rays *rays, size_t count)
{
    size_t width = (size_t)picture->width, height = (size_t)picture->height, found = 0, stride = 1;
    if (count == 0) return;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1) stride = 1 + 2 * found / count;
        found = 0;
        for (size_t i = 0; i + width < width * height; i++) {
            const size_t neighbours[] = {i + 1, i + width};
            double depth = scene_rays_stored_depth(rays, picture->depth[i]);
            for (int k = 0; k < 2; k++) {
                double other = scene_rays_stored_depth(rays, picture->depth[neighbours[k]]);
                if (fabs(other - depth) < 0.05 * fabs(depth) || found++ % stride != 0 || pass == 0) continue;
                choose(truth, picture, i, false);
                choose(truth, picture, neighbours[k], false);
            }
        }
    }
}

static bool choose_pixels(const scene_rays *rays, const drawn_picture *picture, size_t count, true_pixels *truth)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    *truth = (true_pixels){.pixels = malloc(pixel_count * sizeof *truth->pixels), .chosen = calloc(pixel_count, 1)};
    ranked *ranking = rank_pixels(picture, NULL);
    bool ok = truth->pixels && truth->chosen && ranking;
    if (ok && (count == 0 || count >= pixel_count)) {
        for (size_t i = 0; i < pixel_count; i++)
            choose(truth, picture, i, true);
    } else if (ok) {
        choose_evenly(truth, picture, count / 2);
        for (size_t i = 0; i < count / 8; i++) {
            choose(truth, picture, ranking[i].index, false);
            choose(truth, picture, ranking[pixel_count - 1 - i].index, false);
        }
        choose_silhouettes(truth, picture, rays, count / 4);
    }
    free(ranking);
    truth->first_count = truth->count;
    if (!ok) true_pixels_free(truth);
    return ok;
}

/* ---- The truth ------------------------------------------------------------------------------------------------------------
 */

typedef struct worker {
    pthread_t thread;
    reference_workspace *workspace;
    const scene_rays *rays;
    const drawn_picture *picture;
    true_pixel *pixels;
    size_t count, first, stride;
} worker;

static void *work(void *argument)
{
    worker *self = argument;
    for (size_t i = self->first; i < self->count; i += self->stride) {
        true_pixel *pixel = &self->pixels[i];
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

/* Computes the luminance of the pixels from `first` on. */
static bool compute_truth(const scene_rays *rays, const drawn_picture *picture, int threads, true_pixels *truth, size_t first)
{
    worker workers[MAX_THREADS];
    int count = threads < 1 ? 1 : threads > MAX_THREADS ? MAX_THREADS : threads, made = 0, started = 1;
    while (made < count && (workers[made].workspace = reference_create_workspace())) {
        workers[made].rays = rays;
        workers[made].picture = picture;
        workers[made].pixels = truth->pixels;
        workers[made].count = truth->count;
        workers[made].first = first + (size_t)made;
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
        for (size_t i = first; i < truth->count; i++) {
            if (!truth->pixels[i].reliable) truth->unreliable_count++;
            truth->largest = fmax(truth->largest, truth->pixels[i].luminance);
        }
    }
    for (int i = 0; i < made; i++)
        reference_destroy_workspace(workers[i].workspace);
    return ok;
}

bool true_pixels_compute(const scene_rays *rays, const drawn_picture *picture, size_t count, int threads, true_pixels *truth)
{
    if (!choose_pixels(rays, picture, count, truth)) return false;
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

/* Adds the neighbours of the pixels at which the picture is most wrong. */
static void choose_around_the_worst(true_pixels *truth, const drawn_picture *picture)
{
    enum { WORST = 12, REACH = 2 };
    size_t worst[WORST], worst_count = 0;
    for (size_t i = 0; i < truth->count; i++) {
        size_t rank = worst_count;
        double error = error_at(truth, picture, &truth->pixels[i]);
        while (rank > 0 && error > error_at(truth, picture, &truth->pixels[worst[rank - 1]])) {
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
                choose(truth, picture, (size_t)y * (size_t)picture->width + (size_t)x, false);
            }
}

bool true_pixels_refine(const scene_rays *rays, const drawn_picture *picture, const drawn_picture *other, int threads,
                        true_pixels *truth)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    size_t before = truth->count, limit = before + truth->first_count / 2;
    ranked *ranking = rank_pixels(picture, other);
    if (!ranking) return false;
    for (size_t i = 0; i < pixel_count && i < truth->first_count / 8; i++)
        choose(truth, picture, ranking[pixel_count - 1 - i].index, false);
    free(ranking);
    while (before < truth->count) {
        if (!compute_truth(rays, picture, threads, truth, before)) return false;
        before = truth->count;
        if (truth->count < limit) choose_around_the_worst(truth, picture);
    }
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
        /* Where edges meet, as in the corner of a room, the nearest or farthest place may be in between. */
        double slack = 1e-5 * fabs(farthest) + (farthest - nearest);
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
    image_pixels image = {.width = picture->width, .height = picture->height, .channels = 4, .pixels = colors};
    bool ok = image_write(path, &image, message, size);
    free(colors);
    return ok;
}
