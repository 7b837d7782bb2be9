/* Any number of sources: those that no uniform block takes are drawn like the others.
 *
 *     many_test CONTEXT    one of the names in context.h */
#include "canvas.h"
#include "glow.h"
#include "program_context.h"
#include "random_numbers.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A picture of several tiles, large enough for adaptive resolution. Half of the orbs fit into any block that OpenGL promises to
 * desktops, and a tenth into any that OpenGL ES does. */
enum { WIDTH = 288, HEIGHT = 240, VALUES = WIDTH * HEIGHT * 4, ORBS = 2500, PARTS = 10 };

static gl_context *context;
static canvas target;

static ew_effect *create(void)
{
    ew_effect *effect;
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    assert_int_equal(ew_create_effect(&desc, &effect, NULL), EW_OK);
    return effect;
}

/* Small orbs all over the view, or with a reach of 0 orbs without end. */
static void make_orbs(ew_point orbs[ORBS], double reach)
{
    uint64_t random = 5;
    for (int i = 0; i < ORBS; i++) {
        orbs[i] = (ew_point){.coefficient = 0.01, .core = 0.01, .reach = reach};
        for (int axis = 0; axis < 3; axis++) {
            orbs[i].position[axis] = random_between(&random, -2, 2);
            orbs[i].color[axis] = random_between(&random, 0, 1);
        }
    }
}

static ew_frame_desc make_frame(bool has_interval, ew_resolution resolution)
{
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.output = EW_OUTPUT_ADD;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.resolution = resolution;
    frame.depth_source = EW_DEPTH_TEXTURE;
    frame.depth_texture = 0;
    frame.interval_start = has_interval ? 1 : 0;
    frame.interval_end = has_interval ? 12 : 0;
    return frame;
}

/* Adds the light of `count` orbs to the target. */
static void add_light(ew_effect *effect, const ew_point *orbs, size_t count, const ew_frame_desc *frame)
{
    const ew_sources_desc desc = {.points = orbs, .point_count = count, .epsilon = 0.01};
    ew_error error = {EW_OK, ""};
    if (ew_set_sources(effect, &desc, &error) != EW_OK) fail_msg("%s", error.text);
    glow_draw(effect, frame);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

/* All at once against part by part. */
static void expect_the_sum_of_parts(double reach, bool has_interval, ew_resolution resolution, double bound)
{
    static const GLfloat black[4] = {0, 0, 0, 0};
    ew_point *orbs = malloc(ORBS * sizeof *orbs);
    GLfloat *sum = malloc(VALUES * sizeof *sum), *whole = malloc(VALUES * sizeof *whole);
    assert_true(orbs && sum && whole);
    make_orbs(orbs, reach);
    ew_effect *effect = create();
    ew_frame_desc frame = make_frame(has_interval, EW_RESOLUTION_FULL);
    canvas_clear(&target, black);
    for (int part = 0; part < PARTS; part++)
        add_light(effect, orbs + part * (ORBS / PARTS), ORBS / PARTS, &frame);
    canvas_read(&target, sum);
    frame.resolution = resolution;
    canvas_clear(&target, black);
    add_light(effect, orbs, ORBS, &frame);
    canvas_read(&target, whole);
    double peak = 0;
    for (int i = 0; i < VALUES; i++)
        peak = fmax(peak, (double)sum[i]);
    assert_true(peak > 0);
    for (int i = 0; i < VALUES; i++) {
        double off = fabs((double)whole[i] - (double)sum[i]);
        if (!(off <= bound * fmax((double)sum[i], 0.03 * peak)))
            fail_msg("channel %d of pixel (%d, %d) is %g instead of %g", i % 4, i / 4 % WIDTH, i / 4 / WIDTH, (double)whole[i],
                     (double)sum[i]);
    }
    ew_destroy_effect(effect);
    free(orbs);
    free(sum);
    free(whole);
}

static void what_reaches_only_so_far_adds_up(void **state)
{
    (void)state;
    expect_the_sum_of_parts(0.3, false, EW_RESOLUTION_FULL, 1e-4);
    expect_the_sum_of_parts(0.3, true, EW_RESOLUTION_FULL, 1e-4);
}

static void what_has_no_end_adds_up(void **state)
{
    (void)state;
    expect_the_sum_of_parts(0, true, EW_RESOLUTION_FULL, 1e-4);
}

static void it_does_so_at_adaptive_resolution(void **state)
{
    (void)state;
    /* 1e-3 of B, of which a channel has half on average. */
    expect_the_sum_of_parts(0.3, false, EW_RESOLUTION_ADAPTIVE, 2e-3);
    expect_the_sum_of_parts(0, true, EW_RESOLUTION_ADAPTIVE, 2e-3);
}

/* The texture of sources is filled whatever the host has set, and leaves that as it was. */
static void the_host_s_way_to_store_pixels_does_not_matter(void **state)
{
    static const struct {
        GLenum name;
        GLint value;
    } odd[] = {{GL_UNPACK_ALIGNMENT, 8}, {GL_UNPACK_ROW_LENGTH, 7}, {GL_UNPACK_SKIP_ROWS, 3}, {GL_UNPACK_SKIP_PIXELS, 2}};
    GLuint buffer;
    (void)state;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++)
        gl.PixelStorei(odd[i].name, odd[i].value);
    expect_the_sum_of_parts(0.3, false, EW_RESOLUTION_FULL, 1e-4);
    for (size_t i = 0; i < sizeof odd / sizeof odd[0]; i++) {
        GLint value = 0;
        gl.GetIntegerv(odd[i].name, &value);
        assert_int_equal(value, odd[i].value);
        gl.PixelStorei(odd[i].name, i == 0 ? 4 : 0);
    }
    GLint bound = 0;
    gl.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &bound);
    assert_int_equal(bound, buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl.DeleteBuffers(1, &buffer);
}

