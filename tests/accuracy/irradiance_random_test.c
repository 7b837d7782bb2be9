/*
 * The light on surfaces in random scenes of the world integral, against its definition:
 *
 *     irradiance_random_test SCENES [SEED]
 *
 * Of every scene 64 surfaces are lit, most of them next to the sources: at all distances from within the core to beyond the
 * light's reach, on the source itself, edge-on to it, facing it, turned away from it, and any other way. Errors are relative to
 * the scene's brightest surface. SEED is the first scene's (see random_scene.h).
 *
 * Exit status: 0; 1 if more than one scene in 500 has an error of more than 1e-2, or any of more than 2e-2; 2 for bad input; 77
 * if there is no context.
 */
#include "core_pixels.h"
#include "effect_context.h"
#include "message.h"
#include "random_numbers.h"
#include "random_scene.h"
#include "reference_threads.h"
#include "render.h"
#include "scene_file.h"
#include "surface_drawer.h"
#include "vector.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Of the picture's largest. */
#define USUAL_ERROR 1e-2
#define LARGEST_ERROR 2e-2

/* Relative to the distance of what is farthest: a few units in the last place of single precision. */
#define ROUNDING 5e-7

enum { MAX_SCENES = 1000000, WORST_LISTED = 10 };

/* A scene's surfaces, and their light as it was drawn. */
typedef struct lit_scene {
    uint64_t seed;
    int kind;
    bool is_drawn;
    double light_reach;
    double distance;                                  /* from the eye to what is farthest */
    reference_surface surfaces[SURFACE_DRAWER_COUNT]; /* relative to the eye */
    float light[SURFACE_DRAWER_COUNT][4];
    double error;
    int worst;        /* surface */
    double is, truth; /* of the worst */
    int sensitive;    /* surfaces that would be off, if rounding their places did not explain it */
} lit_scene;

static bool load(uint64_t seed, demo_scene *scene, scene_rays *rays, char *message, size_t size)
{
    char *text = random_scene_text(seed);
    bool ok = text && scene_parse(text, strlen(text), "random scene", scene, message, size);
    if (!text) message_write(message, size, "memory is exhausted");
    free(text);
    if (!ok || scene_rays_create(scene, 1, 1, rays)) return ok;
    scene_free(scene);
    message_write(message, size, "memory is exhausted");
    return false;
}

/* ---- Surfaces ----------------------------------------------------------------------------------------------------------- */

static void random_unit_vector(uint64_t *random, double result[3])
{
    do {
        for (int i = 0; i < 3; i++)
            result[i] = random_between(random, -1, 1);
    } while (vector_dot(result, result) > 1 || !vector_normalize(result, result));
}

/* Turned any way, towards or away from what is in the direction `to_source`, or edge-on to it. */
static void random_normal(uint64_t *random, const double to_source[3], double normal[3])
{
    double choice = random_unit(random), along = choice < 0.15 ? 1 : choice < 0.25 ? -1 : 0;
    random_unit_vector(random, normal);
    if (choice > 0.4) return;
    if (along == 0) along = -vector_dot(normal, to_source);
    if (fabs(along) == 1) normal[0] = normal[1] = normal[2] = 0;
    vector_add_scaled(normal, along, to_source, normal);
    vector_normalize(normal, normal);
}

static void place_surfaces(const scene_rays *rays, uint64_t *random, lit_scene *lit)
{
    for (int i = 0; i < SURFACE_DRAWER_COUNT; i++) {
        reference_surface *surface = &lit->surfaces[i];
        double place[3], away[3], to_source[3], core = 0;
        random_source_place(rays, random, place, &core);
        random_unit_vector(random, away);
        /* Thinner cores than single precision can tell are not looked into. */
        double told = 10 * ROUNDING * vector_length(place);
        double least = fmax(0.1 * core, told), most = fmax(2 * lit->light_reach, 2 * least);
        bool is_on_source = random_chance(random, 0.1) && core > told;
        double distance = is_on_source ? 0 : least * pow(most / least, random_unit(random));
        vector_add_scaled(place, distance, away, surface->position);
        for (int k = 0; k < 3; k++) {
            to_source[k] = -away[k];
            surface->position[k] = (double)(float)surface->position[k]; /* as the shader gets it */
        }
        lit->distance = fmax(lit->distance, fmax(vector_length(place), vector_length(surface->position)));
        random_normal(random, to_source, surface->normal);
    }
}

