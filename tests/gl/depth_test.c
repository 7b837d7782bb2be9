/* The opaque scene's depth, of every kind: the light ends where the scene begins, pixel by pixel as the reference has it.
 *
 *     depth_test CONTEXT    one of the names in context.h */
#include "canvas.h"
#include "debug_output.h"
#include "glow.h"
#include "program_context.h"
#include "sampled_scene.h"
#include "scramble.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = GLOW_WIDTH, HEIGHT = GLOW_HEIGHT, SAMPLES = SCENE_SAMPLES };

typedef GLfloat picture[HEIGHT][WIDTH][4];
typedef GLfloat depths[HEIGHT][WIDTH];

static gl_context *context;
static ew_effect *effect;
static canvas target; /* RGBA32F, without depth */

static const GLfloat black[4] = {0, 0, 0, 1};

static GLuint make_depth_texture(GLenum format, depths values)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    switch (format) {
    case GL_DEPTH_COMPONENT16: {
        GLushort texels[HEIGHT][WIDTH];
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            texels[i / WIDTH][i % WIDTH] = (GLushort)lround((double)values[i / WIDTH][i % WIDTH] * 65535);
        gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, texels);
        break;
    }
    case GL_DEPTH_COMPONENT24: {
        static GLuint texels[HEIGHT][WIDTH];
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            texels[i / WIDTH][i % WIDTH] = (GLuint)llround((double)values[i / WIDTH][i % WIDTH] * 4294967295.0);
        gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, texels);
        break;
    }
    case GL_DEPTH24_STENCIL8: {
        static GLuint texels[HEIGHT][WIDTH];
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            texels[i / WIDTH][i % WIDTH] = (GLuint)lround((double)values[i / WIDTH][i % WIDTH] * 16777215) << 8 | 0x5A;
        gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, texels);
        break;
    }
    case GL_DEPTH32F_STENCIL8: {
        static struct {
            GLfloat depth;
            GLuint stencil;
        } texels[HEIGHT][WIDTH];
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            texels[i / WIDTH][i % WIDTH].depth = values[i / WIDTH][i % WIDTH];
            texels[i / WIDTH][i % WIDTH].stencil = 0x5A;
        }
        gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV,
                      texels);
        break;
    }
    case GL_R32F:
        gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, WIDTH, HEIGHT, 0, GL_RED, GL_FLOAT, values);
        break;
    default:
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, values);
    }
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

static void draw_to(const canvas *to, const ew_frame_desc *frame, picture drawn)
{
    ew_frame_desc there = *frame;
    there.framebuffer = to->framebuffer;
    canvas_clear(to, black);
    glow_draw(effect, &there);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    canvas_read(to, &drawn[0][0][0]);
}

/* Draws the luminance. */
static void measure(const ew_frame_desc *frame, picture measured)
{
    ew_frame_desc measuring = *frame;
    measuring.output = EW_OUTPUT_LUMINANCE;
    draw_to(&target, &measuring, measured);
}

/* ---- Projections ----------------------------------------------------------------------------------------------------------
 */

/* The view depth of the opaque scene along the ray of a pixel: a ball before the brightest of the light, a wall through it,
 * aslant, and nothing. */
static double scene_depth(const glow_lens *lens, int column, int row)
{
    double place[2];
    glow_pixel(lens, column, row, place);
    /* origin + depth direction, seen from the eye */
    double origin[3] = {lens->parallel ? place[0] : 0, lens->parallel ? place[1] : 0, 0};
    double direction[3] = {lens->parallel ? 0 : place[0], lens->parallel ? 0 : place[1], 1};
    const double center[3] = {0.5, 0.2, 5}, radius = 0.5;
    double a = 0, b = 0, c = -radius * radius;
    for (int i = 0; i < 3; i++) {
        a += direction[i] * direction[i];
        b += direction[i] * (origin[i] - center[i]);
        c += (origin[i] - center[i]) * (origin[i] - center[i]);
    }
    if (b * b - a * c > 0) return (-b - sqrt(b * b - a * c)) / a;
    /* depth = 6.2 + 0.3 x, where x < -0.2 */
    double wall = (6.2 + 0.3 * origin[0]) / (1 - 0.3 * direction[0]);
    return origin[0] + wall * direction[0] < -0.2 ? wall : (double)INFINITY;
}

/* Window depth of a point on a pixel's ray. */
static double window_depth(const ew_frame_desc *frame, const glow_lens *lens, int column, int row, double depth)
{
    double place[2], clip[4];
    glow_pixel(lens, column, row, place);
    const double scale = lens->parallel ? 1 : depth, view[4] = {place[0] * scale, place[1] * scale, -depth, 1};
    for (int i = 0; i < 4; i++) {
        clip[i] = 0;
        for (int j = 0; j < 4; j++)
            clip[i] += frame->projection[4 * j + i] * view[j];
    }
    return frame->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? clip[2] / clip[3] : 0.5 * clip[2] / clip[3] + 0.5;
}

/* Lengyel, "Oblique View Frustum Depth Projection and Clipping" (2005): the near plane becomes `plane`. */
static void make_oblique(double p[16], const double plane[4])
{
    const double corner[4] = {(copysign(1, plane[0]) + p[8]) / p[0], (copysign(1, plane[1]) + p[9]) / p[5], -1,
                              (1 + p[10]) / p[14]};
    double along = 0;
    for (int i = 0; i < 4; i++)
        along += plane[i] * corner[i];
    for (int i = 0; i < 4; i++)
        p[4 * i + 2] = 2 * plane[i] / along - p[4 * i + 3];
}

