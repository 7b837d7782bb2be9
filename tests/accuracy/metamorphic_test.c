/*
 * What must not change the light, or changes it in a known way: scenes drawn twice, with no reference between.
 *
 *     metamorphic_test SCENE.json...
 *
 * Each relation is an equation between luminances. Each of these may be wrong by the default quality's bound, relative to
 * itself or, where it is darker, to 1e-3 of its picture's largest; so the two sides may differ by the sum of that: by twice the
 * bound for an equation of two pictures.
 *
 * Exit status: 0; 1 for a relation that does not hold; 2 for bad input; 77 if there is no context.
 */
#include "context.h"
#include "field_drawer.h"
#include "reference_arc.h"
#include "scene_file.h"
#include "scene_rays.h"
#include "source_kinds.h"
#include "vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_WRONG = 1, EXIT_BAD_INPUT = 2, EXIT_NO_CONTEXT = 77 };
enum { SIDE = 48, PIXEL_COUNT = SIDE * SIDE };

#define BOUND 1e-3
#define DARK 1e-3

typedef struct stage {
    const char *path;
    const ew_scene *scene;
    scene_rays rays;
    field_drawer drawer;
    float depth[PIXEL_COUNT];
    bool wrong;
} stage;

/* One side of an equation: a sum, and by how much it may be wrong. NaN where the equation says nothing. */
typedef struct luminance_sum {
    double sum[PIXEL_COUNT];
    double allowance[PIXEL_COUNT];
} luminance_sum;

/* ---- Pictures and equations --------------------------------------------------------------------------------------------- */

static ew_frame_desc scene_frame(const stage *s)
{
    render_settings settings = {
        .width = SIDE, .height = SIDE, .integrator = EW_INTEGRATOR_ADAPTIVE, .quality = EW_QUALITY_ERROR_1E_3};
    ew_frame_desc frame = render_frame(s->scene, &settings, &s->drawer.target);
    frame.output = EW_OUTPUT_LUMINANCE;
    return frame;
}

/* Adds `sign` times a picture to a sum. */
static bool add_picture(stage *s, const ew_sources_desc *sources, const ew_frame_desc *frame, const float *depth, double sign,
                        luminance_sum *sum)
{
    static float luminance[PIXEL_COUNT];
    double largest = 0;
    ew_error error;
    if (!field_drawer_draw(&s->drawer, sources, frame, depth, luminance, &error)) {
        fprintf(stderr, "metamorphic_test: %s: %s\n", s->path, error.text);
        return false;
    }
    for (int i = 0; i < PIXEL_COUNT; i++)
        largest = fmax(largest, (double)luminance[i]);
    for (int i = 0; i < PIXEL_COUNT; i++) {
        sum->sum[i] += sign * (double)luminance[i];
        sum->allowance[i] += BOUND * fmax((double)luminance[i], DARK * largest);
    }
    return true;
}

/* Compares the sides where `applies` (NULL for everywhere). */
static void compare(stage *s, const char *relation, const luminance_sum *left, const luminance_sum *right, const bool *applies)
{
    double worst = 0;
    int where = 0, count = 0;
    for (int i = 0; i < PIXEL_COUNT; i++) {
        if (applies && !applies[i]) continue;
        double excess = fabs(left->sum[i] - right->sum[i]) / (left->allowance[i] + right->allowance[i] + 1e-30);
        count++;
        if (excess <= worst) continue;
        worst = isnan(excess) ? HUGE_VAL : excess;
        where = i;
    }
    const char *slash = strrchr(s->path, '/');
    bool ok = worst <= 1 && count > PIXEL_COUNT / 2;
    printf("%-36s %-32s %8.1e of what is allowed at (%2d, %2d): %.6g, %.6g; %d pixels%s\n", slash ? slash + 1 : s->path,
           relation, worst, where % SIDE, where / SIDE, left->sum[where], right->sum[where], count, ok ? "" : "  WRONG");
    s->wrong = s->wrong || !ok;
}

/* ---- A scene moved rigidly ---------------------------------------------------------------------------------------------- */

typedef struct rigid_motion {
    double rotation[3][3]; /* rows */
    double translation[3];
} rigid_motion;

static void turn(const void *user, double direction[3])
{
    const rigid_motion *motion = user;
    double turned[3];
    for (int i = 0; i < 3; i++)
        turned[i] = vector_dot(motion->rotation[i], direction);
    vector_copy(turned, direction);
}

static void move(const void *user, double position[3])
{
    const rigid_motion *motion = user;
    turn(motion, position);
    vector_add_scaled(position, 1, motion->translation, position);
}

/* Turned about an odd axis and carried away by many times its distance, camera and all, it is the same picture: only roundings
 * of the doubles differ. */
