/* What the light of a world frame does to the target, and where the opaque scene cuts it.
 *
 *     composite_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "stage.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const GLfloat black[4] = {0, 0, 0, 0}, behind[4] = {0.5f, 0.25f, 0.75f, 0.25f};
static const double core = 0.2, reach = 2, brightness = 1.5;

/* Two that overlap, of other colours. */
static void set_orbs(void)
{
    const ew_point orbs[] = {
        {.position = {-0.4, 0, 0}, .brightness = brightness, .core = core, .reach = reach, .color = {1, 0.5, 0.1}},
        {.position = {0.5, 0.2, 0}, .brightness = 0.7, .core = core, .reach = 1, .color = {0.1, 0.4, 3}, .sharpness = 2},
    };
    stage_set(&(ew_sources_desc){.points = orbs, .point_count = 2});
}

static void set_orb_at(double z)
{
    const ew_point orb = {.position = {0, 0, z}, .brightness = brightness, .core = core, .reach = reach, .color = {1, 1, 1}};
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
}

static double value(stage_picture of, int i)
{
    return (double)(&of[0][0][0])[i];
}

/* ---- Colours ------------------------------------------------------------------------------------------------------------ */

static void soft_follows_its_formula(void **state)
{
    (void)state;
    static stage_picture light, found;
    set_orbs();
    ew_frame_desc frame = stage_frame(6);
    frame.output = EW_OUTPUT_ADD;
    stage_draw(&frame, black, light);
    frame.output = EW_OUTPUT_SOFT;
    stage_draw(&frame, behind, found);
    int lit = 0;
    for (int i = 0; i < STAGE_VALUES; i++) {
        double back = (double)behind[i % 4], sum = value(light, i);
        double expected = i % 4 == 3 ? back : 1 - (1 - back) * exp(-sum);
        assert_true(fabs(value(found, i) - expected) <= 1e-6);
        lit += i % 4 != 3 && sum > 1;
    }
    assert_true(lit > 10);
}

static void soft_stays_below_white_however_bright(void **state)
{
    (void)state;
    static stage_picture found;
    set_orbs();
    ew_frame_desc frame = stage_frame(6);
    frame.output = EW_OUTPUT_SOFT;
    frame.exposure = 1e6;
    stage_draw(&frame, behind, found);
    for (int i = 0; i < STAGE_VALUES; i++)
        assert_true(value(found, i) >= (double)behind[i % 4] && value(found, i) <= 1);
}

static void exposure_is_a_factor_on_colors_alone(void **state)
{
    (void)state;
    static stage_picture light, bright, luminance, same, lerp, bright_lerp;
    set_orbs();
    ew_frame_desc frame = stage_frame(6), exposed = frame;
    exposed.exposure = 2.5;
    frame.output = exposed.output = EW_OUTPUT_ADD;
    stage_draw(&frame, black, light);
    stage_draw(&exposed, black, bright);
    stage_measure(&frame, luminance);
    stage_measure(&exposed, same);
    frame.output = exposed.output = EW_OUTPUT_LERP;
    stage_draw(&frame, behind, lerp);
    stage_draw(&exposed, behind, bright_lerp);
    for (int i = 0; i < STAGE_VALUES; i++) {
        double sum = value(light, i);
        assert_true(fabs(value(bright, i) - 2.5 * sum) <= 1e-6 * fmax(1, 2.5 * sum));
        assert_true(value(same, i) == value(luminance, i));
        /* The background pales by B, as before. */
        double expected = value(lerp, i) + (i % 4 == 3 ? 0 : 1.5 * sum);
        assert_true(fabs(value(bright_lerp, i) - expected) <= 1e-5 * fmax(1, expected));
    }
}

/* B follows from each source's share: b g(B / b). */
static void sharpness_shapes_a_sources_luminance(void **state)
{
    (void)state;
    static stage_picture plain, sharp;
    ew_point orb = {.brightness = 0.8, .core = core, .reach = reach};
    ew_frame_desc frame = stage_frame(6);
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
    stage_measure(&frame, plain);
    orb.sharpness = 3;
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
    stage_measure(&frame, sharp);
    for (int i = 0; i < STAGE_VALUES; i += 4) {
        double x = value(plain, i) / 0.8, expected = 0.8 * (x <= 1 ? pow(x, 3) : 1 + 3 * (x - 1));
        assert_true(fabs(value(sharp, i) - expected) <= 1e-5);
    }
    /* A coefficient stands for a brightness, too. */
    orb.coefficient = 0.8 / (2 * log(reach / core));
    orb.brightness = 0;
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
    stage_measure(&frame, plain);
    assert_true(stage_difference(plain, sharp) <= 1e-5);
}