/* A lens with a row of the projection matrix that maps its depths. */
typedef struct depth_projection {
    const char *name;
    const glow_lens *lens;
    double z_scale, z_offset, far_value;
    ew_clip_depth clip_depth;
    bool oblique;
} depth_projection;

static ew_frame_desc frame_of(const depth_projection *projection)
{
    ew_frame_desc frame = glow_frame(0);
    glow_projection(projection->lens, projection->z_scale, projection->z_offset, frame.projection);
    frame.clip_depth = projection->clip_depth;
    if (projection->oblique) make_oblique(frame.projection, (const double[4]){0.1, -0.2, -1, -1.5});
    return frame;
}

/* The reference's luminance through a lens. Returns the brightest. */
static double compute_truth(const glow_lens *lens, const ew_frame_desc *frame, double truth[HEIGHT][WIDTH])
{
    double brightest = 0;
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            truth[row][column] = glow_reference(lens, frame, column, row, scene_depth(lens, column, row));
            brightest = fmax(brightest, truth[row][column]);
        }
    return brightest;
}

static void draw_with_depths(const depth_projection *projection, ew_frame_desc *frame, picture found)
{
    static depths values;
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            double depth = scene_depth(projection->lens, column, row);
            values[row][column] =
                (GLfloat)(isfinite(depth) ? window_depth(frame, projection->lens, column, row, depth) : projection->far_value);
        }
    frame->depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    measure(frame, found);
    gl.DeleteTextures(1, &frame->depth_texture);
}

static void every_projection_has_the_luminance_of_the_reference(void **unused)
{
    (void)unused;
    static const double near_depth = 0.5, far_depth = 60;
    const double n = near_depth, f = far_depth;
    static const glow_lens off_axis = {.left = -0.55, .right = 0.25, .bottom = -0.2, .top = 0.4};
    static const glow_lens jittered = {
        .left = -0.4 + 0.3 / 60, .right = 0.4 + 0.3 / 60, .bottom = -0.3 - 0.4 / 60, .top = 0.3 - 0.4 / 60};
    static const glow_lens parallel = {.parallel = true, .left = -2.4, .right = 2.4, .bottom = -1.8, .top = 1.8};
    const depth_projection projections[] = {
        {"perspective", &glow_default_lens, -(f + n) / (f - n), -2 * f * n / (f - n), 1, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 0},
        {"[0, 1] clip depth", &glow_default_lens, -f / (f - n), -f * n / (f - n), 1, EW_CLIP_DEPTH_ZERO_TO_ONE, 0},
        {"reversed", &glow_default_lens, n / (f - n), f * n / (f - n), 0, EW_CLIP_DEPTH_ZERO_TO_ONE, 0},
        {"infinite far plane", &glow_default_lens, -1, -2 * n, 1, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 0},
        {"reversed, infinite far plane", &glow_default_lens, 0, n, 0, EW_CLIP_DEPTH_ZERO_TO_ONE, 0},
        {"reversed in [-1, 1]", &glow_default_lens, (f + n) / (f - n), 2 * f * n / (f - n), 0,
         EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 0},
        {"oblique near plane", &glow_default_lens, -(f + n) / (f - n), -2 * f * n / (f - n), 1,
         EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 1},
        {"off-axis", &off_axis, -(f + n) / (f - n), -2 * f * n / (f - n), 1, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 0},
        {"jittered, reversed", &jittered, 0, n, 0, EW_CLIP_DEPTH_ZERO_TO_ONE, 0},
        {"orthographic", &parallel, -2 / (f - n), -(f + n) / (f - n), 1, EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE, 0},
        {"orthographic, reversed", &parallel, 1 / (f - n), f / (f - n), 0, EW_CLIP_DEPTH_ZERO_TO_ONE, 0},
    };
    static double truth[HEIGHT][WIDTH];
    static picture found;
    const glow_lens *truth_of = NULL;
    double brightest = 0;
    for (size_t i = 0; i < sizeof projections / sizeof projections[0]; i++) {
        ew_frame_desc frame = frame_of(&projections[i]);
        if (projections[i].lens != truth_of) brightest = compute_truth(projections[i].lens, &frame, truth);
        truth_of = projections[i].lens;
        draw_with_depths(&projections[i], &frame, found);

        double worst = 0;
        for (int row = 0; row < HEIGHT; row++)
            for (int column = 0; column < WIDTH; column++) {
                double expected = truth[row][column], error = fabs((double)found[row][column][0] - expected);
                worst = fmax(worst, error / fmax(expected, 1e-3 * brightest));
            }
        fprintf(stderr, "%s: largest relative error %.2g\n", projections[i].name, worst);
        assert_true(worst <= 1e-3);
    }
}

/* ---- Textures -------------------------------------------------------------------------------------------------------------
 */

/* The frame that the textures are for, and its opaque scene's depth. */
static ew_frame_desc textured_frame(depths values)
{
    ew_frame_desc frame = glow_frame(0);
    glow_projection(&glow_default_lens, -1.02, -1.01, frame.projection);
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            double depth = scene_depth(&glow_default_lens, column, row);
            bool is_open = !isfinite(depth);
            values[row][column] = is_open ? 1.0f : (GLfloat)window_depth(&frame, &glow_default_lens, column, row, depth);
        }
    return frame;
}

static int count_different_pixels(picture a, picture b)
{
    int different = 0;
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++)
            different += memcmp(a[row][column], b[row][column], sizeof a[row][column]) != 0;
    return different;
}

