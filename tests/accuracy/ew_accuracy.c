/*
 * ew-accuracy: the library's luminance of scene files against the double-precision reference.
 */
#include "accuracy_result.h"
#include "command_line.h"
#include "comparison.h"
#include "context.h"
#include "heatmap.h"
#include "named_integrator.h"
#include "picture.h"
#include "scene_rays.h"
#include "source_kinds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_WRONG = 1, EXIT_BAD_INPUT = 2, EXIT_NO_CONTEXT = 77 };
enum { MAX_INTEGRATORS = 16 };

static const char help[] =
    "Usage: ew-accuracy SCENE.json... [option]...\n"
    "Compares the luminance that the library draws with a reference in double precision.\n"
    "\n"
    "      --integrators LIST  comma-separated: adaptive:1e-2, adaptive:1e-3 (default), adaptive:1e-4, simpson:N\n"
    "      --resolution NAME   full (default); or adaptive, whose errors are relative to 0.03 of the largest luminance where\n"
    "                          the truth is less\n"
    "      --backend NAME      egl, osmesa or auto (default)\n"
    "      --size WxH          in pixels (default 512x512)\n"
    "      --pixels N          how many pixels to compare (default: 4000, fewer for many sources)\n"
    "      --full              compare all pixels\n"
    "      --sorted            print the results at the end, those furthest beyond (or nearest to) their bounds first\n"
    "      --csv FILE          append a line for each scene and integrator; a new file gets a header\n"
    "      --heatmap FILE.png  where the errors of the last scene and integrator are\n"
    "      --check             fail unless every adaptive integrator keeps the error that it is named by (and\n"
    "                          adaptive:1e-3 a tenth of it on 99 % of the pixels), no pixel is negative, infinite or no\n"
    "                          number, the reference vouches for 99 % of the pixels, and the depth is the scene's\n"
    "\n"
    "Exit status: 0; 1 if a check failed; 2 for bad input; 77 if there is no such context.\n";

typedef struct command_line {
    named_integrator integrators[MAX_INTEGRATORS];
    size_t integrator_count;
    context_backend backend;
    ew_resolution resolution;
    int width, height;
    size_t pixels; /* 0 for all */
    bool pixels_given;
    const char *csv;
    const char *heatmap;
    bool sorted;
    bool check;
} command_line;

/* What one comparison found, for people. */
typedef struct result_line {
    double excess; /* over the bound that is exceeded most; below 1 where all are kept */
    char text[400];
} result_line;

/* What the comparisons found so far. */
typedef struct accuracy_results {
    result_line *lines; /* room for every scene and integrator */
    size_t line_count;
    bool wrong; /* a check failed */
} accuracy_results;

/* ---- The command line -----------------------------------------------------------------------------------------------------
 */

/* `target` is the command_line, here and below. */
static bool read_integrators(const char *text, void *target)
{
    command_line *options = target;
    char list[200];
    if (snprintf(list, sizeof list, "%s", text) >= (int)sizeof list) return false;
    options->integrator_count = 0;
    for (char *name = strtok(list, ","); name; name = strtok(NULL, ","))
        if (options->integrator_count == MAX_INTEGRATORS ||
            !named_integrator_find(name, &options->integrators[options->integrator_count++]))
            return false;
    return options->integrator_count > 0;
}

static bool read_picture_size(const char *text, void *target)
{
    command_line *options = target;
    return read_size(text, &options->width, &options->height);
}

static bool read_pixels(const char *text, void *target)
{
    command_line *options = target;
    char *end;
    options->pixels = strtoul(text, &end, 10);
    options->pixels_given = true;
    return *end == '\0' && options->pixels > 0;
}

