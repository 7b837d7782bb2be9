/* Speed and error of integrators on a scene: see measure.h. */
#include "measure.h"
#include "message.h"
#include "progress.h"
#include "random_numbers.h"
#include "stage.h"
#include "stopwatch.h"
#include "truth.h"

#include <stdlib.h>

/* ---- Errors ------------------------------------------------------------------------------------------------------------- */

static double mean(const float *values, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum / (double)count;
}

/* Draws what is not timed, which is also the first draw, with the shaders' compilation: for the errors and the evaluations. */
static bool measure_errors(bench_stage *stage, const bench_truth *truth, const bench_integrator *integrator, float *pixels,
                           measurement *result, char *message, size_t size)
{
    if (!stage_draw(stage, integrator, EW_OUTPUT_LUMINANCE, message, size)) return false;
    if (integrator->family == FAMILY_BARE) return true;
    stage_read(stage, pixels);
    if (!truth_errors(truth, pixels, stage->width, &result->max_error, &result->p99_error)) {
        message_write(message, size, "--error-samples: the errors do not fit into memory; ask for fewer");
        return false;
    }
    if (!stage_draw(stage, integrator, EW_OUTPUT_EVALUATIONS, message, size)) return false;
    stage_read(stage, pixels);
    result->evaluations_per_pixel = mean(pixels, (size_t)stage->width * (size_t)stage->height);
    return true;
}

static bool compute_truth(const bench_stage *stage, const ew_scene *scene, const measure_settings *settings, float *pixels,
                          bench_truth *truth, char *message, size_t size)
{
    const float *depth = stage_read_depth(stage, pixels) ? pixels : NULL;
    return truth_compute(scene, stage->width, stage->height, depth, settings->error_samples, truth, message, size);
}

static bool measure_all_errors(bench_stage *stage, const ew_scene *scene, const char *name, const measure_settings *settings,
                               scene_measurements *measurements, char *message, size_t size)
{
    bench_truth truth;
    float *pixels = malloc((size_t)stage->width * (size_t)stage->height * sizeof *pixels);
    if (!pixels) {
        message_write(message, size, "--size: the picture does not fit into memory; ask for a smaller one");
        return false;
    }
    bool ok = compute_truth(stage, scene, settings, pixels, &truth, message, size);
    if (ok) {
        measurements->pixels = truth.count - truth.unreliable_count;
        measurements->unreliable_pixels = truth.unreliable_count;
        for (size_t i = 0; ok && i < settings->integrator_count; i++) {
            progress_show("%s: errors of %s", name, settings->integrators[i].name);
            ok = measure_errors(stage, &truth, &settings->integrators[i], pixels, &measurements->integrators[i], message, size);
        }
        truth_free(&truth);
    }
    free(pixels);
    return ok;
}

/* ---- Speed -------------------------------------------------------------------------------------------------------------- */

static int compare_numbers(const void *a, const void *b)
{
    const double *first = a, *second = b;
    return (*first > *second) - (*first < *second);
}

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
            bool slow = round > 0 && own[0] > MEASURE_SLOW_FRAME;
            if (!takes_part(round, settings->repetitions, slow ? MEASURE_MIN_REPETITIONS : settings->repetitions)) continue;
            progress_show("%s: round %d of %d, %s", name, round + 1, settings->repetitions, settings->integrators[i].name);
            stopwatch_start(&stopwatch);
            ok = stage_draw(stage, &settings->integrators[i], EW_OUTPUT_LUMINANCE, message, size);
            own[results[i].repetitions++] = stopwatch_stop(&stopwatch);
        }
    }
    stopwatch_destroy(&stopwatch);
    for (size_t i = 0; ok && i < settings->integrator_count; i++) {
        double *own = &times[i * (size_t)settings->repetitions];
        qsort(own, (size_t)results[i].repetitions, sizeof *own, compare_numbers);
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

bool measure_scene(gl_context *context, const ew_scene *scene, const char *name, const measure_settings *settings,
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
