/* What hosts of other habits than the samples' ask for: it is served, or refused by name, and never dark without an error.
 *
 *     hosts_test CONTEXT    one of the names in context.h */
#include "canvas.h"
#include "glow.h"
#include "program_context.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

enum { WIDTH = GLOW_WIDTH, HEIGHT = GLOW_HEIGHT };

typedef GLfloat picture[HEIGHT][WIDTH][4];

static gl_context *context;
static ew_effect *effect;
static canvas target; /* RGBA32F, with depth and stencil */

static const GLfloat black[4] = {0, 0, 0, 1};

/* Draws the luminance. */
static void measure(const ew_frame_desc *frame, picture measured)
{
    ew_frame_desc measuring = *frame;
    measuring.output = EW_OUTPUT_LUMINANCE;
    canvas_clear(&target, black);
    glow_draw(effect, &measuring);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    canvas_read(&target, &measured[0][0][0]);
}

static void expect_equal(double found, double expected)
{
    if (!(fabs(found - expected) <= 1e-5 * fmax(1, expected))) fail_msg("%g is not %g", found, expected);
}

/* ---- The clip origin ---- */

static bool has_clip_control(void)
{
    return api_has(45, NEVER, gl.es ? "GL_EXT_clip_control" : "GL_ARB_clip_control");
}

/* What is opaque covers the lowest third of what the camera sees. */
static void measure_with_origin(GLenum origin, picture measured)
{
    const glow_lens lens = {.left = -0.4, .right = 0.4, .bottom = -0.2, .top = 0.4};
    ew_frame_desc frame = glow_frame(target.framebuffer);
    glow_projection(&lens, -1.02, -1.01, frame.projection);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    const GLint lowest[4] = {0, origin == GL_UPPER_LEFT ? HEIGHT - HEIGHT / 3 : 0, WIDTH, HEIGHT / 3};
    canvas_clear_depth(&target, 1, lowest, 0.9f);
    gl.ClipControl(origin, GL_NEGATIVE_ONE_TO_ONE);
    measure(&frame, measured);
    gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

static void the_light_is_turned_over_with_the_clip_origin(void **unused)
{
    (void)unused;
    if (!has_clip_control()) return;
    static picture upright, turned;
    measure_with_origin(GL_LOWER_LEFT, upright);
    measure_with_origin(GL_UPPER_LEFT, turned);
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++)
            expect_equal((double)turned[HEIGHT - 1 - row][column][0], (double)upright[row][column][0]);
}

static void bounds_are_turned_over_with_the_clip_origin(void **unused)
{
    (void)unused;
    if (!has_clip_control()) return;
    const ew_point orb = {.position = {0.5, 1, 0}, .brightness = 1, .core = 0.1, .reach = 0.5};
    assert_int_equal(ew_set_sources(effect, &(ew_sources_desc){.points = &orb, .point_count = 1}, NULL), EW_OK);
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.interval_start = frame.interval_end = 0;
    ew_bounds upright, turned;
    assert_int_equal(ew_get_bounds(effect, &frame, &upright, NULL), EW_OK);
    gl.ClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    assert_int_equal(ew_get_bounds(effect, &frame, &turned, NULL), EW_OK);
    gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    assert_int_equal(turned.x, upright.x);
    assert_int_equal(turned.y, HEIGHT - (upright.y + upright.height));
    assert_int_equal(turned.height, upright.height);
    assert_true(upright.y > HEIGHT / 2);
    assert_int_equal(ew_set_sources(effect, &glow_sources, NULL), EW_OK);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    effect = glow_create(context);
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH24_STENCIL8, 0);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_light_is_turned_over_with_the_clip_origin),
        cmocka_unit_test(bounds_are_turned_over_with_the_clip_origin),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    canvas_destroy(&target);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
