/* How the time of a frame grows: see growth.h. */
#include "growth.h"
#include "growth_scene.h"
#include "message.h"
#include "progress.h"
#include "scene_file.h"
#include "sort.h"
#include "upload_counter.h"

#include <math.h>
#include <time.h>

/* A sweep ends where a frame takes longer, in milliseconds. */
#define LONGEST_FRAME 4000.0

static const ew_resolution resolutions[] = {EW_RESOLUTION_ADAPTIVE, EW_RESOLUTION_FULL};

typedef struct growth_run {
    gl_context *context;
    const growth_settings *settings;
    demo_scene arena;
    char *message;
    size_t size;
} growth_run;

/* Times a frame at both resolutions. */
static bool time_both(const growth_run *run, growth_frame *frame, growth_point *point)
{
    for (int i = 0; i < 2; i++) {
        point->y[i] = growth_frame_time(run->context, frame, resolutions[i], run->message, run->size);
        if (point->y[i] < 0) return false;
    }
    return true;
}

/* Whether the sweep goes on: not if its last frame took too long. */
static bool goes_on(growth_sweep *sweep)
{
    if (sweep->count == 0) return true;
    const growth_point *last = &sweep->points[sweep->count - 1];
    if (fmax(last->y[0], last->y[1]) < LONGEST_FRAME) return true;
    message_write(sweep->end, sizeof sweep->end, "There it ends, since a frame took more than %g s.", LONGEST_FRAME / 1000);
    return false;
}

/* ---- Pixels ------------------------------------------------------------------------------------------------------------- */

static bool measure_pixels(const growth_run *run, growth_sweep *sweep)
{
    static const int sizes[][2] = {{256, 256}, {512, 512}, {1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160}};
    *sweep = (growth_sweep){.name = "pixels",
                            .title = "Pixels",
                            .sentence = "The arena of the whole frames, from 256 x 256 to 3840 x 2160 pixels.",
                            .x_title = "pixels",
                            .y_title = "milliseconds a frame",
                            .series = {"adaptive", "full", NULL}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        int width = sizes[i][0], height = sizes[i][1];
        if (width > run->settings->largest_side || !goes_on(sweep)) break;
        progress_show("growth: %d x %d pixels", width, height);
        growth_point *point = &sweep->points[sweep->count];
        growth_frame frame;
        point->x = (double)width * height;
        if (growth_frame_create(run->context, &run->arena, width, height, 1, context_get_proc_address, &frame, run->message,
                                run->size))
            return false;
        bool ok = time_both(run, &frame, point);
        growth_frame_destroy(&frame);
        if (!ok) return false;
        sweep->count++;
    }
    return true;
}

/* ---- Sources and coverage ----------------------------------------------------------------------------------------------- */

/* Appends the point of so many strewn beams, with the share of the picture that is lit beside. Sets *fits to false instead, and
 * tells why in the sweep, if the library does not take as many. */
static bool measure_beams(const growth_run *run, size_t count, double reach, double x, growth_sweep *sweep, bool *fits)
{
    const growth_settings *settings = run->settings;
    strewn_beams beams;
    growth_frame frame;
    if (!strewn_beams_create(count, reach, &beams)) {
        message_write(run->message, run->size, "the beams do not fit into memory");
        return false;
    }
    ew_result result = growth_frame_create(run->context, &beams.scene, settings->width, settings->height, 1,
                                           context_get_proc_address, &frame, run->message, run->size);
    bool ok = result == EW_OK;
    *fits = result != EW_ERROR_TOO_MANY_SOURCES;
    if (!*fits) message_write(sweep->end, sizeof sweep->end, "The library did not take %zu: \"%s\"", count, run->message);
    if (ok) {
        growth_point *point = &sweep->points[sweep->count++];
        point->x = x;
        ok = time_both(run, &frame, point);
        point->beside = growth_frame_lit_share(&frame);
        growth_frame_destroy(&frame);
    }
    strewn_beams_free(&beams);
    return ok || !*fits;
}

