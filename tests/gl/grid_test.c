/* Adaptive resolution draws what full resolution does, to targets of every kind.
 *
 *     grid_test CONTEXT    one of the names in context.h */
#include "canvas.h"
#include "glow.h"
#include "program_context.h"
#include "scramble.h" /* build_program */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* A viewport that is large enough, whose sides are no multiples of a cell, and that begins within the target. */
enum { WIDTH = 320, HEIGHT = 256, VALUES = WIDTH * HEIGHT * 4, SAMPLES = 4 };
static const GLint viewport[4] = {7, 5, 301, 243};

static gl_context *context;
static ew_effect *effect;
static GLuint triangle, vertex_array;

/* Of all frames. */
static ew_fog fog;

static ew_frame_desc frame_to(const canvas *to, ew_output output, ew_resolution resolution)
{
    ew_frame_desc frame = glow_frame(to->framebuffer);
    frame.viewport_x = viewport[0];
    frame.viewport_y = viewport[1];
    frame.viewport_width = viewport[2];
    frame.viewport_height = viewport[3];
    frame.output = output;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    frame.resolution = resolution;
    frame.fog = fog;
    return frame;
}

/* Draws an opaque triangle over a background. Its edges run through pixels, and the light is before and behind it. */
static void draw_opaque(const canvas *to)
{
    static const GLfloat background[4] = {0.3f, 0.2f, 0.1f, 0.5f};
    canvas_clear(to, background);
    canvas_clear_depth(to, 1, (const GLint[4]){0, 0, 0, 0}, 1);
    gl.BindFramebuffer(GL_FRAMEBUFFER, to->framebuffer);
    gl.Viewport(0, 0, WIDTH, HEIGHT);
    gl.BindVertexArray(vertex_array);
    gl.UseProgram(triangle);
    gl.Enable(GL_DEPTH_TEST);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Disable(GL_DEPTH_TEST);
    gl.UseProgram(0);
    gl.BindVertexArray(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void draw(const canvas *to, ew_output output, ew_resolution resolution, const canvas *resolved, GLfloat picture[VALUES])
{
    const ew_frame_desc frame = frame_to(to, output, resolution);
    draw_opaque(to);
    glow_draw(effect, &frame);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    if (resolved != to) canvas_resolve(to, resolved);
    canvas_read(resolved, picture);
}

/* Every value is within twice the bound of B, as the composite may count an error in B and in a colour, or a step of the
 * target; and at least so many differ, or nothing was interpolated. */
static void expect_alike(const GLfloat full[VALUES], const GLfloat adaptive[VALUES], double step, int least_different)
{
    double peak = 0;
    int different = 0;
    for (int i = 0; i < VALUES; i++)
        peak = fmax(peak, fabs((double)full[i]));
    for (int i = 0; i < VALUES; i++) {
        double off = fabs((double)adaptive[i] - (double)full[i]), value = fabs((double)full[i]);
        different += off > 0;
        if (!(off <= 2e-3 * fmax(value, 0.03 * peak) + step))
            fail_msg("channel %d of pixel (%d, %d) is %g instead of %g", i % 4, i / 4 % WIDTH, i / 4 / WIDTH,
                     (double)adaptive[i], (double)full[i]);
    }
    assert_true(different >= least_different);
}

static void compare_outputs(const canvas *to, const canvas *resolved, double step, int least_different)
{
    static GLfloat full[VALUES], adaptive[VALUES];
    const ew_output outputs[] = {EW_OUTPUT_LERP, EW_OUTPUT_ADD, EW_OUTPUT_SOFT, EW_OUTPUT_LUMINANCE};
    for (size_t i = 0; i < sizeof outputs / sizeof outputs[0]; i++) {
        draw(to, outputs[i], EW_RESOLUTION_FULL, resolved, full);
        draw(to, outputs[i], EW_RESOLUTION_ADAPTIVE, resolved, adaptive);
        expect_alike(full, adaptive, step, least_different);
    }
}

static void compare_on_a_part(void)
{
    canvas to = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH_COMPONENT24, 0);
    compare_outputs(&to, &to, 0, 1000);
    canvas_destroy(&to);
}

static void every_output_is_alike_on_a_part_of_a_target(void **unused)
{
    (void)unused;
    compare_on_a_part();
}

static void compare_samples(int least_different)
{
    canvas to = canvas_create(WIDTH, HEIGHT, GL_RGBA8, GL_DEPTH_COMPONENT24, SAMPLES);
    canvas resolved = canvas_create(WIDTH, HEIGHT, GL_RGBA8, 0, 0);
    compare_outputs(&to, &resolved, 1.01 / 255, least_different);
    canvas_destroy(&to);
    canvas_destroy(&resolved);
}

static void every_sample_of_a_target_is_alike(void **unused)
{
    (void)unused;
    compare_samples(1);
}

/* Even and by height, on targets of a sample and of many, whose 8 bits may not tell the difference. */
static void targets_of_every_kind_are_alike_in_fog(void **unused)
{
    (void)unused;
    fog = (ew_fog){.extinction = 0.15, .up = {0, 1, 0}};
    compare_on_a_part();
    fog.scale = 1.5;
    compare_samples(0);
    fog.extinction = 0;
}

static void the_host_s_scissor_bounds_the_patches(void **unused)
{
    (void)unused;
    static GLfloat full[VALUES], adaptive[VALUES];
    canvas to = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH_COMPONENT24, 0);
    GLfloat *const pictures[] = {full, adaptive};
    for (int i = 0; i < 2; i++) {
        const ew_frame_desc frame = frame_to(&to, EW_OUTPUT_ADD, i == 0 ? EW_RESOLUTION_FULL : EW_RESOLUTION_ADAPTIVE);
        draw_opaque(&to);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(100, 90, 121, 83);
        glow_draw(effect, &frame);
        gl.Disable(GL_SCISSOR_TEST);
        canvas_read(&to, pictures[i]);
    }
    expect_alike(full, adaptive, 0, 1000);
    canvas_destroy(&to);
}

