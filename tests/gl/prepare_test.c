/* Shaders that were prepared: no draw compiles them, and nobody waits for them.
 *
 *     prepare_test CONTEXT    one of the names in context.h */
#include "debug_output.h"
#include "effect_fixture.h"
#include "program_context.h"
#include "watched_gl.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>
#include <time.h>

static gl_context *context;
static GLuint target;
static watched_gl watched;

static ew_effect *create_effect(void)
{
    ew_effect *effect = NULL;
    ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address};
    assert_int_equal(ew_create_effect(&desc, &effect, NULL), EW_OK);
    return effect;
}

static void set_field(ew_effect *effect, field *f, size_t points, size_t lines, size_t tori, size_t curves, bool weighted)
{
    make_field(f, points, lines, tori, curves, weighted);
    assert_int_equal(ew_set_sources(effect, &f->desc, NULL), EW_OK);
}

static bool prepare(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame)
{
    ew_error error = {.text = ""};
    int is_ready = -1;
    if (ew_prepare(effect, mix, frame, &is_ready, &error) != EW_OK) fail_msg("%s", error.text);
    assert_in_range(is_ready, 0, 1);
    return is_ready;
}

static void prepare_until_ready(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame)
{
    const struct timespec millisecond = {.tv_nsec = 1000000};
    while (!prepare(effect, mix, frame))
        nanosleep(&millisecond, NULL);
}

static void draw(ew_effect *effect, const ew_frame_desc *frame, picture *drawn)
{
    ew_error error = {.text = ""};
    clear_target(target);
    if (ew_draw(effect, frame, &error) != EW_OK) fail_msg("%s", error.text);
    read_target(target, drawn);
}

static void a_draw_of_what_was_prepared_compiles_nothing(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    field f;
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_LERP);
    set_field(effect, &f, 1, 0, 0, 2, true);
    prepare_until_ready(effect, NULL, &frame);
    int compiled = watched.compiled;
    assert_true(compiled > 0);
    picture drawn;
    draw(effect, &frame, &drawn);
    assert_int_equal(watched.compiled, compiled);

    /* Another mix, described. */
    prepare_until_ready(effect, &(ew_mix){.torus_count = 2, .line_count = 1}, &frame);
    compiled = watched.compiled;
    set_field(effect, &f, 0, 1, 2, 0, false);
    draw(effect, &frame, &drawn);
    assert_int_equal(watched.compiled, compiled);

    /* What was not prepared is compiled: the counter counts. */
    frame.output = EW_OUTPUT_LUMINANCE;
    draw(effect, &frame, &drawn);
    assert_true(watched.compiled > compiled);
    ew_destroy_effect(effect);
}

static void the_loader_is_asked_only_while_an_effect_is_created(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    int loaded = watched.loaded;
    assert_true(loaded > 50);
    field f;
    picture drawn;
    unsigned buffer;
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    set_field(effect, &f, 1, 0, 0, 0, false);
    prepare_until_ready(effect, NULL, &frame);
    draw(effect, &frame, &drawn);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER; /* which it has not */
    assert_int_equal(ew_draw(effect, &frame, NULL), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &buffer, NULL), EW_OK);
    ew_destroy_effect(effect);
    assert_int_equal(watched.loaded, loaded);
}

static void preparing_draws_nothing(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    field f;
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    set_field(effect, &f, 1, 0, 0, 0, false);
    picture before, after;
    clear_target(target);
    read_target(target, &before);
    prepare_until_ready(effect, NULL, &frame);
    read_target(target, &after);
    assert_memory_equal(&before, &after, sizeof before);
    draw(effect, &frame, &after);
    assert_memory_not_equal(&before, &after, sizeof before);
    ew_destroy_effect(effect);
}

