/* What the light does to targets of every kind: encoded once, blended as documented, dithered where asked.
 *
 *     target_test CONTEXT    one of the names in context.h */
#include "canvas.h"
#include "glow.h"
#include "program_context.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = GLOW_WIDTH, HEIGHT = GLOW_HEIGHT, VALUES = WIDTH * HEIGHT * 4 };

static gl_context *context;
static ew_effect *effect;
static canvas floats, bytes, srgb;

static const GLfloat black[4] = {0, 0, 0, 1}, behind[4] = {0.5f, 0.25f, 0.75f, 0.25f};

static bool has_srgb_switch(void)
{
    return api_has(33, NEVER, "GL_EXT_sRGB_write_control");
}

static void set_srgb_switch(bool on)
{
    if (has_srgb_switch()) (on ? gl.Enable : gl.Disable)(GL_FRAMEBUFFER_SRGB);
}

/* As GL encodes: IEC 61966-2-1. */
static double encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

static void draw_over(const canvas *to, const GLfloat color[4], const ew_frame_desc *frame, GLfloat picture[VALUES])
{
    ew_frame_desc there = *frame;
    there.framebuffer = to->framebuffer;
    canvas_clear(to, color);
    glow_draw(effect, &there);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    canvas_read(to, picture);
}

static void an_srgb_target_is_encoded_once_whatever_the_switch_says(void **unused)
{
    (void)unused;
    static GLfloat linear[VALUES], encoded[VALUES];
    ew_frame_desc frame = glow_frame(0);
    frame.encoding = EW_ENCODING_FLOAT;
    draw_over(&floats, behind, &frame, linear);
    frame.encoding = EW_ENCODING_SRGB_8BIT;
    for (int on = 0; on < 2; on++) {
        set_srgb_switch(true);
        canvas_clear(&srgb, behind); /* encoded, too */
        set_srgb_switch(on);
        frame.framebuffer = srgb.framebuffer;
        glow_draw(effect, &frame);
        canvas_read(&srgb, encoded);
        for (int i = 0; i < VALUES; i++) {
            double expected = fmin((double)linear[i], 1);
            if (i % 4 != 3) expected = encode(expected);
            /* The background's own rounding, and that of the result. */
            assert_true(fabs(expected - (double)encoded[i]) <= 1.51 / 255);
        }
        assert_true(!has_srgb_switch() || gl.IsEnabled(GL_FRAMEBUFFER_SRGB) == on);
    }
    set_srgb_switch(false);
}

static void a_linear_target_keeps_its_values_whatever_the_switch_says(void **unused)
{
    (void)unused;
    static GLfloat expected[VALUES], found[VALUES];
    ew_frame_desc frame = glow_frame(0);
    draw_over(&bytes, black, &frame, expected);
    for (int on = 0; on < 2; on++) {
        set_srgb_switch(on);
        draw_over(&bytes, black, &frame, found);
        assert_memory_equal(expected, found, sizeof found);
        if (!has_srgb_switch()) continue;
        draw_over(&srgb, black, &frame, found); /* black is 0, encoded or not */
        for (int i = 0; i < VALUES; i++)
            assert_true(fabsf(expected[i] - found[i]) <= 1.01f / 255);
    }
    set_srgb_switch(false);
}

static void color_and_alpha_follow_the_documented_rules(void **unused)
{
    (void)unused;
    static GLfloat luminance[VALUES], alone[VALUES], lerp[VALUES], add[VALUES];
    ew_frame_desc frame = glow_frame(0);
    frame.encoding = EW_ENCODING_FLOAT;
    frame.decay_alpha = 2; /* so that some pixels have more than 1, and others less */
    frame.output = EW_OUTPUT_LUMINANCE;
    draw_over(&floats, behind, &frame, luminance);
    frame.output = EW_OUTPUT_ADD;
    draw_over(&floats, (const GLfloat[4]){0, 0, 0, 0}, &frame, alone);
    draw_over(&floats, behind, &frame, add);
    frame.output = EW_OUTPUT_LERP;
    draw_over(&floats, behind, &frame, lerp);
    int white = 0;
    for (int i = 0; i < VALUES; i++) {
        double b = (double)luminance[i - i % 4], light = (double)alone[i], back = (double)behind[i % 4];
        double kept = fmax(0, 1 - b) * back;
        double expected_lerp = i % 4 == 3 ? kept + fmin(1, b) : kept + light;
        double expected_add = i % 4 == 3 ? back : back + light;
        assert_true(fabs((double)lerp[i] - expected_lerp) <= 1e-5 * fmax(1, expected_lerp));
        assert_true(fabs((double)add[i] - expected_add) <= 1e-5 * fmax(1, expected_add));
        white += b > 1;
    }
    assert_true(white > 0 && white < VALUES);
}

