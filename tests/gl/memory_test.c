/* The memory and the objects of effects: what the host's allocator gives and refuses, and what is left after a thousand lives.
 *
 *     memory_test CONTEXT    one of the names in context.h */
#include "effect_fixture.h"
#include "program_context.h"
#include "watched_gl.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

static gl_context *context;
static GLuint target;
static watched_gl watched;

/* Counts, and refuses one allocation. */
typedef struct ration {
    int allocations; /* asked for so far */
    int refused;     /* which one, from 0 on; -1: none */
    int live;
    size_t live_bytes;
} ration;

typedef union block_header {
    size_t size;
    max_align_t aligned;
} block_header;

static void *allocate(void *user, size_t size)
{
    ration *given = user;
    assert_true(size > 0);
    if (given->allocations++ == given->refused) return NULL;
    block_header *block = malloc(sizeof *block + size);
    assert_non_null(block);
    memset(block + 1, 0xA5, size); /* whoever relies on zeros is found */
    block->size = size;
    given->live++;
    given->live_bytes += size;
    return block + 1;
}

static void deallocate(void *user, void *memory)
{
    ration *given = user;
    assert_non_null(memory);
    block_header *block = (block_header *)memory - 1;
    given->live--;
    given->live_bytes -= block->size;
    memset(memory, 0xEE, block->size); /* and whoever still looks */
    free(block);
}

static ew_result create_effect(ration *given, ew_effect **effect, ew_error *error)
{
    const ew_allocator allocator = {allocate, deallocate, given};
    const ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address, .allocator = &allocator};
    return ew_create_effect(&desc, effect, error);
}

/* ---- Out of memory ---------------------------------------------------------------------------------------------------------
 */

/* A life in which one allocation is refused. The call that it hits must say so and change nothing; then it succeeds. */
typedef struct life {
    ew_effect *effect;
    ration given;
    int failures;
} life;

static bool has_failed(life *l, ew_result result, const ew_error *error)
{
    if (result == EW_OK) return false;
    assert_int_equal(result, EW_ERROR_OUT_OF_MEMORY);
    assert_int_equal(error->code, EW_ERROR_OUT_OF_MEMORY);
    assert_non_null(strstr(error->text, "memory"));
    l->failures++;
    return true;
}

static void draw(life *l, ew_output output, picture *drawn)
{
    const ew_frame_desc frame = make_frame(target, output);
    ew_error error = {.text = ""};
    picture cleared;
    clear_target(target);
    read_target(target, &cleared);
    int objects = watched.objects;
    if (has_failed(l, ew_draw(l->effect, &frame, &error), &error)) {
        assert_int_equal(watched.objects, objects);
        read_target(target, drawn);
        assert_memory_equal(drawn, &cleared, sizeof cleared);
        assert_int_equal(ew_draw(l->effect, &frame, &error), EW_OK);
    }
    read_target(target, drawn);
}

static void set_points(life *l, size_t points)
{
    field f;
    ew_error error = {.text = ""};
    picture before, after;
    make_field(&f, points, 0, 0, 0, false);
    if (points >= 3) f.points[0].reach = 2;
    draw(l, EW_OUTPUT_ADD, &before);
    if (has_failed(l, ew_set_sources(l->effect, &f.desc, &error), &error)) {
        draw(l, EW_OUTPUT_ADD, &after);
        assert_memory_equal(&before, &after, sizeof before);
        assert_int_equal(ew_set_sources(l->effect, &f.desc, &error), EW_OK);
    }
    draw(l, EW_OUTPUT_ADD, &after);
    assert_memory_not_equal(&before, &after, sizeof before);
}

static const ew_frame_desc frame_of_text = EW_FRAME_DEFAULTS;

static void get_text(life *l, const ew_mix *mix, const char **text)
{
    static char copy[1 << 17];
    const char *before = *text;
    ew_error error = {.text = ""};
    if (before) memcpy(copy, before, strlen(before) + 1);
    if (!has_failed(l, ew_get_shader_text(l->effect, mix, &frame_of_text, text, &error), &error)) return;
    assert_ptr_equal(*text, before);
    if (before) assert_string_equal(before, copy);
    assert_int_equal(ew_get_shader_text(l->effect, mix, &frame_of_text, text, &error), EW_OK);
}