static bool moves_rigidly(stage *s, const luminance_sum *whole)
{
    const double right[] = {0.6, 0.64, 0.48}, up[] = {-0.8, 0.48, 0.36};
    rigid_motion motion;
    vector_copy(right, motion.rotation[0]);
    vector_copy(up, motion.rotation[1]);
    vector_cross(right, up, motion.rotation[2]);
    for (int i = 0; i < 3; i++)
        motion.translation[i] = (i - 0.7) * 1000 * (s->scene->interval_end - s->scene->interval_start);

    luminance_sum moved = {{0}, {0}};
    ew_scene scene = *s->scene;
    stage other = {.path = s->path, .scene = &scene, .drawer = s->drawer};
    if (!copy_source_lists(&s->scene->sources, &scene.sources)) return false;
    change_sources(&scene.sources, move, turn, &motion);
    move(&motion, scene.camera.eye);
    move(&motion, scene.camera.target);
    turn(&motion, scene.camera.up);
    ew_frame_desc frame = scene_frame(&other);
    bool ok = add_picture(&other, &scene.sources, &frame, s->depth, 1, &moved);
    if (ok) compare(s, "moved rigidly", whole, &moved, NULL);
    free_source_lists(&scene.sources);
    return ok;
}

/* ---- Another projection ------------------------------------------------------------------------------------------------- */

/* Reversed, in [0, 1] and without a far plane: z of clip space is the near plane's depth, w the view depth. The near plane lies
 * elsewhere too. Such depth is much finer than the one that it is made of, so that the rays end where they did. */
static bool depth_may_be_reversed(stage *s, const luminance_sum *whole)
{
    static float reversed[PIXEL_COUNT];
    double near_depth = 0.3 * s->rays.camera.near_depth;
    luminance_sum other = {{0}, {0}};
    ew_frame_desc frame = scene_frame(s);
    frame.clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    frame.projection[10] = 0;
    frame.projection[14] = near_depth;
    for (int i = 0; i < PIXEL_COUNT; i++)
        reversed[i] = (float)(near_depth / scene_rays_stored_depth(&s->rays, (double)s->depth[i]));
    if (!add_picture(s, &s->scene->sources, &frame, reversed, 1, &other)) return false;
    compare(s, "reversed depth, no far plane", whole, &other, NULL);
    return true;
}

/* ---- The interval split ------------------------------------------------------------------------------------------------- */

/* The ray's parameter runs from 0 to 1 over each part again: with s = a + (b - a) u, alpha ds / (s + beta)^2 is
 * alpha / (b - a) du / (u + (a + beta) / (b - a))^2. */
static bool interval_splits(stage *s, const luminance_sum *whole, double share)
{
    const ew_scene *scene = s->scene;
    const double ends[] = {0, share, 1};
    luminance_sum parts = {{0}, {0}};
    for (int part = 0; part < 2; part++) {
        double length = ends[part + 1] - ends[part];
        ew_frame_desc frame = scene_frame(s);
        frame.interval_start = scene->interval_start + ends[part] * (scene->interval_end - scene->interval_start);
        frame.interval_end = scene->interval_start + ends[part + 1] * (scene->interval_end - scene->interval_start);
        frame.decay_alpha = scene->decay_alpha / length;
        frame.decay_beta = (ends[part] + scene->decay_beta) / length;
        if (!add_picture(s, &scene->sources, &frame, s->depth, 1, &parts)) return false;
    }
    char name[40];
    snprintf(name, sizeof name, "interval split at %g", share);
    compare(s, name, whole, &parts, NULL);
    return true;
}

/* ---- Curves reversed ---------------------------------------------------------------------------------------------------- */

/* C(first + last - t). */
static void reverse_polynomial(ew_curve *curve)
{
    double sum = curve->domain[0] + curve->domain[1];
    for (int i = 0; i < 3; i++) {
        double c0 = curve->polynomial[0][i], c1 = curve->polynomial[1][i], c2 = curve->polynomial[2][i];
        curve->polynomial[0][i] = c0 + sum * (c1 + sum * c2);
        curve->polynomial[1][i] = -(c1 + 2 * sum * c2);
    }
}

/* Reverses the curves of a copy; `weights` has room for all their weights. */
static void reverse_curves(ew_curve *curves, size_t count, double *weights)
{
    for (size_t i = 0; i < count; i++) {
        ew_curve *curve = &curves[i];
        for (size_t k = 0; k < curve->weight_count; k++)
            weights[k] = curve->weights[curve->weight_count - 1 - k];
        reverse_polynomial(curve);
        if (curve->weight_count > 0) curve->weights = weights;
        weights += curve->weight_count;
    }
}

