/* Frames: what is wrong with one is named before any GL is called. */
#include "check.h"
#include "plan/frame.h"
#include "plan/plan.h"

#include <float.h>

static ew_frame_desc good_frame(void)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.viewport_width = 640;
    frame.viewport_height = 360;
    return frame;
}

static ew_result plan_for_nothing(const ew_frame_desc *frame, ew_error *error)
{
    ew_sources none = {.epsilon = 1e-3};
    ew_plan plan;
    return ew_plan_frame(&plan, &none, NULL, frame, error);
}

static void expect_refused(const ew_frame_desc *frame, const char *name)
{
    ew_error error = {EW_OK, ""};
    ew_result result = plan_for_nothing(frame, &error);
    check_refused(result, &error, EW_ERROR_INVALID_ARGUMENT, name);
    assert_int_equal(plan_for_nothing(frame, NULL), EW_ERROR_INVALID_ARGUMENT);
}

static void expect_taken(const ew_frame_desc *frame)
{
    ew_error error = {EW_OK, ""};
    if (plan_for_nothing(frame, &error) != EW_OK) fail_msg("refused: %s", error.text);
}

/* EW_FRAME_DEFAULTS goes by position: one member too few or in another place shows here. */
static void the_defaults_are_those_of_their_members(void **state)
{
    (void)state;
    const ew_frame_desc frame = EW_FRAME_DEFAULTS;
    const double forward_at_a_tenth[16] = {[0] = 1, [5] = 1, [10] = -1, [11] = -1, [14] = -0.2};
    for (int i = 0; i < 16; ++i) {
        assert_true(frame.view[i] == (i % 5 == 0));
        assert_true(frame.projection[i] == forward_at_a_tenth[i]);
    }
    assert_int_equal(frame.clip_depth, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE);
    assert_true(frame.interval_start == 0 && frame.interval_end == 0);
    assert_true(frame.decay_alpha == 1 && frame.decay_beta == 1 && frame.exposure == 1);
    assert_true(frame.core_pixels == EW_CORE_PIXELS_DEFAULT);
    assert_true(frame.light_gain == 1 && frame.light_reach == 0 && frame.shadow_thickness == 0);
    assert_true(frame.fog.extinction == 0 && frame.fog.base == 0 && frame.fog.scale == 0);
    assert_true(frame.fog.up[0] == 0 && frame.fog.up[1] == 1 && frame.fog.up[2] == 0);
    assert_true(frame.media == NULL && frame.medium_count == 0);
    assert_int_equal(frame.integrator, EW_INTEGRATOR_ADAPTIVE);
    assert_int_equal(frame.quality, EW_QUALITY_ERROR_1E_3);
    assert_int_equal(frame.simpson_divisions, 200);
    assert_int_equal(frame.resolution, EW_RESOLUTION_ADAPTIVE);
    assert_int_equal(frame.output, EW_OUTPUT_SOFT);
    assert_true(frame.framebuffer == 0 && frame.viewport_x == 0 && frame.viewport_y == 0);
    assert_true(frame.viewport_width == 0 && frame.viewport_height == 0);
    assert_int_equal(frame.encoding, EW_ENCODING_LINEAR_8BIT);
    assert_int_equal(frame.depth_source, EW_DEPTH_TEXTURE);
    assert_true(frame.dither == 1 && frame.depth_texture == 0 && frame.normal_texture == 0);
    assert_int_equal(frame.normal_encoding, EW_NORMAL_WORLD);
    assert_true(frame.keep_stencil_test == 0 && frame.skip_restore == 0);
}

static void the_defaults_need_only_a_viewport(void **state)
{
    (void)state;
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    expect_refused(&frame, "viewport_width");
    frame = good_frame();
    expect_taken(&frame);
    expect_refused(NULL, "frame");
}

