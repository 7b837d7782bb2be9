/* Speed and error of integrators on a scene: see measure.h. */
#include "measure.h"
#include "comparison.h"
#include "image.h"
#include "message.h"
#include "progress.h"
#include "random_numbers.h"
#include "sort.h"
#include "stage.h"
#include "stopwatch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- Errors ------------------------------------------------------------------------------------------------------------- */

static double mean(const float *values, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum / (double)count;
}

/* A scene's pixels: what is right there, and one integrator's picture. */
typedef struct error_stage {
    scene_rays rays;
    drawn_picture picture;
    true_pixels truth;
} error_stage;

static bool make_picture(const bench_stage *stage, drawn_picture *picture)
{
    size_t count = (size_t)stage->width * (size_t)stage->height;
    *picture = (drawn_picture){stage->width, stage->height, malloc(count * sizeof(float)), malloc(count * sizeof(float))};
    if (!picture->luminance || !picture->depth) {
        picture_free(picture);
        return false;
    }
    if (!stage_read_depth(stage, picture->depth))
        for (size_t i = 0; i < count; i++)
            picture->depth[i] = 1;
    return true;
}

/* Chooses the pixels by two pictures of the library's, and computes their luminance: also where those differ. */
static bool compute_truth(bench_stage *stage, size_t pixel_count, error_stage *errors, char *message, size_t size)
{
    static const bench_integrator usual = {"full:1e-3", FAMILY_FULL, EW_QUALITY_ERROR_1E_3, 0},
                                  finest = {"full:1e-4", FAMILY_FULL, EW_QUALITY_ERROR_1E_4, 0};
    drawn_picture other;
    int threads = (int)sysconf(_SC_NPROCESSORS_ONLN);
    if (!stage_draw(stage, &usual, EW_OUTPUT_LUMINANCE, message, size)) return false;
    stage_read(stage, errors->picture.luminance);
    if (!stage_draw(stage, &finest, EW_OUTPUT_LUMINANCE, message, size)) return false;
    bool ok = make_picture(stage, &other);
    if (ok) {
        stage_read(stage, other.luminance);
        ok = true_pixels_compute(&errors->rays, &errors->picture, pixel_count, threads, &errors->truth);
        if (ok && !(true_pixels_refine(&errors->rays, &errors->picture, &other, threads, &errors->truth) &&
                    true_pixels_refine(&errors->rays, &other, &errors->picture, threads, &errors->truth))) {
            true_pixels_free(&errors->truth);
            ok = false;
        }
        picture_free(&other);
    }
    if (!ok) message_write(message, size, "--error-samples: the reference does not fit into memory; ask for fewer");
    return ok;
}

/* The picture's light in all over what it ought to be, at the pixels that are spread evenly. */
static double share_of_truth(const error_stage *errors)
{
    double sum = 0, truth = 0;
    for (size_t i = 0; i < errors->truth.count; i++) {
        const true_pixel *pixel = &errors->truth.pixels[i];
        if (!pixel->representative || !pixel->reliable) continue;
        sum += true_pixel_luminance(&errors->picture, pixel);
        truth += pixel->luminance;
    }
    return truth > 0 ? sum / truth : 1;
}

/* As the soft composite shows white light: 1 - exp(-B). */
static bool write_picture(const drawn_picture *picture, const char *folder, const char *scene, const char *integrator,
                          char *message, size_t size)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    float *colors = malloc(4 * count * sizeof *colors);
    if (!colors) {
        message_write(message, size, "--pictures: do not fit into memory");
        return false;
    }
    for (size_t i = 0; i < 4 * count; i++)
        colors[i] = 1 - expf(-picture->luminance[i / 4]);
    char path[4096];
    snprintf(path, sizeof path, "%s/%s-%s.png", folder, scene, integrator);
    for (char *c = strchr(path + strlen(folder), ':'); c; c = strchr(c, ':'))
        *c = '-';
    const image_pixels image = {.width = picture->width, .height = picture->height, .channels = 4, .pixels = colors};
    bool written = image_write(path, &image, message, size);
    free(colors);
    return written;
}

/* Draws what is not timed: once as timed, with the shaders' compilation, and then for the errors and the evaluations. */
static bool measure_errors(bench_stage *stage, error_stage *errors, const char *name, const char *pictures,
                           const bench_integrator *integrator, measurement *result, char *message, size_t size)
{
    picture_comparison comparison;
    if (!stage_draw(stage, integrator, EW_OUTPUT_ADD, message, size)) return false;
    if (!stage_draw(stage, integrator, EW_OUTPUT_LUMINANCE, message, size)) return false;
    if (integrator->family == FAMILY_BARE) return true;
    stage_read(stage, errors->picture.luminance);
    if (!comparison_make(&errors->truth, &errors->picture, &comparison)) {
        message_write(message, size, "--error-samples: the errors do not fit into memory; ask for fewer");
        return false;
    }
    result->max_error = comparison.bad_count ? HUGE_VAL : comparison.largest_error;
    result->p99_error = comparison.percentile_99;
    result->brightness = share_of_truth(errors);
    if (pictures && !write_picture(&errors->picture, pictures, name, integrator->name, message, size)) return false;
    if (!integrator_counts_evaluations(integrator)) return true;
    if (!stage_draw(stage, integrator, EW_OUTPUT_EVALUATIONS, message, size)) return false;
    stage_read(stage, errors->picture.luminance);
    result->evaluations_per_pixel = mean(errors->picture.luminance, (size_t)stage->width * (size_t)stage->height);
    return true;
}