static bool curves_reverse(stage *s, const luminance_sum *whole)
{
    ew_sources_desc sources;
    luminance_sum reversed = {{0}, {0}};
    ew_frame_desc frame = scene_frame(s);
    size_t weight_count = 0;
    if (!copy_source_lists(&s->scene->sources, &sources)) return false;
    for (size_t i = 0; i < sources.curve_count; i++)
        weight_count += sources.curves[i].weight_count;
    double *weights = malloc(weight_count * sizeof *weights + 1);
    /* The library's lists are lists of constants; this is a copy. */
    if (weights) reverse_curves((ew_curve *)sources.curves, sources.curve_count, weights);
    bool ok = weights && add_picture(s, &sources, &frame, s->depth, 1, &reversed);
    if (ok) compare(s, "curves reversed", whole, &reversed, NULL);
    free_source_lists(&sources);
    free(weights);
    return ok;
}

/* ---- A curve split at a point of the arc -------------------------------------------------------------------------------- */

/* The field of an arc is not the sum of its parts': the distance to the arc is that to the nearer part. But a ray of which one
 * stretch is nearer to one part, and the rest to the other, sees the one until where that changes, and the other from there on.
 * What lies beyond is cut off by depth, the same for both, so that its rounding does not matter:
 *
 *     B(arc) = B(near part, up to the change) + B(far part) - B(far part, up to the change)
 */
enum { STEPS = 160 };

/* The difference of the squared distances at the ray's parameter s, 0 where it is but rounding. */
static double nearness(const ew_curve parts[2], const reference_ray *ray, double s)
{
    double place[3], distances[2];
    for (int i = 0; i < 3; i++)
        place[i] = ray->start[i] + s * (ray->end[i] - ray->start[i]);
    for (int i = 0; i < 2; i++)
        distances[i] = reference_curve_distance(&parts[i], place, NULL);
    double difference = distances[0] - distances[1];
    return fabs(difference) < 1e-9 * (distances[0] + distances[1]) ? 0 : difference;
}

/* Where the nearer part changes: returns how often it does, up to 2; with 1, *s is where, and *first the part that is nearer
 * before. With 0 that is nearest all the way. */
static int find_change(const ew_curve parts[2], const reference_ray *ray, double *s, int *first)
{
    double last_s = 0, last = 0;
    int changes = 0;
    *first = 0;
    for (int i = 0; i <= STEPS && changes < 2; i++) {
        /* Denser towards the eye, where the light is. */
        double here_s = ray->s_max * pow(i / (double)STEPS, 2), here = nearness(parts, ray, here_s);
        if (here == 0) continue;
        if (last == 0) {
            *first = here > 0;
        } else if ((here > 0) != (last > 0)) {
            double low = last_s, high = here_s;
            for (int k = 0; k < 60; k++) {
                double middle = 0.5 * (low + high), at_middle = nearness(parts, ray, middle);
                if (at_middle != 0 && (at_middle > 0) == (last > 0))
                    low = middle;
                else
                    high = middle;
            }
            *s = high;
            changes++;
        }
        last = here;
        last_s = here_s;
    }
    return changes;
}

static ew_curve part_of(const ew_curve *curve, const double ramp[2], const double ends[2], double weights[2])
{
    ew_curve part = *curve;
    for (int i = 0; i < 2; i++) {
        part.domain[i] = ends[i];
        double u = (ends[i] - curve->domain[0]) / (curve->domain[1] - curve->domain[0]);
        if (ramp) weights[i] = (1 - u) * ramp[0] + u * ramp[1];
    }
    part.weights = ramp ? weights : NULL;
    part.weight_count = ramp ? 2 : 0;
    return part;
}