/* The composite neither clips nor leaves contours, and faint glow does not band. */
static void the_defaults_suit_a_window_of_8_bits(void **state)
{
    (void)state;
    const ew_frame_desc frame = EW_FRAME_DEFAULTS;
    assert_int_equal(frame.output, EW_OUTPUT_SOFT);
    assert_int_equal(frame.encoding, EW_ENCODING_LINEAR_8BIT);
    assert_int_equal(frame.dither, 1);
    assert_int_equal(frame.framebuffer, 0);
}

static void every_number_that_is_not_finite_is_refused_by_name(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    const struct {
        double *number;
        const char *name;
    } numbers[] = {
        {&frame.view[0], "view"},
        {&frame.view[13], "view"},
        {&frame.view[15], "view"},
        {&frame.projection[0], "projection"},
        {&frame.projection[8], "projection"},
        {&frame.projection[14], "projection"},
        {&frame.interval_start, "interval_start"},
        {&frame.interval_end, "interval_end"},
        {&frame.decay_alpha, "decay_alpha"},
        {&frame.decay_beta, "decay_beta"},
        {&frame.core_pixels, "core_pixels"},
        {&frame.exposure, "exposure"},
        {&frame.light_gain, "light_gain"},
        {&frame.light_reach, "light_reach"},
        {&frame.shadow_thickness, "shadow_thickness"},
        {&frame.fog.extinction, "fog.extinction"},
        {&frame.fog.up[1], "fog.up"},
        {&frame.fog.base, "fog.base"},
        {&frame.fog.scale, "fog.scale"},
    };
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
        double good = *numbers[i].number;
        for (size_t j = 0; j < sizeof bad / sizeof bad[0]; ++j) {
            *numbers[i].number = bad[j];
            expect_refused(&frame, numbers[i].name);
        }
        *numbers[i].number = good;
    }
    expect_taken(&frame);
}

static void a_view_that_is_not_rigid_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.view[0] = frame.view[5] = frame.view[10] = 2; /* a scale */
    expect_refused(&frame, "view");
    frame = good_frame();
    frame.view[4] = 0.1; /* a shear */
    expect_refused(&frame, "view");
    frame = good_frame();
    frame.view[3] = 0.1; /* a perspective */
    expect_refused(&frame, "view");
    frame = good_frame();
    frame.view[15] = 2;
    expect_refused(&frame, "view");
    frame = good_frame();
    memset(frame.view, 0, sizeof frame.view);
    expect_refused(&frame, "view");
}

static void a_view_that_was_kept_in_floats_is_taken(void **state)
{
    (void)state;
    const double angle = 0.7;
    ew_frame_desc frame = good_frame();
    frame.view[0] = frame.view[10] = (double)(float)cos(angle);
    frame.view[8] = (double)(float)sin(angle);
    frame.view[2] = -frame.view[8];
    frame.view[12] = 1e5;
    expect_taken(&frame);
}

/* A turn by angle b about x after one by a about y, as a camera has it at (ex, ey, ez). */
static void look(double a, double b, const double eye[3], double view[16])
{
    const double rows[3][3] = {
        {cos(a), 0, -sin(a)}, {sin(b) * sin(a), cos(b), sin(b) * cos(a)}, {cos(b) * sin(a), -sin(b), cos(b) * cos(a)}};
    memset(view, 0, 16 * sizeof *view);
    view[15] = 1;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            view[4 * column + row] = rows[row][column];
            view[12 + row] -= rows[row][column] * eye[column];
        }
}

/* The largest entry of R R^T - 1. */
static double deviation(const double view[16])
{
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double product = 0;
            for (int k = 0; k < 3; ++k)
                product += view[4 * k + i] * view[4 * k + j];
            largest = fmax(largest, fabs(product - (i == j)));
        }
    return largest;
}

/* An engine turns its camera by products of matrices of floats, and never makes them orthonormal again. The light must be where
 * the engine sees its own things: relative to the eye, as far off as the matrix is from a rotation. */
