/* Plans: what a frame asks for is resolved without a context. */
#include "check.h"
#include "plan/plan.h"

static ew_frame_desc make_frame(void)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.viewport_x = 3;
    frame.viewport_y = 5;
    frame.viewport_width = 640;
    frame.viewport_height = 360;
    return frame;
}

static ew_plan plan_of(const ew_frame_desc *frame, const ew_mix *mix)
{
    ew_sources none = {.epsilon = 1e-3};
    ew_plan plan;
    ew_error error = {EW_OK, ""};
    if (ew_plan_frame(&plan, &none, mix, frame, &error) != EW_OK) fail_msg("refused: %s", error.text);
    return plan;
}

static void the_output_decides_the_blending(void **state)
{
    (void)state;
    static const struct {
        ew_output output;
        ew_blend blend;
    } cases[] = {{EW_OUTPUT_LERP, EW_BLEND_OVER},
                 {EW_OUTPUT_ADD, EW_BLEND_ADD},
                 {EW_OUTPUT_SOFT, EW_BLEND_SOFT},
                 {EW_OUTPUT_LUMINANCE, EW_BLEND_REPLACE},
                 {EW_OUTPUT_EVALUATIONS, EW_BLEND_REPLACE}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        ew_frame_desc frame = make_frame();
        frame.output = cases[i].output;
        assert_int_equal(plan_of(&frame, NULL).target.blend, cases[i].blend);
    }
}

static void target_and_depth_are_the_frames(void **state)
{
    (void)state;
    ew_frame_desc frame = make_frame();
    frame.framebuffer = 7;
    frame.encoding = EW_ENCODING_SRGB_8BIT;
    frame.depth_source = EW_DEPTH_TEXTURE_MULTISAMPLE;
    frame.depth_texture = 9;
    frame.skip_restore = 1;
    ew_plan plan = plan_of(&frame, NULL);
    assert_int_equal(plan.target.framebuffer, 7);
    assert_memory_equal(&plan.target.viewport, (&(ew_viewport){3, 5, 640, 360}), sizeof(ew_viewport));
    assert_true(plan.target.encodes_srgb && plan.skips_restore);
    assert_int_equal(plan.depth.source, EW_DEPTH_TEXTURE_MULTISAMPLE);
    assert_int_equal(plan.depth.texture, 9);
}

static void a_given_mix_takes_the_place_of_the_sources_own(void **state)
{
    (void)state;
    ew_frame_desc frame = make_frame();
    const ew_mix mix = {.line_count = 3};
    assert_int_equal(plan_of(&frame, &mix).permutation, ew_permutation_of(&mix, &frame));
    assert_int_not_equal(plan_of(&frame, NULL).permutation, plan_of(&frame, &mix).permutation);
}

static void resolution_is_adaptive_where_the_header_says(void **state)
{
    (void)state;
    const ew_mix curve = {.curve_count = 1}, two_points = {.point_count = 2}, three_points = {.point_count = 3},
                 beam = {.path_count = 1}, beams = {.path_count = 2}, orb = {.point_count = 1, .has_reach = 1};
    ew_frame_desc frame = make_frame();
    assert_true(plan_of(&frame, &curve).is_adaptive);
    assert_true(plan_of(&frame, &three_points).is_adaptive && plan_of(&frame, &beams).is_adaptive);
    assert_true(plan_of(&frame, &orb).is_adaptive);
    assert_false(plan_of(&frame, &two_points).is_adaptive || plan_of(&frame, &beam).is_adaptive);

    frame.viewport_width = frame.viewport_height = 256;
    assert_true(plan_of(&frame, &curve).is_adaptive);
    frame.viewport_height = 255;
    assert_false(plan_of(&frame, &curve).is_adaptive);

    frame = make_frame();
    frame.resolution = EW_RESOLUTION_FULL;
    assert_false(plan_of(&frame, &curve).is_adaptive);
    frame = make_frame();
    frame.integrator = EW_INTEGRATOR_SIMPSON;
    assert_false(plan_of(&frame, &curve).is_adaptive);
    frame = make_frame();
    frame.output = EW_OUTPUT_EVALUATIONS;
    assert_false(plan_of(&frame, &curve).is_adaptive);
}

static void uniforms_need_no_target(void **state)
{
    (void)state;
    ew_frame_desc frame = EW_FRAME_DEFAULTS; /* its viewport is empty */
    ew_sources none = {.epsilon = 1e-3};
    ew_plan plan;
    assert_int_equal(ew_plan_uniforms(&plan, &none, &frame, NULL), EW_OK);
    assert_int_equal(ew_plan_frame(&plan, &none, NULL, &frame, NULL), EW_ERROR_INVALID_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_output_decides_the_blending),
        cmocka_unit_test(target_and_depth_are_the_frames),
        cmocka_unit_test(a_given_mix_takes_the_place_of_the_sources_own),
        cmocka_unit_test(resolution_is_adaptive_where_the_header_says),
        cmocka_unit_test(uniforms_need_no_target),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