/* ---- Depth -------------------------------------------------------------------------------------------------------------- */

/* A projection by its row for clip z, with its window depths. */
typedef struct lens {
    const char *name;
    bool is_parallel, is_reversed;
    double z_scale, z_offset;
    ew_clip_depth clip_depth;
} lens;

static const double near_depth = 0.5, far_depth = 8;

enum { LENS_COUNT = 8 };

static void make_lenses(lens lenses[LENS_COUNT])
{
    const double n = near_depth, f = far_depth;
    const lens all[LENS_COUNT] = {
        {"perspective", false, false, -(f + n) / (f - n), -2 * f * n / (f - n), EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE},
        {"[0, 1]", false, false, -f / (f - n), -f * n / (f - n), EW_CLIP_DEPTH_ZERO_TO_ONE},
        {"reversed", false, true, n / (f - n), f * n / (f - n), EW_CLIP_DEPTH_ZERO_TO_ONE},
        {"reversed in [-1, 1]", false, true, (f + n) / (f - n), 2 * f * n / (f - n), EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE},
        {"infinite", false, false, -1, -2 * n, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE},
        {"reversed, infinite", false, true, 0, n, EW_CLIP_DEPTH_ZERO_TO_ONE},
        {"parallel", true, false, -2 / (f - n), -(f + n) / (f - n), EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE},
        {"parallel, reversed", true, true, 1 / (f - n), f / (f - n), EW_CLIP_DEPTH_ZERO_TO_ONE},
    };
    memcpy(lenses, all, sizeof all);
}

static ew_frame_desc frame_of(const lens *seen)
{
    ew_frame_desc frame = stage_frame(6);
    double *p = frame.projection;
    p[10] = seen->z_scale;
    p[14] = seen->z_offset;
    frame.clip_depth = seen->clip_depth;
    frame.core_pixels = 0;
    if (!seen->is_parallel) return frame;
    p[0] /= 6;
    p[5] /= 6;
    p[11] = 0;
    p[15] = 1;
    return frame;
}

static double window_depth(const lens *seen, double depth)
{
    double ndc = (-seen->z_scale * depth + seen->z_offset) / (seen->is_parallel ? 1 : depth);
    return seen->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? ndc : 0.5 + 0.5 * ndc;
}