/* By how much the pictures differ, relative to the brighter of their pixels. */
static double largest_difference(picture a, picture b)
{
    double largest = 0;
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
        double x = (double)(&a[0][0][0])[i], y = (double)(&b[0][0][0])[i];
        largest = fmax(largest, fabs(x - y) / fmax(1e-3, fmax(x, y)));
    }
    return largest;
}

/* The projection's depths may be anything then: a logarithmic buffer's, say. */
static void linear_view_depth_has_the_luminance_of_the_reference(void **unused)
{
    (void)unused;
    static const glow_lens lenses[] = {{.left = -0.55, .right = 0.25, .bottom = -0.2, .top = 0.4},
                                       {.parallel = true, .left = -2.4, .right = 2.4, .bottom = -1.8, .top = 1.8}};
    static double truth[HEIGHT][WIDTH];
    static picture found;
    static depths values;
    for (int i = 0; i < 2; i++) {
        ew_frame_desc frame = glow_frame(0);
        glow_projection(&lenses[i], -1.02, -1.01, frame.projection);
        double brightest = compute_truth(&lenses[i], &frame, truth);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++)
            values[pixel / WIDTH][pixel % WIDTH] = (GLfloat)scene_depth(&lenses[i], pixel % WIDTH, pixel / WIDTH);
        frame.depth_source = EW_DEPTH_TEXTURE_LINEAR;
        frame.depth_texture = make_depth_texture(GL_R32F, values);
        measure(&frame, found);
        gl.DeleteTextures(1, &frame.depth_texture);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            double expected = truth[pixel / WIDTH][pixel % WIDTH], light = (double)found[pixel / WIDTH][pixel % WIDTH][0];
            assert_true(fabs(light - expected) <= 1e-3 * fmax(expected, 1e-3 * brightest));
        }
    }
}

/* In the world integral, light goes on beyond the far plane. */
static void linear_view_depth_is_open_where_it_is_infinite(void **unused)
{
    (void)unused;
    static const ew_point orb = {.position = {0.2, 0.1, 0}, .brightness = 1, .core = 0.2, .reach = 3};
    static const float linear[] = {INFINITY, 1e30f, 6, 5.5f, 0, -1, -INFINITY, NAN};
    enum { COUNT = sizeof linear / sizeof linear[0] };
    static depths values;
    static picture open, expected, found;
    assert_int_equal(ew_set_sources(effect, &(ew_sources_desc){.points = &orb, .point_count = 1}, NULL), EW_OK);
    ew_frame_desc frame = glow_frame(0);
    frame.interval_start = frame.interval_end = 0;
    measure(&frame, open);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double depth = (double)linear[i % COUNT];
        bool is_surface = depth > 0 && depth < 1e3;
        double window = is_surface ? window_depth(&frame, &glow_default_lens, 0, 0, depth) : depth > 0;
        values[i / WIDTH][i % WIDTH] = (GLfloat)window;
    }
    frame.depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    measure(&frame, expected);
    gl.DeleteTextures(1, &frame.depth_texture);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        values[i / WIDTH][i % WIDTH] = linear[i % COUNT];
    frame.depth_source = EW_DEPTH_TEXTURE_LINEAR;
    frame.depth_texture = make_depth_texture(GL_R32F, values);
    measure(&frame, found);
    gl.DeleteTextures(1, &frame.depth_texture);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        if (i % COUNT < 2) assert_true(found[i / WIDTH][i % WIDTH][0] == open[i / WIDTH][i % WIDTH][0]);
    assert_true(largest_difference(expected, found) <= 1e-4);
    assert_int_equal(ew_set_sources(effect, &glow_sources, NULL), EW_OK);
}

/* The depths as a fixed-point format keeps them. */
static void quantize(depths values, int bits, depths kept)
{
    const double steps = ldexp(1, bits) - 1;
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++)
            kept[row][column] = (GLfloat)((double)llround((double)values[row][column] * steps) / steps);
}

static void every_format_of_a_depth_texture_is_read(void **unused)
{
    (void)unused;
    static const struct {
        GLenum format;
        int bits; /* 0: floats */
    } formats[] = {{GL_DEPTH_COMPONENT16, 16}, {GL_DEPTH_COMPONENT24, 24}, {GL_DEPTH24_STENCIL8, 24},
                   {GL_DEPTH_COMPONENT32F, 0}, {GL_DEPTH32F_STENCIL8, 0},  {GL_R32F, 0}};
    static depths values, kept;
    static picture open, expected, found;
    ew_frame_desc frame = textured_frame(values);
    measure(&frame, open);
    for (size_t i = 0; i < sizeof formats / sizeof formats[0]; i++) {
        if (formats[i].bits > 0)
            quantize(values, formats[i].bits, kept);
        else
            memcpy(kept, values, sizeof kept);
        frame.depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, kept);
        measure(&frame, expected);
        gl.DeleteTextures(1, &frame.depth_texture);
        frame.depth_texture = make_depth_texture(formats[i].format, values);
        measure(&frame, found);
        gl.DeleteTextures(1, &frame.depth_texture);
        assert_true(count_different_pixels(open, expected) > WIDTH);
        /* A float keeps the fixed-point fraction only to 24 bits. */
        assert_true(largest_difference(expected, found) <= 1e-4);
    }
}