/* `ramp` are the two weights that it is given instead of its own, NULL for none. */
static bool curve_splits(stage *s, size_t index, const double ramp[2])
{
    const double *domain = s->scene->sources.curves[index].domain, middle = domain[0] + 0.4 * (domain[1] - domain[0]);
    const double ends[3][2] = {{domain[0], domain[1]}, {domain[0], middle}, {middle, domain[1]}};
    double weights[3][2];
    ew_curve seen[2], drawn[3];
    for (int i = 0; i < 3; i++)
        drawn[i] = part_of(&s->scene->sources.curves[index], ramp, ends[i], weights[i]);
    for (int i = 0; i < 2; i++)
        seen[i] = part_of(&s->rays.sources.curves[index], NULL, ends[i + 1], NULL);

    /* Which part comes first differs from pixel to pixel, so both ways are drawn; `order` says which one is meant. */
    static float depth_at_change[PIXEL_COUNT];
    static bool applies[2][PIXEL_COUNT];
    for (int i = 0; i < PIXEL_COUNT; i++) {
        double opaque_depth = scene_rays_stored_depth(&s->rays, (double)s->depth[i]), change = 0;
        reference_ray ray = scene_rays_ray(&s->rays, i % SIDE + 0.5, i / SIDE + 0.5, opaque_depth);
        int first, changes = find_change(seen, &ray, &change, &first);
        double depth = s->rays.interval_start + change * (s->rays.interval_end - s->rays.interval_start);
        depth_at_change[i] = scene_rays_depth_to_store(&s->rays, changes == 0 ? opaque_depth : depth);
        applies[0][i] = changes < 2 && first == 0;
        applies[1][i] = changes < 2 && first == 1;
    }
    luminance_sum whole = {{0}, {0}}, ordered[2] = {{{0}, {0}}, {{0}, {0}}}, parts;
    ew_frame_desc frame = scene_frame(s);
    ew_sources_desc arc = {.curves = &drawn[0], .curve_count = 1, .epsilon = s->scene->sources.epsilon};
    if (!add_picture(s, &arc, &frame, s->depth, 1, &whole)) return false;
    for (int order = 0; order < 2; order++) {
        ew_sources_desc near = arc, far = arc;
        near.curves = &drawn[1 + order];
        far.curves = &drawn[2 - order];
        if (!add_picture(s, &near, &frame, depth_at_change, 1, &ordered[order]) ||
            !add_picture(s, &far, &frame, s->depth, 1, &ordered[order]) ||
            !add_picture(s, &far, &frame, depth_at_change, -1, &ordered[order]))
            return false;
    }
    for (int i = 0; i < PIXEL_COUNT; i++) {
        const luminance_sum *meant = &ordered[applies[1][i]];
        parts.sum[i] = meant->sum[i];
        parts.allowance[i] = meant->allowance[i];
        applies[0][i] = applies[0][i] || applies[1][i];
    }
    char name[40];
    snprintf(name, sizeof name, "curve %zu split%s", index, ramp ? ", weighted" : "");
    compare(s, name, &whole, &parts, applies[0]);
    return true;
}

/* ---- Scenes ------------------------------------------------------------------------------------------------------------- */

static bool check_relations(stage *s)
{
    static const double ramp[] = {1, 0.25};
    luminance_sum whole = {{0}, {0}};
    ew_frame_desc frame = scene_frame(s);
    bool ok = add_picture(s, &s->scene->sources, &frame, s->depth, 1, &whole) && moves_rigidly(s, &whole) &&
              interval_splits(s, &whole, 0.1) && interval_splits(s, &whole, 0.45);
    if (!s->scene->camera.orthographic) ok = ok && depth_may_be_reversed(s, &whole);
    if (s->scene->sources.curve_count > 0) ok = ok && curves_reverse(s, &whole);
    for (size_t i = 0; ok && i < s->scene->sources.curve_count && i < 3; i++)
        ok = curve_splits(s, i, NULL) && curve_splits(s, i, ramp);
    return ok;
}

static bool check_scene(gl_context *context, ew_effect *effect, const char *path, bool *wrong)
{
    char message[400];
    ew_scene scene;
    static stage s;
    s = (stage){.path = path, .scene = &scene};
    if (!scene_load(path, &scene, message, sizeof message)) {
        fprintf(stderr, "metamorphic_test: %s\n", message);
        return false;
    }
    bool ok = scene_rays_create(&scene, SIDE, SIDE, &s.rays);
    if (ok) {
        for (int i = 0; i < PIXEL_COUNT; i++)
            s.depth[i] = scene_rays_depth_to_store(&s.rays, scene_rays_cast(&s.rays, i % SIDE + 0.5, i / SIDE + 0.5));
        ok = field_drawer_create(context, effect, SIDE, SIDE, &s.drawer, message, sizeof message);
        if (ok) {
            ok = check_relations(&s);
            field_drawer_destroy(&s.drawer);
        }
        scene_rays_free(&s.rays);
    }
    *wrong = *wrong || s.wrong;
    scene_free(&scene);
    return ok;
}

int main(int argc, char **argv)
{
    char message[400];
    ew_effect *effect;
    ew_error error;
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    gl_context *context = context_create(CONTEXT_EGL, message, sizeof message);
    if (!context) {
        printf("SKIPPED: %s\n", message);
        return EXIT_NO_CONTEXT;
    }
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    bool ok = !ew_create_effect(&desc, &effect, &error), wrong = false;
    if (!ok) fprintf(stderr, "metamorphic_test: %s\n", error.text);
    for (int i = 1; ok && i < argc; i++)
        ok = check_scene(context, effect, argv[i], &wrong);
    if (ok) ew_destroy_effect(effect);
    context_destroy(context);
    return !ok ? EXIT_BAD_INPUT : wrong ? EXIT_WRONG : EXIT_SUCCESS;
}