/* The luminance of an orb at the origin, 6 before the eye, where a wall stands at view depth `wall`. */
static double orb_before_wall(const lens *seen, int column, int row, double wall)
{
    double x = (2 * column + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT;
    double y = (2 * row + 1 - STAGE_HEIGHT) * stage_slope() / STAGE_HEIGHT;
    double length = seen->is_parallel ? 1 : sqrt(1 + x * x + y * y);
    double miss = seen->is_parallel ? 6 * hypot(x, y) : stage_ray_distance(6, column, row);
    double nearest = seen->is_parallel ? 6 : 6 / length;
    return stage_orb(brightness, core, reach, miss, wall * length - nearest);
}

static void a_wall_cuts_the_light(void **state)
{
    (void)state;
    static const double walls[] = {3.9, 4.5, 5.9, 6, 6.3, 7.7, 7.99};
    static stage_picture found;
    lens lenses[LENS_COUNT];
    make_lenses(lenses);
    set_orb_at(0);
    for (int i = 0; i < LENS_COUNT; i++)
        for (size_t w = 0; w < sizeof walls / sizeof walls[0]; w++) {
            ew_frame_desc frame = frame_of(&lenses[i]);
            frame.depth_texture = stage_make_depth(window_depth(&lenses[i], walls[w]));
            stage_measure(&frame, found);
            gl.DeleteTextures(1, &frame.depth_texture);
            double worst = 0;
            for (int row = 0; row < STAGE_HEIGHT; row += 8)
                for (int column = 0; column < STAGE_WIDTH; column += 8) {
                    double expected = orb_before_wall(&lenses[i], column, row, walls[w]);
                    double is = (double)found[row][column][0];
                    worst = fmax(worst, fabs(is - expected) / fmax(expected, 1e-3 * brightness));
                }
            if (worst > 1e-3) fprintf(stderr, "%s, wall at %g: off by %.2g\n", lenses[i].name, walls[w], worst);
            assert_true(worst <= 1e-3);
        }
}

/* Where nothing was drawn, the depth is the far plane's, and that is not a wall: neither before the light nor in it. */
static void what_lies_beyond_the_far_plane_shines_where_depth_is_cleared(void **state)
{
    (void)state;
    static const double places[] = {0, -2, -30};
    static stage_picture open, cleared;
    lens lenses[LENS_COUNT];
    make_lenses(lenses);
    for (int i = 0; i < LENS_COUNT; i++)
        for (int place = 0; place < 3; place++) {
            set_orb_at(places[place]);
            ew_frame_desc frame = frame_of(&lenses[i]);
            stage_measure(&frame, open);
            assert_true(stage_peak(open) > 0.1);
            frame.depth_texture = stage_make_depth(lenses[i].is_reversed ? 0 : 1);
            stage_measure(&frame, cleared);
            gl.DeleteTextures(1, &frame.depth_texture);
            double difference = stage_difference(cleared, open);
            if (difference > 1e-6) fprintf(stderr, "%s, orb at %g: off by %.2g\n", lenses[i].name, places[place], difference);
            assert_true(difference <= 1e-6);
        }
}

/* A wall before the far plane hides what lies beyond both. */
static void a_wall_hides_what_lies_beyond_the_far_plane(void **state)
{
    (void)state;
    static stage_picture found;
    lens lenses[LENS_COUNT];
    make_lenses(lenses);
    set_orb_at(-30);
    for (int i = 0; i < LENS_COUNT; i++) {
        ew_frame_desc frame = frame_of(&lenses[i]);
        frame.depth_texture = stage_make_depth(window_depth(&lenses[i], 7));
        stage_measure(&frame, found);
        gl.DeleteTextures(1, &frame.depth_texture);
        assert_true(stage_peak(found) == 0);
    }
}

/* A parallel projection has no eye: its light begins at the near plane. */
static void a_parallel_views_light_begins_at_the_near_plane(void **state)
{
    (void)state;
    static stage_picture found;
    lens lenses[LENS_COUNT];
    make_lenses(lenses);
    for (int i = LENS_COUNT - 2; i < LENS_COUNT; i++)
        for (double z = 4; z < 8; z += 0.5) {
            /* The orb's middle is at view depth 6 - z, which is before or behind the near plane. */
            set_orb_at(z);
            ew_frame_desc frame = frame_of(&lenses[i]);
            stage_measure(&frame, found);
            for (int column = 0; column < STAGE_WIDTH; column += 8) {
                double miss = 6 * fabs((2 * column + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT);
                /* Seen from behind, the rest of the orb is what its ray leaves up to the near plane. */
                double expected = stage_orb(brightness, core, reach, miss, 6 - z - near_depth);
                double is = (double)found[STAGE_HEIGHT / 2][column][0];
                assert_true(fabs(is - expected) <= 1e-3 * fmax(expected, 1e-3 * brightness));
            }
        }
}

int main(int argc, char **argv)
{
    if (argc != 2 || !stage_open(argv[1])) return 2;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(soft_follows_its_formula),
        cmocka_unit_test(soft_stays_below_white_however_bright),
        cmocka_unit_test(exposure_is_a_factor_on_colors_alone),
        cmocka_unit_test(sharpness_shapes_a_sources_luminance),
        cmocka_unit_test(a_wall_cuts_the_light),
        cmocka_unit_test(what_lies_beyond_the_far_plane_shines_where_depth_is_cleared),
        cmocka_unit_test(a_wall_hides_what_lies_beyond_the_far_plane),
        cmocka_unit_test(a_parallel_views_light_begins_at_the_near_plane),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    stage_close();
    return failed;
}