static bool measure_all_errors(bench_stage *stage, const demo_scene *scene, const char *name, const measure_settings *settings,
                               scene_measurements *measurements, char *message, size_t size)
{
    error_stage errors;
    if (!make_picture(stage, &errors.picture)) {
        message_write(message, size, "--size: the picture does not fit into memory; ask for a smaller one");
        return false;
    }
    bool ok = scene_rays_create(scene, stage->width, stage->height, &errors.rays);
    if (!ok) message_write(message, size, "the scene does not fit into memory");
    if (ok) {
        progress_show("%s: reference", name);
        ok = compute_truth(stage, settings->error_samples, &errors, message, size);
        if (ok) {
            errors.truth.dark = settings->dark;
            measurements->pixels = errors.truth.count - errors.truth.unreliable_count;
            measurements->unreliable_pixels = errors.truth.unreliable_count;
            for (size_t i = 0; ok && i < settings->integrator_count; i++) {
                progress_show("%s: errors of %s", name, settings->integrators[i].name);
                ok = measure_errors(stage, &errors, name, settings->pictures, &settings->integrators[i],
                                    &measurements->integrators[i], message, size);
            }
            true_pixels_free(&errors.truth);
        }
        scene_rays_free(&errors.rays);
    }
    picture_free(&errors.picture);
    return ok;
}

/* ---- Speed -------------------------------------------------------------------------------------------------------------- */

static double median(const double *sorted, int count)
{
    return 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
}

/* Puts the integrators into another order for every round, so that none of them always follows the same one. */
static void shuffle(size_t *order, size_t count, uint64_t *random)
{
    for (size_t i = count; i > 1; i--) {
        size_t other = random_index(random, i), kept = order[i - 1];
        order[i - 1] = order[other];
        order[other] = kept;
    }
}

/* Whether an integrator that is repeated `wanted` times of `rounds` takes part in the given one: evenly spread, the first one
 * among them. */
static bool takes_part(int round, int rounds, int wanted)
{
    return (long)round * wanted % rounds < wanted;
}

/* How many frames that take `ms` each are drawn. */
static int repetitions_within_budget(const measure_settings *settings, double ms)
{
    return (int)fmin(settings->repetitions, fmax(MEASURE_MIN_REPETITIONS, MEASURE_BUDGET / ms));
}

/* Draws in rounds. `times` has room for settings->repetitions of each integrator, and `order` for the integrators. */
static bool measure_times(gl_context *context, bench_stage *stage, const char *name, const measure_settings *settings,
                          double *times, size_t *order, measurement *results, char *message, size_t size)
{
    uint64_t random = 0;
    bool ok = true;
    bench_stopwatch stopwatch = stopwatch_create(context);
    for (size_t i = 0; i < settings->integrator_count; i++)
        order[i] = i;
    for (int round = 0; ok && round < settings->repetitions; round++) {
        shuffle(order, settings->integrator_count, &random);
        for (size_t turn = 0; ok && turn < settings->integrator_count; turn++) {
            size_t i = order[turn];
            double *own = &times[i * (size_t)settings->repetitions];
            int wanted = round > 0 ? repetitions_within_budget(settings, own[0]) : settings->repetitions;
            if (!takes_part(round, settings->repetitions, wanted)) continue;
            progress_show("%s: round %d of %d, %s", name, round + 1, settings->repetitions, settings->integrators[i].name);
            stopwatch_start(&stopwatch);
            ok = stage_draw(stage, &settings->integrators[i], EW_OUTPUT_ADD, message, size);
            own[results[i].repetitions++] = stopwatch_stop(&stopwatch);
        }
    }
    stopwatch_destroy(&stopwatch);
    for (size_t i = 0; ok && i < settings->integrator_count; i++) {
        double *own = &times[i * (size_t)settings->repetitions];
        sort_numbers(own, (size_t)results[i].repetitions);
        results[i].ms_min = own[0];
        results[i].ms_median = median(own, results[i].repetitions);
    }
    return ok;
}

static bool measure_all_times(gl_context *context, bench_stage *stage, const char *name, const measure_settings *settings,
                              measurement *results, char *message, size_t size)
{
    double *times = malloc(settings->integrator_count * (size_t)settings->repetitions * sizeof *times);
    size_t *order = malloc(settings->integrator_count * sizeof *order);
    bool ok = times && order;
    if (ok)
        ok = measure_times(context, stage, name, settings, times, order, results, message, size);
    else
        message_write(message, size, "--repetitions: do not fit into memory; ask for fewer");
    free(times);
    free(order);
    return ok;
}

bool measure_scene(gl_context *context, const demo_scene *scene, const char *name, const measure_settings *settings,
                   scene_measurements *measurements, char *message, size_t size)
{
    bench_stage stage;
    *measurements = (scene_measurements){.integrators = calloc(settings->integrator_count, sizeof *measurements->integrators)};
    if (!measurements->integrators) {
        message_write(message, size, "--integrators: do not fit into memory; name fewer");
        return false;
    }
    bool ok = stage_create(context, scene, settings->width, settings->height, &stage, message, size);
    if (ok) {
        ok = measure_all_errors(&stage, scene, name, settings, measurements, message, size) &&
             measure_all_times(context, &stage, name, settings, measurements->integrators, message, size);
        stage_destroy(&stage);
    }
    progress_clear();
    if (ok && context_gl(context)->GetError() != GL_NO_ERROR) {
        message_write(message, size, "--backend: GL reported an error while drawing; try another backend");
        ok = false;
    }
    if (!ok) measure_free(measurements);
    return ok;
}

void measure_free(scene_measurements *measurements)
{
    free(measurements->integrators);
    *measurements = (scene_measurements){0};
}