static void depths_that_no_scene_has_leave_a_picture_of_numbers(void **unused)
{
    (void)unused;
    static const float strange[] = {NAN, INFINITY, -INFINITY, -1, 2, 1e30f, -1e-30f};
    enum { COUNT = sizeof strange / sizeof strange[0] };
    static depths values;
    static picture found;
    ew_frame_desc frame = glow_frame(0);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        values[i / WIDTH][i % WIDTH] = strange[i % COUNT];
    frame.depth_texture = make_depth_texture(GL_R32F, values);
    measure(&frame, found);
    gl.DeleteTextures(1, &frame.depth_texture);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        float light = found[i / WIDTH][i % WIDTH][0];
        /* Beyond the far plane there is all the light; before the near plane, and nowhere, none. */
        bool is_none = strange[i % COUNT] <= -1 || isnan(strange[i % COUNT]), is_all = strange[i % COUNT] >= 2;
        if (!isfinite(light) || light < 0 || (is_none && light > 0) || (is_all && light == 0))
            fail_msg("depth %g: light %g", (double)strange[i % COUNT], (double)light);
    }
}

static void what_the_host_set_on_its_texture_does_not_matter_and_stays(void **unused)
{
    (void)unused;
    const bool stencil_texturing = api_has(43, 31, "GL_ARB_stencil_texturing");
    const GLenum depth_texture_mode = 0x884B, alpha = GL_ALPHA;
    const struct {
        GLenum name;
        GLint value;
        bool known;
    } settings[] = {
        {GL_TEXTURE_SWIZZLE_R, GL_ZERO, true},
        {GL_TEXTURE_SWIZZLE_R, GL_GREEN, true},
        {GL_TEXTURE_BASE_LEVEL, 1, true},
        {GL_TEXTURE_BASE_LEVEL, 7, true},
        {GL_TEXTURE_MAX_LEVEL, 0, true},
        {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE, true},
        {GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR, true},
        {GL_TEXTURE_MAG_FILTER, GL_LINEAR, true},
        {GL_DEPTH_STENCIL_TEXTURE_MODE, GL_STENCIL_INDEX, stencil_texturing},
        {depth_texture_mode, (GLint)alpha, gl.compatibility},
    };
    static depths values;
    static picture expected, found;
    ew_frame_desc frame = textured_frame(values);
    frame.depth_texture = make_depth_texture(GL_DEPTH24_STENCIL8, values);
    measure(&frame, expected);
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (!settings[i].known) continue;
        GLint before = 0, after = 0;
        gl.BindTexture(GL_TEXTURE_2D, frame.depth_texture);
        gl.GetTexParameteriv(GL_TEXTURE_2D, settings[i].name, &before);
        gl.TexParameteri(GL_TEXTURE_2D, settings[i].name, settings[i].value);
        measure(&frame, found);
        gl.GetTexParameteriv(GL_TEXTURE_2D, settings[i].name, &after);
        gl.TexParameteri(GL_TEXTURE_2D, settings[i].name, before);
        gl.BindTexture(GL_TEXTURE_2D, 0);
        assert_int_equal(after, settings[i].value);
        if (count_different_pixels(expected, found) != 0) fail_msg("parameter 0x%x changes the picture", settings[i].name);
    }
    gl.DeleteTextures(1, &frame.depth_texture);
}

static void a_viewport_smaller_than_the_depth_is_a_part_of_the_picture(void **unused)
{
    (void)unused;
    enum { X = 11, Y = 7, W = 23, H = 19 };
    static depths values;
    static picture whole, part;
    ew_frame_desc frame = textured_frame(values);
    frame.depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    measure(&frame, whole);

    /* The lens of the part: NDC [-1, 1] spans these pixels. */
    const glow_lens *lens = &glow_default_lens;
    double first[2], last[2];
    glow_pixel(lens, X, Y, first);
    glow_pixel(lens, X + W, Y + H, last);
    const double half_x = (lens->right - lens->left) / WIDTH / 2, half_y = (lens->top - lens->bottom) / HEIGHT / 2;
    const glow_lens part_lens = {
        .left = first[0] - half_x, .right = last[0] - half_x, .bottom = first[1] - half_y, .top = last[1] - half_y};
    glow_projection(&part_lens, -1.02, -1.01, frame.projection);
    frame.viewport_x = X;
    frame.viewport_y = Y;
    frame.viewport_width = W;
    frame.viewport_height = H;
    measure(&frame, part);
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            bool inside = column >= X && column < X + W && row >= Y && row < Y + H;
            double expected = inside ? (double)whole[row][column][0] : 0, found = (double)part[row][column][0];
            assert_true(fabs(found - expected) <= 1e-4 * expected);
        }

    /* A target as large as that part, below and left of the depth's middle. */
    canvas small = canvas_create(W, H, GL_RGBA32F, 0, 0);
    static GLfloat small_picture[H][W][4];
    const glow_lens corner_lens = {
        .left = lens->left, .right = lens->left + 2 * half_x * W, .bottom = lens->bottom, .top = lens->bottom + 2 * half_y * H};
    glow_projection(&corner_lens, -1.02, -1.01, frame.projection);
    frame.viewport_x = frame.viewport_y = 0;
    frame.framebuffer = small.framebuffer;
    frame.output = EW_OUTPUT_LUMINANCE;
    canvas_clear(&small, black);
    glow_draw(effect, &frame);
    canvas_read(&small, &small_picture[0][0][0]);
    for (int row = 0; row < H; row++)
        for (int column = 0; column < W; column++) {
            double expected = (double)whole[row][column][0], found = (double)small_picture[row][column][0];
            assert_true(fabs(found - expected) <= 1e-4 * expected);
        }
    canvas_destroy(&small);
    gl.DeleteTextures(1, &frame.depth_texture);
}

