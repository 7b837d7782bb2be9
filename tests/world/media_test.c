/* What bodies of media do to the opaque scene and to the light, against their definition: places are asked whether they are in
 * a body.
 *
 *     media_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "stage.h"
#include "vector.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const GLfloat black[4] = {0, 0, 0, 0}, behind[4] = {0.5f, 0.25f, 0.75f, 0.25f};
static const double distance = 6;

/* ---- The definition ----------------------------------------------------------------------------------------------------- */

/* Where a place is in the space of a body's half axes, by Gauss's elimination. */
static void place_in_body(const ew_medium *medium, const double place[3], double own[3])
{
    double rows[3][4];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            rows[i][k] = medium->half_axes[k][i];
        rows[i][3] = place[i] - medium->center[i];
    }
    for (int step = 0; step < 3; step++) {
        int pivot = step;
        for (int i = step; i < 3; i++)
            if (fabs(rows[i][step]) > fabs(rows[pivot][step])) pivot = i;
        for (int k = 0; k < 4; k++) {
            double swapped = rows[step][k];
            rows[step][k] = rows[pivot][k];
            rows[pivot][k] = swapped;
        }
        for (int i = 0; i < 3; i++) {
            double factor = i == step ? 0 : rows[i][step] / rows[step][step];
            for (int k = 0; k < 4; k++)
                rows[i][k] -= factor * rows[step][k];
        }
    }
    for (int i = 0; i < 3; i++)
        own[i] = rows[i][3] / rows[i][i];
}

static bool is_inside(const ew_medium *medium, const double place[3])
{
    double own[3];
    place_in_body(medium, place, own);
    if (medium->shape == EW_MEDIUM_ELLIPSOID) return vector_dot(own, own) <= 1;
    return fabs(own[0]) <= 1 && fabs(own[1]) <= 1 && fabs(own[2]) <= 1;
}

/* A ray of a pixel: origin + x direction, x the distance. */
typedef struct ray {
    double origin[3], direction[3];
    double length_of_depth; /* of the ray, per unit of view depth */
} ray;

