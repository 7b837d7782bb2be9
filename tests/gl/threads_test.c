/* Effects on several threads, and in contexts that share their objects: the rules of the header.
 *
 *     threads_test CONTEXT    one of the names in context.h */
#include "debug_output.h"
#include "effect_fixture.h"
#include "program_context.h"
#include "watched_gl.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

static const char *kind;
static gl_context *context;
static GLuint target, renderbuffer;

static ew_effect *create_effect(const ew_effect_desc *desc, size_t points, size_t lines)
{
    ew_effect *effect = NULL;
    field f;
    make_field(&f, points, lines, 0, 0, false);
    if (ew_create_effect(desc, &effect, NULL) != EW_OK || ew_set_sources(effect, &f.desc, NULL) != EW_OK) return NULL;
    return effect;
}

static bool draw(ew_effect *effect, GLuint framebuffer, picture *drawn)
{
    const ew_frame_desc frame = make_frame(framebuffer, EW_OUTPUT_ADD);
    ew_error error = {.text = ""};
    clear_target(framebuffer);
    bool ok = ew_draw(effect, &frame, &error) == EW_OK;
    if (!ok) fprintf(stderr, "%s\n", error.text);
    read_target(framebuffer, drawn);
    return ok && gl.GetError() == GL_NO_ERROR;
}

/* ---- Two contexts, two threads ---------------------------------------------------------------------------------------------
 */

enum { ROUNDS = 40, SOURCE_COUNTS = 2 };

typedef struct painter {
    gl_context *context;
    size_t first_kind; /* of the sources in its first round */
    const picture *expected;
    pthread_barrier_t *start;
    int wrong; /* rounds */
} painter;

/* The sources change in each round, between a few that were compiled for. */
static void *paint(void *argument)
{
    painter *self = argument;
    context_make_current(self->context);
    GLuint own_target = make_target(NULL);
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = self->context};
    ew_effect *effect = create_effect(&desc, 0, 0);
    pthread_barrier_wait(self->start);
    for (size_t round = 0; round < ROUNDS; round++) {
        size_t sources = (round + self->first_kind) % SOURCE_COUNTS;
        field f;
        picture drawn;
        make_field(&f, sources, 1 - sources, 0, 0, false);
        bool ok = ew_set_sources(effect, &f.desc, NULL) == EW_OK && draw(effect, own_target, &drawn);
        self->wrong += !ok || memcmp(&drawn, &self->expected[sources], sizeof drawn) != 0;
    }
    ew_destroy_effect(effect);
    context_make_current(NULL);
    return NULL;
}

static void two_effects_draw_at_once_on_two_threads(void **state)
{
    (void)state;
    context_make_current(context);
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    picture expected[SOURCE_COUNTS];
    for (size_t i = 0; i < SOURCE_COUNTS; i++) {
        ew_effect *effect = create_effect(&desc, i, 1 - i);
        assert_non_null(effect);
        assert_true(draw(effect, target, &expected[i]));
        ew_destroy_effect(effect);
    }
    assert_memory_not_equal(&expected[0], &expected[1], sizeof expected[0]);

    pthread_barrier_t start;
    assert_int_equal(pthread_barrier_init(&start, NULL, 2), 0);
    painter painters[2];
    pthread_t threads[2];
    for (size_t i = 0; i < 2; i++) {
        painters[i] = (painter){open_context(kind, NULL), i, expected, &start, 0};
        assert_non_null(painters[i].context);
        context_make_current(NULL);
    }
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(pthread_create(&threads[i], NULL, paint, &painters[i]), 0);
    for (size_t i = 0; i < 2; i++)
        assert_int_equal(pthread_join(threads[i], NULL), 0);
    pthread_barrier_destroy(&start);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(painters[i].wrong, 0);
        context_destroy(painters[i].context);
    }
    context_make_current(context);
}

/* ---- Contexts that share objects -------------------------------------------------------------------------------------------
 */

static watched_gl watched;
static ew_effect *loaded;

