/* How long the first draw takes, once its shader was prepared.
 *
 *     first_draw_test CONTEXT    one of the names in context.h */
#include "effect_fixture.h"
#include "program_context.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <time.h>

static gl_context *context;
static GLuint target;

/* Of a curve, with weights or without: two shaders of about the same length. */
static ew_effect *create_effect(bool weighted)
{
    ew_effect *effect = NULL;
    field f;
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    make_field(&f, 0, 0, 0, 1, weighted);
    assert_int_equal(ew_create_effect(&desc, &effect, NULL), EW_OK);
    assert_int_equal(ew_set_sources(effect, &f.desc, NULL), EW_OK);
    return effect;
}

static double seconds_of_draw(ew_effect *effect, const ew_frame_desc *frame)
{
    struct timespec start, end;
    timespec_get(&start, TIME_UTC);
    assert_int_equal(ew_draw(effect, frame, NULL), EW_OK);
    gl.Finish();
    timespec_get(&end, TIME_UTC);
    return (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec);
}

/* Some drivers finish a shader only when it draws: that, too, must have happened before. */
static void what_was_prepared_draws_at_once(void **state)
{
    (void)state;
    ew_effect *unprepared = create_effect(false), *prepared = create_effect(true);
    const ew_frame_desc frame = make_frame(target, EW_OUTPUT_LERP);
    double without = seconds_of_draw(unprepared, &frame);
    int is_ready = 0;
    while (!is_ready)
        assert_int_equal(ew_prepare(prepared, NULL, &frame, &is_ready, NULL), EW_OK);
    gl.Finish();
    double with = seconds_of_draw(prepared, &frame);
    print_message("first draw: %.1f ms unprepared, %.1f ms prepared\n", 1e3 * without, 1e3 * with);
    assert_true(with < without / 4);
    ew_destroy_effect(unprepared);
    ew_destroy_effect(prepared);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    target = make_target(NULL);
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_was_prepared_draws_at_once)};
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    close_context(context);
    return failed;
}