/* Sources come and go from frame to frame. */
static void a_general_shader_draws_any_sources_and_the_same_light(void **state)
{
    (void)state;
    static const struct {
        size_t points, lines, tori, curves;
        bool weighted;
    } mixes[] = {{0, 0, 0, 0, false}, {1, 0, 0, 0, false}, {0, 3, 5, 2, false}, {6, 0, 1, 1, true}};
    watched_gl_start(&watched, context);
    ew_effect *general = create_effect(), *exact = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    frame.quality = EW_QUALITY_ERROR_1E_4; /* rounding may decide which panels the quadrature takes */
    const ew_mix any = {.point_count = EW_ANY_COUNT,
                        .line_count = EW_ANY_COUNT,
                        .torus_count = EW_ANY_COUNT,
                        .curve_count = EW_ANY_COUNT,
                        .has_weights = 1};
    prepare_until_ready(general, &any, &frame);
    for (size_t i = 0; i < sizeof mixes / sizeof mixes[0]; i++) {
        field f;
        set_field(general, &f, mixes[i].points, mixes[i].lines, mixes[i].tori, mixes[i].curves, mixes[i].weighted);
        set_field(exact, &f, mixes[i].points, mixes[i].lines, mixes[i].tori, mixes[i].curves, mixes[i].weighted);
        picture drawn, expected;
        int compiled = watched.compiled;
        draw(general, &frame, &drawn);
        assert_int_equal(watched.compiled, compiled);
        draw(exact, &frame, &expected);
        if (i == 0)
            assert_memory_equal(&drawn, &expected, sizeof drawn);
        else
            assert_true(picture_difference(&drawn, &expected) < 1e-5);
    }
    ew_destroy_effect(general);
    ew_destroy_effect(exact);
}

static void expect_to_compile_beside(const ew_mix *lacking, size_t points, size_t curves, bool weighted)
{
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    const ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    field f;
    picture drawn;
    set_field(effect, &f, points, 0, 0, curves, weighted);
    prepare_until_ready(effect, lacking, &frame);
    int compiled = watched.compiled;
    draw(effect, &frame, &drawn);
    assert_true(watched.compiled > compiled);
    ew_destroy_effect(effect);
}

/* Or it would leave out a kind, a number of sources, or weights. */
static void a_shader_that_lacks_something_is_not_used(void **state)
{
    (void)state;
    expect_to_compile_beside(&(ew_mix){.line_count = EW_ANY_COUNT}, 2, 0, false);
    expect_to_compile_beside(&(ew_mix){.point_count = 1}, 2, 0, false);
    expect_to_compile_beside(&(ew_mix){.curve_count = EW_ANY_COUNT}, 0, 1, true);
}

/* A shader for sources that may have reaches, and sources that have none: either it draws these right, or another one does. */
static void a_shader_with_reaches_draws_sources_without(void **state)
{
    (void)state;
    static const ew_mix general = {.point_count = EW_ANY_COUNT,
                                   .line_count = EW_ANY_COUNT,
                                   .torus_count = EW_ANY_COUNT,
                                   .curve_count = EW_ANY_COUNT,
                                   .path_count = EW_ANY_COUNT,
                                   .has_weights = 1,
                                   .has_reach = 1,
                                   .has_sharpness = 1,
                                   .has_bends = 1};
    watched_gl_start(&watched, context);
    ew_effect *prepared = create_effect(), *plain = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    frame.quality = EW_QUALITY_ERROR_1E_4;
    prepare_until_ready(prepared, &general, &frame);
    for (int has_reach = 0; has_reach < 2; has_reach++) {
        field f;
        picture drawn, expected;
        make_field(&f, 2, 1, 1, 2, true);
        if (has_reach) f.points[0].reach = f.curves[1].reach = 2;
        assert_int_equal(ew_set_sources(prepared, &f.desc, NULL), EW_OK);
        assert_int_equal(ew_set_sources(plain, &f.desc, NULL), EW_OK);
        int compiled = watched.compiled;
        draw(prepared, &frame, &drawn);
        if (has_reach) assert_int_equal(watched.compiled, compiled);
        draw(plain, &frame, &expected);
        assert_true(picture_difference(&drawn, &expected) < 1e-4);
    }
    ew_destroy_effect(prepared);
    ew_destroy_effect(plain);
}