static ray ray_of(const ew_frame_desc *frame, int column, int row)
{
    bool is_parallel = frame->projection[11] == 0;
    double x = (2 * column + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT;
    double y = (2 * row + 1 - STAGE_HEIGHT) * stage_slope() / STAGE_HEIGHT;
    double length = is_parallel ? 1 : sqrt(1 + x * x + y * y);
    if (!is_parallel) return (ray){{0, 0, distance}, {x / length, y / length, -1 / length}, length};
    double near_depth = (frame->projection[14] + 1) / frame->projection[10];
    return (ray){{distance * x, distance * y, distance - near_depth}, {0, 0, -1}, 1};
}

static double fog_at(const ew_fog *fog, const double place[3])
{
    return fog->extinction * (fog->scale > 0 ? exp(-(place[1] - fog->base) / fog->scale) : 1);
}

static unsigned bodies_at(const ew_frame_desc *frame, const ray *r, double x)
{
    double place[3];
    unsigned set = 0;
    vector_copy(r->origin, place);
    vector_add_scaled(place, x, r->direction, place);
    for (size_t i = 0; i < frame->medium_count; i++)
        set |= (unsigned)is_inside(&frame->media[i], place) << i;
    return set;
}

/* What is left of light from behind: through bodies alone, and through fog, too; and the bodies' own light. */
typedef struct passage {
    double through_bodies, through_all;
    double light[3];
} passage;

/* Goes through a part of the ray on which the bodies are the same, by the midpoint rule. */
static void pass(const ew_frame_desc *frame, const ray *r, double from, double to, unsigned bodies, passage *passed)
{
    enum { STEPS = 200 };
    double step = (to - from) / STEPS, extinction = 0, source[3] = {0};
    for (size_t i = 0; i < frame->medium_count; i++) {
        const ew_medium *medium = &frame->media[i];
        if (!(bodies >> i & 1)) continue;
        extinction += medium->extinction;
        vector_add_scaled(source, frame->exposure * medium->extinction * medium->albedo, medium->ambient, source);
    }
    for (int i = 0; i < STEPS; i++) {
        double place[3];
        vector_copy(r->origin, place);
        vector_add_scaled(place, from + (i + 0.5) * step, r->direction, place);
        double depth = step * (extinction + fog_at(&frame->fog, place));
        vector_add_scaled(passed->light, passed->through_all * exp(-0.5 * depth) * step, source, passed->light);
        passed->through_all *= exp(-depth);
        passed->through_bodies *= exp(-step * extinction);
    }
}

/* Up to the distance `end`. Between two places with other bodies, bisection finds where that changes. */
static passage pass_all(const ew_frame_desc *frame, const ray *r, double end)
{
    enum { SAMPLES = 2000 };
    passage passed = {1, 1, {0}};
    double from = 0, low = 0;
    unsigned bodies = bodies_at(frame, r, 0);
    for (int i = 1; i <= SAMPLES; i++) {
        double high = end * i / SAMPLES;
        while (bodies_at(frame, r, high) != bodies) {
            double before = low, after = high;
            for (int step = 0; step < 60; step++) {
                double middle = 0.5 * (before + after);
                if (bodies_at(frame, r, middle) == bodies)
                    before = middle;
                else
                    after = middle;
            }
            pass(frame, r, from, after, bodies, &passed);
            from = low = after;
            bodies = bodies_at(frame, r, after);
        }
        low = high;
    }
    pass(frame, r, from, end, bodies, &passed);
    return passed;
}

/* ---- Frames ------------------------------------------------------------------------------------------------------------- */

static const ew_medium bodies[] = {
    {.center = {-0.9, 0.2, 0.3},
     .half_axes = {{0.7, 0.1, 0}, {-0.1, 0.9, 0.2}, {0.1, -0.2, 0.6}},
     .extinction = 0.9,
     .albedo = 0.6,
     .ambient = {0.5, 0.2, 0.1}},
    {.shape = EW_MEDIUM_ELLIPSOID,
     .center = {-0.2, -0.1, 0.6},
     .half_axes = {{0.9, 0.2, 0.1}, {-0.1, 0.5, 0}, {0, 0.1, 0.8}},
     .extinction = 2,
     .albedo = 0.3,
     .ambient = {0.2, 0.9, 1.4}},
    {.shape = EW_MEDIUM_ELLIPSOID,
     .center = {0.6, 0.1, 5.2},
     .half_axes = {{1.5, 0, 0}, {0, 1.5, 0}, {0, 0, 1.5}},
     .extinction = 0.15,
     .albedo = 1,
     .ambient = {0.3, 0.3, 0.3}}, /* the eye is in it */
};

static ew_frame_desc frame_with_bodies(ew_output output)
{
    ew_frame_desc frame = stage_frame(distance);
    frame.media = bodies;
    frame.medium_count = 3;
    frame.output = output;
    frame.exposure = 1.5;
    return frame;
}

static void make_parallel(ew_frame_desc *frame)
{
    double *p = frame->projection;
    p[0] /= distance;
    p[5] /= distance;
    p[10] = -2 / (20 - 0.5);
    p[14] = -(20 + 0.5) / (20 - 0.5);
    p[11] = 0;
    p[15] = 1;
}

static const ew_fog fogs[] = {{0}, {.extinction = 0.1}, {.extinction = 0.4, .up = {0, 3, 0}, .base = -0.5, .scale = 0.6}};
enum { FOG_COUNT = sizeof fogs / sizeof fogs[0] };

/* Holds the target to what is expected of a background, with a light that is `light` by a pixel and covers `cover`. */
static void expect_picture(const ew_frame_desc *frame, double wall, stage_picture light, stage_picture cover,
                           stage_picture found)
{
    int dimmed = 0;
    for (int row = 0; row < STAGE_HEIGHT; row += 4)
        for (int column = 0; column < STAGE_WIDTH; column += 4) {
            const ray r = ray_of(frame, column, row);
            const double start = frame->projection[11] == 0 ? 0.5 : 0;
            const passage passed = pass_all(frame, &r, (wall - start) * r.length_of_depth);
            const double covered = cover ? fmin(1, (double)cover[row][column][0]) : 0;
            dimmed += passed.through_bodies < 0.5;
            for (int i = 0; i < 4; i++) {
                bool is_alpha = i == 3, is_lerp = frame->output == EW_OUTPUT_LERP;
                double back = (double)behind[i], seen = passed.through_bodies * back,
                       sum = light ? (double)light[row][column][i] : 0;
                double expected = is_alpha ? back : seen + passed.light[i];
                if (is_alpha && is_lerp) expected = (1 - covered) * (seen + 1 - passed.through_bodies) + covered;
                if (!is_alpha && is_lerp) expected = (1 - covered) * expected + sum;
                if (!is_alpha && frame->output == EW_OUTPUT_ADD) expected += sum;
                if (!is_alpha && frame->output == EW_OUTPUT_SOFT) expected = 1 - (1 - expected) * exp(-sum);
                double is = (double)found[row][column][i];
                if (!(fabs(is - expected) <= 1e-4))
                    fail_msg("output %d, %s, fog %g, wall %g, pixel (%d, %d), channel %d: %g, not %g", (int)frame->output,
                             frame->projection[11] == 0 ? "parallel" : "perspective", frame->fog.extinction, wall, column, row,
                             i, is, expected);
            }
        }
    assert_true(dimmed > 5);
}

/* ---- Promises ----------------------------------------------------------------------------------------------------------- */

static const ew_output outputs[] = {EW_OUTPUT_LERP, EW_OUTPUT_ADD, EW_OUTPUT_SOFT};

static void bodies_dim_the_target_and_shine_as_the_formula_says(void **state)
{
    (void)state;
    static stage_picture found;
    stage_set(&(ew_sources_desc){.points = NULL});
    for (int output = 0; output < 3; output++)
        for (int fog = 0; fog < FOG_COUNT; fog++)
            for (int is_parallel = 0; is_parallel < 2; is_parallel++) {
                ew_frame_desc frame = frame_with_bodies(outputs[output]);
                frame.fog = fogs[fog];
                if (is_parallel) make_parallel(&frame);
                stage_draw(&frame, behind, found);
                expect_picture(&frame, 12, NULL, NULL, found);
            }
}

static void set_orb(void)
{
    const ew_point orb = {.position = {-0.3, 0.1, 0.2}, .brightness = 1.2, .core = 0.2, .reach = 2, .color = {1, 0.5, 0.1}};
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
}

/* The light is as over black among bodies that do not shine. */
static void light_is_drawn_over_bodies(void **state)
{
    (void)state;
    static stage_picture found, light, luminance;
    ew_medium dark[3];
    memcpy(dark, bodies, sizeof dark);
    for (int i = 0; i < 3; i++)
        dark[i].albedo = 0;
    set_orb();
    for (int output = 0; output < 3; output++) {
        ew_frame_desc frame = frame_with_bodies(EW_OUTPUT_ADD);
        frame.media = dark;
        stage_draw(&frame, black, light);
        stage_measure(&frame, luminance);
        frame.media = bodies;
        frame.output = outputs[output];
        stage_draw(&frame, behind, found);
        expect_picture(&frame, 12, light, luminance, found);
    }
}

static GLuint make_wall(const ew_frame_desc *frame, double depth)
{
    const double *p = frame->projection;
    return stage_make_depth(0.5 + 0.5 * (-p[10] * depth + p[14]) / (p[11] == 0 ? 1 : depth));
}

static void what_is_opaque_ends_bodies(void **state)
{
    (void)state;
    static const double walls[] = {5.3, 5.6, 7};
    static stage_picture found;
    stage_set(&(ew_sources_desc){.points = NULL});
    for (int i = 0; i < 6; i++) {
        ew_frame_desc frame = frame_with_bodies(EW_OUTPUT_LERP);
        if (i % 2) make_parallel(&frame);
        frame.depth_texture = make_wall(&frame, walls[i / 2]);
        stage_draw(&frame, behind, found);
        gl.DeleteTextures(1, &frame.depth_texture);
        expect_picture(&frame, walls[i / 2], NULL, NULL, found);
    }
}

static void bodies_before_all_that_is_opaque_or_behind_the_eye_change_nothing(void **state)
{
    (void)state;
    static stage_picture found;
    ew_medium far_off[2];
    memcpy(far_off, bodies, sizeof far_off);
    far_off[0].center[2] = distance + 3;
    far_off[1].center[2] = -8;
    stage_set(&(ew_sources_desc){.points = NULL});
    ew_frame_desc frame = frame_with_bodies(EW_OUTPUT_LERP);
    frame.media = far_off;
    frame.medium_count = 2;
    frame.depth_texture = make_wall(&frame, 9);
    stage_draw(&frame, behind, found);
    gl.DeleteTextures(1, &frame.depth_texture);
    for (int i = 0; i < STAGE_VALUES; i++)
        assert_true((&found[0][0][0])[i] == behind[i % 4]);
}

static void measurements_do_not_show_bodies(void **state)
{
    (void)state;
    static stage_picture found;
    stage_set(&(ew_sources_desc){.points = NULL});
    ew_frame_desc frame = frame_with_bodies(EW_OUTPUT_LUMINANCE);
    stage_measure(&frame, found);
    assert_true(stage_peak(found) == 0);
}

/* ---- Bounds ------------------------------------------------------------------------------------------------------------- */

static double between(double low, double high)
{
    return low + (high - low) * rand() / RAND_MAX;
}

/* Returns how many pixels changed. */
static int expect_within_bounds(const ew_frame_desc *frame)
{
    static stage_picture found;
    ew_bounds bounds;
    ew_error error = {.text = ""};
    int changed = 0;
    if (ew_get_bounds(stage_effect(), frame, &bounds, &error) != EW_OK) fail_msg("%s", error.text);
    stage_draw(frame, behind, found);
    for (int row = 0; row < STAGE_HEIGHT; row++)
        for (int column = 0; column < STAGE_WIDTH; column++) {
            if (memcmp(found[row][column], behind, sizeof behind) == 0) continue;
            changed++;
            assert_in_range(column, bounds.x, bounds.x + bounds.width - 1);
            assert_in_range(row, bounds.y, bounds.y + bounds.height - 1);
        }
    return changed;
}

static void bodies_are_seen_within_the_bounds_alone(void **state)
{
    (void)state;
    srand(1);
    int seen = 0, unseen = 0;
    for (int i = 0; i < 300; i++) {
        ew_medium body = {.shape = i % 2 ? EW_MEDIUM_BOX : EW_MEDIUM_ELLIPSOID, .extinction = 3};
        double size = exp(between(log(0.02), log(2)));
        for (int k = 0; k < 3; k++) {
            body.center[k] = between(-5, 5);
            for (int axis = 0; axis < 3; axis++)
                body.half_axes[axis][k] = size * between(-1, 1);
        }
        ew_frame_desc frame = stage_frame(distance);
        frame.output = EW_OUTPUT_LERP;
        frame.media = &body;
        frame.medium_count = 1;
        if (i % 3 == 0) make_parallel(&frame);
        int changed = expect_within_bounds(&frame);
        seen += changed > 0;
        unseen += changed == 0;
    }
    assert_true(seen > 100 && unseen > 20);
}

int main(int argc, char **argv)
{
    if (argc != 2 || !stage_open(argv[1])) return 2;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_dim_the_target_and_shine_as_the_formula_says),
        cmocka_unit_test(light_is_drawn_over_bodies),
        cmocka_unit_test(what_is_opaque_ends_bodies),
        cmocka_unit_test(bodies_before_all_that_is_opaque_or_behind_the_eye_change_nothing),
        cmocka_unit_test(measurements_do_not_show_bodies),
        cmocka_unit_test(bodies_are_seen_within_the_bounds_alone),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    stage_close();
    return failed;
}