static bool measure_sources(const growth_run *run, growth_sweep *sweep)
{
    *sweep = (growth_sweep){
        .name = "sources",
        .title = "Sources",
        .sentence = "From 1 to 4096 beams, each as long as a ninth of the picture's height, with a reach of a 36th.",
        .x_title = "beams",
        .y_title = "milliseconds a frame",
        .series = {"adaptive", "full", NULL},
        .beside = "lit share of the picture"};
    for (int count = 1; count <= 4096 && count <= run->settings->largest_count && goes_on(sweep); count *= 4) {
        bool fits;
        progress_show("growth: %d beams", count);
        if (!measure_beams(run, (size_t)count, 0.25, count, sweep, &fits)) return false;
        if (!fits) break;
    }
    return true;
}

static bool measure_coverage(const growth_run *run, growth_sweep *sweep)
{
    enum { BEAMS = 64 };
    *sweep = (growth_sweep){.name = "coverage",
                            .title = "Coverage",
                            .sentence = "The same 64 beams, with a reach from less than a pixel to all of the picture.",
                            .x_title = "reach, in heights of the picture",
                            .y_title = "milliseconds a frame",
                            .series = {"adaptive", "full", NULL},
                            .beside = "lit share of the picture"};
    for (double reach = 9.0 / 512; reach <= 9.0 && goes_on(sweep); reach *= 2) {
        bool fits;
        progress_show("growth: a reach of %g of the picture's height", reach / 9);
        if (!measure_beams(run, BEAMS, reach, reach / 9, sweep, &fits)) return false;
        if (!fits) break;
    }
    return true;
}

/* ---- Samples ------------------------------------------------------------------------------------------------------------ */

static bool measure_samples(const growth_run *run, growth_sweep *sweep)
{
    const growth_settings *settings = run->settings;
    GLint color = 1, depth = 1;
    context_gl(run->context)->GetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &color);
    context_gl(run->context)->GetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
    *sweep = (growth_sweep){.name = "samples",
                            .title = "Samples",
                            .sentence = "The arena onto a target of 1, 2, 4 and 8 samples a pixel, whose depth has as many.",
                            .x_title = "samples a pixel",
                            .y_title = "milliseconds a frame",
                            .series = {"adaptive", "full", NULL}};
    for (int samples = 1; samples <= 8 && goes_on(sweep); samples *= 2) {
        if (samples > color || samples > depth) {
            message_write(sweep->end, sizeof sweep->end, "This GL has targets of %d samples at the most.", samples / 2);
            break;
        }
        progress_show("growth: %d samples", samples);
        growth_point *point = &sweep->points[sweep->count];
        growth_frame frame;
        point->x = samples;
        if (growth_frame_create(run->context, &run->arena, settings->width, settings->height, samples, context_get_proc_address,
                                &frame, run->message, run->size))
            return false;
        bool ok = time_both(run, &frame, point);
        growth_frame_destroy(&frame);
        if (!ok) return false;
        sweep->count++;
    }
    return true;
}

/* ---- The processor ------------------------------------------------------------------------------------------------------ */

static double now_microseconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec * 1e6 + (double)time.tv_nsec * 1e-3;
}

/* Lets the frames draw a single pixel, so that a software rasteriser, too, has nothing to do; or all of them again. */
static void set_scissor(const growth_run *run, bool is_on)
{
    const gl_functions *gl = context_gl(run->context);
    ((PFNGLSCISSORPROC)context_get_proc_address(run->context, "glScissor"))(0, 0, 1, 1);
    (is_on ? gl->Enable : gl->Disable)(GL_SCISSOR_TEST);
}