static void a_layer_laid_over_a_picture_is_as_if_drawn_there(void **unused)
{
    (void)unused;
    static GLfloat layer[VALUES], direct[VALUES];
    ew_frame_desc frame = glow_frame(0);
    frame.encoding = EW_ENCODING_FLOAT;
    draw_over(&floats, (const GLfloat[4]){0, 0, 0, 0}, &frame, layer);
    draw_over(&floats, behind, &frame, direct);
    for (int i = 0; i < VALUES; i++) {
        double over = (double)layer[i] + (1 - (double)layer[i - i % 4 + 3]) * (double)behind[i % 4];
        assert_true(fabs(over - (double)direct[i]) <= 1e-5 * fmax(1, over));
    }
}

/* The largest difference of the means over blocks of some pixels square, in steps of 8 bits. */
static double largest_difference_of_means(const GLfloat expected[VALUES], const GLfloat found[VALUES], bool encoded, int block)
{
    double largest = 0;
    for (int y = 0; y < HEIGHT; y += block)
        for (int x = 0; x < WIDTH; x += block)
            for (int c = 0; c < 3; c++) {
                double difference = 0;
                for (int i = 0; i < block * block; i++) {
                    int at = 4 * ((y + i / block) * WIDTH + x + i % block) + c;
                    double value = (double)expected[at];
                    difference += (double)found[at] - (encoded ? encode(value) : value);
                }
                largest = fmax(largest, fabs(difference) / (block * block) * 255);
            }
    return largest;
}

static void check_dither(ew_encoding encoding, const canvas *to, double alpha)
{
    static GLfloat exact[VALUES], plain[VALUES], dithered[VALUES], again[VALUES];
    const bool encoded = encoding == EW_ENCODING_SRGB_8BIT;
    ew_frame_desc frame = glow_frame(0);
    frame.decay_alpha = alpha; /* a glow of a few steps */
    frame.encoding = EW_ENCODING_FLOAT;
    draw_over(&floats, black, &frame, exact);
    frame.dither = 1;
    draw_over(&floats, black, &frame, again);
    assert_memory_equal(exact, again, sizeof exact); /* floats need none */

    frame.encoding = encoding;
    frame.dither = 0;
    draw_over(to, black, &frame, plain);
    frame.dither = 1;
    draw_over(to, black, &frame, dithered);
    draw_over(to, black, &frame, again);
    assert_memory_equal(dithered, again, sizeof again);
    /* The noise is half a step, and the rounding another or, by Direct3D's rule for hardware that blends or encodes, 0.6. */
    const double rounding = api_is_software() ? 0.51 : 0.6;
    for (int i = 0; i < VALUES; i++) {
        double value = encoded && i % 4 != 3 ? encode((double)exact[i]) : (double)exact[i];
        double steps = fabs((double)dithered[i] - value) * 255;
        if (steps > (i % 4 == 3 ? rounding : 0.5 + rounding))
            fail_msg("component %d is %.3f steps from %g, not dithered %.3f", i % 4, steps, value,
                     fabs((double)plain[i] - value) * 255);
    }
    /* Rounding that went up or down by chance would leave a standard deviation of at most 0.5 steps a pixel; and of three,
     * hardly a block is beyond. */
    static const int blocks[] = {6, 12};
    for (int i = 0; i < 2; i++) {
        double plainly = largest_difference_of_means(exact, plain, encoded, blocks[i]);
        double left = largest_difference_of_means(exact, dithered, encoded, blocks[i]);
        fprintf(stderr, "means of %d pixels square are off by %.2f steps, dithered by %.2f\n", blocks[i], plainly, left);
        assert_true(plainly > 3 * 0.5 / blocks[i]);
        assert_true(left < 3 * 0.5 / blocks[i]);
    }
}