static void any_allocation_may_fail_and_changes_nothing(void **state)
{
    (void)state;
    for (int refused = 0;; refused++) {
        watched_gl_start(&watched, context);
        life l = {.given = {.refused = refused}};
        ew_error error = {.text = ""};
        if (has_failed(&l, create_effect(&l.given, &l.effect, &error), &error)) {
            assert_null(l.effect);
            assert_int_equal(l.given.live, 0);
            assert_int_equal(watched.objects, 0);
            continue;
        }
        /* Each output of no point, one, several, and several with a reach is a program: more than there is room for at first.
         */
        for (size_t points = 1; points <= 5; points++) {
            picture drawn;
            set_points(&l, points);
            draw(&l, EW_OUTPUT_LUMINANCE, &drawn);
            draw(&l, EW_OUTPUT_SOFT, &drawn);
        }
        const char *text = NULL;
        get_text(&l, NULL, &text);
        get_text(&l, &(ew_mix){.line_count = 1}, &text);
        ew_destroy_effect(l.effect);
        assert_int_equal(l.given.live, 0);
        assert_int_equal(watched.objects, 0);
        if (l.failures == 0) {
            print_message("%d allocations\n", l.given.allocations);
            assert_true(refused >= 1 + 5 + 2 + 3 + 2); /* the effect, its sources, programs, lists and texts */
            return;
        }
        assert_int_equal(l.failures, 1);
    }
}

/* ---- Frame by frame
 * ---------------------------------------------------------------------------------------------------------- */

static void sources_change_every_frame_without_an_allocation(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    life l = {.given = {.refused = -1}};
    assert_int_equal(create_effect(&l.given, &l.effect, NULL), EW_OK);
    const ew_mix any = {.point_count = EW_ANY_COUNT, .curve_count = EW_ANY_COUNT, .has_weights = 1};
    const ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    int is_ready = 0;
    while (!is_ready)
        assert_int_equal(ew_prepare(l.effect, &any, &frame, &is_ready, NULL), EW_OK);
    field f;
    make_field(&f, FIELD_SIZE, 0, 0, FIELD_SIZE, true);
    assert_int_equal(ew_set_sources(l.effect, &f.desc, NULL), EW_OK);
    int before = l.given.allocations;
    for (size_t i = 0; i < 20; i++) {
        picture drawn;
        make_field(&f, i % (FIELD_SIZE + 1), 0, 0, 3 * i % (FIELD_SIZE + 1), i % 2);
        assert_int_equal(ew_set_sources(l.effect, &f.desc, NULL), EW_OK);
        f.points[0].coefficient = -1;
        if (f.desc.point_count > 0) assert_int_equal(ew_set_sources(l.effect, &f.desc, NULL), EW_ERROR_INVALID_ARGUMENT);
        draw(&l, EW_OUTPUT_ADD, &drawn);
    }
    assert_int_equal(l.given.allocations, before);
    ew_destroy_effect(l.effect);
    assert_int_equal(l.given.live, 0);
}

static ew_gl_function lacks_a_function(void *user, const char *name)
{
    return strcmp(name, "glDrawArrays") == 0 ? NULL : watched_gl_get_proc_address(user, name);
}

static void an_effect_that_is_refused_leaves_nothing(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ration given = {.refused = -1};
    const ew_allocator allocator = {allocate, deallocate, &given};
    const ew_effect_desc desc = {.get_proc_address = lacks_a_function, .allocator = &allocator};
    ew_effect *effect = NULL;
    assert_int_equal(ew_create_effect(&desc, &effect, NULL), EW_ERROR_MISSING_FUNCTION);
    assert_null(effect);
    assert_int_equal(given.live, 0);
    assert_int_equal(watched.objects, 0);
}

