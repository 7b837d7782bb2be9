/*
 * ew-accuracy-random: the library's luminance of thousands of random scenes against the double-precision reference, at a few
 * dozen pixels of each.
 */
#include "command_line.h"
#include "context.h"
#include "named_integrator.h"
#include "random_picture.h"
#include "random_report.h"
#include "random_scene.h"
#include "random_truth.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_WRONG = 1, EXIT_BAD_INPUT = 2, EXIT_NO_CONTEXT = 77 };
enum { MAX_SCENES = 1000000 };

static const char help[] =
    "Usage: ew-accuracy-random [option]...\n"
    "Compares the luminance that the library draws of random scenes with a reference in double precision, at 64 pixels of\n"
    "each, most of them on the sources and close around.\n"
    "\n"
    "      --scenes N         how many (default 2000)\n"
    "      --seed N           the first scene's seed (default 1); the others have those that follow. From 1000000000000 on\n"
    "                         they are of the world integral, from 2000000000000 on of the papers' in fog, and from\n"
    "                         3000000000000 on of the world integral in fog; from 4000000000000 and 5000000000000\n"
    "                         on of the two among media.\n"
    "      --kind NAME        only those of one kind, by its name in the table of results: torus or \"weighted curve\", say\n"
    "      --integrator NAME  adaptive:1e-2, adaptive:1e-3 (default), adaptive:1e-4 or simpson:N\n"
    "      --worst N          how many of the worst scenes to list (default 20)\n"
    "      --backend NAME     egl, osmesa or auto (default)\n"
    "      --write FILE       writes the first scene as a scene file, and draws nothing\n"
    "      --check            fail if a pixel is wrong by more than 1e-2, or more than 1e-3 of a kind's by more than 1e-3\n"
    "      --largest ERROR    with --check, instead of that 1e-2\n"
    "      --share SHARE      with --check, instead of 1e-3 of a kind's pixels; 0: none may be wrong by more than 1e-3\n"
    "\n"
    "Fails in any case if a pixel is negative, infinite or no number, or if the reference does not vouch for 1 % of them.\n"
    "The list of the worst says for each scene what `ew-accuracy-random --seed SEED --write scene.json` and\n"
    "`ew-accuracy scene.json --size 512x512` need: the seed and the pixel. Its last column is by how much the truth itself\n"
    "changes when the ray's ends are rounded to single precision.\n"
    "\n"
    "Exit status: 0; 1 for a failure; 2 for bad input; 77 if there is no such context.\n";

typedef struct command_line {
    int scenes;
    unsigned long long seed;
    int kind; /* -1 for all */
    named_integrator integrator;
    int worst;
    context_backend backend;
    const char *write;
    bool check;
    random_bounds bounds;
} command_line;

/* ---- The command line --------------------------------------------------------------------------------------------------- */

static bool read_scene_count(const char *text, void *target)
{
    return read_number(text, 1, MAX_SCENES, target);
}

static bool read_worst(const char *text, void *target)
{
    return read_number(text, 0, MAX_SCENES, target);
}

static bool read_seed(const char *text, void *target)
{
    char *end;
    *(unsigned long long *)target = strtoull(text, &end, 10);
    return *text >= '0' && *text <= '9' && *end == '\0';
}

static bool read_bound(const char *text, void *target)
{
    char *end;
    double *bound = target;
    *bound = strtod(text, &end);
    return end != text && *end == '\0' && *bound >= 0;
}

static bool read_kind(const char *text, void *target)
{
    int *kind = target;
    *kind = random_scene_kind_find(text);
    return *kind >= 0;
}

static bool read_named_integrator(const char *text, void *target)
{
    return named_integrator_find(text, target);
}

/* Returns false with a message, or with an empty one where the options asked for a text that has been printed. */
static bool read_options(int argc, char **argv, command_line *options, char *message, size_t size)
{
    const command_option table[] = {
        {"scenes", 0, read_scene_count, &options->scenes, "must be a number of scenes"},
        {"seed", 0, read_seed, &options->seed, "must be a number"},
        {"kind", 0, read_kind, &options->kind, "must be a kind of scene"},
        {"integrator", 0, read_named_integrator, &options->integrator,
         "must be adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 or simpson:N, N even"},
        {"worst", 0, read_worst, &options->worst, "must be a number of scenes"},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
        {"write", 0, read_text, &options->write, NULL},
        {"check", 0, NULL, &options->check, NULL},
        {"largest", 0, read_bound, &options->bounds.largest, "must be an error, not below 0"},
        {"share", 0, read_bound, &options->bounds.unusual_share, "must be a share, not below 0"},
    };
    const command_program program = {"ew-accuracy-random", help, table, sizeof table / sizeof *table};
    if (!command_line_read(&argc, argv, &program, message, size)) return false;
    if (argc == 1) return true;
    snprintf(message, size, "%s: is not an option; see ew-accuracy-random --help", argv[1]);
    return false;
}

static int write_scene(const command_line *options)
{
    char *text = random_scene_text(options->seed);
    FILE *file = text ? fopen(options->write, "w") : NULL;
    bool ok = file && fputs(text, file) >= 0;
    if (file) ok = fclose(file) == 0 && ok;
    free(text);
    if (ok) return EXIT_SUCCESS;
    fprintf(stderr, "ew-accuracy-random: %s: cannot be written\n", options->write);
    return EXIT_BAD_INPUT;
}

/* The scenes that are wanted, not drawn yet. Returns how many. */
static size_t choose_scenes(const command_line *options, random_picture *pictures)
{
    size_t count = 0;
    for (size_t i = 0; i < (size_t)options->scenes; i++) {
        int kind = random_scene_kind_of(options->seed + i);
        if (options->kind < 0 || kind == options->kind)
            pictures[count++] = (random_picture){.seed = options->seed + i, .kind = kind};
    }
    return count;
}

static bool compare_scenes(const command_line *options, gl_context *context, bool *well, char *message, size_t size)
{
    random_picture *pictures = calloc((size_t)options->scenes, sizeof *pictures);
    size_t count = pictures ? choose_scenes(options, pictures) : 0;
    bool ok = pictures && random_pictures_draw(context, &options->integrator.settings, pictures, count, message, size);
    if (!pictures || (ok && !(ok = random_truths_compute(pictures, count) &&
                                   random_report_print(pictures, count, (size_t)options->worst,
                                                       options->check ? &options->bounds : NULL, well))))
        snprintf(message, size, "memory is exhausted");
    free(pictures);
    return ok;
}

int main(int argc, char **argv)
{
    command_line options = {.scenes = 2000, .seed = 1, .kind = -1, .worst = 20, .bounds = {1e-2, 1e-3}};
    char message[600];
    named_integrator_find("adaptive:1e-3", &options.integrator);
    if (!read_options(argc, argv, &options, message, sizeof message)) {
        if (message[0] == '\0') return EXIT_SUCCESS;
        fprintf(stderr, "ew-accuracy-random: %s\n", message);
        return EXIT_BAD_INPUT;
    }
    if (options.write) return write_scene(&options);
    gl_context *context = context_create(options.backend, message, sizeof message);
    if (!context) {
        printf("SKIPPED: %s\n", message);
        return EXIT_NO_CONTEXT;
    }
    puts(context_description(context));

    bool well = false, ok = compare_scenes(&options, context, &well, message, sizeof message);
    context_destroy(context);
    if (!ok) fprintf(stderr, "ew-accuracy-random: %s\n", message);
    return !ok ? EXIT_BAD_INPUT : !well ? EXIT_WRONG : EXIT_SUCCESS;
}
