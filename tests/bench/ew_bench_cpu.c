/*
 * ew-bench-cpu: what a frame costs the thread that draws it, whatever the GPU then has to do.
 *
 *     ew-bench-cpu [egl | osmesa]
 *
 * Measures the library's calls for 64 sources, onto a single pixel so that even a software rasteriser has nothing to do, and
 * what of that is the saving and restoring of the host's state. Prints the processor time of one call in microseconds.
 */
#include "context.h"
#include "render.h"
#include "sort.h"

/* What the library keeps to itself. */
#include "host/gl.h"
#include "host/state_guard.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { REPETITIONS = 3000, WARM_UP = 100, SOURCES_OF_A_KIND = 16 };

typedef struct cpu_bench {
    const gl_functions *gl;
    ew_gl loaded;
    ew_gl_state saved;
    ew_effect *effect;
    ew_sources_desc sources;
    ew_frame_desc frame;
    ew_result result; /* the worst so far */
} cpu_bench;

static double now_microseconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec * 1e6 + (double)time.tv_nsec * 1e-3;
}

static void note(cpu_bench *bench, ew_result result)
{
    if (result != EW_OK) bench->result = result;
}

static void do_set_sources(cpu_bench *bench)
{
    note(bench, ew_set_sources(bench->effect, &bench->sources, NULL));
}

static void do_draw(cpu_bench *bench)
{
    note(bench, ew_draw(bench->effect, &bench->frame, NULL));
}

static void do_draw_without_restoring(cpu_bench *bench)
{
    bench->frame.skip_restore = 1;
    note(bench, ew_draw(bench->effect, &bench->frame, NULL));
    bench->frame.skip_restore = 0;
}

static void do_update_uniform_buffer(cpu_bench *bench)
{
    unsigned buffer;
    note(bench, ew_update_uniform_buffer(bench->effect, &bench->frame, &buffer, NULL));
}

static void do_save(cpu_bench *bench)
{
    note(bench, ew_gl_save_state(&bench->loaded, &bench->saved, NULL));
}

static void do_restore(cpu_bench *bench)
{
    ew_gl_restore_state(&bench->loaded, &bench->saved);
}

static const struct {
    const char *name;
    void (*call)(cpu_bench *bench);
} rows[] = {
    {"ew_set_sources, 64 sources", do_set_sources},
    {"ew_update_uniform_buffer", do_update_uniform_buffer},
    {"ew_draw", do_draw},
    {"ew_draw with skip_restore", do_draw_without_restoring},
    {"saving the host's state", do_save},
    {"restoring it", do_restore},
};

static void measure(cpu_bench *bench, const char *name, void (*call)(cpu_bench *bench))
{
    static double times[REPETITIONS];
    for (int i = -WARM_UP; i < REPETITIONS; i++) {
        double start = now_microseconds();
        call(bench);
        double end = now_microseconds();
        if (i >= 0) times[i] = end - start;
        bench->gl->Finish();
    }
    sort_numbers(times, REPETITIONS);
    printf("  %-28s %12.1f %12.1f\n", name, times[REPETITIONS / 2], times[0]);
}

static void make_sources(ew_sources_desc *sources)
{
    static ew_point points[SOURCES_OF_A_KIND];
    static ew_line lines[SOURCES_OF_A_KIND];
    static ew_torus tori[SOURCES_OF_A_KIND];
    static ew_curve curves[SOURCES_OF_A_KIND];
    static const double weights[] = {1, 0.2, 0.6, 1};
    for (int i = 0; i < SOURCES_OF_A_KIND; i++) {
        double x = 0.1 * i - 0.8;
        points[i] = (ew_point){.position = {x, 0, 0}, .coefficient = 1, .color = {1, 1, 1}};
        lines[i] = (ew_line){.position = {x, 0, 0}, .direction = {x, 1, 0}, .coefficient = 1, .color = {1, 1, 1}};
        tori[i] = (ew_torus){.center = {x, 0, 0}, .axis = {x, 0, 1}, .radius = 0.5, .coefficient = 1, .color = {1, 1, 1}};
        curves[i] = (ew_curve){.polynomial = {{x, 0, 0}, {1, 1, 0}, {0, 0, 1}},
                               .domain = {0, 1},
                               .weights = weights,
                               .weight_count = 4,
                               .coefficient = 1,
                               .color = {1, 1, 1}};
    }
    *sources = (ew_sources_desc){
        .points = points,
        .point_count = SOURCES_OF_A_KIND,
        .lines = lines,
        .line_count = SOURCES_OF_A_KIND,
        .tori = tori,
        .torus_count = SOURCES_OF_A_KIND,
        .curves = curves,
        .curve_count = SOURCES_OF_A_KIND,
        .epsilon = 1e-2,
    };
}

static int fail(const char *message)
{
    fprintf(stderr, "ew-bench-cpu: %s\n", message);
    return 2;
}

int main(int argc, char **argv)
{
    char message[300] = "";
    context_backend backend = CONTEXT_AUTO;
    if (argc > 2) return fail("usage: ew-bench-cpu [egl | osmesa]");
    if (argc == 2) {
        while (context_backend_names[backend] && strcmp(argv[1], context_backend_names[backend]) != 0)
            backend++;
        if (!context_backend_names[backend]) return fail("the backend must be egl or osmesa");
    }
    gl_context *context = context_create(backend, message, sizeof message);
    if (!context) return fail(message);

    const render_settings one_pixel = {.width = 1, .height = 1};
    render_target target;
    cpu_bench bench = {.gl = context_gl(context), .frame = EW_FRAME_DEFAULTS};
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    ew_error error;
    if (!render_create_target(bench.gl, &one_pixel, &target, message, sizeof message)) return fail(message);
    if (ew_create_effect(&desc, &bench.effect, &error) || ew_gl_load(&bench.loaded, context_get_proc_address, context, &error))
        return fail(error.text);
    make_sources(&bench.sources);
    bench.frame.view[14] = -4;
    bench.frame.interval_start = 1;
    bench.frame.interval_end = 8;
    bench.frame.framebuffer = target.effect_framebuffer;
    bench.frame.viewport_width = bench.frame.viewport_height = 1;

    printf("%s\n  %-28s %12s %12s\n", context_description(context), "microseconds a call", "median", "least");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
        measure(&bench, rows[i].name, rows[i].call);
    ew_destroy_effect(bench.effect);
    render_destroy_target(bench.gl, &target);
    context_destroy(context);
    return bench.result == EW_OK ? 0 : fail(ew_result_text(bench.result));
}