static void the_host_s_scissor_bounds_the_picture(void **unused)
{
    (void)unused;
    static const GLint box[4] = {5, 9, 20, 14};
    static depths values;
    static picture whole, part;
    ew_frame_desc frame = textured_frame(values);
    canvas with_depth = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH_COMPONENT24, 0);
    canvas_clear_depth(&with_depth, 1, box, 0.9f);
    frame.output = EW_OUTPUT_LUMINANCE;
    const GLuint texture = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    for (int copied = 0; copied < 2; copied++) {
        frame.depth_source = copied ? EW_DEPTH_FRAMEBUFFER : EW_DEPTH_TEXTURE;
        frame.depth_texture = copied ? 0 : texture;
        const canvas *to = copied ? &with_depth : &target;
        draw_to(to, &frame, whole);
        canvas_clear(to, black);
        gl.Scissor(box[0], box[1], box[2], box[3]);
        gl.Enable(GL_SCISSOR_TEST);
        frame.framebuffer = to->framebuffer;
        glow_draw(effect, &frame);
        gl.Disable(GL_SCISSOR_TEST);
        canvas_read(to, &part[0][0][0]);
        for (int row = 0; row < HEIGHT; row++)
            for (int column = 0; column < WIDTH; column++) {
                bool inside = column >= box[0] && column < box[0] + box[2] && row >= box[1] && row < box[1] + box[3];
                assert_true(whole[row][column][0] > 0);
                double expected = inside ? (double)whole[row][column][0] : 0, found = (double)part[row][column][0];
                /* Mesa's copies of 24 bits lose the last one where there is a scissor. */
                assert_true(fabs(found - expected) <= 1e-5 * expected);
            }
    }
    gl.DeleteTextures(1, &texture);
    canvas_destroy(&with_depth);
}

/* ---- The framebuffer's own depth ------------------------------------------------------------------------------------------
 */

static const GLint near_box[4] = {13, 8, 21, 17};

/* What canvas_clear_depth leaves. */
static void boxed_depths(GLfloat near_value, depths values)
{
    for (int row = 0; row < HEIGHT; row++)
        for (int column = 0; column < WIDTH; column++) {
            bool inside = column >= near_box[0] && column < near_box[0] + near_box[2] && row >= near_box[1] &&
                          row < near_box[1] + near_box[3];
            values[row][column] = inside ? near_value : 1;
        }
}

static void expect_copied_depth(const canvas *to, GLfloat near_value, int bits)
{
    static depths values, kept;
    static picture expected, found;
    ew_frame_desc frame = glow_frame(0);
    frame.output = EW_OUTPUT_LUMINANCE;
    boxed_depths(near_value, values);
    if (bits > 0)
        quantize(values, bits, kept);
    else
        memcpy(kept, values, sizeof kept);
    frame.depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, kept);
    draw_to(&target, &frame, expected);
    gl.DeleteTextures(1, &frame.depth_texture);

    frame.depth_texture = 0;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    canvas_clear_depth(to, 1, near_box, near_value);
    draw_to(to, &frame, found);
    assert_true(largest_difference(expected, found) <= 1e-4);
}

static void the_depth_of_a_framebuffer_is_copied_whatever_its_format(void **unused)
{
    (void)unused;
    static const struct {
        GLenum format;
        int bits; /* 0: floats */
        bool es;
    } formats[] = {{GL_DEPTH_COMPONENT16, 16, true},  {GL_DEPTH_COMPONENT24, 24, true}, {GL_DEPTH24_STENCIL8, 24, true},
                   {GL_DEPTH_COMPONENT32, 32, false}, {GL_DEPTH_COMPONENT32F, 0, true}, {GL_DEPTH32F_STENCIL8, 0, true}};
    enum { COUNT = sizeof formats / sizeof formats[0] };
    for (int pass = 0; pass < 2; pass++) /* each format after each of its neighbours, and with the copy's storage made */
        for (int i = 0; i < COUNT; i++) {
            if (gl.es && !formats[i].es) continue;
            canvas made = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, formats[i].format, 0);
            expect_copied_depth(&made, 0.86f, formats[i].bits);
            expect_copied_depth(&made, 0.88f, formats[i].bits);
            canvas_destroy(&made);
        }
}

static void the_copy_of_the_depth_grows_with_the_viewport(void **unused)
{
    (void)unused;
    canvas made = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, GL_DEPTH_COMPONENT16, 0);
    static picture expected, found;
    ew_frame_desc frame = glow_frame(made.framebuffer);
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    canvas_clear_depth(&made, 1, near_box, 0.86f);
    draw_to(&made, &frame, expected);

    /* Narrower, lower, and beside the picture. */
    static const GLint parts[][3] = {{0, WIDTH / 2, HEIGHT}, {0, WIDTH, HEIGHT / 3}, {-WIDTH, WIDTH, HEIGHT}};
    ew_effect *other;
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        other = glow_create(context);
        ew_frame_desc part = frame;
        part.viewport_x = parts[i][0];
        part.viewport_width = parts[i][1];
        part.viewport_height = parts[i][2];
        glow_draw(other, &part);
        canvas_clear(&made, black);
        glow_draw(other, &frame);
        canvas_read(&made, &found[0][0][0]);
        assert_int_equal(count_different_pixels(expected, found), 0);
        ew_destroy_effect(other);
    }

    /* An unpack buffer of the host's is no source of depth. */
    GLuint buffer;
    GLubyte bytes[64] = {0};
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    gl.BufferData(GL_PIXEL_UNPACK_BUFFER, sizeof bytes, bytes, GL_STATIC_DRAW);
    other = glow_create(context);
    canvas_clear(&made, black);
    glow_draw(other, &frame);
    GLint bound = 0;
    gl.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &bound);
    assert_int_equal(bound, buffer);
    gl.DeleteBuffers(1, &buffer);
    canvas_read(&made, &found[0][0][0]);
    assert_int_equal(count_different_pixels(expected, found), 0);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    ew_destroy_effect(other);

    /* Nor is an error that the host left in GL's flag one of the copy's. */
    other = glow_create(context);
    debug_output_pause();
    gl.Enable(GL_INVALID_ENUM);
    debug_output_resume();
    glow_draw(other, &frame);
    ew_destroy_effect(other);
    canvas_destroy(&made);
}