/* How many pixels are drawn in all passes at full resolution, by OpenGL's own count. */
static GLuint count_drawn_pixels(const ew_frame_desc *frame)
{
    GLuint query, count = 0;
    gl.GenQueries(1, &query);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
    glow_draw(effect, frame);
    gl.EndQuery(GL_SAMPLES_PASSED);
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    gl.DeleteQueries(1, &query);
    return count;
}

/* Points, lines, tori and curves are summed up in three parts before they are composited: four passes. Regression: each part
 * was drawn over all of the viewport. */
static void parts_are_not_drawn_where_nothing_is_to_be_seen(void **unused)
{
    (void)unused;
    enum { PASSES = 4 };
    if (gl.es) skip(); /* OpenGL ES does not count */
    canvas to = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH_COMPONENT24, 0);
    ew_frame_desc frame = frame_to(&to, EW_OUTPUT_ADD, EW_RESOLUTION_FULL);
    draw_opaque(&to);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(100, 90, 3, 2);
    assert_int_equal(count_drawn_pixels(&frame), PASSES * 3 * 2);
    gl.Disable(GL_SCISSOR_TEST);

    frame.viewport_x = -WIDTH;
    frame.viewport_y = -2 * HEIGHT;
    frame.viewport_width = 4 * WIDTH;
    frame.viewport_height = 5 * HEIGHT;
    assert_int_equal(count_drawn_pixels(&frame), PASSES * WIDTH * HEIGHT);

    /* Regression: what the target and such a viewport have in common overflowed. */
    frame.viewport_x = frame.viewport_y = INT_MIN;
    assert_int_equal(count_drawn_pixels(&frame), 0);
    canvas_destroy(&to);
}

int main(int argc, char **argv)
{
    if (argc != 2) return 2;
    context = open_context(argv[1], NULL);
    if (context == NULL) return 2;
    effect = glow_create(context);
    triangle = build_program("void main() {\n"
                             "vec2 corner = vec2(gl_VertexID == 1 ? 0.9 : -0.7, gl_VertexID == 2 ? 0.8 : -0.6);\n"
                             "gl_Position = vec4(corner, 0.75 + 0.2 * corner.x, 1.0); }\n",
                             "out vec4 color;\nvoid main() { color = vec4(0.1, 0.15, 0.2, 1.0); }\n", NULL);
    gl.GenVertexArrays(1, &vertex_array);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_output_is_alike_on_a_part_of_a_target),
        cmocka_unit_test(every_sample_of_a_target_is_alike),
        cmocka_unit_test(targets_of_every_kind_are_alike_in_fog),
        cmocka_unit_test(the_host_s_scissor_bounds_the_patches),
        cmocka_unit_test(parts_are_not_drawn_where_nothing_is_to_be_seen),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    gl.DeleteVertexArrays(1, &vertex_array);
    gl.DeleteProgram(triangle);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
