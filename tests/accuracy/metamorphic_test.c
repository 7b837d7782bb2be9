/*
 * What must not change the light, or changes it in a known way: scenes drawn twice, with no reference between.
 *
 *     metamorphic_test SCENE.json...
 *
 * Each relation is an equation between luminances: see equation.h.
 *
 * Exit status: 0; 1 for a relation that does not hold; 2 for bad input; 77 if there is no context.
 */
#include "curve_split.h"
#include "effect_context.h"
#include "equation.h"
#include "path_forms.h"
#include "source_kinds.h"
#include "vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
static bool moves_rigidly(equation_stage *s, const luminance_sum *whole)
{
    const double right[] = {0.6, 0.64, 0.48}, up[] = {-0.8, 0.48, 0.36};
    rigid_motion motion;
    vector_copy(right, motion.rotation[0]);
    vector_copy(up, motion.rotation[1]);
    vector_cross(right, up, motion.rotation[2]);
    double middle, length;
    scene_rays_depth_range(&s->rays, &middle, &length);
    for (int i = 0; i < 3; i++)
        motion.translation[i] = (i - 0.7) * 1000 * length;

    luminance_sum moved = {{0}, {0}};
    demo_scene scene = *s->scene;
    equation_stage other = {.path = s->path, .scene = &scene, .drawer = s->drawer};
    if (!copy_source_lists(&s->scene->sources, &scene.sources)) return false;
    change_sources(&scene.sources, move, turn, &motion);
    move(&motion, scene.camera.eye);
    move(&motion, scene.camera.target);
    turn(&motion, scene.camera.up);
    ew_frame_desc frame = equation_frame(&other);
    bool ok = equation_add_picture(&other, &scene.sources, &frame, s->depth, 1, &moved);
    if (ok) equation_compare(s, "moved rigidly", whole, &moved, NULL);
    free_source_lists(&scene.sources);
    return ok;
}

/* ---- A scene in another unit -------------------------------------------------------------------------------------------- */

static void scale(const void *user, double vector[3])
{
    const double *factor = user;
    for (int i = 0; i < 3; i++)
        vector[i] *= *factor;
}

/* Cores, reaches and radii of a copy. */
static void scale_lengths(ew_sources_desc *copy, double factor)
{
    copy->epsilon *= factor;
    for (size_t i = 0; i < copy->torus_count; i++)
        ((ew_torus *)copy->tori)[i].radius *= factor;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++)
        for (size_t i = 0; i < source_count(source_kinds[k], copy); i++) {
            source_light *light = (source_light *)((char *)source_at(source_kinds[k], copy, i) + source_kinds[k]->light_offset);
            light->core *= factor;
            light->reach *= factor;
        }
}

/* Luminance has no unit in the world integral. The depth buffer holds the same. */
static bool unit_does_not_matter(equation_stage *s, const luminance_sum *whole, double factor)
{
    demo_scene scene = *s->scene;
    equation_stage other = {.path = s->path, .scene = &scene, .drawer = s->drawer};
    luminance_sum scaled = {{0}, {0}};
    char name[40];
    if (!copy_source_lists(&s->scene->sources, &scene.sources)) return false;
    change_sources(&scene.sources, scale, scale, &factor);
    scale_lengths(&scene.sources, factor);
    scale(&factor, scene.camera.eye);
    scale(&factor, scene.camera.target);
    scene.camera.height *= factor;
    scene.camera.near_depth *= factor;
    scene.camera.far_depth *= factor;
    ew_frame_desc frame = equation_frame(&other);
    bool ok = equation_add_picture(&other, &scene.sources, &frame, s->depth, 1, &scaled);
    snprintf(name, sizeof name, "scaled by %g", factor);
    if (ok) equation_compare(s, name, whole, &scaled, NULL);
    free_source_lists(&scene.sources);
    return ok;
}

/* ---- Another projection ------------------------------------------------------------------------------------------------- */

/* Reversed, in [0, 1] and without a far plane: z of clip space is the near plane's depth, w the view depth. The near plane lies
 * elsewhere too. Such depth is much finer than the one that it is made of, so that the rays end where they did. */
static bool depth_may_be_reversed(equation_stage *s, const luminance_sum *whole)
{
    static float reversed[EQUATION_PIXEL_COUNT];
    double near_depth = 0.3 * s->rays.camera.near_depth;
    luminance_sum other = {{0}, {0}};
    ew_frame_desc frame = equation_frame(s);
    frame.clip_depth = EW_CLIP_DEPTH_ZERO_TO_ONE;
    frame.projection[10] = 0;
    frame.projection[14] = near_depth;
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++)
        reversed[i] = (float)(near_depth / scene_rays_stored_depth(&s->rays, (double)s->depth[i]));
    if (!equation_add_picture(s, &s->scene->sources, &frame, reversed, 1, &other)) return false;
    equation_compare(s, "reversed depth, no far plane", whole, &other, NULL);
    return true;
}