/* The calls that hand a shader to the driver. */
enum { COMPILE_AND_LINK = 2 };

/* With a driver that compiles on other threads, played by the loader. */
static void nothing_waits_for_a_compiler_that_is_at_work(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    watched.completion_delay = 3;
    ew_effect *effect = create_effect();
    field f;
    picture drawn, expected;
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    const ew_mix general = {.point_count = EW_ANY_COUNT};
    for (int i = 0; i < COMPILE_AND_LINK + watched.completion_delay; i++)
        assert_false(prepare(effect, &general, &frame));
    assert_true(prepare(effect, &general, &frame));

    /* While the shader for one point is under way, the general one draws. */
    set_field(effect, &f, 1, 0, 0, 0, false);
    for (int i = 0; i < COMPILE_AND_LINK; i++)
        assert_false(prepare(effect, NULL, &frame));
    draw(effect, &frame, &expected);
    for (int i = 0; i < watched.completion_delay; i++)
        assert_false(prepare(effect, NULL, &frame));
    assert_int_equal(watched.asked_too_early, 0);
    assert_true(prepare(effect, NULL, &frame));
    draw(effect, &frame, &drawn);
    assert_true(picture_difference(&drawn, &expected) < 1e-5);
    assert_int_equal(watched.asked_too_early, 0);

    /* A host that draws without having waited for anything that covers its sources does wait. */
    set_field(effect, &f, 0, 1, 0, 0, false);
    for (int i = 0; i < COMPILE_AND_LINK; i++)
        assert_false(prepare(effect, NULL, &frame));
    draw(effect, &frame, &drawn);
    assert_true(watched.asked_too_early > 0);
    ew_destroy_effect(effect);
}

/* A driver that compiles while it is called makes its caller wait; so a call does no more than one of these. */
static void a_call_compiles_links_or_draws(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    const ew_mix mix = {.torus_count = 2};
    static const struct {
        int compiled, linked, drawn;
    } after[] = {{2, 0, 0}, {2, 1, 0}, {2, 1, 1}};
    for (int i = 0; i < 3; i++) {
        int steps_left = -1;
        assert_int_equal(ew_prepare_step(effect, &mix, &frame, &steps_left, NULL), EW_OK);
        assert_int_equal(steps_left, 2 - i);
        assert_int_equal(watched.compiled, after[i].compiled);
        assert_int_equal(watched.linked, after[i].linked);
        assert_int_equal(watched.drawn, after[i].drawn);
    }
    ew_destroy_effect(effect);
}

/* Some drivers finish a shader only when it draws. Of all kinds of sources, a shader for each of the five parts and one for
 * their sum are compiled, and each makes its first draw in a call of its own. */
static void a_call_draws_with_one_shader_for_the_first_time(void **state)
{
    (void)state;
    enum { SHADERS = 6 };
    watched_gl_start(&watched, context);
    watched.completion_delay = 0;
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    const ew_mix mix = {.point_count = EW_ANY_COUNT,
                        .line_count = EW_ANY_COUNT,
                        .torus_count = EW_ANY_COUNT,
                        .curve_count = EW_ANY_COUNT,
                        .path_count = EW_ANY_COUNT,
                        .has_bends = 1};
    int steps_left = -1;
    for (int i = 0; i < COMPILE_AND_LINK; i++) {
        assert_int_equal(ew_prepare_step(effect, &mix, &frame, &steps_left, NULL), EW_OK);
        assert_int_equal(steps_left, (2 - i) * SHADERS);
    }
    assert_int_equal(watched.compiled, 2 * SHADERS);
    assert_int_equal(watched.linked, SHADERS);
    for (int drawn = 1; drawn <= SHADERS; drawn++) {
        assert_int_equal(ew_prepare_step(effect, &mix, &frame, &steps_left, NULL), EW_OK);
        assert_int_equal(steps_left, SHADERS - drawn);
        assert_int_equal(watched.drawn, drawn);
    }
    field f;
    picture drawn;
    set_field(effect, &f, 1, 1, 1, 1, false);
    draw(effect, &frame, &drawn);
    assert_int_equal(watched.compiled, 2 * SHADERS);
    ew_destroy_effect(effect);
}