static int count_objects(void)
{
    int count = 0;
    for (GLuint name = 1; name < 4096; name++)
        count += gl.IsTexture(name) + gl.IsFramebuffer(name);
    return count;
}

static void copies_of_framebuffers_in_turn_leave_no_object_behind(void **unused)
{
    (void)unused;
    const int before = count_objects();
    canvas made[2];
    for (int i = 0; i < 2; i++)
        made[i] = canvas_create(WIDTH, HEIGHT, GL_RGBA8, GL_DEPTH24_STENCIL8, i * SAMPLES);
    ew_effect *other = glow_create(context);
    for (int i = 0; i < 6; i++) {
        ew_frame_desc frame = glow_frame(made[i % 2].framebuffer);
        frame.depth_source = EW_DEPTH_FRAMEBUFFER;
        glow_draw(other, &frame);
    }
    ew_destroy_effect(other);
    for (int i = 0; i < 2; i++)
        canvas_destroy(&made[i]);
    assert_int_equal(count_objects(), before);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static void the_depth_of_the_window_is_copied(void **unused)
{
    (void)unused;
    const canvas window = {.width = WIDTH, .height = HEIGHT, .color_format = GL_RGBA8};
    canvas bytes = canvas_create(WIDTH, HEIGHT, GL_RGBA8, 0, 0);
    static depths values;
    static picture open, expected, found;
    ew_frame_desc frame = glow_frame(0);
    boxed_depths(0.86f, values);
    draw_to(&bytes, &frame, open);
    frame.depth_texture = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    draw_to(&bytes, &frame, expected);
    gl.DeleteTextures(1, &frame.depth_texture);
    assert_true(count_different_pixels(open, expected) > 100);

    frame.depth_texture = 0;
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    canvas_clear_depth(&window, 1, near_box, 0.86f);
    draw_to(&window, &frame, found);
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++)
        assert_true(fabsf((&found[0][0][0])[i] - (&expected[0][0][0])[i]) <= 1.01f / 255);
    canvas_destroy(&bytes);
}

/* ---- Multisampled depth ---------------------------------------------------------------------------------------------------
 */

/* A triangle before nearly all of the light, and nothing beside it. */
static const opaque_triangle triangle = {{{-0.7f, -0.6f, 0.5f}, {0.9f, -0.6f, 0.5f}, {-0.7f, 0.8f, 0.5f}}, {1, 0.9f, 0.6f, 1}};

/* What a single-sampled host would see, did it render at the place of each sample; 8-bit targets clip. */
static void draw_samples_alone(const sampled_scene *scene, const ew_frame_desc *frame, picture samples[SAMPLES])
{
    for (int i = 0; i < SAMPLES; i++) {
        ew_frame_desc alone = *frame;
        alone.framebuffer = scene->sample_framebuffers[i];
        alone.depth_source = EW_DEPTH_TEXTURE;
        alone.depth_texture = scene->sample_depth[i];
        glow_draw(effect, &alone);
        gl.BindFramebuffer(GL_FRAMEBUFFER, scene->sample_framebuffers[i]);
        gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, samples[i]);
        for (int j = 0; j < WIDTH * HEIGHT * 4; j++)
            (&samples[i][0][0][0])[j] = fminf((&samples[i][0][0][0])[j], 1);
    }
}

/* How many pixels have samples of different pictures; each component of `resolved` must lie between them. */
static int expect_between(picture samples[SAMPLES], picture resolved, float tolerance)
{
    int edges = 0;
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
        float least = 1, most = 0, found = (&resolved[0][0][0])[i];
        for (int j = 0; j < SAMPLES; j++) {
            least = fminf(least, (&samples[j][0][0][0])[i]);
            most = fmaxf(most, (&samples[j][0][0][0])[i]);
        }
        if (!(found >= least - tolerance && found <= most + tolerance))
            fail_msg("pixel (%d, %d) is %g, its samples are from %g to %g", i / 4 % WIDTH, i / 4 / WIDTH, (double)found,
                     (double)least, (double)most);
        edges += most - least > 0.1f;
    }
    return edges;
}

