/* A host that computes the light in its own shader, from the text that the library gives: as ew_draw does, pixel by pixel.
 *
 *     include_test CONTEXT    one of the names in context.h */
#include "effect_fixture.h"
#include "program_context.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static gl_context *context;
static GLuint target;
static GLuint vertex_array;

enum { HOST_BINDING = 3 }; /* the host's own choice */

static ew_effect *create_effect(void)
{
    ew_effect *effect = NULL;
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    assert_int_equal(ew_create_effect(&desc, &effect, NULL), EW_OK);
    return effect;
}

/* ---- The host ------------------------------------------------------------------------------------------------------------ */

static GLuint compile(GLenum stage, int count, const char *const *strings)
{
    GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, count, strings, NULL);
    gl.CompileShader(shader);
    return shader;
}

/* A program with a quad of its own, which knows the view ray's direction, of unit view depth, at each pixel. */
static GLuint build_host_program(const char *light_text, const char *main_text)
{
    const char *version = gl.es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n";
    const char *const vertex_strings[] = {version, "uniform mat3 camera;\nout vec3 direction;\nvoid main()\n{\n"
                                                   "vec2 corner = 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0;\n"
                                                   "direction = camera * vec3(corner, 1.0);\n"
                                                   "gl_Position = vec4(corner, 0.0, 1.0);\n}\n"};
    const char *const fragment_strings[] = {version, light_text, "in vec3 direction;\nout vec4 color;\n", main_text};
    GLuint program = gl.CreateProgram();
    gl.AttachShader(program, compile(GL_VERTEX_SHADER, 2, vertex_strings));
    gl.AttachShader(program, compile(GL_FRAGMENT_SHADER, 4, fragment_strings));
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    char log[500] = "";
    gl.GetProgramInfoLog(program, sizeof log, NULL, log);
    if (!linked) fail_msg("%s", log);
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "ew_uniforms"), HOST_BINDING);
    return program;
}

static void host_draw(GLuint program, ew_effect *effect, const ew_frame_desc *frame, picture *drawn)
{
    unsigned buffer = 0;
    ew_error error = {.text = ""};
    if (ew_update_uniform_buffer(effect, frame, &buffer, &error) != EW_OK) fail_msg("%s", error.text);
    clear_target(target);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target);
    gl.Viewport(0, 0, PICTURE_WIDTH, PICTURE_HEIGHT);
    gl.UseProgram(program);
    /* The world's axes in the view: right, up and forward, for the default projection of 90 degrees. */
    GLfloat camera[9];
    for (int column = 0; column < 3; column++)
        for (int row = 0; row < 3; row++)
            camera[3 * column + row] = (GLfloat)(frame->view[4 * row + column] * (column == 2 ? -1 : 1));
    gl.UniformMatrix3fv(gl.GetUniformLocation(program, "camera"), 1, GL_FALSE, camera);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, HOST_BINDING, buffer);
    gl.BindVertexArray(vertex_array);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.BindVertexArray(0);
    gl.UseProgram(0);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, HOST_BINDING, 0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    read_target(target, drawn);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static GLuint build_for_frame(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, const char *main_text)
{
    const char *text = NULL;
    ew_error error = {.text = ""};
    if (ew_get_shader_text(effect, mix, frame, &text, &error) != EW_OK) fail_msg("%s", error.text);
    return build_host_program(text, main_text);
}

static GLuint build_for(ew_effect *effect, const ew_mix *mix, ew_integrator integrator, const char *main_text)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.interval_start = 1;
    frame.interval_end = 2;
    frame.integrator = integrator;
    return build_for_frame(effect, mix, &frame, main_text);
}

/* ---- Its camera, turned and far from the origin -----------------------------------------------------------------------------
 */

static const double far_away[3] = {1e5, -3e4, 2e5};

