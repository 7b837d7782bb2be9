/*
 * ew-bench: how fast and how wrong the library and its peers are on scene files.
 */
#include "command_line.h"
#include "comparison.h"
#include "context.h"
#include "integrator.h"
#include "message.h"
#include "render.h"
#include "report.h"
#include "results.h"
#include "scene_file.h"
#include "table.h"

#include <ctype.h>
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_BAD_INPUT = 2, MAX_REPETITIONS = 1000, MAX_ERROR_SAMPLES = 1000000 };

static const char help[] =
    "Usage: ew-bench [SCENE.json]... [option]...\n"
    "Measures the speed and the error of integrators on scenes, by default on those that come with the benchmark.\n"
    "\n"
    "      --size WxH          in pixels, up to 8192x8192 (default 512x512)\n"
    "      --integrators LIST  separated by commas: adaptive:1e-2, adaptive:1e-3, adaptive:1e-4, simpson:N (N divisions),\n"
    "                          full:E, which is adaptive:E at every pixel,\n"
    "                          marching:N, equiangular:N (N samples), bare (a pass that only writes a constant);\n"
    "                          by default all that a report compares\n"
    "      --repetitions N     frames that are timed, 3 or more (default 15); fewer of what takes more than 1.5 s for that\n"
    "      --error-samples N   pixels that are compared with the reference (default 4096)\n"
    "      --csv FILE          writes the measurements as comma-separated rows, scene by scene\n"
    "      --report FOLDER     writes FOLDER/speed-and-error.md, with plots drawn by gnuplot\n"
    "      --name NAME         makes that FOLDER/speed-and-error-NAME.md\n"
    "      --pictures FOLDER   writes a picture of each scene by each integrator into the folder, as PNG\n"
    "      --backend NAME      egl, osmesa or auto (default): EGL or else OSMesa\n"
    "  -h, --help              print this help\n"
    "\n"
    "Prints a table. Exit status: 0, or 2 with one line of what to mend on standard error.\n";

typedef struct command_line {
    char **scenes;
    size_t scene_count;
    const char *integrators;
    const char *csv;      /* NULL for none */
    const char *report;   /* NULL for none */
    const char *name;     /* NULL for none */
    const char *pictures; /* NULL for none */
    int width;
    int height;
    int repetitions;
    int error_samples;
    context_backend backend;
} command_line;

/* ---- Options ------------------------------------------------------------------------------------------------------------ */

/* `target` is the command_line. */
static bool read_target_size(const char *text, void *target)
{
    command_line *options = target;
    return read_size(text, &options->width, &options->height);
}

static bool read_repetitions(const char *text, void *target)
{
    return read_number(text, MEASURE_MIN_REPETITIONS, MAX_REPETITIONS, target);
}

static bool read_error_samples(const char *text, void *target)
{
    return read_number(text, 1, MAX_ERROR_SAMPLES, target);
}

