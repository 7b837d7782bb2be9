/* What is right: see truth.h. */
#include "truth.h"
#include "camera.h"
#include "message.h"
#include "progress.h"
#include "random_numbers.h"
#include "reference.h"
#include "vector.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- The scene in view space, where the eye is the origin and no digits are lost ---------------------------------------- */

typedef struct view_space {
    ew_sources_desc sources;
    void *memory[4];
    bool orthographic;
    double projection[16];
    double interval_start;
    double interval_end;
    double decay_alpha;
    double decay_beta;
    int width;
    int height;
    const float *depth; /* NULL for none */
} view_space;

static void *copy_list(const void *list, size_t bytes)
{
    void *copy = malloc(bytes > 0 ? bytes : 1);
    if (copy && bytes > 0) memcpy(copy, list, bytes);
    return copy;
}

static void destroy_view(view_space *view)
{
    for (int i = 0; i < 4; i++)
        free(view->memory[i]);
}

static bool make_view(const ew_scene *scene, int width, int height, const float *depth, view_space *view)
{
    const ew_scene_camera *camera = &scene->camera;
    const ew_sources_desc *sources = &scene->sources;
    ew_point *points = copy_list(sources->points, sources->point_count * sizeof *points);
    ew_line *lines = copy_list(sources->lines, sources->line_count * sizeof *lines);
    ew_torus *tori = copy_list(sources->tori, sources->torus_count * sizeof *tori);
    ew_curve *curves = copy_list(sources->curves, sources->curve_count * sizeof *curves);
    *view = (view_space){.sources = *sources,
                         .memory = {points, lines, tori, curves},
                         .orthographic = camera->orthographic,
                         .interval_start = scene->interval_start,
                         .interval_end = scene->interval_end,
                         .decay_alpha = scene->decay_alpha,
                         .decay_beta = scene->decay_beta,
                         .width = width,
                         .height = height,
                         .depth = depth};
    if (!points || !lines || !tori || !curves) {
        destroy_view(view);
        return false;
    }
    camera_projection(camera, (double)width / height, view->projection);
    for (size_t i = 0; i < sources->point_count; i++)
        camera_to_view(camera, sources->points[i].position, points[i].position);
    for (size_t i = 0; i < sources->line_count; i++) {
        camera_to_view(camera, sources->lines[i].position, lines[i].position);
        camera_turn_to_view(camera, sources->lines[i].direction, lines[i].direction);
    }
    for (size_t i = 0; i < sources->torus_count; i++) {
        camera_to_view(camera, sources->tori[i].center, tori[i].center);
        camera_turn_to_view(camera, sources->tori[i].axis, tori[i].axis);
    }
    for (size_t i = 0; i < sources->curve_count; i++) {
        camera_to_view(camera, sources->curves[i].polynomial[0], curves[i].polynomial[0]);
        camera_turn_to_view(camera, sources->curves[i].polynomial[1], curves[i].polynomial[1]);
        camera_turn_to_view(camera, sources->curves[i].polynomial[2], curves[i].polynomial[2]);
    }
    view->sources.points = points;
    view->sources.lines = lines;
    view->sources.tori = tori;
    view->sources.curves = curves;
    return true;
}

/* The view depth of the opaque surface at a value of the depth buffer: the projection's third and fourth rows, inverted. */
static double view_depth(const view_space *view, double depth)
{
    double ndc = 2 * depth - 1;
    return view->orthographic ? (view->projection[14] - ndc) / view->projection[10]
                              : view->projection[14] / (ndc + view->projection[10]);
}

static reference_ray pixel_ray(const view_space *view, int x, int y)
{
    double ndc_x = 2 * (x + 0.5) / view->width - 1, ndc_y = 2 * (y + 0.5) / view->height - 1;
    double across[2] = {ndc_x / view->projection[0], ndc_y / view->projection[5]};
    reference_ray ray = {.s_max = 1, .decay_alpha = view->decay_alpha, .decay_beta = view->decay_beta};
    for (int i = 0; i < 2; i++) {
        ray.start[i] = across[i] * (view->orthographic ? 1 : view->interval_start);
        ray.end[i] = across[i] * (view->orthographic ? 1 : view->interval_end);
    }
    ray.start[2] = -view->interval_start;
    ray.end[2] = -view->interval_end;
    if (view->depth) {
        double depth = view_depth(view, (double)view->depth[(size_t)y * (size_t)view->width + (size_t)x]);
        ray.s_max = fmin(fmax((depth - view->interval_start) / (view->interval_end - view->interval_start), 0), 1);
    }
    return ray;
}

