/*
 * ew-accuracy-random: the library's luminance of thousands of random scenes against the double-precision reference, at a few
 * dozen pixels of each.
 */
#include "command_line.h"
#include "context.h"
#include "core_pixels.h"
#include "field_drawer.h"
#include "named_integrator.h"
#include "random_numbers.h"
#include "random_scene.h"
#include "reference.h"
#include "scene_file.h"
#include "scene_rays.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { EXIT_WRONG = 1, EXIT_BAD_INPUT = 2, EXIT_NO_CONTEXT = 77 };
enum { MAX_THREADS = 64, MAX_SCENES = 1000000 };

/* Of a picture of SIDE x SIDE pixels, a few square windows are drawn: one anywhere, two on the sources, and one where a preview
 * of the whole picture is brightest, since errors are relative to that. */
enum { SIDE = 512, PREVIEW = 16, WINDOW = 4, WINDOW_COUNT = 4, PIXEL_COUNT = WINDOW_COUNT * WINDOW * WINDOW };

/* The bounds: of every pixel, and of 99.9 % of them. */
#define LARGEST_ERROR 1e-2
#define USUAL_ERROR 1e-3
#define UNUSUAL_SHARE 1e-3

/* Errors are relative to the truth or, where it is darker, to this share of the largest truth of the scene. */
#define DARK 1e-3

static const char help[] =
    "Usage: ew-accuracy-random [option]...\n"
    "Compares the luminance that the library draws of random scenes with a reference in double precision, at 64 pixels of\n"
    "each, most of them on the sources and close around.\n"
    "\n"
    "      --scenes N         how many (default 2000)\n"
    "      --seed N           the first scene's seed (default 1); the others have those that follow\n"
    "      --kind NAME        only those of them that are of this kind: point, line, torus, curve, \"weighted curve\",\n"
    "                         \"two curves\", mix or many\n"
    "      --integrator NAME  adaptive:1e-2, adaptive:1e-3 (default), adaptive:1e-4 or simpson:N\n"
    "      --worst N          how many of the worst scenes to list (default 20)\n"
    "      --backend NAME     egl, osmesa or auto (default)\n"
    "      --write FILE       writes the first scene as a scene file, and draws nothing\n"
    "      --check            fail if a pixel is wrong by more than 1e-2, or more than 0.1 % of a kind's by more than 1e-3\n"
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
} command_line;

/* A pixel that was drawn, and later the truth. */
typedef struct random_pixel {
    int x, y;
    float depth; /* as stored */
    float luminance;
    bool reliable;
    double truth;
    double error;
} random_pixel;

typedef struct random_picture {
    uint64_t seed;
    random_scene_kind kind;
    random_pixel pixels[PIXEL_COUNT];
    const random_pixel *worst;
    double sensitivity; /* of the worst pixel's truth */
} random_picture;

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

typedef struct window_stage {
    render_settings settings; /* of the whole picture */
    field_drawer window, preview;
} window_stage;

typedef struct window_scene {
    demo_scene scene;
    scene_rays rays;
} window_scene;

static bool load_scene(uint64_t seed, window_scene *scene, char *message, size_t size)
{
    char name[40];
    char *text = random_scene_text(seed);
    snprintf(name, sizeof name, "random scene %llu", (unsigned long long)seed);
    if (!text) {
        snprintf(message, size, "%s: memory is exhausted", name);
        return false;
    }
    bool ok = scene_parse(text, strlen(text), name, &scene->scene, message, size);
    free(text);
    if (ok && !scene_rays_create(&scene->scene, SIDE, SIDE, &scene->rays)) {
        scene_free(&scene->scene);
        snprintf(message, size, "%s: memory is exhausted", name);
        ok = false;
    }
    return ok;
}

static void free_scene(window_scene *scene)
{
    scene_rays_free(&scene->rays);
    scene_free(&scene->scene);
}

/* A window's lower left corner, for a pixel in its middle. */
static void window_around(int x, int y, int corner[2])
{
    const int middle[2] = {x, y};
    for (int i = 0; i < 2; i++) {
        corner[i] = middle[i] - WINDOW / 2;
        if (corner[i] < 0) corner[i] = 0;
        if (corner[i] > SIDE - WINDOW) corner[i] = SIDE - WINDOW;
    }
}