/* A name that is safe in any file's name and in a Markdown link. */
static bool read_plain_name(const char *text, void *target)
{
    size_t length = strlen(text);
    return length > 0 && length <= 60 && read_text(text, target) &&
           strspn(text, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") == length;
}

/* Returns whether there is something to do; where there is not, a message if the command line is at fault. */
static bool read_options(int argc, char **argv, command_line *options, char *message, size_t size)
{
    const command_option table[] = {
        {"size", 0, read_target_size, options, SIZE_REMEDY},
        {"integrators", 0, read_text, &options->integrators, NULL},
        {"repetitions", 0, read_repetitions, &options->repetitions, "must be from 3 to 1000"},
        {"error-samples", 0, read_error_samples, &options->error_samples, "must be from 1 to 1000000"},
        {"csv", 0, read_text, &options->csv, NULL},
        {"report", 0, read_text, &options->report, NULL},
        {"pictures", 0, read_text, &options->pictures, NULL},
        {"name", 0, read_plain_name, &options->name, "must be of letters, digits, - and _, 60 at most"},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
    };
    const command_program program = {"ew-bench", help, table, sizeof table / sizeof *table};
    if (!command_line_read(&argc, argv, &program, message, size)) return false;
    options->scenes = argv + 1;
    options->scene_count = (size_t)(argc - 1);
    if (!options->name || options->report) return true;
    message_write(message, size, "--name: names a report, but none is asked for; add --report FOLDER");
    return false;
}

/* ---- The run ------------------------------------------------------------------------------------------------------------ */

/* The file's name without folders and .json, with what is not safe in a file's name replaced. */
static void name_scene(bench_scene *scene)
{
    const char *slash = strrchr(scene->path, '/'), *name = slash ? slash + 1 : scene->path;
    snprintf(scene->name, sizeof scene->name, "%s", name);
    char *dot = strrchr(scene->name, '.');
    if (dot && dot > scene->name) *dot = '\0';
    for (char *c = scene->name; *c; c++)
        if (!isalnum((unsigned char)*c) && *c != '-') *c = '_';
}

/* Fills results->scenes, to be freed by the caller. */
static bool list_scenes(char **paths, size_t count, bench_results *results, char *message, size_t size)
{
    results->scenes = calloc(count > 0 ? count : 1, sizeof *results->scenes);
    if (!results->scenes || count == 0) {
        message_write(message, size, "SCENE.json: %s", count == 0 ? "is missing" : "does not fit into memory; name fewer");
        return false;
    }
    for (; results->scene_count < count; results->scene_count++) {
        bench_scene *scene = &results->scenes[results->scene_count];
        scene->path = paths[results->scene_count];
        name_scene(scene);
        for (size_t i = 0; i < results->scene_count; i++)
            if (strcmp(results->scenes[i].name, scene->name) == 0) {
                message_write(message, size, "%s: has the name of another scene; rename it", scene->path);
                return false;
            }
    }
    return true;
}

static bool measure_all_scenes(gl_context *context, bench_results *results, FILE *csv, const char *csv_path, char *message,
                               size_t size)
{
    for (size_t i = 0; i < results->scene_count; i++) {
        bench_scene *bench = &results->scenes[i];
        char reason[400];
        demo_scene scene;
        if (!scene_load(bench->path, &scene, message, size)) return false;
        bool ok = measure_scene(context, &scene, bench->name, &results->settings, &bench->measurements, reason, sizeof reason);
        scene_free(&scene);
        if (!ok) {
            message_write(message, size, "%s: %s", bench->path, reason);
            return false;
        }
        table_print(results, bench);
        if (csv && !table_write_csv(csv, results, bench)) {
            message_write(message, size, "%s: cannot be written (%s)", csv_path, strerror(errno));
            return false;
        }
    }
    return true;
}

static bool measure_to_file(gl_context *context, const command_line *options, bench_results *results, char *message,
                            size_t size)
{
    FILE *csv = options->csv ? fopen(options->csv, "w") : NULL;
    if (options->csv && !(csv && table_write_csv_header(csv))) {
        message_write(message, size, "%s: cannot be written (%s); name a file in a folder that exists", options->csv,
                      strerror(errno));
        if (csv) fclose(csv);
        return false;
    }
    bool ok = measure_all_scenes(context, results, csv, options->csv, message, size);
    if (csv && fclose(csv) != 0 && ok) {
        message_write(message, size, "%s: cannot be written (%s)", options->csv, strerror(errno));
        ok = false;
    }
    return ok && (!options->report || report_write(results, options->report, options->name, message, size));
}

static bool run(const command_line *options, bench_results *results, char *message, size_t size)
{
    gl_context *context = context_create(options->backend, message, size);
    if (!context) return false;
    puts(context_description(context));
    results->machine = machine_describe(context);
    bool ok = measure_to_file(context, options, results, message, size);
    context_destroy(context);
    return ok;
}

static bool benchmark(const command_line *options, char **paths, size_t path_count, char *message, size_t size)
{
    bench_results results = {.settings = {.width = options->width,
                                          .height = options->height,
                                          .repetitions = options->repetitions,
                                          .error_samples = (size_t)options->error_samples,
                                          .dark = TRUTH_DARK,
                                          .pictures = options->pictures}};
    bench_integrator *integrators =
        integrator_parse_list(options->integrators, &results.settings.integrator_count, message, size);
    results.settings.integrators = integrators;
    bool ok = integrators && list_scenes(paths, path_count, &results, message, size) && run(options, &results, message, size);
    for (size_t i = 0; i < results.scene_count; i++)
        measure_free(&results.scenes[i].measurements);
    free(results.scenes);
    free(integrators);
    return ok;
}

int main(int argc, char **argv)
{
    command_line options = {.integrators = integrator_default_list,
                            .width = 512,
                            .height = 512,
                            .repetitions = 15,
                            .error_samples = 4096,
                            .backend = CONTEXT_AUTO};
    char message[600];
    if (!read_options(argc, argv, &options, message, sizeof message)) {
        if (message[0] == '\0') return EXIT_SUCCESS;
    } else {
        glob_t found = {0};
        if (options.scene_count == 0) glob(EW_BENCH_SCENES "/*.json", 0, NULL, &found);
        bool ok = benchmark(&options, options.scene_count > 0 ? options.scenes : found.gl_pathv,
                            options.scene_count > 0 ? options.scene_count : found.gl_pathc, message, sizeof message);
        globfree(&found);
        if (ok) return EXIT_SUCCESS;
    }
    fprintf(stderr, "ew-bench: %s\n", message);
    return EXIT_BAD_INPUT;
}