static void a_view_that_drifted_is_taken_for_the_rotation_next_to_it(void **state)
{
    (void)state;
    const double eye[3] = {2e4, -300, 5e3};
    for (int reflected = 0; reflected < 2; ++reflected) {
        ew_frame_desc frame = good_frame();
        double exact[16];
        look(0.7, -0.3, eye, exact);
        for (int i = 0; i < 16 && reflected; i += 4)
            exact[i] = -exact[i];
        /* R + drift R, and the same for the translation: the eye stays. */
        static const double drift[3][3] = {{3e-4, 2e-4, -1e-4}, {1e-4, -2e-4, 3e-4}, {-4e-4, 1e-4, 2e-4}};
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) {
                double *element = &frame.view[4 * column + row];
                *element = exact[4 * column + row];
                for (int k = 0; k < 3; ++k)
                    *element += drift[row][k] * exact[4 * column + k];
            }
        frame.view[15] = 1;
        assert_true(deviation(frame.view) > 5e-4);
        expect_taken(&frame);
        const ew_frame_desc settled = ew_settle_frame(&frame, false);
        assert_true(deviation(settled.view) < 1e-14);
        for (int row = 0; row < 3; ++row) {
            double seen = settled.view[12 + row];
            for (int k = 0; k < 3; ++k)
                seen += settled.view[4 * k + row] * eye[k];
            assert_true(fabs(seen) < 1e-9); /* the eye is the origin of what it sees */
        }
        for (int i = 0; i < 11; ++i)
            assert_true(fabs(settled.view[i] - frame.view[i]) < 5e-4);
    }
}

static void a_view_that_is_exact_stays_as_it_is(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    look(0.7, -0.3, (const double[3]){2e4, -300, 5e3}, frame.view);
    const ew_frame_desc settled = ew_settle_frame(&frame, false);
    assert_memory_equal(settled.view, frame.view, sizeof frame.view);
}

static void a_last_row_that_drifted_is_taken_for_the_one_next_to_it(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.view[3] = 1e-8; /* an inverse in floats */
    frame.view[15] = 1 - 1e-7;
    expect_taken(&frame);
    const ew_frame_desc settled = ew_settle_frame(&frame, false);
    assert_true(settled.view[3] == 0 && settled.view[15] == 1);
}

static void a_view_beyond_the_tolerance_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.view[0] = 1.0004; /* squared, 8e-4 beyond 1 */
    expect_taken(&frame);
    frame.view[0] = 1.0006;
    expect_refused(&frame, "view");
    frame = good_frame();
    frame.view[4] = 0.9e-3;
    expect_taken(&frame);
    frame.view[4] = 1.1e-3;
    expect_refused(&frame, "1e-3");
    frame = good_frame();
    frame.view[7] = 1e-5;
    expect_refused(&frame, "view");
}

static void a_projection_that_projects_nothing_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    memset(frame.projection, 0, sizeof frame.projection);
    expect_refused(&frame, "projection");
    frame = good_frame();
    frame.projection[11] = 1; /* looks along +z */
    expect_refused(&frame, "projection");
    frame = good_frame();
    frame.projection[3] = 0.1; /* w depends on x */
    expect_refused(&frame, "projection");
    frame = good_frame();
    frame.projection[15] = 1; /* neither parallel nor from a point in the eye */
    expect_refused(&frame, "projection");
    frame = good_frame();
    frame.projection[5] = 0; /* no height */
    expect_refused(&frame, "projection");
}

static void an_interval_without_length_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.interval_start = frame.interval_end = 5;
    expect_refused(&frame, "interval_start");
    frame.interval_end = 4;
    expect_refused(&frame, "interval_start");
    frame.interval_start = -DBL_MAX;
    frame.interval_end = DBL_MAX;
    expect_refused(&frame, "interval_start");
}

static void only_a_parallel_projection_may_start_behind_the_eye(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.interval_start = 0;
    frame.interval_end = 4;
    expect_refused(&frame, "interval_start");
    frame.interval_start = -1;
    expect_refused(&frame, "interval_start");
    frame.projection[11] = 0;
    frame.projection[15] = 1;
    expect_taken(&frame);
}