/* A loader's thread, with a context and a framebuffer of its own: creates, compiles, and is gone. */
static void *load(void *argument)
{
    gl_context *own = argument;
    context_make_current(own);
    GLuint own_target = make_framebuffer_of(renderbuffer);
    const ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address};
    const ew_frame_desc frame = make_frame(own_target, EW_OUTPUT_ADD);
    int is_ready = 0;
    loaded = create_effect(&desc, 1, 1);
    while (loaded && !is_ready && ew_prepare(loaded, NULL, &frame, &is_ready, NULL) == EW_OK)
        continue;
    gl.Finish();
    context_make_current(NULL);
    return NULL;
}

static void an_effect_prepared_on_one_thread_draws_on_another(void **state)
{
    (void)state;
    context_make_current(context);
    debug_output_pause(); /* Mesa says that it finishes shaders anew for each context */
    gl_context *shared = open_context(kind, context);
    assert_non_null(shared);
    context_make_current(context);
    watched_gl_start(&watched, context);
    pthread_t thread;
    assert_int_equal(pthread_create(&thread, NULL, load, shared), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    assert_non_null(loaded);
    int compiled = watched.compiled;
    assert_true(compiled > 0);
    picture drawn, expected;
    assert_true(draw(loaded, target, &drawn));
    assert_int_equal(watched.compiled, compiled);
    ew_destroy_effect(loaded);
    assert_int_equal(watched.objects, 0);

    const ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address};
    ew_effect *effect = create_effect(&desc, 1, 1);
    assert_true(draw(effect, target, &expected));
    assert_memory_equal(&drawn, &expected, sizeof drawn);
    ew_destroy_effect(effect);
    context_destroy(shared);
    debug_output_resume();
}

/* Framebuffers and vertex arrays are not shared. */
static void an_effect_goes_to_and_fro_between_contexts(void **state)
{
    (void)state;
    context_make_current(context);
    debug_output_pause();
    gl_context *contexts[2] = {context, open_context(kind, context)};
    GLuint framebuffers[2];
    assert_non_null(contexts[1]);
    GLuint depth;
    gl.GenRenderbuffers(1, &depth);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, PICTURE_WIDTH, PICTURE_HEIGHT);
    gl.Finish();
    for (int i = 0; i < 2; i++) {
        context_make_current(contexts[i]);
        framebuffers[i] = make_framebuffer_of(renderbuffer);
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffers[i]);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
        gl.ClearDepthf(1.0f);
        gl.Clear(GL_DEPTH_BUFFER_BIT);
        gl.Finish();
    }
    watched_gl_start(&watched, context);
    const ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address};
    ew_effect *effect = create_effect(&desc, 1, 0);
    assert_non_null(effect);
    static const ew_depth_source sources[] = {EW_DEPTH_TEXTURE, EW_DEPTH_FRAMEBUFFER};
    picture expected, drawn;
    for (int i = 0; i < 6; i++) {
        int current = i % 2;
        context_make_current(contexts[current]);
        ew_frame_desc frame = make_frame(framebuffers[current], EW_OUTPUT_ADD);
        frame.depth_source = sources[i / 2 % 2];
        ew_error error = {.text = ""};
        clear_target(framebuffers[current]);
        if (ew_draw(effect, &frame, &error) != EW_OK) fail_msg("%s", error.text);
        read_target(framebuffers[current], &drawn);
        assert_int_equal(gl.GetError(), GL_NO_ERROR);
        if (i == 0) expected = drawn;
        assert_memory_equal(&drawn, &expected, sizeof drawn);
        gl.Finish();
    }
    context_make_current(contexts[1]);
    ew_destroy_effect(effect);
    assert_int_equal(watched.objects, 0);
    gl.DeleteRenderbuffers(1, &depth);
    context_make_current(contexts[0]);
    context_destroy(contexts[1]);
    debug_output_resume();
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(kind = argv[1], NULL)) == NULL) return 2;
    target = make_target(&renderbuffer);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_effects_draw_at_once_on_two_threads),
        cmocka_unit_test(an_effect_prepared_on_one_thread_draws_on_another),
        cmocka_unit_test(an_effect_goes_to_and_fro_between_contexts),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(kind, tests, NULL, NULL);
    close_context(context);
    return failed;
}