static void dither_keeps_the_mean_of_faint_glow(void **unused)
{
    (void)unused;
    check_dither(EW_ENCODING_LINEAR_8BIT, &bytes, 0.01);
    check_dither(EW_ENCODING_SRGB_8BIT, &srgb, 0.001);
}

/* By how much the means over blocks of 6 x 6 pixels go up and down, in the target's steps. Their own mean is left out: drivers
 * may round small floats to the nearest, or down. */
static double unevenness(const GLfloat exact[VALUES], const GLfloat found[VALUES], double fixed_step)
{
    enum { BLOCK = 6 };
    double lowest = 1e30, highest = -1e30;
    for (int y = 0; y < HEIGHT; y += BLOCK)
        for (int x = 0; x < WIDTH; x += BLOCK)
            for (int c = 0; c < 3; c++) {
                double mean = 0;
                for (int i = 0; i < BLOCK * BLOCK; i++) {
                    int at = 4 * ((y + i / BLOCK) * WIDTH + x + i % BLOCK) + c, exponent;
                    frexp((double)exact[at], &exponent);
                    /* 6 bits behind the leading one, 5 for blue */
                    double step = fixed_step > 0 ? fixed_step : ldexp(1, exponent - 1 - (c == 2 ? 5 : 6));
                    mean += ((double)found[at] - (double)exact[at]) / step / (BLOCK * BLOCK);
                }
                lowest = fmin(lowest, mean);
                highest = fmax(highest, mean);
            }
    return highest - lowest;
}

/* A glow that changes by a step every few pixels. */
static void dither_smoothes_targets_of_10_and_11_bits(void **unused)
{
    (void)unused;
    static GLfloat exact[VALUES], found[2][VALUES];
    static const struct {
        ew_encoding encoding;
        GLenum format;
        double distance, coefficient, fixed_step;
    } cases[] = {{EW_ENCODING_LINEAR_10BIT, GL_RGB10_A2, 30, 1, 1.0 / 1023},
                 {EW_ENCODING_FLOAT_11BIT, GL_R11F_G11F_B10F, 200, 150, 0}};
    for (int i = 0; i < 2; i++) {
        const ew_point far_away = {
            .position = {cases[i].distance, 10, 0}, .coefficient = cases[i].coefficient, .color = {1, 0.8, 0.7}};
        const ew_sources_desc sources = {.points = &far_away, .point_count = 1, .epsilon = 0.1};
        assert_int_equal(ew_set_sources(effect, &sources, NULL), EW_OK);
        canvas to = canvas_create(WIDTH, HEIGHT, cases[i].format, 0, 0);
        ew_frame_desc frame = glow_frame(0);
        frame.encoding = EW_ENCODING_FLOAT;
        draw_over(&floats, black, &frame, exact);
        frame.encoding = cases[i].encoding;
        frame.framebuffer = to.framebuffer;
        for (frame.dither = 0; frame.dither < 2; frame.dither++) {
            canvas_clear(&to, black);
            glow_draw(effect, &frame);
            canvas_resolve(&to, &floats);
            canvas_read(&floats, found[frame.dither]);
        }
        const double plainly = unevenness(exact, found[0], cases[i].fixed_step);
        const double left = unevenness(exact, found[1], cases[i].fixed_step);
        fprintf(stderr, "means of 6 pixels square are uneven by %.2f steps, dithered by %.2f\n", plainly, left);
        assert_true(plainly > 0.6);
        assert_true(left < plainly / 3);
        canvas_destroy(&to);
    }
    assert_int_equal(ew_set_sources(effect, &glow_sources, NULL), EW_OK);
}