/* Draws the luminance of a part of a picture of `side` x `side` pixels: of as many from `corner` on as the drawer has. */
static bool draw_part(window_stage *stage, field_drawer *drawer, const window_scene *scene, int side, const int corner[2],
                      float *depth, float *luminance, ew_error *error)
{
    for (int i = 0; i < drawer->width * drawer->height; i++) {
        double scale = (double)SIDE / side, x = corner[0] + i % drawer->width + 0.5, y = corner[1] + i / drawer->width + 0.5;
        depth[i] = scene_rays_depth_to_store(&scene->rays, scene_rays_cast(&scene->rays, scale * x, scale * y));
    }
    render_settings settings = stage->settings;
    settings.width = settings.height = side;
    ew_frame_desc frame = render_frame(&scene->scene, &settings, &drawer->target);
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.viewport_x = -corner[0];
    frame.viewport_y = -corner[1];
    return field_drawer_draw(drawer, &scene->scene.sources, &frame, depth, luminance, error);
}

/* The window where the preview is brightest; what is no number is no light. */
static bool find_brightest(window_stage *stage, const window_scene *scene, int corner[2], ew_error *error)
{
    float depth[PREVIEW * PREVIEW], luminance[PREVIEW * PREVIEW];
    if (!draw_part(stage, &stage->preview, scene, PREVIEW, (const int[2]){0, 0}, depth, luminance, error)) return false;
    int brightest = 0;
    for (int i = 0; i < PREVIEW * PREVIEW; i++)
        if (luminance[i] > luminance[brightest] && isfinite(luminance[i])) brightest = i;
    window_around((2 * (brightest % PREVIEW) + 1) * SIDE / (2 * PREVIEW),
                  (2 * (brightest / PREVIEW) + 1) * SIDE / (2 * PREVIEW), corner);
    return true;
}

static bool draw_windows(window_stage *stage, const window_scene *scene, random_picture *picture, ew_error *error)
{
    uint64_t random = ~picture->seed;
    int corners[WINDOW_COUNT][2];
    for (int window = 0; window < WINDOW_COUNT; window++) {
        int x = (int)random_index(&random, SIDE), y = (int)random_index(&random, SIDE);
        for (int attempt = 0; window > 0 && attempt < 20; attempt++)
            if (random_core_pixel(&scene->rays, &random, &x, &y)) break;
        window_around(x, y, corners[window]);
    }
    if (!find_brightest(stage, scene, corners[WINDOW_COUNT - 1], error)) return false;
    for (int window = 0; window < WINDOW_COUNT; window++) {
        float depth[WINDOW * WINDOW], luminance[WINDOW * WINDOW];
        if (!draw_part(stage, &stage->window, scene, SIDE, corners[window], depth, luminance, error)) return false;
        for (int i = 0; i < WINDOW * WINDOW; i++)
            picture->pixels[window * WINDOW * WINDOW + i] = (random_pixel){
                .x = corners[window][0] + i % WINDOW,
                .y = corners[window][1] + i / WINDOW,
                .depth = depth[i],
                .luminance = luminance[i],
            };
    }
    return true;
}

static bool draw_picture(window_stage *stage, random_picture *picture, char *message, size_t size)
{
    window_scene scene;
    ew_error error;
    if (!load_scene(picture->seed, &scene, message, size)) return false;
    bool ok = draw_windows(stage, &scene, picture, &error);
    if (!ok) snprintf(message, size, "random scene %llu: %s", (unsigned long long)picture->seed, error.text);
    free_scene(&scene);
    return ok;
}

static bool draw_all(window_stage *stage, gl_context *context, ew_effect *effect, random_picture *pictures, size_t count,
                     char *message, size_t size)
{
    if (!field_drawer_create(context, effect, WINDOW, WINDOW, &stage->window, message, size)) return false;
    bool ok = field_drawer_create(context, effect, PREVIEW, PREVIEW, &stage->preview, message, size);
    if (ok) {
        for (size_t i = 0; ok && i < count; i++)
            ok = draw_picture(stage, &pictures[i], message, size);
        field_drawer_destroy(&stage->preview);
    }
    field_drawer_destroy(&stage->window);
    return ok;
}

static bool draw_pictures(gl_context *context, const render_settings *settings, random_picture *pictures, size_t count,
                          char *message, size_t size)
{
    window_stage stage = {.settings = *settings};
    ew_effect *effect;
    ew_error error;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    if (ew_create_effect(&desc, &effect, &error)) {
        snprintf(message, size, "%s", error.text);
        return false;
    }
    bool ok = draw_all(&stage, context, effect, pictures, count, message, size);
    ew_destroy_effect(effect);
    return ok;
}

/* ---- The truth ---------------------------------------------------------------------------------------------------------- */