/* ---- The choice of pixels ----------------------------------------------------------------------------------------------- */

/* A random place on a random source. */
static void random_source_place(const view_space *view, uint64_t *random, double place[3])
{
    const ew_sources_desc *sources = &view->sources;
    size_t count = sources->point_count + sources->line_count + sources->torus_count + sources->curve_count;
    size_t i = random_index(random, count);
    double u = random_unit(random);
    if (i < sources->point_count) {
        vector_copy(sources->points[i].position, place);
        return;
    }
    i -= sources->point_count;
    if (i < sources->line_count) {
        /* About the line's point that is nearest to the middle of the view. */
        const ew_line *line = &sources->lines[i];
        double middle[3] = {0, 0, -0.5 * (view->interval_start + view->interval_end)}, direction[3], to_middle[3];
        vector_normalize(line->direction, direction);
        vector_subtract(middle, line->position, to_middle);
        double reach = (2 * u - 1) * (view->interval_end - view->interval_start);
        vector_add_scaled(line->position, vector_dot(to_middle, direction) + reach, direction, place);
        return;
    }
    i -= sources->line_count;
    if (i < sources->torus_count) {
        const ew_torus *torus = &sources->tori[i];
        double axis[3], right[3], up[3];
        vector_normalize(torus->axis, axis);
        double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0};
        vector_cross(axis, other, right);
        vector_normalize(right, right);
        vector_cross(axis, right, up);
        vector_add_scaled(torus->center, torus->radius * cos(2 * M_PI * u), right, place);
        vector_add_scaled(place, torus->radius * sin(2 * M_PI * u), up, place);
        return;
    }
    const ew_curve *curve = &sources->curves[i - sources->torus_count];
    double t = curve->domain[0] + u * (curve->domain[1] - curve->domain[0]);
    vector_add_scaled(curve->polynomial[0], t, curve->polynomial[1], place);
    vector_add_scaled(place, t * t, curve->polynomial[2], place);
}

/* A pixel from a quarter to 32 pixels away from a random place on a source, all magnitudes alike; false if it is outside of the
 * picture, or the place is not in the interval. */
static bool random_core_pixel(const view_space *view, uint64_t *random, int *x, int *y)
{
    double place[3];
    random_source_place(view, random, place);
    double distance = 0.25 * pow(128, random_unit(random)), angle = 2 * M_PI * random_unit(random), depth = -place[2];
    if (!(depth >= view->interval_start && depth <= view->interval_end)) return false;
    double w = view->orthographic ? 1 : depth;
    double column = (0.5 + 0.5 * view->projection[0] * place[0] / w) * view->width + distance * cos(angle);
    double row = (0.5 + 0.5 * view->projection[5] * place[1] / w) * view->height + distance * sin(angle);
    if (!(column >= 0 && column < view->width && row >= 0 && row < view->height)) return false;
    *x = (int)column;
    *y = (int)row;
    return true;
}

/* Chooses `count` different pixels; there are at least as many. */
static bool choose_pixels(const view_space *view, size_t count, truth_pixel *pixels)
{
    const ew_sources_desc *sources = &view->sources;
    bool any_source = sources->point_count + sources->line_count + sources->torus_count + sources->curve_count > 0;
    size_t all = (size_t)view->width * (size_t)view->height, chosen = 0;
    bool *taken = calloc(all, sizeof *taken);
    uint64_t random = 0;
    if (!taken) return false;
    for (size_t attempt = 0; any_source && attempt < 16 * count && chosen < count / 2; attempt++) {
        int x, y;
        if (!random_core_pixel(view, &random, &x, &y)) continue;
        bool *mark = &taken[(size_t)y * (size_t)view->width + (size_t)x];
        if (!*mark) pixels[chosen++] = (truth_pixel){.x = x, .y = y};
        *mark = true;
    }
    /* The others by Knuth's algorithm S: each of those left with the same chance. */
    size_t left = all - chosen;
    for (size_t i = 0; i < all; i++) {
        if (taken[i]) continue;
        if (random_index(&random, left--) >= count - chosen) continue;
        pixels[chosen++] = (truth_pixel){.x = (int)(i % (size_t)view->width), .y = (int)(i / (size_t)view->width)};
    }
    free(taken);
    return true;
}