static void turn_camera(ew_frame_desc *frame, const double center[3])
{
    /* About y, then about x. */
    const double cy = cos(0.6), sy = sin(0.6), cx = cos(-0.4), sx = sin(-0.4);
    const double rotation[3][3] = {{cy, 0, sy}, {sx * sy, cx, -sx * cy}, {-cx * sy, sx, cx * cy}};
    for (int row = 0; row < 3; row++) {
        frame->view[12 + row] = row == 2 ? -6 : 0;
        for (int column = 0; column < 3; column++) {
            frame->view[4 * column + row] = rotation[row][column];
            frame->view[12 + row] -= rotation[row][column] * center[column];
        }
    }
}

static void move_field(field *f, const double by[3])
{
    for (int i = 0; i < FIELD_SIZE; i++) {
        for (int j = 0; j < 3; j++) {
            f->points[i].position[j] += by[j];
            f->lines[i].position[j] += by[j];
            f->tori[i].center[j] += by[j];
            f->curves[i].polynomial[0][j] += by[j];
        }
    }
}

static void set_field(ew_effect *effect, size_t points, size_t lines, size_t tori, size_t curves, bool weighted)
{
    field f;
    make_field(&f, points, lines, tori, curves, weighted);
    move_field(&f, far_away);
    assert_int_equal(ew_set_sources(effect, &f.desc, NULL), EW_OK);
}

static ew_frame_desc make_turned_frame(ew_output output)
{
    ew_frame_desc frame = make_frame(target, output);
    frame.quality = EW_QUALITY_ERROR_1E_4;
    turn_camera(&frame, far_away);
    return frame;
}

static void draw_expected(ew_effect *effect, const ew_frame_desc *frame, picture *expected)
{
    clear_target(target);
    assert_int_equal(ew_draw(effect, frame, NULL), EW_OK);
    read_target(target, expected);
}

/* Each pixel, relative to itself, within the error of the quality drawn with: rays that are rounded differently may be
 * integrated over other panels. */
static void expect_same(const picture *actual, const picture *expected, int channels)
{
    const double tolerance = 1e-4;
    double worst = 0, brightest = 0;
    for (int y = 0; y < PICTURE_HEIGHT; y++) {
        for (int x = 0; x < PICTURE_WIDTH; x++) {
            for (int i = 0; i < channels; i++) {
                double a = (double)actual->pixels[y][x][i], b = (double)expected->pixels[y][x][i];
                assert_true(isfinite(a) && b > 0);
                worst = fmax(worst, fabs(a - b) / b);
                brightest = fmax(brightest, b);
            }
        }
    }
    print_message("largest relative difference %.2g, brightest %g\n", worst, brightest);
    assert_true(brightest > 0.01);
    assert_true(worst < tolerance);
}

/* ---- The tests -------------------------------------------------------------------------------------------------------------
 */

static const char luminance_main[] =
    "void main() { color = vec4(ew_luminance(vec3(0.0), direction, vec2(2.0, 10.0), 1e30), 0.0, 0.0, 1.0); }\n";

/* With one source of each kind, for the two tests that follow. */
static ew_effect *one_of_each;
static GLuint one_of_each_program;
static picture one_of_each_expected;

static int set_up_one_of_each(void **state)
{
    (void)state;
    one_of_each = create_effect();
    set_field(one_of_each, 1, 1, 1, 1, true);
    const ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    draw_expected(one_of_each, &frame, &one_of_each_expected);
    one_of_each_program = build_for(one_of_each, NULL, EW_INTEGRATOR_ADAPTIVE, luminance_main);
    return 0;
}

static int tear_down_one_of_each(void **state)
{
    (void)state;
    gl.DeleteProgram(one_of_each_program);
    ew_destroy_effect(one_of_each);
    return 0;
}

static void a_hosts_shader_has_the_luminance_of_ew_draw(void **state)
{
    (void)state;
    const ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    picture drawn;
    host_draw(one_of_each_program, one_of_each, &frame, &drawn);
    expect_same(&drawn, &one_of_each_expected, 1);
}