/* Returns false with a message, or with an empty one where the options asked for a text that has been printed. */
static bool read_options(int *argc, char **argv, command_line *options, char *message, size_t size)
{
    bool full = false;
    const command_option table[] = {
        {"integrators", 0, read_integrators, options, "must be of adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 and simpson:N"},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
        {"resolution", 0, read_resolution, &options->resolution, RESOLUTION_REMEDY},
        {"size", 0, read_picture_size, options, SIZE_REMEDY},
        {"pixels", 0, read_pixels, options, "must be a number of pixels"},
        {"full", 0, NULL, &full, NULL},
        {"sorted", 0, NULL, &options->sorted, NULL},
        {"csv", 0, read_text, &options->csv, NULL},
        {"heatmap", 0, read_text, &options->heatmap, NULL},
        {"check", 0, NULL, &options->check, NULL},
    };
    const command_program program = {"ew-accuracy", help, table, sizeof table / sizeof *table};
    if (!command_line_read(argc, argv, &program, message, size)) return false;
    if (full) {
        options->pixels = 0;
        options->pixels_given = true;
    }
    if (*argc > 1) return true;
    snprintf(message, size, "SCENE.json: is missing; name a scene file");
    return false;
}

/* ---- Scenes ---------------------------------------------------------------------------------------------------------------
 */

/* As many as take the reference about a second. A path is a source for each of its pieces and joints. */
static size_t default_pixels(const demo_scene *scene)
{
    size_t sources = source_count_of_all_kinds(&scene->sources);
    for (size_t i = 0; i < scene->sources.path_count; i++)
        sources += 2 * scene->sources.paths[i].point_count;
    size_t pixels = 40000 / (sources + 1);
    return pixels > 4000 ? 4000 : pixels < 400 ? 400 : pixels;
}

static bool report(const command_line *options, const accuracy_result *result, accuracy_results *results, char *message,
                   size_t size)
{
    double excess = accuracy_excess(result);
    bool is_bounded = result->comparison.bad_count || isfinite(result->integrator->largest_error);
    bool wrong = options->check && excess > 1 && is_bounded;
    result_line *line = &results->lines[results->line_count++];
    line->excess = excess;
    accuracy_describe(result, line->text, sizeof line->text);
    if (wrong) strncat(line->text, "  WRONG", sizeof line->text - strlen(line->text) - 1);
    if (!options->sorted) puts(line->text);
    results->wrong = results->wrong || wrong;
    if (!options->csv || accuracy_append_csv(result, options->csv)) return true;
    snprintf(message, size, "%s: cannot be written", options->csv);
    return false;
}

static int compare_lines(const void *a, const void *b)
{
    const result_line *first = a, *second = b;
    return (first->excess < second->excess) - (first->excess > second->excess);
}

/* A scene that is being compared, and its picture by each of the integrators; a single one has another one beside it. */
typedef struct compared_scene {
    const char *path;
    demo_scene scene;
    scene_rays rays;
    drawn_picture pictures[MAX_INTEGRATORS];
    size_t picture_count;
} compared_scene;

static bool draw_pictures(const command_line *options, gl_context *context, compared_scene *compared, char *message,
                          size_t size)
{
    size_t count = options->integrator_count > 1 ? options->integrator_count : 2;
    while (compared->picture_count < count) {
        char reason[300];
        named_integrator integrator = options->integrators[compared->picture_count % options->integrator_count];
        bool is_beside = compared->picture_count == options->integrator_count;
        integrator.settings.resolution = is_beside ? EW_RESOLUTION_FULL : options->resolution;
        if (is_beside && options->resolution == EW_RESOLUTION_FULL)
            named_integrator_find(strcmp(integrator.name, "adaptive:1e-4") == 0 ? "adaptive:1e-3" : "adaptive:1e-4",
                                  &integrator);
        integrator.settings.width = options->width;
        integrator.settings.height = options->height;
        if (!picture_draw(context, &compared->scene, &integrator.settings, &compared->pictures[compared->picture_count], reason,
                          sizeof reason)) {
            snprintf(message, size, "%s: %s", compared->path, reason);
            return false;
        }
        compared->picture_count++;
    }
    return true;
}

/* Compares the picture by one of the integrators. */
static bool compare_picture(const command_line *options, const char *renderer, const compared_scene *compared, size_t index,
                            true_pixels *truth, accuracy_results *results, char *message, size_t size)
{
    /* Where two integrators disagree, one of them is wrong. */
    const drawn_picture *picture = &compared->pictures[index];
    const drawn_picture *other = &compared->pictures[(index + 1) % compared->picture_count];
    int threads = (int)sysconf(_SC_NPROCESSORS_ONLN);
    accuracy_result result = {
        .path = compared->path,
        .renderer = renderer,
        .integrator = &options->integrators[index],
        .picture = picture,
        .truth = truth,
    };
    if (!true_pixels_refine(&compared->rays, picture, other, threads, truth) ||
        !comparison_make(truth, picture, &result.comparison)) {
        snprintf(message, size, "%s: memory is exhausted", compared->path);
        return false;
    }
    return report(options, &result, results, message, size) &&
           (!options->heatmap || heatmap_write(options->heatmap, truth, picture, message, size));
}