static void a_perspective_interval_whose_ends_are_too_far_apart_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.interval_start = 1e-3;
    frame.interval_end = 0.9e9;
    expect_taken(&frame);
    frame.interval_end = 1.1e9;
    expect_refused(&frame, "interval_end");
}

static void decay_out_of_range_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.interval_start = 1;
    frame.interval_end = 2;
    frame.decay_alpha = -1;
    expect_refused(&frame, "decay_alpha");
    frame.decay_alpha = 0;
    expect_taken(&frame);
    frame.decay_beta = 0;
    expect_refused(&frame, "decay_beta");
    frame.decay_beta = -1;
    expect_refused(&frame, "decay_beta");
}

/* The world integral has none. */
static void decay_without_an_interval_is_refused(void **state)
{
    (void)state;
    const double bad[] = {0, 0.5, 2, -1, (double)NAN};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        ew_frame_desc frame = good_frame();
        frame.decay_alpha = bad[i];
        expect_refused(&frame, "decay_alpha");
        frame = good_frame();
        frame.decay_beta = bad[i];
        expect_refused(&frame, "decay_beta");
        frame.interval_end = 4;
        frame.interval_start = 0.1;
        frame.decay_beta = 0.5;
        expect_taken(&frame);
    }
}

static void core_pixels_out_of_range_are_refused(void **state)
{
    (void)state;
    const double bad[] = {-0.5, -2, 64.5, (double)NAN, (double)INFINITY}, good[] = {0, 1.5, 64, EW_CORE_PIXELS_DEFAULT};
    for (int is_world = 0; is_world < 2; ++is_world) {
        ew_frame_desc frame = good_frame();
        frame.interval_start = is_world ? 0 : 1;
        frame.interval_end = is_world ? 0 : 2;
        for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
            frame.core_pixels = bad[i];
            expect_refused(&frame, "core_pixels");
        }
        for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
            frame.core_pixels = good[i];
            expect_taken(&frame);
        }
    }
}

static void exposure_out_of_range_is_refused(void **state)
{
    (void)state;
    const double bad[] = {-1e-300, -1, 1.1e6, (double)NAN, (double)INFINITY}, good[] = {0, 1, 1e6};
    ew_frame_desc frame = good_frame();
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        frame.exposure = bad[i];
        expect_refused(&frame, "exposure");
    }
    for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
        frame.exposure = good[i];
        expect_taken(&frame);
    }
}

static void light_on_surfaces_out_of_range_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.light_gain = -1;
    expect_refused(&frame, "light_gain");
    frame.light_gain = 1.1e6;
    expect_refused(&frame, "light_gain");
    frame.light_gain = 0;
    frame.light_reach = -1e-3;
    expect_refused(&frame, "light_reach");
    frame.light_reach = 1e30;
    frame.shadow_thickness = -1e-3;
    expect_refused(&frame, "shadow_thickness");
    frame.shadow_thickness = 1e30;
    expect_taken(&frame);
}

static void light_on_surfaces_that_is_no_number_is_refused(void **state)
{
    (void)state;
    static const double none[] = {NAN, HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < sizeof none / sizeof none[0]; ++i) {
        ew_frame_desc frame = good_frame();
        frame.light_gain = none[i];
        expect_refused(&frame, "light_gain");
        frame = good_frame();
        frame.light_reach = none[i];
        expect_refused(&frame, "light_reach");
        frame = good_frame();
        frame.shadow_thickness = none[i];
        expect_refused(&frame, "shadow_thickness");
    }
}

/* Light on surfaces is found from their depth, and ends somewhere. */
static void surfaces_without_depth_or_reach_are_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.output = EW_OUTPUT_SURFACES;
    frame.depth_texture = 1;
    expect_refused(&frame, "light_reach");
    frame.light_reach = 1;
    expect_taken(&frame);
    frame.depth_texture = 0;
    expect_refused(&frame, "depth_texture");
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    expect_taken(&frame);
}

