/*
 * ew-bench-light: what light on surfaces costs, beside as many point lights along the sources as are no more wrong.
 */
#include "light_stage.h"
#include "message.h"
#include "output_file.h"
#include "reference_irradiance.h"
#include "reference_threads.h"
#include "scene_rays.h"
#include "sort.h"
#include "stopwatch.h"
#include "table_program.h"
#include "vector.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What ew_irradiance promises, relative to the picture's largest; and how many lights the court of the demo once had. */
#define BAR 1e-2
enum { COURT_LIGHTS = 50 };

enum { SAMPLES = 4096, ROUNDS = 7 };

static bool run(gl_context *context, const table_settings *settings, char *message, size_t size);
static const table_program program = {
    "ew-bench-light", "Measures what light on surfaces costs, and how many point lights along the sources are as good.",
    "light-on-surfaces", "What light on surfaces costs", run};

/* What is drawn of a scene, in turns. */
enum { OURS, OURS_WITH_SHADOWS, FEW_LIGHTS, MANY_LIGHTS, WAY_COUNT };

typedef struct light_result {
    char scene[64];
    int lights; /* how many keep the bar; 0: MAX_POINT_LIGHTS do not */
    double ms[WAY_COUNT], errors[WAY_COUNT];
} light_result;

/* A picture and what is right at some of its pixels. */
typedef struct light_truth {
    const ew_sources_desc *sources; /* relative to the eye */
    double reach, gain;
    int pixel_count;
    float *color, *positions, *normals;
    double truths[SAMPLES][3];
    double brightest;
} light_truth;

/* ---- Errors ------------------------------------------------------------------------------------------------------------- */

static int sample_pixel(const light_truth *truth, size_t sample)
{
    return (int)((double)truth->pixel_count * ((double)sample + 0.5) / SAMPLES);
}

static bool compute_truth(void *user, reference_workspace *workspace, size_t sample)
{
    light_truth *truth = user;
    int pixel = sample_pixel(truth, sample);
    reference_surface surface;
    (void)workspace;
    for (int k = 0; k < 3; k++) {
        surface.position[k] = (double)truth->positions[4 * pixel + k];
        surface.normal[k] = (double)truth->normals[4 * pixel + k];
    }
    if (truth->positions[4 * pixel + 3] == 0) return true;
    vector_normalize((const double[]){surface.normal[0], surface.normal[1], surface.normal[2]}, surface.normal);
    reference_irradiance(truth->sources, truth->reach, &surface, NULL, truth->truths[sample]);
    return true;
}

static bool make_truth(light_stage *stage, const scene_rays *rays, light_truth *truth)
{
    size_t count = (size_t)(stage->settings.width * stage->settings.height);
    *truth = (light_truth){.sources = &rays->sources,
                           .reach = stage->scene->light_reach,
                           .gain = stage->scene->light_gain,
                           .pixel_count = (int)count,
                           .color = malloc(4 * count * sizeof(float)),
                           .positions = malloc(4 * count * sizeof(float)),
                           .normals = malloc(4 * count * sizeof(float))};
    if (!truth->color || !truth->positions || !truth->normals) return false;
    light_stage_read(stage, truth->color, truth->positions, truth->normals);
    if (!reference_threads_run(compute_truth, truth, SAMPLES, (int)sysconf(_SC_NPROCESSORS_ONLN))) return false;
    for (int i = 0; i < SAMPLES; i++)
        for (int k = 0; k < 3; k++)
            truth->brightest = fmax(truth->brightest, truth->gain * truth->truths[i][k]);
    return true;
}

static void free_truth(light_truth *truth)
{
    free(truth->color);
    free(truth->positions);
    free(truth->normals);
}

/* The largest of the picture that was drawn last. */
static double error_of(light_stage *stage, light_truth *truth)
{
    double largest = 0;
    light_stage_read(stage, truth->color, NULL, NULL);
    for (size_t i = 0; i < SAMPLES; i++)
        for (int k = 0; k < 3; k++) {
            double is = (double)truth->color[4 * sample_pixel(truth, i) + k] - 1;
            largest = fmax(largest, fabs(is - truth->gain * truth->truths[i][k]));
        }
    return largest / truth->brightest;
}

static double error_of_lights(light_stage *stage, light_truth *truth, int count)
{
    light_stage_set_lights(stage, count);
    light_stage_clear(stage);
    light_stage_draw_lights(stage, count);
    return error_of(stage, truth);
}