/* Shaders of the host's have only the block. */
static void the_buffer_of_the_host_s_shaders_takes_no_more_than_a_block(void **state)
{
    (void)state;
    GLint block_size = 0;
    gl.GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &block_size);
    const size_t too_many = (size_t)block_size / (3 * 16);
    ew_point *orbs = calloc(too_many, sizeof *orbs);
    assert_non_null(orbs);
    for (size_t i = 0; i < too_many; i++)
        orbs[i] = (ew_point){.coefficient = 0.01, .core = 0.01, .reach = 0.3};
    ew_sources_desc desc = {.points = orbs, .point_count = too_many, .epsilon = 0.01};
    ew_effect *effect = create();
    const ew_frame_desc frame = make_frame(false, EW_RESOLUTION_FULL);
    unsigned name = 0;
    ew_error error = {EW_OK, ""};
    assert_int_equal(ew_set_sources(effect, &desc, NULL), EW_OK);
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &name, &error), EW_ERROR_TOO_MANY_SOURCES);
    assert_non_null(strstr(error.text, "uniform block"));
    assert_int_equal(name, 0);
    desc.point_count = 200;
    assert_int_equal(ew_set_sources(effect, &desc, NULL), EW_OK);
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &name, &error), EW_OK);
    ew_destroy_effect(effect);
    free(orbs);
}

int main(int argc, char **argv)
{
    if (argc != 2) return 2;
    context = open_context(argv[1], NULL);
    if (context == NULL) return 2;
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, 0, 0);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_reaches_only_so_far_adds_up),
        cmocka_unit_test(what_has_no_end_adds_up),
        cmocka_unit_test(it_does_so_at_adaptive_resolution),
        cmocka_unit_test(the_host_s_way_to_store_pixels_does_not_matter),
        cmocka_unit_test(the_buffer_of_the_host_s_shaders_takes_no_more_than_a_block),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    canvas_destroy(&target);
    close_context(context);
    return failed;
}