static void fog_out_of_range_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.fog.extinction = -1e-300;
    expect_refused(&frame, "fog.extinction");
    frame.fog.extinction = 1.1e12;
    expect_refused(&frame, "fog.extinction");
    frame.fog.extinction = 1e12;
    expect_taken(&frame);
    frame.fog.scale = -1;
    expect_refused(&frame, "fog.scale");
    frame.fog.scale = 1;
    expect_taken(&frame);
}

/* Without a height there is no direction up. */
static void fog_by_height_needs_a_direction_up(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.fog = (ew_fog){.extinction = 1};
    expect_taken(&frame);
    frame.fog.scale = 2;
    expect_refused(&frame, "fog.up");
    frame.fog.up[2] = -3;
    expect_taken(&frame);
}

static ew_medium good_medium(void)
{
    return (ew_medium){.half_axes = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, .extinction = 1, .albedo = 0.5, .ambient = {1, 1, 1}};
}

static void numbers_of_media_that_are_none_are_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    ew_medium media[2] = {good_medium(), good_medium()}, *medium = &media[1];
    frame.media = media;
    frame.medium_count = 2;
    expect_taken(&frame);
    struct {
        double *number;
        const char *name;
        double most; /* HUGE_VAL for none */
        bool is_not_negative;
    } numbers[] = {{&medium->center[2], "media[1].center", HUGE_VAL, false},
                   {&medium->half_axes[1][0], "media[1].half_axes", HUGE_VAL, false},
                   {&medium->extinction, "media[1].extinction", 1e12, true},
                   {&medium->albedo, "media[1].albedo", 1, true},
                   {&medium->ambient[2], "media[1].ambient", 65504, true}};
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
        const double bad[] = {(double)NAN, (double)INFINITY, -1e-300, 1.01 * numbers[i].most};
        double good = *numbers[i].number;
        for (int j = 0; j < 4; ++j) {
            *numbers[i].number = bad[j];
            bool is_fine = isfinite(bad[j]) && !numbers[i].is_not_negative;
            if (!is_fine) expect_refused(&frame, numbers[i].name);
        }
        *numbers[i].number = good;
    }
    expect_taken(&frame);
}

static void media_without_volume_or_more_than_there_is_room_for_are_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    ew_medium media[EW_MAX_MEDIA + 1];
    for (int i = 0; i <= EW_MAX_MEDIA; ++i)
        media[i] = good_medium();
    frame.media = media;
    frame.medium_count = EW_MAX_MEDIA;
    expect_taken(&frame);
    frame.medium_count = EW_MAX_MEDIA + 1;
    expect_refused(&frame, "medium_count");
    frame.media = NULL;
    frame.medium_count = 1;
    expect_refused(&frame, "media");
    frame.media = media;
    media[0].half_axes[2][2] = 0;
    expect_refused(&frame, "media[0].half_axes");
    media[0].half_axes[2][0] = 5; /* along the first axis */
    expect_refused(&frame, "media[0].half_axes");
    media[0].half_axes[2][2] = 1e-3;
    expect_taken(&frame);
    media[0].shape = (ew_medium_shape)2;
    expect_refused(&frame, "media[0].shape");
}

static void numbers_of_divisions_that_simpson_cannot_take_are_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.integrator = EW_INTEGRATOR_SIMPSON;
    const int bad[] = {0, 1, 3, 201, -2, EW_MAX_SIMPSON_DIVISIONS + 2};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        frame.simpson_divisions = bad[i];
        expect_refused(&frame, "simpson_divisions");
    }
    const int good[] = {2, 200, EW_MAX_SIMPSON_DIVISIONS};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; ++i) {
        frame.simpson_divisions = good[i];
        expect_taken(&frame);
    }
    frame.integrator = EW_INTEGRATOR_ADAPTIVE;
    frame.simpson_divisions = 3;
    expect_taken(&frame);
}

