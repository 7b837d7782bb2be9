/*
 * ew-bench-fog: how many times as long a frame takes in fog and among media as without.
 */
#include "camera.h"
#include "camera_ray.h"
#include "growth_scene.h"
#include "message.h"
#include "output_file.h"
#include "progress.h"
#include "scene_file.h"
#include "sort.h"
#include "stopwatch.h"
#include "table_program.h"
#include "texture.h"
#include "vector.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS = 5, BALL_COUNT = 4, MAX_SCENES = 24 };

static bool run(gl_context *context, const table_settings *settings, char *message, size_t size);
static const table_program program = {"ew-bench-fog",
                                      "Measures how many times as long a frame takes in fog and among media as without.",
                                      "fog-and-media", "What fog and media cost", run};

/* What a frame is drawn in, in turns. */
enum { IN_NOTHING, IN_EVEN_FOG, IN_FOG_BY_HEIGHT, IN_A_BODY, BEHIND_A_PANE, AMONG_BALLS, WAY_COUNT };

static const struct {
    ew_resolution resolution;
    const char *title;
} resolutions[] = {{EW_RESOLUTION_ADAPTIVE, "adaptive"}, {EW_RESOLUTION_FULL, "full"}};
enum { RESOLUTION_COUNT = sizeof resolutions / sizeof *resolutions };

typedef struct fog_result {
    char scene[64];
    bool is_dark; /* without its sources: what media do to the opaque scene alone */
    double ms[RESOLUTION_COUNT][WAY_COUNT];
} fog_result;

/* Where the light of a frame is. */
typedef struct light_place {
    double middle[3];
    double axes[3][3];  /* the camera's right, up and backward */
    double depth;       /* of the middle */
    double end;         /* view depth at which the light ends */
    double half_height; /* of the picture, at the middle */
    double half_width;
} light_place;

/* ---- What the light is in ------------------------------------------------------------------------------------------------ */

static bool find_light(const growth_frame *frame, const scene_camera *camera, light_place *place, char *message, size_t size)
{
    ew_bounds bounds;
    ew_error error;
    if (ew_get_bounds(frame->effect, &frame->desc, &bounds, &error) != EW_OK) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    const double aspect = (double)frame->desc.viewport_width / frame->desc.viewport_height;
    place->end = fmin(bounds.depth_end, camera->far_depth);
    place->depth = (fmax(bounds.depth_start, camera->near_depth) + place->end) / 2;
    camera_axes(camera, place->axes);
    vector_add_scaled(camera->eye, -place->depth, place->axes[2], place->middle);
    place->half_height = camera_half_height(camera, place->depth);
    place->half_width = aspect * place->half_height;
    return true;
}

/* A body along the camera's axes. */
static ew_medium body(ew_medium_shape shape, const double center[3], const double half[3], const light_place *place,
                      double extinction)
{
    ew_medium medium = {.shape = shape, .extinction = extinction, .albedo = 0.5, .ambient = {0.1, 0.1, 0.1}};
    vector_copy(center, medium.center);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            medium.half_axes[i][k] = half[i] * place->axes[i][k];
    return medium;
}

static size_t make_balls(const light_place *place, ew_medium media[BALL_COUNT])
{
    const double radius = 0.8 * place->half_height;
    for (int i = 0; i < BALL_COUNT; i++) {
        double center[3];
        vector_add_scaled(place->middle, (i & 1 ? 0.5 : -0.5) * radius, place->axes[0], center);
        vector_add_scaled(center, (i & 2 ? 0.5 : -0.5) * radius, place->axes[1], center);
        media[i] = body(EW_MEDIUM_ELLIPSOID, center, (double[]){radius, radius, radius}, place, 0.5 / radius);
    }
    return BALL_COUNT;
}