/* Whether the depth comes from the texture or from the framebuffer that it is attached to. */
static void check_resolved_picture(ew_depth_source source)
{
    sampled_scene scene;
    sampled_scene_create(&triangle, 1, GL_RGBA8, WIDTH, HEIGHT, &scene);
    static picture samples[SAMPLES], resolved;
    canvas bytes = canvas_create(WIDTH, HEIGHT, GL_RGBA8, 0, 0);
    const bool copied = source == EW_DEPTH_FRAMEBUFFER;
    const GLuint whole = make_framebuffer(GL_TEXTURE_2D_MULTISAMPLE, scene.color, scene.depth);
    ew_frame_desc frame = glow_frame(copied ? whole : scene.framebuffer);
    frame.depth_source = source;
    frame.depth_texture = copied ? 0 : scene.depth;
    if (!gl.es) gl.Disable(GL_MULTISAMPLE); /* the host's own business */
    glow_draw(effect, &frame);
    if (!gl.es) gl.Enable(GL_MULTISAMPLE);
    const canvas drawn = {.framebuffer = scene.framebuffer, .width = WIDTH, .height = HEIGHT};
    canvas_resolve(&drawn, &bytes);
    canvas_read(&bytes, &resolved[0][0][0]);
    draw_samples_alone(&scene, &frame, samples);
    /* A rasterizer may round the light, the factor and the result to 8 bits. */
    const float rounding = 1.51f / 255;
    assert_true(expect_between(samples, resolved, rounding) > 50);
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++) {
        float mean = 0;
        for (int j = 0; j < SAMPLES; j++)
            mean += (&samples[j][0][0][0])[i] / SAMPLES;
        assert_true(fabsf(mean - (&resolved[0][0][0])[i]) <= rounding + 0.5f / 255);
    }
    gl.DeleteFramebuffers(1, &whole);
    canvas_destroy(&bytes);
    sampled_scene_destroy(&scene);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static void a_resolved_picture_is_the_mean_of_its_samples_pictures(void **unused)
{
    (void)unused;
    if (!has_multisampled_textures()) skip();
    check_resolved_picture(EW_DEPTH_TEXTURE_MULTISAMPLE);
    if (!gl.es) check_resolved_picture(EW_DEPTH_FRAMEBUFFER);
}

static void multisampled_depth_on_other_targets_is_the_mean_over_the_samples(void **unused)
{
    (void)unused;
    if (!has_multisampled_textures()) skip();
    sampled_scene scene;
    sampled_scene_create(&triangle, 1, GL_RGBA8, WIDTH, HEIGHT, &scene);
    static picture sample, mean, found;
    ew_frame_desc frame = glow_frame(0);
    memset(mean, 0, sizeof mean);
    for (int i = 0; i < SAMPLES; i++) {
        frame.depth_texture = scene.sample_depth[i];
        draw_to(&target, &frame, sample);
        for (int j = 0; j < WIDTH * HEIGHT * 4; j++)
            (&mean[0][0][0])[j] += (&sample[0][0][0])[j] / SAMPLES;
    }
    frame.depth_source = EW_DEPTH_TEXTURE_MULTISAMPLE;
    frame.depth_texture = scene.depth;
    draw_to(&target, &frame, found);
    assert_true(largest_difference(mean, found) <= 1e-5);

    /* Swizzled, too. */
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, scene.depth);
    gl.TexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_SWIZZLE_R, GL_ONE);
    draw_to(&target, &frame, sample);
    GLint swizzle = 0;
    gl.GetTexParameteriv(GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_SWIZZLE_R, &swizzle);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    assert_int_equal(swizzle, GL_ONE);
    assert_int_equal(count_different_pixels(found, sample), 0);
    sampled_scene_destroy(&scene);
}

/* ---- Refusals -------------------------------------------------------------------------------------------------------------
 */

static void depth_that_cannot_be_read_is_refused_by_name(void **unused)
{
    (void)unused;
    GLuint cube, empty;
    gl.GenTextures(1, &cube);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.depth_texture = cube;
    debug_output_pause(); /* GL sees the mistakes */
    /* Regression: glIsTexture let it pass, and the bind raised a GL error. */
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    frame.depth_texture = 12345;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");

    frame = glow_frame(target.framebuffer);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_source");

    GLuint color = make_float_texture(WIDTH, HEIGHT), depth;
    static depths values;
    depth = make_depth_texture(GL_DEPTH_COMPONENT32F, values);
    frame = glow_frame(make_framebuffer(GL_TEXTURE_2D, color, depth));
    frame.depth_texture = depth;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "EW_DEPTH_FRAMEBUFFER");
    gl.DeleteFramebuffers(1, &frame.framebuffer);

    frame = glow_frame(target.framebuffer);
    frame.depth_source = EW_DEPTH_TEXTURE_MULTISAMPLE;
    frame.depth_texture = depth;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, has_multisampled_textures() ? "depth_texture" : "OpenGL ES");
    if (has_multisampled_textures()) {
        gl.GenTextures(1, &empty);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, empty);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
        frame.depth_texture = empty;
        glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "storage");
        gl.DeleteTextures(1, &empty);
    }
    gl.DeleteTextures(1, &color);
    gl.DeleteTextures(1, &depth);
    gl.DeleteTextures(1, &cube);
    debug_output_resume();
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static GLuint make_texture(GLenum format, GLenum layout, GLenum type, int width, int height)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    if (width > 0) gl.TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, width, height, 0, layout, type, NULL);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

/* OpenGL ES 3.0 cannot be asked for a texture's format and size. */
static bool has_texture_queries(void)
{
    return api_has(33, 31, NULL);
}

static void a_texture_that_is_no_depth_is_refused(void **unused)
{
    (void)unused;
    static const struct {
        ew_depth_source source;
        GLenum format, layout, type;
        int width;
        const char *reason;
    } cases[] = {
        {EW_DEPTH_TEXTURE, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, WIDTH, "depth format"},
        {EW_DEPTH_TEXTURE, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, WIDTH, "depth format"},
        {EW_DEPTH_TEXTURE, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 0, "storage"},
        {EW_DEPTH_TEXTURE_LINEAR, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, WIDTH, "float format"},
        {EW_DEPTH_TEXTURE_LINEAR, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, WIDTH, "float format"},
    };
    if (!has_texture_queries()) return;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        ew_frame_desc frame = glow_frame(target.framebuffer);
        frame.depth_source = cases[i].source;
        frame.depth_texture = make_texture(cases[i].format, cases[i].layout, cases[i].type, cases[i].width, HEIGHT);
        glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, cases[i].reason);
        gl.DeleteTextures(1, &frame.depth_texture);
    }
}