static bool compare_pictures(const command_line *options, const char *renderer, const compared_scene *compared,
                             accuracy_results *results, char *message, size_t size)
{
    const drawn_picture *pictures = compared->pictures;
    int threads = (int)sysconf(_SC_NPROCESSORS_ONLN);
    size_t pixels = options->pixels_given ? options->pixels : default_pixels(&compared->scene);
    true_pixels truth;
    if (!true_pixels_compute(&compared->rays, &pictures[0], pixels, threads, &truth)) {
        snprintf(message, size, "%s: memory is exhausted", compared->path);
        return false;
    }
    if (options->resolution == EW_RESOLUTION_ADAPTIVE) truth.dark = TRUTH_DARK_INTERPOLATED;
    size_t misses = compared->scene.opaque_count ? depth_misses(&compared->rays, &truth, &pictures[0]) : 0;
    if (misses) printf("%s: the depth of %zu pixels is not the scene's\n", compared->path, misses);
    bool ok = true;
    for (size_t i = 0; ok && i < options->integrator_count; i++)
        ok = compare_picture(options, renderer, compared, i, &truth, results, message, size);
    if (truth.unreliable_count)
        printf("%s: the reference does not vouch for %zu of %zu pixels\n", compared->path, truth.unreliable_count, truth.count);
    if (options->check && (misses || truth.unreliable_count * 100 > truth.count)) results->wrong = true;
    true_pixels_free(&truth);
    return ok;
}

/* Compares one scene. On failure returns false, with a message. */
static bool compare_scene(const command_line *options, gl_context *context, const char *path, accuracy_results *results,
                          char *message, size_t size)
{
    compared_scene compared = {.path = path};
    if (!scene_load(path, &compared.scene, message, size)) return false;
    bool ok = scene_rays_create(&compared.scene, options->width, options->height, &compared.rays);
    if (!ok) {
        snprintf(message, size, "%s: memory is exhausted", path);
    } else {
        ok = draw_pictures(options, context, &compared, message, size) &&
             compare_pictures(options, context_description(context), &compared, results, message, size);
        for (size_t i = 0; i < compared.picture_count; i++)
            picture_free(&compared.pictures[i]);
        scene_rays_free(&compared.rays);
    }
    scene_free(&compared.scene);
    return ok;
}

int main(int argc, char **argv)
{
    command_line options = {.integrator_count = 1, .width = 512, .height = 512};
    char message[600];
    named_integrator_find("adaptive:1e-3", &options.integrators[0]);
    if (!read_options(&argc, argv, &options, message, sizeof message)) {
        if (message[0] == '\0') return EXIT_SUCCESS;
        fprintf(stderr, "ew-accuracy: %s\n", message);
        return EXIT_BAD_INPUT;
    }
    gl_context *context = context_create(options.backend, message, sizeof message);
    if (!context) {
        printf("SKIPPED: %s\n", message);
        return EXIT_NO_CONTEXT;
    }
    puts(context_description(context));
    accuracy_results results = {.lines = malloc((size_t)(argc - 1) * options.integrator_count * sizeof *results.lines)};
    bool bad_input = !results.lines;
    if (bad_input) fprintf(stderr, "ew-accuracy: memory is exhausted\n");
    for (int i = 1; results.lines && i < argc; i++)
        if (!compare_scene(&options, context, argv[i], &results, message, sizeof message)) {
            fprintf(stderr, "ew-accuracy: %s\n", message);
            bad_input = true;
        }
    qsort(results.lines, results.line_count, sizeof *results.lines, compare_lines);
    for (size_t i = 0; options.sorted && i < results.line_count; i++)
        puts(results.lines[i].text);
    free(results.lines);
    context_destroy(context);
    return bad_input ? EXIT_BAD_INPUT : results.wrong ? EXIT_WRONG : EXIT_SUCCESS;
}