static void an_allocator_needs_both_functions(void **state)
{
    (void)state;
    const ew_allocator halves[] = {{.allocate = allocate}, {.deallocate = deallocate}};
    for (int i = 0; i < 2; i++) {
        ew_effect *effect = NULL;
        ew_error error = {.text = ""};
        const ew_effect_desc desc = {.get_proc_address = watched_gl_get_proc_address, .allocator = &halves[i]};
        assert_int_equal(ew_create_effect(&desc, &effect, &error), EW_ERROR_INVALID_ARGUMENT);
        assert_non_null(strstr(error.text, "allocator"));
        assert_null(effect);
    }
}

/* ---- Life by life
 * -------------------------------------------------------------------------------------------------------------- */

static void a_thousand_lives_leave_no_object_and_no_byte(void **state)
{
    (void)state;
    enum { LIVES = 1000 };
    watched_gl_start(&watched, context);
    ration given = {.refused = -1};
    const ew_point point = {.coefficient = 0.1, .color = {1, 1, 1}};
    ew_sources_desc sources = {.points = &point, .epsilon = 0.1};
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER; /* whose copy has objects of its own */
    for (int i = 0; i < LIVES; i++) {
        ew_effect *effect = NULL;
        unsigned buffer;
        const char *text;
        sources.point_count = i % 50 == 0; /* mostly none: their shader is compiled in no time */
        assert_int_equal(create_effect(&given, &effect, NULL), EW_OK);
        assert_int_equal(ew_set_sources(effect, &sources, NULL), EW_OK);
        assert_int_equal(ew_draw(effect, &frame, NULL), EW_OK);
        assert_int_equal(ew_get_shader_text(effect, NULL, &frame_of_text, &text, NULL), EW_OK);
        assert_int_equal(ew_update_uniform_buffer(effect, &frame, &buffer, NULL), EW_OK);
        assert_true(given.live > 0 && watched.objects > 0);
        ew_destroy_effect(effect);
        assert_int_equal(given.live, 0);
        assert_int_equal(given.live_bytes, 0);
        assert_int_equal(watched.objects, 0);
    }
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

/* A lost context has taken the effect's objects with it, and their names may be other objects' by now. */
static void an_abandoned_effect_leaves_no_byte_and_touches_no_object(void **state)
{
    (void)state;
    watched_gl_start(&watched, context);
    ration given = {.refused = -1};
    ew_effect *effect = NULL;
    assert_int_equal(create_effect(&given, &effect, NULL), EW_OK);
    field f;
    const char *text;
    ew_frame_desc frame = make_frame(target, EW_OUTPUT_ADD);
    make_field(&f, 2, 1, 0, 1, true);
    assert_int_equal(ew_set_sources(effect, &f.desc, NULL), EW_OK);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    assert_int_equal(ew_draw(effect, &frame, NULL), EW_OK);
    assert_int_equal(ew_get_shader_text(effect, NULL, &frame, &text, NULL), EW_OK);
    const int objects = watched.objects;
    assert_true(objects > 0);
    context_make_current(NULL);
    ew_abandon_effect(effect);
    ew_abandon_effect(NULL);
    context_make_current(context);
    assert_int_equal(watched.objects, objects);
    assert_int_equal(given.live, 0);
    assert_int_equal(given.live_bytes, 0);
}

static void add_depth(GLuint framebuffer)
{
    GLuint depth;
    gl.GenRenderbuffers(1, &depth);
    gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, PICTURE_WIDTH, PICTURE_HEIGHT);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    gl.ClearDepthf(1.0f);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    target = make_target(NULL);
    add_depth(target);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_allocation_may_fail_and_changes_nothing),
        cmocka_unit_test(sources_change_every_frame_without_an_allocation),
        cmocka_unit_test(an_effect_that_is_refused_leaves_nothing),
        cmocka_unit_test(an_allocator_needs_both_functions),
        cmocka_unit_test(a_thousand_lives_leave_no_object_and_no_byte),
        cmocka_unit_test(an_abandoned_effect_leaves_no_byte_and_touches_no_object),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    close_context(context);
    return failed;
}