/* The frame in the buffer only sets the unit of length. */
static void the_rays_may_be_much_shorter_or_longer_than_the_frames(void **state)
{
    (void)state;
    static const double lengths[] = {8e-3, 800};
    for (int i = 0; i < 2; i++) {
        ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
        frame.interval_end = frame.interval_start + lengths[i];
        picture drawn;
        host_draw(one_of_each_program, one_of_each, &frame, &drawn);
        expect_same(&drawn, &one_of_each_expected, 1);
    }
}

static void a_hosts_shader_has_simpsons_rule(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    set_field(effect, 1, 0, 0, 0, false);
    ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    frame.integrator = EW_INTEGRATOR_SIMPSON;
    frame.simpson_divisions = 20;
    picture drawn, expected;
    draw_expected(effect, &frame, &expected);
    GLuint program = build_for(effect, NULL, EW_INTEGRATOR_SIMPSON, luminance_main);
    host_draw(program, effect, &frame, &drawn);
    gl.DeleteProgram(program);
    expect_same(&drawn, &expected, 1);
    ew_destroy_effect(effect);
}

/* ---- The world integral ---- */

/* The field with a reach for every source, and a path. */
static void set_world_field(ew_effect *effect)
{
    static double points[4][3] = {{-1.5, -1, 0}, {-0.5, 1, 0.5}, {0.5, -1, -0.5}, {1.5, 1, 0}};
    ew_path path = {
        .kind = EW_PATH_CATMULL_ROM, .points = (const double(*)[3])points, .point_count = 4, .brightness = 0.4, .core = 0.05};
    field f;
    make_field(&f, 2, 1, 1, 1, true);
    move_field(&f, far_away);
    double moved[4][3];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++)
            moved[i][j] = points[i][j] + far_away[j];
    path.points = (const double(*)[3])moved;
    path.reach = f.points[0].reach = f.points[1].reach = f.lines[0].reach = f.tori[0].reach = f.curves[0].reach = 1.5;
    path.sharpness = f.points[0].sharpness = 2;
    memcpy(path.color, (double[3]){0.3, 0.6, 1}, sizeof path.color);
    f.desc.paths = &path;
    f.desc.path_count = 1;
    ew_error error = {.text = ""};
    if (ew_set_sources(effect, &f.desc, &error) != EW_OK) fail_msg("%s", error.text);
}

static ew_frame_desc make_world_frame(ew_output output)
{
    ew_frame_desc frame = make_turned_frame(output);
    frame.interval_start = frame.interval_end = 0;
    return frame;
}

/* Unlike the papers', it leaves pixels dark: differences are relative to the brightest. */
static void expect_same_world(picture *drawn, picture *expected, int channels)
{
    for (int y = 0; y < PICTURE_HEIGHT; y++)
        for (int x = 0; x < PICTURE_WIDTH; x++)
            for (int i = channels; i < 4; i++)
                drawn->pixels[y][x][i] = expected->pixels[y][x][i] = 0;
    assert_true(picture_difference(drawn, expected) < 1e-4);
}

static void a_hosts_shader_has_the_world_light_of_ew_draw(void **state)
{
    (void)state;
    static const ew_integrator integrators[] = {EW_INTEGRATOR_ADAPTIVE, EW_INTEGRATOR_SIMPSON};
    static const double core_pixels[] = {0, EW_CORE_PIXELS_DEFAULT};
    ew_effect *effect = create_effect();
    set_world_field(effect);
    for (int i = 0; i < 4; i++) {
        ew_frame_desc frame = make_world_frame(EW_OUTPUT_ADD);
        frame.integrator = integrators[i / 2];
        frame.core_pixels = core_pixels[i % 2];
        GLuint program =
            build_for_frame(effect, NULL, &frame, "void main() { color = ew_light(vec3(0.0), direction, 1e30); }\n");
        picture drawn, expected;
        host_draw(program, effect, &frame, &drawn);
        gl.DeleteProgram(program);
        draw_expected(effect, &frame, &expected);
        expect_same_world(&drawn, &expected, 3);
    }
    ew_destroy_effect(effect);
}