/* The median of what the thread needs for ew_set_sources and ew_draw, and the bytes that it uploads a frame. */
static bool time_calls(const growth_run *run, const demo_scene *scene, growth_frame *frame, growth_point *point)
{
    enum { CALLS = 101 };
    double set[CALLS], draw[CALLS];
    ew_error error;
    frame->desc.resolution = EW_RESOLUTION_FULL;
    for (int i = -1; i < CALLS; i++) {
        double start = now_microseconds();
        bool ok = ew_set_sources(frame->effect, &scene->sources, &error) == EW_OK;
        double middle = now_microseconds();
        upload_counter_take();
        ok = ok && ew_draw(frame->effect, &frame->desc, &error) == EW_OK;
        double end = now_microseconds();
        if (!ok) {
            message_write(run->message, run->size, "%s", error.text);
            return false;
        }
        frame->gl->Finish();
        if (i < 0) continue;
        set[i] = middle - start;
        draw[i] = end - middle;
    }
    sort_numbers(set, CALLS);
    sort_numbers(draw, CALLS);
    point->y[0] = set[CALLS / 2];
    point->y[1] = draw[CALLS / 2];
    point->beside = (double)upload_counter_take() / (double)scene->sources.path_count;
    return true;
}

static bool measure_processor(const growth_run *run, growth_sweep *sweep)
{
    *sweep = (growth_sweep){
        .name = "processor",
        .title = "The processor",
        .sentence = "What the sources of a frame cost the thread that draws: the same beams, set anew in every frame, behind a "
                    "scissor of a single pixel.",
        .x_title = "beams",
        .y_title = "microseconds a frame",
        .series = {"ew_set_sources", "ew_draw", NULL},
        .beside = "bytes uploaded a beam"};
    for (int count = 1; count <= 4096 && count <= run->settings->largest_count; count *= 4) {
        strewn_beams beams;
        growth_frame frame;
        progress_show("growth: the processor, %d beams", count);
        if (!strewn_beams_create((size_t)count, 0.25, &beams)) {
            message_write(run->message, run->size, "the beams do not fit into memory");
            return false;
        }
        ew_result result = growth_frame_create(run->context, &beams.scene, run->settings->width, run->settings->height, 1,
                                               upload_counter_get_proc_address, &frame, run->message, run->size);
        bool ok = result == EW_OK;
        if (ok) {
            growth_point *point = &sweep->points[sweep->count++];
            point->x = count;
            set_scissor(run, true);
            ok = time_calls(run, &beams.scene, &frame, point);
            set_scissor(run, false);
            growth_frame_destroy(&frame);
        }
        strewn_beams_free(&beams);
        if (result == EW_ERROR_TOO_MANY_SOURCES) {
            message_write(sweep->end, sizeof sweep->end, "The library did not take %d: \"%s\"", count, run->message);
            break;
        }
        if (!ok) return false;
    }
    return true;
}

/* ---- All ---------------------------------------------------------------------------------------------------------------- */

bool growth_measure(gl_context *context, const growth_settings *settings, growth_sweep sweeps[GROWTH_SWEEPS], char *message,
                    size_t size)
{
    growth_run run = {.context = context, .settings = settings, .message = message, .size = size};
    if (!scene_load(settings->scene, &run.arena, message, size)) return false;
    bool ok = measure_pixels(&run, &sweeps[0]) && measure_sources(&run, &sweeps[1]) && measure_coverage(&run, &sweeps[2]) &&
              measure_samples(&run, &sweeps[3]) && measure_processor(&run, &sweeps[4]);
    progress_clear();
    scene_free(&run.arena);
    if (ok && context_gl(context)->GetError() != GL_NO_ERROR) {
        message_write(message, size, "--backend: GL reported an error while drawing; try another backend");
        return false;
    }
    return ok;
}

double growth_exponent(const growth_sweep *sweep, size_t series)
{
    size_t first = (sweep->count - 1) / 2;
    double n = (double)(sweep->count - first), x = 0, y = 0, xx = 0, xy = 0;
    for (size_t i = first; i < sweep->count; i++) {
        double a = log(sweep->points[i].x), b = log(sweep->points[i].y[series]);
        x += a / n;
        y += b / n;
        xx += a * a / n;
        xy += a * b / n;
    }
    return xx > x * x ? (xy - x * y) / (xx - x * x) : 0;
}