typedef struct truth_job {
    random_picture *pictures;
    size_t count;
    atomic_size_t next;
    atomic_bool failed;
} truth_job;

static void round_to_float(double place[3])
{
    for (int i = 0; i < 3; i++)
        place[i] = (double)(float)place[i];
}

static double luminance_error(const random_pixel *pixel, double floor)
{
    double difference = fabs((double)pixel->luminance - pixel->truth);
    if (!isfinite(pixel->luminance) || pixel->luminance < 0) return HUGE_VAL;
    return difference == 0 ? 0 : difference / fmax(pixel->truth, floor);
}

static void compute_truth(reference_workspace *workspace, const scene_rays *rays, random_picture *picture)
{
    double largest = 0;
    reference_value sum;
    for (int i = 0; i < PIXEL_COUNT; i++) {
        random_pixel *pixel = &picture->pixels[i];
        double opaque_depth = scene_rays_stored_depth(rays, (double)pixel->depth);
        reference_ray ray = scene_rays_ray(rays, pixel->x + 0.5, pixel->y + 0.5, opaque_depth);
        pixel->reliable = reference_luminance(workspace, &rays->sources, &ray, &sum, NULL);
        pixel->truth = sum.luminance;
        largest = fmax(largest, pixel->truth);
    }
    picture->worst = &picture->pixels[0];
    for (int i = 0; i < PIXEL_COUNT; i++) {
        random_pixel *pixel = &picture->pixels[i];
        pixel->error = luminance_error(pixel, DARK * largest);
        if (!pixel->reliable && isfinite(pixel->error)) pixel->error = 0;
        if (pixel->error > picture->worst->error) picture->worst = pixel;
    }
    const random_pixel *worst = picture->worst;
    reference_ray ray =
        scene_rays_ray(rays, worst->x + 0.5, worst->y + 0.5, scene_rays_stored_depth(rays, (double)worst->depth));
    round_to_float(ray.start);
    round_to_float(ray.end);
    reference_luminance(workspace, &rays->sources, &ray, &sum, NULL);
    picture->sensitivity =
        sum.luminance == worst->truth ? 0 : fabs(sum.luminance - worst->truth) / fmax(worst->truth, DARK * largest);
}

static void *compute_truths(void *user)
{
    truth_job *job = user;
    reference_workspace *workspace = reference_create_workspace();
    for (size_t i; workspace && (i = atomic_fetch_add(&job->next, 1)) < job->count;) {
        window_scene scene;
        char message[300];
        if (!load_scene(job->pictures[i].seed, &scene, message, sizeof message)) {
            atomic_store(&job->failed, true);
            break;
        }
        compute_truth(workspace, &scene.rays, &job->pictures[i]);
        free_scene(&scene);
    }
    if (!workspace) atomic_store(&job->failed, true);
    reference_destroy_workspace(workspace);
    return NULL;
}

/* On as many threads as there are processors. Returns false where memory is exhausted. */
static bool compute_all_truths(random_picture *pictures, size_t count)
{
    truth_job job = {.pictures = pictures, .count = count};
    pthread_t threads[MAX_THREADS];
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    int started = 0;
    while (started < processors - 1 && started < MAX_THREADS &&
           pthread_create(&threads[started], NULL, compute_truths, &job) == 0)
        started++;
    compute_truths(&job);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
    return !atomic_load(&job.failed);
}

/* ---- The report --------------------------------------------------------------------------------------------------------- */

typedef struct error_counts {
    size_t scenes, pixels, unreliable, bad, unusual, wrong;
    double largest;
} error_counts;

static void count_errors(const random_picture *picture, error_counts *counts)
{
    counts->scenes++;
    for (int i = 0; i < PIXEL_COUNT; i++) {
        const random_pixel *pixel = &picture->pixels[i];
        counts->pixels++;
        counts->unreliable += !pixel->reliable;
        counts->bad += !isfinite(pixel->error);
        counts->unusual += pixel->error > USUAL_ERROR;
        counts->wrong += pixel->error > LARGEST_ERROR;
        counts->largest = fmax(counts->largest, pixel->error);
    }
}

static void print_counts(const char *name, const error_counts *counts)
{
    if (counts->scenes > 0)
        printf("%-15s %6zu %8zu %10.2e %8zu %7.3f %% %8zu %6zu %10zu\n", name, counts->scenes, counts->pixels, counts->largest,
               counts->unusual, 100.0 * (double)counts->unusual / (double)counts->pixels, counts->wrong, counts->bad,
               counts->unreliable);
}

