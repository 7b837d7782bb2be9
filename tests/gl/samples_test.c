/* Multisampled targets: each surface that a pixel's samples see has its own light, and is shaded once.
 *
 *     samples_test CONTEXT    one of the names in context.h */
#include "glow.h"
#include "program_context.h"
#include "sampled_scene.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

/* Large enough for adaptive resolution. */
enum { WIDTH = 320, HEIGHT = 240, VALUES = WIDTH * HEIGHT * 4 };

static gl_context *context;
static ew_effect *effect;

static const ew_resolution resolutions[] = {EW_RESOLUTION_FULL, EW_RESOLUTION_ADAPTIVE};
enum { RESOLUTIONS = sizeof resolutions / sizeof *resolutions };

static ew_frame_desc frame_of(unsigned framebuffer, ew_resolution resolution)
{
    ew_frame_desc frame = glow_frame(framebuffer);
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.output = EW_OUTPUT_ADD;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.resolution = resolution;
    return frame;
}

static void read_picture(GLuint framebuffer, GLfloat pixels[VALUES])
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, pixels);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

/* Draws the light over the scene, all samples at once. */
static void draw_samples(sampled_scene *scene, ew_resolution resolution)
{
    ew_frame_desc frame = frame_of(scene->framebuffer, resolution);
    frame.depth_source = EW_DEPTH_TEXTURE_MULTISAMPLE;
    frame.depth_texture = scene->depth;
    glow_draw(effect, &frame);
    sampled_scene_fetch_color(scene, WIDTH, HEIGHT);
}

/* Draws it over the picture of one sample. */
static void draw_sample_alone(const sampled_scene *scene, int sample, ew_resolution resolution)
{
    ew_frame_desc frame = frame_of(scene->sample_framebuffers[sample], resolution);
    frame.depth_texture = scene->sample_depth[sample];
    glow_draw(effect, &frame);
}

/* The largest difference of the red, green and blue of two pictures, relative to the value or to 0.03 of the largest. */
static double largest_error(const GLfloat is[VALUES], const GLfloat should[VALUES])
{
    double peak = 0, largest = 0;
    for (int i = 0; i < VALUES; i++)
        peak = fmax(peak, i % 4 < 3 ? (double)should[i] : 0);
    for (int i = 0; i < VALUES; i++)
        if (i % 4 < 3) largest = fmax(largest, fabs((double)is[i] - (double)should[i]) / fmax((double)should[i], 0.03 * peak));
    return largest;
}

/* Surfaces that face the camera have the same depth at all of their samples, so each sample must have what a target of its own
 * has. Where the triangles meet the background, pixels see three surfaces. */
static void each_of_three_surfaces_in_a_pixel_has_its_own_light(void **unused)
{
    (void)unused;
    static const opaque_triangle triangles[] = {
        {{{-0.9f, -0.8f, 0.78f}, {0.4f, -0.7f, 0.78f}, {-0.3f, 0.9f, 0.78f}}, {0.2f, 0, 0, 1}},
        {{{0.8f, -0.9f, 0.7f}, {0.7f, 0.8f, 0.7f}, {-0.5f, -0.1f, 0.7f}}, {0, 0.2f, 0, 1}},
    };
    static GLfloat is[VALUES], should[VALUES];
    if (!has_multisampled_textures() || gl.es) skip(); /* ES has no multisampled floats */
    for (int k = 0; k < RESOLUTIONS; k++) {
        sampled_scene all, alone;
        sampled_scene_create(triangles, 2, GL_RGBA32F, WIDTH, HEIGHT, &all);
        sampled_scene_create(triangles, 2, GL_RGBA32F, WIDTH, HEIGHT, &alone);
        draw_samples(&all, resolutions[k]);
        for (int i = 0; i < SCENE_SAMPLES; i++) {
            read_picture(all.sample_framebuffers[i], is);
            draw_sample_alone(&alone, i, EW_RESOLUTION_FULL);
            read_picture(alone.sample_framebuffers[i], should);
            double error = largest_error(is, should);
            if (!(error <= (k == 0 ? 1e-5 : 2e-3))) fail_msg("sample %d, resolution %d: %g", i, k, error);
        }
        sampled_scene_destroy(&all);
        sampled_scene_destroy(&alone);
    }
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

/* The depth of a plane through the light at the pixels' centres, at a small angle to the rays. */
static GLuint make_depth_of_plane(const opaque_triangle *plane)
{
    static GLfloat depths[HEIGHT][WIDTH][4];
    const double bottom = (double)plane->corners[0][2], rise = ((double)plane->corners[2][2] - bottom) / 4;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        depths[i / WIDTH][i % WIDTH][0] = (GLfloat)(0.5 + 0.5 * (bottom + rise * (2 * (i / WIDTH + 0.5) / HEIGHT)));
    GLuint texture = make_float_texture(WIDTH, HEIGHT);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, depths);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

/* The depth of that plane differs between a pixel's samples by more than the light may be off. A rasteriser shades it once a
 * pixel, at the centre. So must the light be, or it would be computed for each sample. */
static void a_slanted_plane_is_shaded_once_a_pixel(void **unused)
{
    (void)unused;
    static const opaque_triangle plane = {{{-1, -1, 0.7675f}, {3, -1, 0.7675f}, {-1, 3, 1.0485f}}, {0, 0, 0, 1}};
    static GLfloat should[VALUES], is[VALUES];
    if (!api_has(40, 32, NULL) || gl.es) skip(); /* gl_SampleMask; multisampled floats */
    for (int k = 0; k < RESOLUTIONS; k++) {
        sampled_scene scene;
        sampled_scene_create(&plane, 1, GL_RGBA32F, WIDTH, HEIGHT, &scene);
        GLuint color = make_float_texture(WIDTH, HEIGHT);
        ew_frame_desc frame = frame_of(make_framebuffer(GL_TEXTURE_2D, color, 0), EW_RESOLUTION_FULL);
        gl.BindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
        gl.ClearBufferfv(GL_COLOR, 0, (const GLfloat[4]){0, 0, 0, 1});
        frame.depth_texture = make_depth_of_plane(&plane);
        glow_draw(effect, &frame);
        read_picture(frame.framebuffer, should);
        draw_sample_alone(&scene, 0, EW_RESOLUTION_FULL);
        read_picture(scene.sample_framebuffers[0], is);
        assert_true(largest_error(is, should) > 1e-2);

        draw_samples(&scene, resolutions[k]);
        for (int i = 0; i < SCENE_SAMPLES; i++) {
            read_picture(scene.sample_framebuffers[i], is);
            double error = largest_error(is, should);
            if (!(error <= (k == 0 ? 1e-4 : 1e-3))) fail_msg("sample %d, resolution %d: %g", i, k, error);
        }
        gl.DeleteTextures(1, &color);
        gl.DeleteTextures(1, &frame.depth_texture);
        gl.DeleteFramebuffers(1, &frame.framebuffer);
        sampled_scene_destroy(&scene);
    }
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

int main(int argc, char **argv)
{
    context_desc desc;
    if (argc != 2 || !describe_context(argv[1], &desc)) return 2;
    context = open_described_context(&desc);
    if (context == NULL) return 2;
    effect = glow_create(context);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_of_three_surfaces_in_a_pixel_has_its_own_light),
        cmocka_unit_test(a_slanted_plane_is_shaded_once_a_pixel),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