/* The least number that keeps the bar, to a twentieth. */
static int find_light_count(light_stage *stage, light_truth *truth)
{
    int low = 1, high = 2;
    while (high <= MAX_POINT_LIGHTS && error_of_lights(stage, truth, high) > BAR)
        low = high, high *= 2;
    if (high > MAX_POINT_LIGHTS) return 0;
    while (high - low > 1 + high / 20) {
        int middle = (low + high) / 2;
        if (error_of_lights(stage, truth, middle) > BAR)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* ---- Measurements ------------------------------------------------------------------------------------------------------- */

static bool draw_way(light_stage *stage, int way, int lights, char *message, size_t size)
{
    if (way == OURS || way == OURS_WITH_SHADOWS) return light_stage_draw(stage, way == OURS_WITH_SHADOWS, message, size);
    light_stage_draw_lights(stage, lights);
    return true;
}

/* All take turns, so that whatever slows the machine down for a while hits all alike. */
static bool measure_times(light_stage *stage, light_result *result, char *message, size_t size)
{
    double times[WAY_COUNT][ROUNDS];
    bench_stopwatch stopwatch = stopwatch_create(stage->context);
    bool ok = true;
    for (int round = -1; ok && round < ROUNDS; round++)
        for (int way = 0; ok && way < WAY_COUNT; way++) {
            int lights = way == FEW_LIGHTS ? COURT_LIGHTS : result->lights;
            if (way >= FEW_LIGHTS) light_stage_set_lights(stage, lights);
            light_stage_clear(stage);
            stopwatch_start(&stopwatch);
            ok = draw_way(stage, way, lights, message, size);
            double ms = stopwatch_stop(&stopwatch);
            if (round >= 0) times[way][round] = ms;
        }
    for (int way = 0; ok && way < WAY_COUNT; way++) {
        sort_numbers(times[way], ROUNDS);
        result->ms[way] = times[way][ROUNDS / 2];
    }
    stopwatch_destroy(&stopwatch);
    return ok;
}

static bool measure_stage(light_stage *stage, light_truth *truth, light_result *result, char *message, size_t size)
{
    light_stage_clear(stage);
    if (!light_stage_draw(stage, false, message, size)) return false;
    result->errors[OURS] = error_of(stage, truth);
    result->errors[FEW_LIGHTS] = error_of_lights(stage, truth, COURT_LIGHTS);
    result->lights = find_light_count(stage, truth);
    result->errors[MANY_LIGHTS] = error_of_lights(stage, truth, result->lights);
    return measure_times(stage, result, message, size);
}

static bool measure(gl_context *context, const char *path, const table_settings *settings, light_result *result, char *message,
                    size_t size)
{
    const char *slash = strrchr(path, '/');
    demo_scene scene;
    scene_rays rays;
    light_stage stage;
    static light_truth truth;
    snprintf(result->scene, sizeof result->scene, "%.*s", (int)strcspn(slash + 1, "."), slash + 1);
    if (!scene_load(path, &scene, message, size)) return false;
    bool ok = scene_rays_create(&scene, settings->width, settings->height, &rays);
    if (!ok) message_write(message, size, "%s: does not fit into memory", path);
    if (ok && (ok = light_stage_create(context, &scene, settings->width, settings->height, &stage, message, size))) {
        ok = make_truth(&stage, &rays, &truth);
        if (!ok) message_write(message, size, "%s: the reference does not fit into memory", path);
        ok = ok && measure_stage(&stage, &truth, result, message, size);
        free_truth(&truth);
        light_stage_destroy(&stage);
        scene_rays_free(&rays);
    }
    scene_free(&scene);
    return ok;
}

/* ---- The report --------------------------------------------------------------------------------------------------------- */

static void write_table(FILE *file, const light_result *results, size_t count)
{
    fprintf(file,
            "| scene | this library | with shadows | %d point lights | as many as keep the bar | times as fast as these |\n",
            COURT_LIGHTS);
    fputs("|---|--:|--:|--:|--:|--:|\n", file);
    for (size_t i = 0; i < count; i++) {
        const light_result *r = &results[i];
        fprintf(file, "| `%s` | %s ms (%.1e) | %s ms | %s ms (%.1e) | %d lights: %s ms (%.1e) | %s |\n", r->scene,
                page_number(r->ms[OURS]), r->errors[OURS], page_number(r->ms[OURS_WITH_SHADOWS]),
                page_number(r->ms[FEW_LIGHTS]), r->errors[FEW_LIGHTS], r->lights, page_number(r->ms[MANY_LIGHTS]),
                r->errors[MANY_LIGHTS], page_number(r->ms[MANY_LIGHTS] / r->ms[OURS]));
    }
}

static bool write_report(gl_context *context, const table_settings *settings, const light_result *results, size_t count,
                         char *message, size_t size)
{
    char path[4096];
    bench_machine machine;
    FILE *file = table_page_open(&program, context, settings, &machine, path, message, size);
    if (!file) return false;
    fprintf(file,
            "- Pictures of %d x %d pixels. Milliseconds a frame, the median of %d, all in turns; in brackets the largest "
            "error, "
            "relative to the picture's largest light, at %d pixels against a reference in double precision.\n\n",
            settings->width, settings->height, ROUNDS, SAMPLES);
    write_table(file, results, count);
    fprintf(file,
            "\n- \"This library\" is `EW_OUTPUT_SURFACES` with a texture of normals, as a deferred renderer has it.\n"
            "- Point lights are what games have in its place, and what the court of the demo had before, some %d in all: they "
            "stand at even distances along the source, with this library's falloff, and are summed in one pass over the same "
            "textures. They cast no shadows. They are not sorted into tiles, since nearly all reach all of these pictures.\n"
            "- The bar is 1e-2, which `ew_irradiance` keeps. How many lights keep it depends on how close a surface comes to "
            "the source: they must be about as far apart as that is away.\n"
            "- A bent path is as many emitters as it has pieces, and each that is close takes many nodes: next to a spiral, "
            "point "
            "lights that keep the bar cost less.\n"
            "- All take turns. On a machine that does other things, too, the ratios tell more than the times, and no more than "
            "roughly.\n",
            COURT_LIGHTS);
    return output_file_close(file, path, message, size);
}

static bool run(gl_context *context, const table_settings *settings, char *message, size_t size)
{
    enum { MAX_SCENES = 16 };
    light_result results[MAX_SCENES] = {0};
    glob_t found = {0};
    glob(EW_BENCH_LIGHT "/*.json", 0, NULL, &found);
    size_t count = found.gl_pathc < MAX_SCENES ? found.gl_pathc : MAX_SCENES;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++)
        ok = measure(context, found.gl_pathv[i], settings, &results[i], message, size);
    if (ok) write_table(stdout, results, count);
    if (ok && settings->report) ok = write_report(context, settings, results, count, message, size);
    globfree(&found);
    return ok;
}

int main(int argc, char **argv)
{
    return table_program_main(&program, argc, argv);
}
