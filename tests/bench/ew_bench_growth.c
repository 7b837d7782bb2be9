/*
 * ew-bench-growth: how the time of the library's frames grows, with what.
 */
#include "command_line.h"
#include "growth_report.h"
#include "message.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_BAD_INPUT = 2 };

static const char help[] =
    "Usage: ew-bench-growth [option]...\n"
    "Measures how the time of a frame grows with pixels, sources, coverage and samples, and what sources cost the processor.\n"
    "\n"
    "      --size WxH          of the frames whose size is not varied, in pixels (default 640x360)\n"
    "      --largest-side N    leaves out sizes that are wider (default 3840)\n"
    "      --largest-count N   leaves out larger numbers of sources (default 4096)\n"
    "      --report FOLDER     writes FOLDER/growth.md, with plots drawn by gnuplot\n"
    "      --name NAME         makes that FOLDER/growth-NAME.md\n"
    "      --backend NAME      egl, osmesa or auto (default): EGL or else OSMesa\n"
    "  -h, --help              print this help\n"
    "\n"
    "Prints the points. Exit status: 0, or 2 with one line of what to mend on standard error.\n";

typedef struct command_options {
    growth_settings settings;
    const char *report; /* NULL for none */
    const char *name;   /* NULL for none */
    context_backend backend;
} command_options;

static bool read_frame_size(const char *text, void *target)
{
    growth_settings *settings = target;
    return read_size(text, &settings->width, &settings->height);
}

static bool read_positive(const char *text, void *target)
{
    return read_number(text, 1, 999999, target);
}

/* Returns whether there is something to do; where there is not, a message if the command line is at fault. */
static bool read_options(int argc, char **argv, command_options *options, char *message, size_t size)
{
    const command_option table[] = {
        {"size", 0, read_frame_size, &options->settings, SIZE_REMEDY},
        {"largest-side", 0, read_positive, &options->settings.largest_side, "must be a number of pixels"},
        {"largest-count", 0, read_positive, &options->settings.largest_count, "must be a number of sources"},
        {"report", 0, read_text, &options->report, NULL},
        {"name", 0, read_text, &options->name, NULL},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
    };
    const command_program program = {"ew-bench-growth", help, table, sizeof table / sizeof *table};
    if (!command_line_read(&argc, argv, &program, message, size)) return false;
    if (argc == 1) return true;
    message_write(message, size, "%s: is no option; see --help", argv[1]);
    return false;
}

static void print_sweep(const growth_sweep *sweep)
{
    printf("%s: %s %s\n  %-32s", sweep->title, sweep->sentence, sweep->end, sweep->x_title);
    for (int i = 0; sweep->series[i]; i++)
        printf(" %16s", sweep->series[i]);
    printf(" %26s\n", sweep->beside ? sweep->beside : "");
    for (size_t k = 0; k < sweep->count; k++) {
        const growth_point *point = &sweep->points[k];
        printf("  %-32g", point->x);
        for (int i = 0; sweep->series[i]; i++)
            printf(" %16.3f", point->y[i]);
        if (sweep->beside) printf(" %26.3f", point->beside);
        printf("\n");
    }
    printf("  %-32s", "exponent");
    for (size_t i = 0; sweep->series[i]; i++)
        printf(" %16.2f", growth_exponent(sweep, i));
    printf("\n");
}

static bool run(const command_options *options, char *message, size_t size)
{
    static growth_sweep sweeps[GROWTH_SWEEPS];
    bench_machine machine;
    gl_context *context = context_create(options->backend, message, size);
    if (!context) return false;
    puts(context_description(context));
    bool ok = machine_describe(context, &machine, message, size) &&
              growth_measure(context, &options->settings, sweeps, message, size);
    for (int i = 0; ok && i < GROWTH_SWEEPS; i++)
        print_sweep(&sweeps[i]);
    context_destroy(context);
    return ok && (!options->report ||
                  growth_report_write(sweeps, &options->settings, &machine, options->report, options->name, message, size));
}

int main(int argc, char **argv)
{
    command_options options = {
        .settings =
            {.scene = EW_BENCH_FRAMES "/arena.json", .width = 640, .height = 360, .largest_side = 3840, .largest_count = 4096},
        .backend = CONTEXT_AUTO,
    };
    char message[600] = "";
    if (read_options(argc, argv, &options, message, sizeof message) && run(&options, message, sizeof message))
        return EXIT_SUCCESS;
    if (message[0] == '\0') return EXIT_SUCCESS;
    fprintf(stderr, "ew-bench-growth: %s\n", message);
    return EXIT_BAD_INPUT;
}
