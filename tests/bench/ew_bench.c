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
    "Measures the speed and the error of integrators on scenes. By default, these are those that come with the benchmark: "
    "frames\n"
    "as games have them, at 1920x1080, and scenes of the papers' integral.\n"
    "\n"
    "      --size WxH          in pixels, up to 8192x8192 (default 512x512, but for the frames)\n"
    "      --integrators LIST  separated by commas: adaptive:1e-2, adaptive:1e-3, adaptive:1e-4, simpson:N (N divisions),\n"
    "                          full:E, which is adaptive:E at every pixel,\n"
    "                          marching:N, equiangular:N, half-marching:N (N samples), billboards:N, ribbon:N (N a source),\n"
    "                          bare (a pass that only writes a constant); by default all that a report compares\n"
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
    const char *integrators; /* NULL for the defaults */
    const char *csv;         /* NULL for none */
    const char *report;      /* NULL for none */
    const char *name;        /* NULL for none */
    const char *pictures;    /* NULL for none */
    int width;               /* 0 for the defaults */
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

/* Measures all sets of scenes. */
static bool measure_to_file(gl_context *context, const command_line *options, bench_results *sets, size_t set_count,
                            char *message, size_t size)
{
    FILE *csv = options->csv ? fopen(options->csv, "w") : NULL;
    if (options->csv && !(csv && table_write_csv_header(csv))) {
        message_write(message, size, "%s: cannot be written (%s); name a file in a folder that exists", options->csv,
                      strerror(errno));
        if (csv) fclose(csv);
        return false;
    }
    bool ok = true;
    for (size_t i = 0; ok && i < set_count; i++)
        ok = measure_all_scenes(context, &sets[i], csv, options->csv, message, size);
    if (csv && fclose(csv) != 0 && ok) {
        message_write(message, size, "%s: cannot be written (%s)", options->csv, strerror(errno));
        ok = false;
    }
    return ok && (!options->report || report_write(sets, set_count, options->report, options->name, message, size));
}

static bool run(const command_line *options, bench_results *sets, size_t set_count, char *message, size_t size)
{
    gl_context *context = context_create(options->backend, message, size);
    if (!context) return false;
    puts(context_description(context));
    bench_machine machine;
    bool ok = machine_describe(context, &machine, message, size);
    for (size_t i = 0; i < set_count; i++)
        sets[i].machine = machine;
    ok = ok && measure_to_file(context, options, sets, set_count, message, size);
    context_destroy(context);
    return ok;
}

/* Scenes to measure, and by which integrators unless the options name others. */
typedef struct scene_set {
    const char *title;
    bool is_frames;
    const char *pattern; /* of their files, for glob; NULL for those that the options name */
    const char *integrators;
    int width, height;
    double dark;
} scene_set;

static const scene_set own_sets[] = {
    {"Whole frames", true, EW_BENCH_FRAMES "/*.json", integrator_frame_list, 1920, 1080, TRUTH_DARK_INTERPOLATED},
    {"The papers' integral", false, EW_BENCH_SCENES "/*.json", integrator_default_list, 512, 512, TRUTH_DARK},
};
static const scene_set named_set = {"Scenes", false, NULL, integrator_default_list, 512, 512, TRUTH_DARK};

/* Fills in what is to be measured; free_set frees it. `found` keeps the names of the files. */
static bool make_set(const scene_set *set, const command_line *options, glob_t *found, bench_results *results, char *message,
                     size_t size)
{
    *results = (bench_results){.title = set->title,
                               .is_frames = set->is_frames,
                               .settings = {.width = options->width > 0 ? options->width : set->width,
                                            .height = options->height > 0 ? options->height : set->height,
                                            .repetitions = options->repetitions,
                                            .error_samples = (size_t)options->error_samples,
                                            .dark = set->dark,
                                            .pictures = options->pictures}};
    if (set->pattern) glob(set->pattern, 0, NULL, found);
    results->settings.integrators = integrator_parse_list(options->integrators ? options->integrators : set->integrators,
                                                          &results->settings.integrator_count, message, size);
    return results->settings.integrators &&
           list_scenes(set->pattern ? found->gl_pathv : options->scenes, set->pattern ? found->gl_pathc : options->scene_count,
                       results, message, size);
}

static void free_set(bench_results *results)
{
    for (size_t i = 0; i < results->scene_count; i++)
        measure_free(&results->scenes[i].measurements);
    free(results->scenes);
    free((void *)results->settings.integrators);
}

static bool benchmark(const command_line *options, char *message, size_t size)
{
    enum { OWN_SETS = sizeof own_sets / sizeof *own_sets };
    bool has_names = options->scene_count > 0;
    size_t count = has_names ? 1 : OWN_SETS;
    bench_results results[OWN_SETS] = {0};
    glob_t found[OWN_SETS] = {0};
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++)
        ok = make_set(has_names ? &named_set : &own_sets[i], options, &found[i], &results[i], message, size);
    ok = ok && run(options, results, count, message, size);
    for (size_t i = 0; i < count; i++) {
        free_set(&results[i]);
        globfree(&found[i]);
    }
    return ok;
}

int main(int argc, char **argv)
{
    command_line options = {.repetitions = 15, .error_samples = 4096, .backend = CONTEXT_AUTO};
    char message[600];
    if (!read_options(argc, argv, &options, message, sizeof message)) {
        if (message[0] == '\0') return EXIT_SUCCESS;
    } else if (benchmark(&options, message, sizeof message)) {
        return EXIT_SUCCESS;
    }
    fprintf(stderr, "ew-bench: %s\n", message);
    return EXIT_BAD_INPUT;
}