/* The frame in these surroundings. The media must last as long as it does. */
static ew_frame_desc frame_in(int way, const growth_frame *frame, const scene_camera *camera, const light_place *place,
                              ew_medium media[BALL_COUNT])
{
    ew_frame_desc desc = frame->desc;
    const double end = 2 * place->end, thin = 0.02 * place->depth, extinction = 1 / place->depth;
    desc.media = media;
    switch (way) {
    case IN_FOG_BY_HEIGHT:
        vector_normalize(camera->up, desc.fog.up);
        desc.fog.base = vector_dot(desc.fog.up, place->middle);
        desc.fog.scale = place->half_height;
        desc.fog.extinction = extinction;
        break;
    case IN_EVEN_FOG:
        desc.fog.extinction = extinction;
        break;
    case IN_A_BODY:
        media[0] = body(EW_MEDIUM_BOX, camera->eye, (double[]){end, end, end}, place, extinction);
        desc.medium_count = 1;
        break;
    case BEHIND_A_PANE:
        media[0] = body(EW_MEDIUM_BOX, place->middle, (double[]){4 * place->half_width, 4 * place->half_height, thin}, place,
                        0.5 / thin);
        desc.medium_count = 1;
        break;
    case AMONG_BALLS:
        desc.medium_count = make_balls(place, media);
        break;
    default:
        break;
    }
    return desc;
}

/* ---- Measurements ------------------------------------------------------------------------------------------------------- */

/* Draws once, and returns how long that takes: by GL's own timer, or else the processor time of all threads of a software
 * rasteriser, which other work on the machine hardly changes. */
static double time_frame(const growth_frame *frame, const ew_frame_desc *desc, bench_stopwatch *stopwatch, bool *ok,
                         ew_error *error)
{
    texture_clear(frame->gl, frame->framebuffers[1]);
    stopwatch_start(stopwatch);
    const clock_t began = clock();
    *ok = ew_draw(frame->effect, desc, error) == EW_OK;
    const double ms = stopwatch_stop(stopwatch);
    return stopwatch_is_gl_timer(stopwatch) ? ms : 1e3 * (double)(clock() - began) / CLOCKS_PER_SEC;
}

/* All take turns, so that whatever slows the machine down for a while hits all alike. The first round compiles. */
static bool measure_times(gl_context *context, const growth_frame *frame, const scene_camera *camera, const light_place *place,
                          ew_resolution resolution, double medians[WAY_COUNT], char *message, size_t size)
{
    double times[WAY_COUNT][ROUNDS];
    bench_stopwatch stopwatch = stopwatch_create(context);
    ew_error error;
    bool ok = true;
    for (int round = -1; ok && round < ROUNDS; round++)
        for (int way = 0; ok && way < WAY_COUNT; way++) {
            ew_medium media[BALL_COUNT];
            ew_frame_desc desc = frame_in(way, frame, camera, place, media);
            desc.resolution = resolution;
            const double ms = time_frame(frame, &desc, &stopwatch, &ok, &error);
            if (round >= 0) times[way][round] = ms;
        }
    if (!ok) message_write(message, size, "%s", error.text);
    for (int way = 0; ok && way < WAY_COUNT; way++) {
        sort_numbers(times[way], ROUNDS);
        medians[way] = times[way][ROUNDS / 2];
    }
    stopwatch_destroy(&stopwatch);
    return ok;
}

static bool measure(gl_context *context, const char *path, const table_settings *settings, fog_result *result, char *message,
                    size_t size)
{
    const char *slash = strrchr(path, '/');
    demo_scene scene;
    growth_frame frame;
    light_place place;
    snprintf(result->scene, sizeof result->scene, "%.*s%s", (int)strcspn(slash + 1, "."), slash + 1,
             result->is_dark ? " without light" : "");
    if (!scene_load(path, &scene, message, size)) return false;
    bool ok = growth_frame_create(context, &scene, settings->width, settings->height, 1, context_get_proc_address, &frame,
                                  message, size) == EW_OK;
    if (ok) {
        ok = find_light(&frame, &scene.camera, &place, message, size);
        if (result->is_dark) ew_set_sources(frame.effect, &(ew_sources_desc){0}, NULL);
        for (int i = 0; ok && i < RESOLUTION_COUNT; i++) {
            progress_show("fog: %s at %s resolution", result->scene, resolutions[i].title);
            ok = measure_times(context, &frame, &scene.camera, &place, resolutions[i].resolution, result->ms[i], message, size);
        }
        growth_frame_destroy(&frame);
    }
    scene_free(&scene);
    progress_clear();
    return ok;
}