/* Prints what was found, of pictures that are sorted; returns whether all is well; the bounds count if `check`. */
static bool report(const random_picture *const *pictures, size_t count, size_t worst, bool check)
{
    error_counts all = {0}, kinds[RANDOM_SCENE_KIND_COUNT] = {{0}};
    for (size_t i = 0; i < count; i++) {
        count_errors(pictures[i], &all);
        count_errors(pictures[i], &kinds[pictures[i]->kind]);
    }
    printf("%-15s %6s %8s %10s %8s %9s %8s %6s %10s\n", "kind", "scenes", "pixels", "largest", "> 1e-3", "", "> 1e-2", "bad",
           "unreliable");
    for (int kind = 0; kind < RANDOM_SCENE_KIND_COUNT; kind++)
        print_counts(random_scene_kind_names[kind], &kinds[kind]);
    print_counts("all", &all);
    if (worst > 0)
        printf("\n%-10s %-15s %-10s %10s %13s %13s %11s\n", "seed", "kind", "pixel", "error", "luminance", "truth",
               "rounded ray");
    for (size_t i = 0; i < count && i < worst; i++) {
        const random_pixel *pixel = pictures[i]->worst;
        char place[24];
        snprintf(place, sizeof place, "%d,%d", pixel->x, pixel->y);
        printf("%-10llu %-15s %-10s %10.2e %13.6g %13.6g %11.1e\n", (unsigned long long)pictures[i]->seed,
               random_scene_kind_names[pictures[i]->kind], place, pixel->error, (double)pixel->luminance, pixel->truth,
               pictures[i]->sensitivity);
    }
    bool bounded = true;
    for (int kind = 0; kind < RANDOM_SCENE_KIND_COUNT; kind++)
        bounded =
            bounded && kinds[kind].wrong == 0 && (double)kinds[kind].unusual <= UNUSUAL_SHARE * (double)kinds[kind].pixels;
    return all.bad == 0 && all.unreliable * 100 <= all.pixels && (bounded || !check);
}

static int compare_pictures(const void *a, const void *b)
{
    const random_picture *first = *(const random_picture *const *)a, *second = *(const random_picture *const *)b;
    double first_error = first->worst->error, second_error = second->worst->error;
    if (first_error != second_error) return first_error < second_error ? 1 : -1;
    return (first->seed > second->seed) - (first->seed < second->seed);
}

static bool report_worst_first(const random_picture *pictures, size_t count, size_t worst, bool check, bool *well)
{
    const random_picture **order = malloc((count + 1) * sizeof *order);
    if (!order) return false;
    for (size_t i = 0; i < count; i++)
        order[i] = &pictures[i];
    qsort(order, count, sizeof *order, compare_pictures);
    *well = report(order, count, worst, check);
    free(order);
    return true;
}

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

static bool read_kind(const char *text, void *target)
{
    int *kind = target;
    for (*kind = 0; *kind < RANDOM_SCENE_KIND_COUNT; ++*kind)
        if (strcmp(random_scene_kind_names[*kind], text) == 0) return true;
    return false;
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
    };
    const command_program program = {"ew-accuracy-random", help, table, sizeof table / sizeof *table};
    if (!command_line_read(argc, argv, &program, message, size)) return false;
    if (optind == argc) return true;
    snprintf(message, size, "%s: is not an option; see ew-accuracy-random --help", argv[optind]);
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

int main(int argc, char **argv)
{
    command_line options = {.scenes = 2000, .seed = 1, .kind = -1, .worst = 20};
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

    random_picture *pictures = calloc((size_t)options.scenes, sizeof *pictures);
    snprintf(message, sizeof message, "memory is exhausted");
    bool ok = pictures, well = false;
    size_t count = 0;
    for (size_t i = 0; ok && i < (size_t)options.scenes; i++) {
        random_scene_kind kind = random_scene_kind_of(options.seed + i);
        if (options.kind < 0 || (int)kind == options.kind)
            pictures[count++] = (random_picture){.seed = options.seed + i, .kind = kind};
    }
    ok = ok && draw_pictures(context, &options.integrator.settings, pictures, count, message, sizeof message);
    if (ok) {
        snprintf(message, sizeof message, "memory is exhausted");
        ok = compute_all_truths(pictures, count) &&
             report_worst_first(pictures, count, (size_t)options.worst, options.check, &well);
    }
    free(pictures);
    context_destroy(context);
    if (!ok) fprintf(stderr, "ew-accuracy-random: %s\n", message);
    return !ok ? EXIT_BAD_INPUT : !well ? EXIT_WRONG : EXIT_SUCCESS;
}