/* ---- The interval split ------------------------------------------------------------------------------------------------- */

/* The ray's parameter runs from 0 to 1 over each part again: with s = a + (b - a) u, alpha ds / (s + beta)^2 is
 * alpha / (b - a) du / (u + (a + beta) / (b - a))^2. */
static bool interval_splits(equation_stage *s, const luminance_sum *whole, double share)
{
    const demo_scene *scene = s->scene;
    const double ends[] = {0, share, 1};
    luminance_sum parts = {{0}, {0}};
    for (int part = 0; part < 2; part++) {
        double length = ends[part + 1] - ends[part];
        ew_frame_desc frame = equation_frame(s);
        frame.interval_start = scene->interval_start + ends[part] * (scene->interval_end - scene->interval_start);
        frame.interval_end = scene->interval_start + ends[part + 1] * (scene->interval_end - scene->interval_start);
        frame.decay_alpha = scene->decay_alpha / length;
        frame.decay_beta = (ends[part] + scene->decay_beta) / length;
        if (!equation_add_picture(s, &scene->sources, &frame, s->depth, 1, &parts)) return false;
    }
    char name[40];
    snprintf(name, sizeof name, "interval split at %g", share);
    equation_compare(s, name, whole, &parts, NULL);
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

static bool curves_reverse(equation_stage *s, const luminance_sum *whole)
{
    ew_sources_desc sources;
    luminance_sum reversed = {{0}, {0}};
    ew_frame_desc frame = equation_frame(s);
    size_t weight_count = 0;
    if (!copy_source_lists(&s->scene->sources, &sources)) return false;
    for (size_t i = 0; i < sources.curve_count; i++)
        weight_count += sources.curves[i].weight_count;
    double *weights = malloc(weight_count * sizeof *weights + 1);
    /* The library's lists are lists of constants; this is a copy. */
    if (weights) reverse_curves((ew_curve *)sources.curves, sources.curve_count, weights);
    bool ok = weights && equation_add_picture(s, &sources, &frame, s->depth, 1, &reversed);
    if (ok) equation_compare(s, "curves reversed", whole, &reversed, NULL);
    free_source_lists(&sources);
    free(weights);
    return ok;
}

/* ---- Scenes ------------------------------------------------------------------------------------------------------------- */

static bool check_relations(equation_stage *s)
{
    static const double ramp[] = {1, 0.25};
    luminance_sum whole = {{0}, {0}};
    ew_frame_desc frame = equation_frame(s);
    bool ok = equation_add_picture(s, &s->scene->sources, &frame, s->depth, 1, &whole) && moves_rigidly(s, &whole);
    if (scene_is_world(s->scene))
        ok = ok && unit_does_not_matter(s, &whole, 1e-3) && unit_does_not_matter(s, &whole, 1e4);
    else
        ok = ok && interval_splits(s, &whole, 0.1) && interval_splits(s, &whole, 0.45);
    if (!s->scene->camera.orthographic) ok = ok && depth_may_be_reversed(s, &whole);
    if (s->scene->sources.curve_count > 0) ok = ok && curves_reverse(s, &whole);
    if (s->scene->sources.path_count > 0) ok = ok && paths_reverse(s, &whole) && splines_are_beziers(s, &whole);
    for (size_t i = 0; ok && i < s->scene->sources.curve_count && i < 3; i++)
        ok = curve_splits(s, i, NULL) && curve_splits(s, i, ramp);
    return ok;
}

static bool check_scene(effect_context *drawing, const char *path, bool *wrong)
{
    char message[400];
    demo_scene scene;
    static equation_stage s;
    s = (equation_stage){.path = path, .scene = &scene};
    if (!scene_load(path, &scene, message, sizeof message)) {
        fprintf(stderr, "metamorphic_test: %s\n", message);
        return false;
    }
    bool ok = scene_rays_create(&scene, EQUATION_SIDE, EQUATION_SIDE, &s.rays);
    if (ok) {
        scene_rays_cast_all(&s.rays, s.depth);
        ok = field_drawer_create(drawing->context, drawing->effect, EQUATION_SIDE, EQUATION_SIDE, &s.drawer, message,
                                 sizeof message);
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
    effect_context drawing;
    bool ok = true, wrong = false;
    int status = effect_context_create("metamorphic_test", &drawing);
    if (status != EXIT_SUCCESS) return status;
    for (int i = 1; ok && i < argc; i++)
        ok = check_scene(&drawing, argv[i], &wrong);
    effect_context_destroy(&drawing);
    return !ok ? EXIT_BAD_INPUT : wrong ? EXIT_WRONG : EXIT_SUCCESS;
}