/* Even fog and fog by height, in the world integral and in the papers'. */
static void a_hosts_shader_has_the_fog_of_ew_draw(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    for (int i = 0; i < 4; i++) {
        ew_frame_desc frame = i < 2 ? make_world_frame(EW_OUTPUT_ADD) : make_turned_frame(EW_OUTPUT_ADD);
        frame.fog = (ew_fog){.extinction = 0.3, .up = {0, 2, 0}, .base = far_away[1]};
        if (i % 2 == 1) frame.fog.scale = 2;
        set_world_field(effect);
        const char *main_text = i < 2 ? "void main() { color = ew_light(vec3(0.0), direction, 1e30); }\n"
                                      : "void main() { color = ew_light(vec3(0.0), direction, vec2(2.0, 10.0), 1e30); }\n";
        GLuint program = build_for_frame(effect, NULL, &frame, main_text);
        picture drawn, expected, clear;
        host_draw(program, effect, &frame, &drawn);
        gl.DeleteProgram(program);
        draw_expected(effect, &frame, &expected);
        expect_same_world(&drawn, &expected, 3);
        frame.fog.extinction = 0;
        draw_expected(effect, &frame, &clear);
        assert_true(picture_difference(&expected, &clear) > 0.3);
    }
    ew_destroy_effect(effect);
}

/* In clear air and in fog by height, in the world integral and in the papers'. */
static void a_hosts_shader_has_the_media_of_ew_draw(void **state)
{
    (void)state;
    const double *at = far_away;
    const ew_medium media[] = {{.center = {at[0] - 0.5, at[1], at[2]},
                                .half_axes = {{1, 0, 0}, {0, 1.5, 0.3}, {0, -0.3, 0.5}},
                                .extinction = 0.7,
                                .albedo = 0.5,
                                .ambient = {0.2, 0.4, 0.6}},
                               {.shape = EW_MEDIUM_ELLIPSOID,
                                .center = {at[0] + 0.5, at[1], at[2] + 0.5},
                                .half_axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                .extinction = 1.2,
                                .albedo = 0.8,
                                .ambient = {0.5, 0.3, 0.1}}};
    ew_effect *effect = create_effect();
    for (int i = 0; i < 4; i++) {
        ew_frame_desc frame = i < 2 ? make_world_frame(EW_OUTPUT_LERP) : make_turned_frame(EW_OUTPUT_LERP);
        frame.media = media;
        frame.medium_count = 2;
        if (i % 2 == 1) frame.fog = (ew_fog){.extinction = 0.3, .up = {0, 2, 0}, .base = far_away[1], .scale = 2};
        set_world_field(effect);
        /* Over black: the media's light pales by B, as the composite says. A call leaves nothing behind for the next one. */
        const char *light = i < 2 ? "vec4 light = ew_light(vec3(0.0), direction, 1e30);\n"
                                    "light = ew_light(vec3(0.0), direction, 1e30);\n"
                                  : "vec4 light = ew_light(vec3(0.0), direction, vec2(2.0, 10.0), 1e30);\n";
        char main_text[400];
        snprintf(main_text, sizeof main_text,
                 "void main() {\n%svec4 media = ew_media_light(vec3(0.0), direction, 1e30);\n"
                 "color = vec4(light.rgb + max(1.0 - light.a, 0.0) * media.rgb, 1.0); }\n",
                 light);
        GLuint program = build_for_frame(effect, NULL, &frame, main_text);
        picture drawn, expected, clear;
        host_draw(program, effect, &frame, &drawn);
        gl.DeleteProgram(program);
        draw_expected(effect, &frame, &expected);
        expect_same_world(&drawn, &expected, 3);
        frame.medium_count = 0;
        draw_expected(effect, &frame, &clear);
        assert_true(picture_difference(&expected, &clear) > 0.3);
    }
    ew_destroy_effect(effect);
}