/* Light that ends within two cores of a source is next to none, in a narrow ring. */
static double random_light_reach(const scene_rays *rays, uint64_t *random)
{
    double middle, length, place[3], core, largest = 0;
    scene_rays_depth_range(rays, &middle, &length);
    for (int i = 0; i < 100; i++) {
        random_source_place(rays, random, place, &core);
        largest = fmax(largest, core);
    }
    return fmax(2 * largest, middle * 3e-3 * pow(3000, random_unit(random)));
}

/* ---- Light -------------------------------------------------------------------------------------------------------------- */

static bool draw_scene(surface_drawer *drawer, lit_scene *lit, char *message, size_t size)
{
    uint64_t random = ~lit->seed;
    demo_scene scene;
    scene_rays rays;
    bool has_room;
    if (!load(lit->seed, &scene, &rays, message, size)) return false;
    lit->light_reach = random_light_reach(&rays, &random);
    place_surfaces(&rays, &random, lit);
    const render_settings settings = {.width = 512, .height = 512};
    const render_target none = {0};
    ew_frame_desc frame = render_frame(&scene, &settings, &none);
    frame.light_reach = lit->light_reach;
    frame.light_gain = 1;
    lit->is_drawn = surface_drawer_draw(drawer, &scene.sources, &frame, lit->surfaces, lit->light, &has_room, message, size);
    scene_rays_free(&rays);
    scene_free(&scene);
    return lit->is_drawn || !has_room;
}

static double largest_of(const double color[3])
{
    return fmax(color[0], fmax(color[1], color[2]));
}

/* How much the truth itself changes when the surface is moved by what single precision leaves of places that far from the eye.
 */