static void an_effect_destroyed_while_it_compiles_loses_nothing(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    watched.completion_delay = 3;
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    for (int i = 0; i < COMPILE_AND_LINK; i++)
        assert_false(prepare(effect, &(ew_mix){.point_count = 1}, &frame));
    assert_true(watched.objects > 0);
    ew_destroy_effect(effect);
    assert_int_equal(watched.objects, 0);
}

/* Until it is ready, or fails. */
static ew_result prepare_to_the_end(ew_effect *effect, const ew_frame_desc *frame, int *is_ready, ew_error *error)
{
    ew_result result;
    do {
        int ready = 0;
        result = ew_prepare(effect, NULL, frame, &ready, error);
        if (ready) *is_ready = ready;
    } while (result == EW_OK && *is_ready != 1);
    return result;
}

/* The error says which shader, the effect is as before, and works as soon as the driver does. */
static void a_driver_that_refuses_a_shader_is_an_error(void **state)
{
    (void)state;
    static const char *const stages[] = {"vertex", "fragment"};
    debug_output_pause();
    for (int i = 0; i < 2; i++) {
        watched_gl_start(&watched, context);
        ew_effect *effect = create_effect();
        field f;
        set_field(effect, &f, 1, 0, 0, 0, false);
        ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
        int objects = watched.objects;
        watched.refused_stage = stages[i];
        for (int attempt = 0; attempt < 3; attempt++) {
            ew_error error = {.text = ""};
            int is_ready = -1;
            ew_result result =
                attempt == 1 ? ew_draw(effect, &frame, &error) : prepare_to_the_end(effect, &frame, &is_ready, &error);
            assert_int_equal(result, EW_ERROR_SHADER);
            assert_int_equal(error.code, EW_ERROR_SHADER);
            assert_int_equal(is_ready, -1);
            assert_non_null(strstr(error.text, stages[i]));
            assert_int_equal(watched.objects, objects);
        }
        assert_int_equal(gl.GetError(), GL_NO_ERROR);
        watched.refused_stage = NULL;
        picture drawn;
        draw(effect, &frame, &drawn);
        ew_destroy_effect(effect);
    }
    debug_output_resume();
}

static void what_cannot_be_drawn_cannot_be_prepared(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    int is_ready = -1;
    ew_error error = {.text = ""};
    assert_int_equal(ew_prepare(NULL, NULL, &frame, &is_ready, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_prepare(effect, NULL, NULL, &is_ready, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_prepare(effect, NULL, &frame, NULL, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "is_ready"));
    frame.viewport_width = 0;
    assert_int_equal(ew_prepare(effect, NULL, &frame, &is_ready, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "viewport_width"));
    assert_int_equal(is_ready, -1);
    assert_int_equal(watched.compiled, 0);
    ew_destroy_effect(effect);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    target = make_target(NULL);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_draw_of_what_was_prepared_compiles_nothing),
        cmocka_unit_test(the_loader_is_asked_only_while_an_effect_is_created),
        cmocka_unit_test(preparing_draws_nothing),
        cmocka_unit_test(a_general_shader_draws_any_sources_and_the_same_light),
        cmocka_unit_test(a_shader_that_lacks_something_is_not_used),
        cmocka_unit_test(a_shader_with_reaches_draws_sources_without),
        cmocka_unit_test(nothing_waits_for_a_compiler_that_is_at_work),
        cmocka_unit_test(a_call_compiles_links_or_draws),
        cmocka_unit_test(a_call_draws_with_one_shader_for_the_first_time),
        cmocka_unit_test(an_effect_destroyed_while_it_compiles_loses_nothing),
        cmocka_unit_test(a_driver_that_refuses_a_shader_is_an_error),
        cmocka_unit_test(what_cannot_be_drawn_cannot_be_prepared),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    close_context(context);
    return failed;
}