/* ---- The luminance ------------------------------------------------------------------------------------------------------ */

enum { MAX_THREADS = 64 };

typedef struct truth_job {
    const view_space *view;
    bench_truth *truth;
    atomic_size_t next;
} truth_job;

typedef struct worker {
    truth_job *job;
    reference_workspace *workspace;
    bool shows_progress;
    pthread_t thread;
} worker;

static void *compute_luminances(void *user)
{
    worker *self = user;
    bench_truth *truth = self->job->truth;
    for (size_t i; (i = atomic_fetch_add(&self->job->next, 1)) < truth->count;) {
        truth_pixel *pixel = &truth->pixels[i];
        reference_ray ray = pixel_ray(self->job->view, pixel->x, pixel->y);
        reference_value sum;
        pixel->reliable = reference_luminance(self->workspace, &self->job->view->sources, &ray, &sum, NULL);
        pixel->luminance = sum.luminance;
        if (self->shows_progress) progress_show("reference: %zu of %zu pixels", i + 1, truth->count);
    }
    return NULL;
}

static bool compute_with_threads(truth_job *job)
{
    worker workers[MAX_THREADS];
    long cores = sysconf(_SC_NPROCESSORS_ONLN);
    size_t wanted = cores < 1 ? 1 : cores > MAX_THREADS ? MAX_THREADS : (size_t)cores, made = 0, started = 1;
    for (; made < wanted; made++) {
        workers[made] = (worker){.job = job, .workspace = reference_create_workspace(), .shows_progress = made == 0};
        if (!workers[made].workspace) break;
    }
    if (made == 0) return false;
    /* This thread is the first worker; without any other it still does all the work. */
    for (; started < made; started++)
        if (pthread_create(&workers[started].thread, NULL, compute_luminances, &workers[started]) != 0) break;
    compute_luminances(&workers[0]);
    for (size_t i = 1; i < started; i++)
        pthread_join(workers[i].thread, NULL);
    for (size_t i = 0; i < made; i++)
        reference_destroy_workspace(workers[i].workspace);
    progress_clear();
    return true;
}

bool truth_compute(const ew_scene *scene, int width, int height, const float *depth, size_t count, bench_truth *truth,
                   char *message, size_t size)
{
    size_t all = (size_t)width * (size_t)height;
    *truth = (struct bench_truth){.count = count < all ? count : all};
    truth->pixels = malloc(truth->count * sizeof *truth->pixels);
    view_space view;
    bool viewed = make_view(scene, width, height, depth, &view);
    truth_job job = {.view = &view, .truth = truth};
    bool ok = truth->pixels && viewed && choose_pixels(&view, truth->count, truth->pixels) && compute_with_threads(&job);
    if (viewed) destroy_view(&view);
    if (!ok) {
        truth_free(truth);
        message_write(message, size, "--error-samples: the reference does not fit into memory; ask for fewer");
        return false;
    }
    for (size_t i = 0; i < truth->count; i++)
        if (truth->pixels[i].reliable)
            truth->largest = fmax(truth->largest, truth->pixels[i].luminance);
        else
            truth->unreliable_count++;
    if (truth->unreliable_count < truth->count) return true;
    truth_free(truth);
    message_write(message, size, "the reference vouches for none of the pixels; its errors would mean nothing");
    return false;
}

void truth_free(bench_truth *truth)
{
    free(truth->pixels);
    *truth = (struct bench_truth){0};
}

/* ---- The errors --------------------------------------------------------------------------------------------------------- */

static int compare_numbers(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

bool truth_errors(const bench_truth *truth, const float *luminance, int width, double *largest, double *percentile_99)
{
    size_t count = 0;
    double *errors = malloc(truth->count * sizeof *errors);
    if (!errors) return false;
    for (size_t i = 0; i < truth->count; i++) {
        const truth_pixel *pixel = &truth->pixels[i];
        if (!pixel->reliable) continue;
        double difference = fabs((double)luminance[(size_t)pixel->y * (size_t)width + (size_t)pixel->x] - pixel->luminance);
        double error = difference == 0 ? 0 : difference / fmax(pixel->luminance, TRUTH_DARK * truth->largest);
        errors[count++] = isnan(error) ? HUGE_VAL : error;
    }
    qsort(errors, count, sizeof *errors, compare_numbers);
    *largest = errors[count - 1];
    *percentile_99 = errors[(99 * count + 99) / 100 - 1];
    free(errors);
    return true;
}