/* ---- The report --------------------------------------------------------------------------------------------------------- */

static void write_table(FILE *file, const fog_result *results, size_t count, int resolution)
{
    fprintf(file,
            "| %s resolution | without, ms | in even fog | in fog by height | in a body | behind a pane | among balls |\n",
            resolutions[resolution].title);
    fputs("|---|--:|--:|--:|--:|--:|--:|\n", file);
    for (size_t i = 0; i < count; i++) {
        const double *ms = results[i].ms[resolution];
        fprintf(file, "| `%s` | %s |", results[i].scene, page_number(ms[IN_NOTHING]));
        for (int way = IN_NOTHING + 1; way < WAY_COUNT; way++)
            if (results[i].is_dark)
                fprintf(file, " %s ms |", page_number(ms[way]));
            else
                fprintf(file, " %.2f |", ms[way] / ms[IN_NOTHING]);
        fputs("\n", file);
    }
    fputs("\n", file);
}

static bool write_report(gl_context *context, const table_settings *settings, const fog_result *results, size_t count,
                         char *message, size_t size)
{
    char path[4096];
    bench_machine machine;
    FILE *file = table_page_open(&program, context, settings, &machine, path, message, size);
    if (!file) return false;
    fprintf(file,
            "- Frames of %d x %d pixels, as hosts draw them: without, the median of %d in milliseconds, %s; in fog and among "
            "media, how many times as long that takes. All take turns, so the ratios are of the same run.\n"
            "- Even fog leaves 1 / e of the light in the middle of the depths that are lit. Fog by height is as thick there, "
            "and e times thicker half a picture below.\n"
            "- Media: a box around the eye and all light; a pane of glass across the middle, which lets 1 / e through; and "
            "four balls there that overlap. All are drawn over the opaque scene, too, in a pass over all pixels that they "
            "cover: the "
            "last row is that alone, in milliseconds. It is most of the cost where the light is cheap.\n"
            "- Scenes: the whole frames of [Speed against error](speed-and-error.md), the spiral of [Light on "
            "surfaces](light-on-surfaces.md), and, with an interval, those of the papers' integral.\n\n",
            settings->width, settings->height, ROUNDS,
            machine.has_gl_timer ? "by GL's own timer" : "of the processor's time on all threads");
    for (int i = 0; i < RESOLUTION_COUNT; i++)
        write_table(file, results, count, i);
    return output_file_close(file, path, message, size);
}

static bool run(gl_context *context, const table_settings *settings, char *message, size_t size)
{
    fog_result results[MAX_SCENES] = {0};
    glob_t found = {0};
    glob(EW_BENCH_FRAMES "/*.json", 0, NULL, &found);
    glob(EW_BENCH_LIGHT "/spiral.json", GLOB_APPEND, NULL, &found);
    glob(EW_BENCH_SCENES "/*.json", GLOB_APPEND, NULL, &found);
    size_t count = found.gl_pathc < MAX_SCENES ? found.gl_pathc : MAX_SCENES - 1;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++)
        ok = measure(context, found.gl_pathv[i], settings, &results[i], message, size);
    results[count].is_dark = true;
    ok = ok && measure(context, found.gl_pathv[0], settings, &results[count++], message, size);
    for (int i = 0; ok && i < RESOLUTION_COUNT; i++)
        write_table(stdout, results, count, i);
    if (ok && settings->report) ok = write_report(context, settings, results, count, message, size);
    globfree(&found);
    return ok;
}

int main(int argc, char **argv)
{
    return table_program_main(&program, argc, argv);
}