static void linear_depth_that_is_drawn_to_is_refused(void **unused)
{
    (void)unused;
    const GLuint color = make_float_texture(WIDTH, HEIGHT), linear = make_float_texture(WIDTH, HEIGHT);
    ew_frame_desc frame = glow_frame(make_framebuffer(GL_TEXTURE_2D, color, 0));
    frame.depth_source = EW_DEPTH_TEXTURE_LINEAR;
    frame.depth_texture = linear;
    glow_draw(effect, &frame);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + 1, GL_TEXTURE_2D, linear, 0);
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "attached");
    gl.DeleteFramebuffers(1, &frame.framebuffer);
    gl.DeleteTextures(2, (const GLuint[]){color, linear});
}

/* Of the target as a renderbuffer, a texture and the window, GL tells the size of the first two, the second not everywhere. */
static void a_depth_texture_smaller_than_what_is_drawn_is_refused(void **unused)
{
    (void)unused;
    if (!has_texture_queries()) return;
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, WIDTH, HEIGHT / 2);
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");
    frame.viewport_height = HEIGHT / 2;
    glow_draw(effect, &frame);
    frame.viewport_y = 1;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");
    frame.viewport_y = 0;
    frame.viewport_height = HEIGHT;
    frame.framebuffer = 0;
    glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");
    if (api_has(45, NEVER, "GL_ARB_direct_state_access")) {
        const GLuint color = make_float_texture(WIDTH, HEIGHT);
        frame.framebuffer = make_framebuffer(GL_TEXTURE_2D, color, 0);
        glow_refuse(effect, &frame, EW_ERROR_INVALID_ARGUMENT, "depth_texture");
        gl.DeleteFramebuffers(1, &frame.framebuffer);
        gl.DeleteTextures(1, &color);
    }
    gl.DeleteTextures(1, &frame.depth_texture);
}

/* A tile of a poster: the viewport is the whole poster, moved. */
static void a_viewport_larger_than_the_target_needs_no_more_depth_than_that(void **unused)
{
    (void)unused;
    ew_frame_desc frame = glow_frame(target.framebuffer);
    frame.depth_texture = make_texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, WIDTH, HEIGHT);
    frame.viewport_width = 4 * WIDTH;
    frame.viewport_height = 4 * HEIGHT;
    for (int tile = 0; tile < 4; tile++) {
        frame.viewport_x = -tile * WIDTH;
        frame.viewport_y = -tile * HEIGHT;
        glow_draw(effect, &frame);
    }
    const GLuint color = make_float_texture(WIDTH, HEIGHT);
    frame.framebuffer = make_framebuffer(GL_TEXTURE_2D, color, 0);
    frame.viewport_x = frame.viewport_y = 0;
    glow_draw(effect, &frame);
    gl.DeleteFramebuffers(1, &frame.framebuffer);
    gl.DeleteTextures(1, &color);
    gl.DeleteTextures(1, &frame.depth_texture);
}

int main(int argc, char **argv)
{
    context_desc desc;
    if (argc != 2 || !describe_context(argv[1], &desc)) return 2;
    desc.window_width = WIDTH;
    desc.window_height = HEIGHT;
    if (strcmp(argv[1], "gl45") == 0 || strcmp(argv[1], "es31") == 0) desc.window_samples = SAMPLES;
    context = open_described_context(&desc);
    if (context == NULL) return 2;
    effect = glow_create(context);
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, 0, 0);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_projection_has_the_luminance_of_the_reference),
        cmocka_unit_test(linear_view_depth_has_the_luminance_of_the_reference),
        cmocka_unit_test(linear_view_depth_is_open_where_it_is_infinite),
        cmocka_unit_test(every_format_of_a_depth_texture_is_read),
        cmocka_unit_test(depths_that_no_scene_has_leave_a_picture_of_numbers),
        cmocka_unit_test(what_the_host_set_on_its_texture_does_not_matter_and_stays),
        cmocka_unit_test(a_viewport_smaller_than_the_depth_is_a_part_of_the_picture),
        cmocka_unit_test(the_host_s_scissor_bounds_the_picture),
        cmocka_unit_test(the_depth_of_a_framebuffer_is_copied_whatever_its_format),
        cmocka_unit_test(the_copy_of_the_depth_grows_with_the_viewport),
        cmocka_unit_test(copies_of_framebuffers_in_turn_leave_no_object_behind),
        cmocka_unit_test(the_depth_of_the_window_is_copied),
        cmocka_unit_test(a_resolved_picture_is_the_mean_of_its_samples_pictures),
        cmocka_unit_test(multisampled_depth_on_other_targets_is_the_mean_over_the_samples),
        cmocka_unit_test(depth_that_cannot_be_read_is_refused_by_name),
        cmocka_unit_test(a_texture_that_is_no_depth_is_refused),
        cmocka_unit_test(linear_depth_that_is_drawn_to_is_refused),
        cmocka_unit_test(a_depth_texture_smaller_than_what_is_drawn_is_refused),
        cmocka_unit_test(a_viewport_larger_than_the_target_needs_no_more_depth_than_that),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    canvas_destroy(&target);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