static void dither_leaves_pixels_without_light_alone(void **unused)
{
    (void)unused;
    static GLfloat before[VALUES], after[VALUES];
    ew_frame_desc frame = glow_frame(0);
    frame.decay_alpha = 0;
    frame.dither = 1;
    const canvas *to[2] = {&bytes, &srgb};
    for (int i = 0; i < 2; i++) {
        frame.encoding = i ? EW_ENCODING_SRGB_8BIT : EW_ENCODING_LINEAR_8BIT;
        set_srgb_switch(i);
        canvas_clear(to[i], behind);
        set_srgb_switch(false);
        canvas_read(to[i], before);
        frame.framebuffer = to[i]->framebuffer;
        glow_draw(effect, &frame);
        canvas_read(to[i], after);
        assert_memory_equal(before, after, sizeof before);
    }
}

static void targets_of_all_sizes_take_turns(void **unused)
{
    (void)unused;
    enum { SIDES = 3 };
    static const int sides[SIDES] = {8, 33, 20};
    static const GLenum formats[SIDES] = {GL_RGBA8, GL_RGBA32F, GL_SRGB8_ALPHA8};
    static GLfloat alone[SIDES][33 * 33 * 4], in_turn[SIDES][33 * 33 * 4];
    canvas made[SIDES];
    ew_frame_desc frames[SIDES];
    for (int i = 0; i < SIDES; i++) {
        made[i] = canvas_create(sides[i], sides[i], formats[i], GL_DEPTH_COMPONENT24, 0);
        canvas_clear_depth(&made[i], 1, (const GLint[4]){0, 0, sides[i] / 2, sides[i]}, 0.88f);
        frames[i] = glow_frame(made[i].framebuffer);
        frames[i].viewport_width = frames[i].viewport_height = sides[i];
        frames[i].depth_source = EW_DEPTH_FRAMEBUFFER;
        frames[i].encoding = (ew_encoding[]){EW_ENCODING_LINEAR_8BIT, EW_ENCODING_FLOAT, EW_ENCODING_SRGB_8BIT}[i];
        ew_effect *own = glow_create(context);
        canvas_clear(&made[i], black);
        glow_draw(own, &frames[i]);
        canvas_read(&made[i], alone[i]);
        ew_destroy_effect(own);
    }
    for (int turn = 0; turn < 2; turn++) {
        for (int i = 0; i < SIDES; i++)
            canvas_clear(&made[i], black);
        for (int i = 0; i < SIDES; i++)
            glow_draw(effect, &frames[i]);
        for (int i = 0; i < SIDES; i++) {
            canvas_read(&made[i], in_turn[i]);
            assert_memory_equal(alone[i], in_turn[i], (size_t)sides[i] * (size_t)sides[i] * 4 * sizeof(GLfloat));
        }
    }
    for (int i = 0; i < SIDES; i++)
        canvas_destroy(&made[i]);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    effect = glow_create(context);
    floats = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, 0, 0);
    bytes = canvas_create(WIDTH, HEIGHT, GL_RGBA8, 0, 0);
    srgb = canvas_create(WIDTH, HEIGHT, GL_SRGB8_ALPHA8, 0, 0);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_srgb_target_is_encoded_once_whatever_the_switch_says),
        cmocka_unit_test(a_linear_target_keeps_its_values_whatever_the_switch_says),
        cmocka_unit_test(color_and_alpha_follow_the_documented_rules),
        cmocka_unit_test(a_layer_laid_over_a_picture_is_as_if_drawn_there),
        cmocka_unit_test(dither_keeps_the_mean_of_faint_glow),
        cmocka_unit_test(dither_smoothes_targets_of_10_and_11_bits),
        cmocka_unit_test(dither_leaves_pixels_without_light_alone),
        cmocka_unit_test(targets_of_all_sizes_take_turns),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    canvas_destroy(&floats);
    canvas_destroy(&bytes);
    canvas_destroy(&srgb);
    ew_destroy_effect(effect);
    close_context(context);
    return failed;
}