/* With distances along unit vectors, from elsewhere on the ray, and in two parts. */
static void world_rays_may_start_anywhere_and_be_of_any_length(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    set_world_field(effect);
    ew_frame_desc frame = make_world_frame(EW_OUTPUT_LUMINANCE);
    frame.core_pixels = 0;
    GLuint program =
        build_for_frame(effect, NULL, &frame,
                        "void main()\n{\nvec3 unit = normalize(direction);\n"
                        "float light = ew_luminance(vec3(0.0), 7.0 * direction, 1e30);\n"
                        "color = vec4(light, ew_luminance(vec3(0.0), unit, 1e6), ew_luminance(unit, unit, 1e6), 1.0);\n}\n");
    picture drawn, expected;
    host_draw(program, effect, &frame, &drawn);
    gl.DeleteProgram(program);
    draw_expected(effect, &frame, &expected);
    const picture measured = drawn;
    expect_same_world(&drawn, &expected, 1);
    /* The other two: all of the sources lie beyond 1. */
    for (int i = 1; i < 3; i++) {
        picture other;
        for (int y = 0; y < PICTURE_HEIGHT; y++)
            for (int x = 0; x < PICTURE_WIDTH; x++)
                other.pixels[y][x][0] = measured.pixels[y][x][i];
        expect_same_world(&other, &expected, 1);
    }
    ew_destroy_effect(effect);
}

/* One shader for any number of sources; the rays' interval is another than that of the frame in the buffer. */
static void a_general_hosts_shader_has_the_coloured_light_of_ew_draw(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    const ew_mix mix = {.point_count = EW_ANY_COUNT, .line_count = EW_ANY_COUNT};
    GLuint program = build_for(effect, &mix, EW_INTEGRATOR_ADAPTIVE,
                               "void main() { color = ew_light(vec3(0.0), direction, vec2(3.0, 8.0), 1e30); }\n");
    static const size_t counts[][2] = {{3, 0}, {0, 2}, {8, 7}};
    for (int i = 0; i < 3; i++) {
        set_field(effect, counts[i][0], counts[i][1], 0, 0, false);
        ew_frame_desc frame = make_turned_frame(EW_OUTPUT_ADD);
        picture drawn, expected;
        host_draw(program, effect, &frame, &drawn);
        frame.interval_start = 3;
        frame.interval_end = 8;
        draw_expected(effect, &frame, &expected);
        expect_same(&drawn, &expected, 3);
    }
    gl.DeleteProgram(program);
    ew_destroy_effect(effect);
}

/* What a deferred pass or a ray marcher does: rays from elsewhere, with distances along unit vectors, up to a wall. */
static void rays_may_start_anywhere_and_end_at_what_is_opaque(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    set_field(effect, 2, 1, 0, 0, false);
    ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    picture drawn, expected;
    GLuint program = build_for(effect, NULL, EW_INTEGRATOR_ADAPTIVE,
                               "void main()\n{\nvec3 origin = 1.5 * direction, unit = normalize(direction);\n"
                               "float scale = length(direction);\n"
                               "float light = ew_luminance(origin, unit, vec2(0.5, 8.5) * scale, 4.5 * scale);\n"
                               "color = vec4(light, 0.0, 0.0, 1.0);\n}\n");
    host_draw(program, effect, &frame, &drawn);
    gl.DeleteProgram(program);

    /* The same wall, at view depth 6, for ew_draw. */
    GLfloat depth[PICTURE_HEIGHT][PICTURE_WIDTH];
    const double *p = frame.projection;
    for (int y = 0; y < PICTURE_HEIGHT; y++)
        for (int x = 0; x < PICTURE_WIDTH; x++)
            depth[y][x] = (GLfloat)(0.5 + 0.5 * (-6 * p[10] + p[14]) / 6);
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, PICTURE_WIDTH, PICTURE_HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                  depth);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    frame.depth_texture = texture;
    draw_expected(effect, &frame, &expected);
    gl.DeleteTextures(1, &texture);
    expect_same(&drawn, &expected, 1);
    ew_destroy_effect(effect);
}

