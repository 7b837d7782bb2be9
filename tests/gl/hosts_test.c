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

/* ---- Targets ---- */

static GLuint make_array(int layers)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture);
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, WIDTH, HEIGHT, layers, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl.BindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return texture;
}

static void layers_that_are_attached_all_at_once_are_refused(void **unused)
{
    (void)unused;
    if (!api_has(33, 32, "GL_OES_geometry_shader")) return;
    GLuint framebuffer, array = make_array(2);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0);
    const ew_frame_desc frame = glow_frame(framebuffer);
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "layer");
    /* Each by itself is a target like any other. */
    for (int layer = 0; layer < 2; layer++) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, layer);
        glow_draw(effect, &frame);
    }
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteTextures(1, &array);
}

/* Two images, the first of them drawn to by the host's draw buffer 1 or not at all. */
static void draw_buffers_without_an_image_for_the_light_are_refused(void **unused)
{
    (void)unused;
    GLuint framebuffer, images[2];
    gl.GenRenderbuffers(2, images);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    for (int i = 0; i < 2; i++) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, WIDTH, HEIGHT);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + (GLenum)i, GL_RENDERBUFFER, images[i]);
    }
    const ew_frame_desc frame = glow_frame(framebuffer);
    gl.DrawBuffers(2, (const GLenum[]){GL_NONE, GL_COLOR_ATTACHMENT1});
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "draw buffer 0");
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.DrawBuffers(2, (const GLenum[]){GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1});
    glow_draw(effect, &frame);
    /* OpenGL before 4.1 calls a framebuffer incomplete whose draw buffer has no image. */
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
        glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "draw buffer 0");
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteRenderbuffers(2, images);
}

static void a_target_of_integers_is_refused(void **unused)
{
    (void)unused;
    canvas integers = canvas_create(WIDTH, HEIGHT, GL_RGBA8UI, 0, 0);
    const ew_frame_desc frame = glow_frame(integers.framebuffer);
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "integer");
    canvas_destroy(&integers);
}

/* A context whose framebuffers have two views, as far as it tells. */
static void APIENTRY get_integerv_with_views(GLenum name, GLint *value)
{
    gl.GetIntegerv(name, value);
    if (name == GL_NUM_EXTENSIONS) ++*value;
}

static const GLubyte *APIENTRY get_stringi_with_views(GLenum name, GLuint index)
{
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    return name == GL_EXTENSIONS && index == (GLuint)count ? (const GLubyte *)"GL_OVR_multiview" : gl.GetStringi(name, index);
}

static void APIENTRY get_attachment_with_views(GLenum place, GLenum attachment, GLenum name, GLint *value)
{
    enum { NUM_VIEWS = 0x9630 };
    if (name == NUM_VIEWS)
        *value = 2;
    else
        gl.GetFramebufferAttachmentParameteriv(place, attachment, name, value);
}

static ew_gl_function get_proc_address_with_views(void *user, const char *name)
{
    if (strcmp(name, "glGetIntegerv") == 0) return (ew_gl_function)get_integerv_with_views;
    if (strcmp(name, "glGetStringi") == 0) return (ew_gl_function)get_stringi_with_views;
    if (strcmp(name, "glGetFramebufferAttachmentParameteriv") == 0) return (ew_gl_function)get_attachment_with_views;
    return context_get_proc_address(user, name);
}

static void a_target_of_several_views_is_refused(void **unused)
{
    (void)unused;
    ew_effect *watching = NULL;
    const ew_effect_desc desc = {.get_proc_address = get_proc_address_with_views, .user = context};
    assert_int_equal(ew_create_effect(&desc, &watching, NULL), EW_OK);
    GLuint framebuffer, array = make_array(2);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, 0);
    const ew_frame_desc frame = glow_frame(framebuffer);
    glow_refuse(watching, &frame, EW_ERROR_INVALID_ARGUMENT, "layer");
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.DeleteTextures(1, &array);
    ew_destroy_effect(watching);
}

static void a_viewport_beyond_the_context_s_largest_is_refused(void **unused)
{
    (void)unused;
    GLint largest[2];
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, largest);
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.viewport_width = largest[0] + 1;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "viewport_width");
    frame = glow_frame(target.framebuffer);
    frame.viewport_height = largest[1] + 1;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "viewport_height");
    frame.viewport_height = largest[1];
    glow_draw(effect, &frame);
}

/* ---- Hosts that know no samplers, and keep their own cache of the state ---- */

static void no_sampler_is_left_bound_without_restoration(void **unused)
{
    (void)unused;
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    frame.skip_restore = 1;
    canvas_clear_depth(&target, 1, (const GLint[4]){0, 0, 1, 1}, 1);
    glow_draw(effect, &frame);
    GLint sampler = -1;
    gl.ActiveTexture(GL_TEXTURE0);
    gl.GetIntegerv(GL_SAMPLER_BINDING, &sampler);
    assert_int_equal(sampler, 0);
}

/* ---- Portals and mirrors ---- */

static void stencil_left_half(GLint inside)
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.ClearStencil(1 - inside);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    gl.ClearStencil(inside);
    gl.Scissor(0, 0, WIDTH / 2, HEIGHT);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Clear(GL_STENCIL_BUFFER_BIT);
    gl.Disable(GL_SCISSOR_TEST);
    gl.StencilFuncSeparate(GL_FRONT_AND_BACK, GL_EQUAL, 1, 0xFF);
    gl.StencilOpSeparate(GL_FRONT_AND_BACK, GL_KEEP, GL_KEEP, GL_KEEP);
    gl.Enable(GL_STENCIL_TEST);
}

/* Draws with the host's stencil test on, and expects light in all pixels for which it is wanted, and in no others. */
static void expect_light(bool keeps_stencil_test, bool skips_restore, GLint inside)
{
    static picture everywhere, found;
    ew_frame_desc frame = glow_frame(target.framebuffer);
    measure(&frame, everywhere);
    frame.keep_stencil_test = keeps_stencil_test;
    frame.skip_restore = skips_restore;
    stencil_left_half(inside);
    measure(&frame, found);
    if (!skips_restore) assert_true(gl.IsEnabled(GL_STENCIL_TEST));
    gl.Disable(GL_STENCIL_TEST);
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            bool passes = !keeps_stencil_test || (column < WIDTH / 2) == inside;
            expect_equal((double)found[row][column][0], passes ? (double)everywhere[row][column][0] : 0);
        }
}

static void the_stencil_test_is_kept_on_request_alone(void **unused)
{
    (void)unused;
    for (int skips_restore = 0; skips_restore < 2; skips_restore++)
        for (GLint inside = 0; inside < 2; inside++) {
            expect_light(false, skips_restore, inside);
            expect_light(true, skips_restore, inside);
        }
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    effect = glow_create(context);
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH24_STENCIL8, 0);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_light_is_turned_over_with_the_clip_origin),
        cmocka_unit_test(bounds_are_turned_over_with_the_clip_origin),
        cmocka_unit_test(layers_that_are_attached_all_at_once_are_refused),
        cmocka_unit_test(draw_buffers_without_an_image_for_the_light_are_refused),
        cmocka_unit_test(a_target_of_integers_is_refused),
        cmocka_unit_test(a_target_of_several_views_is_refused),
        cmocka_unit_test(a_viewport_beyond_the_context_s_largest_is_refused),
        cmocka_unit_test(no_sampler_is_left_bound_without_restoration),
        cmocka_unit_test(the_stencil_test_is_kept_on_request_alone),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    canvas_destroy(&target);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