static void values_outside_an_enumeration_are_refused(void **state)
{
    (void)state;
    const int bad[] = {-1, 6, 1000};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        ew_frame_desc frame = good_frame();
        frame.clip_depth = (ew_clip_depth)bad[i];
        expect_refused(&frame, "clip_depth");
        frame = good_frame();
        frame.integrator = (ew_integrator)bad[i];
        expect_refused(&frame, "integrator");
        frame = good_frame();
        frame.quality = (ew_quality)bad[i];
        expect_refused(&frame, "quality");
        frame = good_frame();
        frame.output = (ew_output)bad[i];
        expect_refused(&frame, "output");
        frame = good_frame();
        frame.encoding = (ew_encoding)bad[i];
        expect_refused(&frame, "encoding");
        frame = good_frame();
        frame.depth_source = (ew_depth_source)bad[i];
        expect_refused(&frame, "depth_source");
        frame = good_frame();
        frame.normal_encoding = (ew_normal_encoding)bad[i];
        expect_refused(&frame, "normal_encoding");
        frame = good_frame();
        frame.dither = bad[i];
        expect_refused(&frame, "dither");
        frame = good_frame();
        frame.skip_restore = bad[i];
        expect_refused(&frame, "skip_restore");
        frame = good_frame();
        frame.keep_stencil_test = bad[i];
        expect_refused(&frame, "keep_stencil_test");
    }
}

static void a_viewport_without_pixels_is_refused(void **state)
{
    (void)state;
    ew_frame_desc frame = good_frame();
    frame.viewport_width = 0;
    expect_refused(&frame, "viewport_width");
    frame = good_frame();
    frame.viewport_height = -1;
    expect_refused(&frame, "viewport_height");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_defaults_are_those_of_their_members),
        cmocka_unit_test(the_defaults_need_only_a_viewport),
        cmocka_unit_test(the_defaults_suit_a_window_of_8_bits),
        cmocka_unit_test(every_number_that_is_not_finite_is_refused_by_name),
        cmocka_unit_test(a_view_that_is_not_rigid_is_refused),
        cmocka_unit_test(a_view_that_was_kept_in_floats_is_taken),
        cmocka_unit_test(a_view_that_drifted_is_taken_for_the_rotation_next_to_it),
        cmocka_unit_test(a_view_that_is_exact_stays_as_it_is),
        cmocka_unit_test(a_last_row_that_drifted_is_taken_for_the_one_next_to_it),
        cmocka_unit_test(a_view_beyond_the_tolerance_is_refused),
        cmocka_unit_test(a_projection_that_projects_nothing_is_refused),
        cmocka_unit_test(an_interval_without_length_is_refused),
        cmocka_unit_test(only_a_parallel_projection_may_start_behind_the_eye),
        cmocka_unit_test(a_perspective_interval_whose_ends_are_too_far_apart_is_refused),
        cmocka_unit_test(decay_out_of_range_is_refused),
        cmocka_unit_test(decay_without_an_interval_is_refused),
        cmocka_unit_test(core_pixels_out_of_range_are_refused),
        cmocka_unit_test(exposure_out_of_range_is_refused),
        cmocka_unit_test(light_on_surfaces_out_of_range_is_refused),
        cmocka_unit_test(light_on_surfaces_that_is_no_number_is_refused),
        cmocka_unit_test(surfaces_without_depth_or_reach_are_refused),
        cmocka_unit_test(fog_out_of_range_is_refused),
        cmocka_unit_test(fog_by_height_needs_a_direction_up),
        cmocka_unit_test(numbers_of_media_that_are_none_are_refused),
        cmocka_unit_test(media_without_volume_or_more_than_there_is_room_for_are_refused),
        cmocka_unit_test(numbers_of_divisions_that_simpson_cannot_take_are_refused),
        cmocka_unit_test(values_outside_an_enumeration_are_refused),
        cmocka_unit_test(a_viewport_without_pixels_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