static void the_buffer_keeps_its_name_and_the_host_its_binding(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    GLuint own;
    gl.GenBuffers(1, &own);
    gl.BindBuffer(GL_UNIFORM_BUFFER, own);
    unsigned first = 0, second = 0;
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &first, NULL), EW_OK);
    assert_int_equal(ew_draw(effect, &frame, NULL), EW_OK);
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &second, NULL), EW_OK);
    assert_true(first != 0 && first != own && first == second);
    GLint bound = 0;
    gl.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &bound);
    assert_int_equal(bound, own);
    gl.DeleteBuffers(1, &own);
    ew_destroy_effect(effect);
}

/* A host that draws light on surfaces hands over that frame for its own shaders, too. */
static void the_output_of_the_frame_does_not_matter(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    set_field(effect, 1, 1, 1, 1, false);
    ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    picture drawn, expected;
    draw_expected(effect, &frame, &expected);
    frame.output = EW_OUTPUT_SURFACES;
    frame.light_reach = 3;
    GLuint program = build_for_frame(effect, NULL, &frame, luminance_main);
    host_draw(program, effect, &frame, &drawn);
    gl.DeleteProgram(program);
    expect_same(&drawn, &expected, 1);
    ew_destroy_effect(effect);
}

static void bad_arguments_are_errors_that_change_nothing(void **state)
{
    (void)state;
    ew_effect *effect = create_effect();
    ew_frame_desc frame = make_turned_frame(EW_OUTPUT_LUMINANCE);
    const char *text = "unchanged";
    unsigned buffer = 7;
    ew_error error = {.text = ""};
    assert_int_equal(ew_get_shader_text(NULL, NULL, &frame, &text, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_get_shader_text(effect, NULL, &frame, NULL, &error), EW_ERROR_INVALID_ARGUMENT);
    frame.integrator = (ew_integrator)2;
    assert_int_equal(ew_get_shader_text(effect, NULL, &frame, &text, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "integrator"));
    assert_string_equal(text, "unchanged");
    assert_int_equal(ew_update_uniform_buffer(NULL, &frame, &buffer, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_update_uniform_buffer(effect, NULL, &buffer, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, NULL, &error), EW_ERROR_INVALID_ARGUMENT);
    frame.decay_beta = 0;
    assert_int_equal(ew_update_uniform_buffer(effect, &frame, &buffer, &error), EW_ERROR_INVALID_ARGUMENT);
    assert_non_null(strstr(error.text, "decay_beta"));
    assert_int_equal(buffer, 7);
    ew_destroy_effect(effect);
}

int main(int argc, char **argv)
{
    if (argc != 2 || (context = open_context(argv[1], NULL)) == NULL) return 2;
    target = make_target(NULL);
    gl.GenVertexArrays(1, &vertex_array);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_hosts_shader_has_the_luminance_of_ew_draw),
        cmocka_unit_test(the_rays_may_be_much_shorter_or_longer_than_the_frames),
        cmocka_unit_test(a_hosts_shader_has_simpsons_rule),
        cmocka_unit_test(a_general_hosts_shader_has_the_coloured_light_of_ew_draw),
        cmocka_unit_test(rays_may_start_anywhere_and_end_at_what_is_opaque),
        cmocka_unit_test(a_hosts_shader_has_the_world_light_of_ew_draw),
        cmocka_unit_test(a_hosts_shader_has_the_fog_of_ew_draw),
        cmocka_unit_test(a_hosts_shader_has_the_media_of_ew_draw),
        cmocka_unit_test(world_rays_may_start_anywhere_and_be_of_any_length),
        cmocka_unit_test(the_buffer_keeps_its_name_and_the_host_its_binding),
        cmocka_unit_test(the_output_of_the_frame_does_not_matter),
        cmocka_unit_test(bad_arguments_are_errors_that_change_nothing),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, set_up_one_of_each, tear_down_one_of_each);
    close_context(context);
    return failed;
}