static double sensitivity_of(const ew_sources_desc *sources, const lit_scene *lit, const reference_surface *surface,
                             const double truth[3])
{
    double most = 0;
    for (int i = 0; i < 24; i++) {
        reference_surface moved = *surface;
        const double along[4][3] = {
            {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {surface->normal[0], surface->normal[1], surface->normal[2]}};
        double other[3];
        double way = ROUNDING * lit->distance * pow(0.3, i / 8) * (i % 8 < 4 ? 1 : -1);
        vector_add_scaled(surface->position, way, along[i % 4], moved.position);
        reference_irradiance(sources, lit->light_reach, &moved, NULL, other);
        for (int k = 0; k < 3; k++)
            most = fmax(most, fabs(other[k] - truth[k]));
    }
    return most;
}

static double largest_difference(const float light[4], const double truth[3])
{
    double off[3];
    for (int k = 0; k < 3; k++)
        off[k] = isfinite(light[k]) ? fabs((double)light[k] - truth[k]) : HUGE_VAL;
    return largest_of(off);
}

static void compare(const ew_sources_desc *sources, lit_scene *lit)
{
    double truths[SURFACE_DRAWER_COUNT][3], brightest = 0;
    for (int i = 0; i < SURFACE_DRAWER_COUNT; i++) {
        reference_irradiance(sources, lit->light_reach, &lit->surfaces[i], NULL, truths[i]);
        brightest = fmax(brightest, largest_of(truths[i]));
    }
    for (int i = 0; i < SURFACE_DRAWER_COUNT; i++) {
        double off = largest_difference(lit->light[i], truths[i]);
        if (off > USUAL_ERROR * brightest) {
            lit->sensitive++;
            off = fmax(0, off - sensitivity_of(sources, lit, &lit->surfaces[i], truths[i]));
        }
        double error = off == 0 ? 0 : off / brightest;
        if (error <= lit->error) continue;
        lit->error = error;
        lit->worst = i;
    }
    lit->is = largest_of((const double[]){(double)lit->light[lit->worst][0], (double)lit->light[lit->worst][1],
                                          (double)lit->light[lit->worst][2]});
    lit->truth = largest_of(truths[lit->worst]);
}

static bool compare_scene(void *user, reference_workspace *workspace, size_t index)
{
    lit_scene *lit = (lit_scene *)user + index;
    char message[300];
    demo_scene scene;
    scene_rays rays;
    (void)workspace;
    if (!lit->is_drawn) return true;
    if (!load(lit->seed, &scene, &rays, message, sizeof message)) return false;
    compare(&rays.sources, lit);
    scene_rays_free(&rays);
    scene_free(&scene);
    return true;
}

/* ---- The report --------------------------------------------------------------------------------------------------------- */

static int by_error(const void *a, const void *b)
{
    double first = ((const lit_scene *)a)->error, second = ((const lit_scene *)b)->error;
    return (first < second) - (first > second);
}

/* Returns whether all is well. */
static bool report(lit_scene *scenes, size_t count)
{
    size_t drawn = 0, unusual = 0;
    printf("%-22s %7s %7s %9s %9s\n", "kind", "scenes", "> 1e-2", "largest", "sensitive");
    for (int kind = 0; kind < RANDOM_SCENE_KIND_COUNT; kind++) {
        size_t of_kind = 0, beyond = 0, sensitive = 0;
        double largest = 0;
        for (size_t i = 0; i < count; i++) {
            if (scenes[i].kind != kind || !scenes[i].is_drawn) continue;
            of_kind++;
            beyond += scenes[i].error > USUAL_ERROR;
            sensitive += (size_t)scenes[i].sensitive;
            largest = fmax(largest, scenes[i].error);
        }
        drawn += of_kind;
        unusual += beyond;
        if (of_kind > 0)
            printf("%-22s %7zu %7zu %9.2g %9zu\n", random_scene_kind_name(kind), of_kind, beyond, largest, sensitive);
    }
    qsort(scenes, count, sizeof *scenes, by_error);
    for (size_t i = 0; i < count && i < WORST_LISTED; i++) {
        const lit_scene *lit = &scenes[i];
        printf("%llu, a %s: surface %d off by %.2g of the largest; %g instead of %g\n", (unsigned long long)lit->seed,
               random_scene_kind_name(lit->kind), lit->worst, lit->error, lit->is, lit->truth);
    }
    printf("%zu scenes have more sources than a uniform block takes\n", count - drawn);
    return scenes[0].error <= LARGEST_ERROR && unusual * 500 <= count && drawn >= count - count / 50;
}

static bool run(surface_drawer *drawer, lit_scene *scenes, size_t count, uint64_t seed, char *message, size_t size)
{
    for (size_t i = 0; i < count; i++) {
        scenes[i] = (lit_scene){.seed = seed + i, .kind = random_scene_kind_of(seed + i)};
        if (draw_scene(drawer, &scenes[i], message, size)) continue;
        fprintf(stderr, "random scene %llu: ", (unsigned long long)(seed + i));
        return false;
    }
    if (reference_threads_run(compare_scene, scenes, count, (int)sysconf(_SC_NPROCESSORS_ONLN))) return true;
    message_write(message, size, "memory is exhausted");
    return false;
}

int main(int argc, char **argv)
{
    long count = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    uint64_t seed = argc > 2 ? strtoull(argv[2], NULL, 10) : RANDOM_WORLD_SEED + 1;
    effect_context made;
    surface_drawer drawer;
    char message[600] = "";
    if (count < 1 || count > MAX_SCENES) {
        fprintf(stderr, "usage: irradiance_random_test SCENES [SEED]\n");
        return EXIT_BAD_INPUT;
    }
    lit_scene *scenes = calloc((size_t)count, sizeof *scenes);
    int status = scenes ? effect_context_create("irradiance_random_test", &made) : EXIT_BAD_INPUT;
    if (status != EXIT_SUCCESS) return free(scenes), status;
    bool ok = surface_drawer_create(made.context, made.effect, &drawer, message, sizeof message);
    if (ok) {
        ok = run(&drawer, scenes, (size_t)count, seed, message, sizeof message);
        surface_drawer_destroy(&drawer);
    }
    effect_context_destroy(&made);
    if (!ok) fprintf(stderr, "irradiance_random_test: %s\n", message);
    status = !ok ? EXIT_BAD_INPUT : report(scenes, (size_t)count) ? EXIT_SUCCESS : EXIT_WRONG;
    free(scenes);
    return status;
}
