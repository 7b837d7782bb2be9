/* What ew_irradiance promises: the light on surfaces at random places around sources of every kind, against its definition.
 *
 *     irradiance_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "random_numbers.h"
#include "reference_irradiance.h"
#include "source_kinds.h"
#include "stage.h"
#include "vector.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The reference takes its time: one pixel in three is compared. */
enum { HOST_BINDING = 2, SURFACE_COUNT = STAGE_WIDTH * STAGE_HEIGHT, COMPARED_STEP = 3 };

static const double light_reach = 3, light_gain = 2;

static reference_surface surfaces[SURFACE_COUNT];
static float roughness; /* 0: diffuse surfaces */

/* ---- The host's shader -------------------------------------------------------------------------------------------------- */

static GLuint compile(GLenum stage, int count, const char *const *strings)
{
    GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, count, strings, NULL);
    gl.CompileShader(shader);
    return shader;
}

static GLuint build_program(const char *light_text)
{
    const char *version =
        gl.es ? "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\n" : "#version 330 core\n";
    const char *const vertex[] = {version,
                                  "void main()\n{\n"
                                  "gl_Position = vec4(2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0);\n}\n"};
    const char *const fragment[] = {
        version, light_text,
        "uniform sampler2D positions;\nuniform sampler2D normals;\nuniform float roughness;\nout vec4 color;\nvoid main()\n{\n"
        "ivec2 place = ivec2(gl_FragCoord.xy);\n"
        "vec3 position = texelFetch(positions, place, 0).xyz;\nvec3 normal = texelFetch(normals, place, 0).xyz;\n"
        "if (roughness == 0.0) color = vec4(ew_irradiance(position, normal), 1.0);\n"
        "else color = vec4(ew_specular(position, normal, vec3(0.3, 0.5, 1.0), roughness), 1.0);\n}\n"};
    GLuint program = gl.CreateProgram();
    gl.AttachShader(program, compile(GL_VERTEX_SHADER, 2, vertex));
    gl.AttachShader(program, compile(GL_FRAGMENT_SHADER, 3, fragment));
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    char log[500] = "";
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    gl.GetProgramInfoLog(program, sizeof log, NULL, log);
    if (!linked) fail_msg("%s", log);
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "ew_uniforms"), HOST_BINDING);
    return program;
}

static GLuint make_texture(GLuint unit, bool of_normals, const double eye[3])
{
    static GLfloat data[SURFACE_COUNT][4];
    for (int i = 0; i < SURFACE_COUNT; i++)
        for (int k = 0; k < 3; k++)
            data[i][k] = (GLfloat)(of_normals ? surfaces[i].normal[k] : surfaces[i].position[k] - eye[k]);
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, STAGE_WIDTH, STAGE_HEIGHT, 0, GL_RGBA, GL_FLOAT, data);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/* The irradiance of the surfaces, one a pixel. */
static void shade(const ew_frame_desc *frame, stage_picture lit)
{
    const double eye[3] = {0, 0, -frame->view[14]};
    const char *text = NULL;
    unsigned buffer = 0;
    ew_error error = {.text = ""};
    if (ew_get_shader_text(stage_effect(), NULL, frame, &text, &error) != EW_OK) fail_msg("%s", error.text);
    GLuint program = build_program(text), vertex_array;
    if (ew_update_uniform_buffer(stage_effect(), frame, &buffer, &error) != EW_OK) fail_msg("%s", error.text);
    const GLuint textures[] = {make_texture(0, false, eye), make_texture(1, true, eye)};
    gl.GenVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl.Viewport(0, 0, STAGE_WIDTH, STAGE_HEIGHT);
    gl.UseProgram(program);
    gl.Uniform1i(gl.GetUniformLocation(program, "normals"), 1);
    gl.Uniform1f(gl.GetUniformLocation(program, "roughness"), roughness);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, HOST_BINDING, buffer);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.ReadPixels(0, 0, STAGE_WIDTH, STAGE_HEIGHT, GL_RGBA, GL_FLOAT, lit);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.UseProgram(0);
    gl.DeleteProgram(program);
    gl.DeleteVertexArrays(1, &vertex_array);
    gl.DeleteTextures(2, textures);
    gl.ActiveTexture(GL_TEXTURE0);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

/* ---- Surfaces and sources ----------------------------------------------------------------------------------------------- */

static void random_direction_of(uint64_t *random, double direction[3])
{
    do {
        for (int k = 0; k < 3; k++)
            direction[k] = random_between(random, -1, 1);
    } while (vector_dot(direction, direction) > 1 || !vector_normalize(direction, direction));
}

/* The distance from the source, as if it were so many points. */
static double distance_from(const source_kind *kind, const void *source, const double position[3])
{
    enum { PLACES = 300 };
    const source_view view = {{0, 0, 0}, 4};
    double nearest = HUGE_VAL;
    for (int i = 0; i <= PLACES; i++) {
        double place[3];
        kind->place(source, &view, (double)i / PLACES, place);
        for (int k = 0; k < 3; k++)
            place[k] -= position[k];
        nearest = fmin(nearest, sqrt(vector_dot(place, place)));
    }
    return nearest;
}

/* At all distances from places on the source, from within the core to beyond the reach, and turned any way. */
static void place_surfaces(const source_kind *kind, const void *source, uint64_t seed)
{
    const source_view view = {{0, 0, 0}, 4};
    uint64_t random = seed;
    for (int i = 0; i < SURFACE_COUNT; i++) {
        double place[3], away[3];
        do {
            kind->place(source, &view, random_unit(&random), place);
            random_direction_of(&random, away);
            vector_add_scaled(place, pow(10, random_between(&random, roughness > 0 ? -1 : -2.5, 0.5)), away,
                              surfaces[i].position);
        } while (roughness > 0 && i % COMPARED_STEP == 0 && distance_from(kind, source, surfaces[i].position) < 0.1);
        for (int k = 0; k < 3; k++) /* as the shader gets it */
            surfaces[i].position[k] = (double)(GLfloat)(surfaces[i].position[k]);
        random_direction_of(&random, surfaces[i].normal);
    }
}

static reference_gloss gloss_of(const reference_surface *surface)
{
    double to_eye[3];
    reference_gloss gloss = {.exponent = fmax(2 / pow((double)roughness, 4) - 2, 1)};
    vector_normalize((const double[3]){0.3, 0.5, 1}, to_eye);
    for (int i = 0; i < 3; i++)
        gloss.mirrored[i] = 2 * vector_dot(to_eye, surface->normal) * surface->normal[i] - to_eye[i];
    return gloss;
}

typedef struct light_error {
    double largest; /* relative to the brightest surface */
    double share;   /* the sum of all errors, relative to all light */
} light_error;

static light_error compare(const ew_sources_desc *sources, stage_picture lit)
{
    double brightest = 0, all = 0;
    light_error error = {0, 0};
    for (int i = 0; i < SURFACE_COUNT; i += COMPARED_STEP) {
        double irradiance[3];
        const reference_gloss gloss = gloss_of(&surfaces[i]);
        reference_irradiance(sources, light_reach, &surfaces[i], roughness > 0 ? &gloss : NULL, irradiance);
        const double truth = light_gain * irradiance[0], is = (double)lit[i / STAGE_WIDTH][i % STAGE_WIDTH][0];
        assert_true(isfinite(is));
        brightest = fmax(brightest, truth);
        all += truth;
        error.largest = fmax(error.largest, fabs(is - truth));
        error.share += fabs(is - truth);
    }
    assert_true(brightest > 0);
    return (light_error){error.largest / brightest, error.share / all};
}

#define LIGHT .brightness = 1, .color = {1, 0.5, 0.25}, .core = 0.05, .reach = 1

static const double bent[3][3] = {{-1.5, -0.5, 0.2}, {3, 0.4, -0.5}, {0, 1.5, 0.3}},
                    hairpin[3][3] = {{-1, 0, 0}, {4, 1, 0}, {-4, 0, 0.1}}, fold[3][3] = {{-1, 0, 0}, {4, 0.2, 0}, {-4, 0, 0.1}};
static const double corners[][3] = {{-1, -1, 0},   {0.2, 0.4, 0.5}, {0.4, -0.6, -0.3}, {1, 0.8, 0},
                                    {1.2, 1, 0.8}, {0, 1.2, 1},     {-0.6, 0.9, 0.4}};
static const double pulse[] = {0, 0.2, 1, 0.4, 0, 0.7, 0.1}, ramp[] = {0.2, 1};

static light_error error_of(const char *name, const source_kind *kind, const void *source, const ew_sources_desc *sources)
{
    static stage_picture lit;
    ew_frame_desc frame = stage_frame(6);
    frame.light_gain = light_gain;
    frame.light_reach = light_reach;
    stage_set(sources);
    place_surfaces(kind, source, 17);
    shade(&frame, lit);
    const light_error error = compare(sources, lit);
    fprintf(stderr, "%s: off by %.2g of the largest, by %.2g of all light\n", name, error.largest, error.share);
    return error;
}

static void expect_error_within(double bound, const char *name, const source_kind *kind, const void *source,
                                const ew_sources_desc *sources)
{
    assert_true(error_of(name, kind, source, sources).largest <= bound);
}

static void points_and_lines_light_surfaces(void **state)
{
    (void)state;
    const ew_point point = {.position = {0.1, -0.2, 0.3}, LIGHT};
    const ew_line line = {.position = {0.1, -0.2, 0.3}, .direction = {1, 2, -0.5}, LIGHT};
    expect_error_within(1e-2, "point", source_kinds[KIND_POINT], &point,
                        &(ew_sources_desc){.points = &point, .point_count = 1});
    expect_error_within(1e-2, "line", source_kinds[KIND_LINE], &line, &(ew_sources_desc){.lines = &line, .line_count = 1});
}

static void tori_light_surfaces(void **state)
{
    (void)state;
    static const double radii[] = {0.02, 0.3, 1, 4};
    for (int i = 0; i < 4; i++) {
        const ew_torus torus = {.center = {0.1, -0.2, 0.3}, .axis = {1, 2, -0.5}, .radius = radii[i], LIGHT};
        expect_error_within(1e-2, "torus", source_kinds[KIND_TORUS], &torus,
                            &(ew_sources_desc){.tori = &torus, .torus_count = 1});
    }
}

static void expect_curve_within(double bound, const double polynomial[3][3], bool weighted)
{
    ew_curve curve = {.domain = {0, 1}, LIGHT};
    memcpy(curve.polynomial, polynomial, sizeof curve.polynomial);
    if (weighted) curve.weights = pulse, curve.weight_count = 7;
    expect_error_within(bound, "curve", source_kinds[KIND_CURVE], &curve,
                        &(ew_sources_desc){.curves = &curve, .curve_count = 1});
}

static void curves_light_surfaces(void **state)
{
    (void)state;
    for (int weighted = 0; weighted < 2; weighted++) {
        expect_curve_within(1e-2, bent, weighted);
        expect_curve_within(1e-2, hairpin, weighted);
    }
}

/* It turns within a tenth of its core's radius, where no straight piece stands for it. */
static void a_fold_within_its_core_lights_surfaces(void **state)
{
    (void)state;
    for (int weighted = 0; weighted < 2; weighted++)
        expect_curve_within(1e-2, fold, weighted);
}

static void paths_light_surfaces(void **state)
{
    (void)state;
    static const char *const names[] = {"polyline", "bspline", "bezier", "catmull_rom"};
    for (int kind = EW_PATH_POLYLINE; kind <= EW_PATH_CATMULL_ROM; kind++)
        for (int weighted = 0; weighted < 2; weighted++) {
            ew_path path = {.kind = (ew_path_kind)kind, .points = corners, .point_count = 7, LIGHT};
            path.is_closed = kind == EW_PATH_CATMULL_ROM;
            if (weighted) path.weights = pulse, path.weight_count = 7;
            expect_error_within(1e-2, names[kind], source_kinds[KIND_PATH], &path,
                                &(ew_sources_desc){.paths = &path, .path_count = 1});
        }
    const ew_path beam = {.points = corners, .point_count = 2, .weights = ramp, .weight_count = 2, LIGHT};
    expect_error_within(1e-2, "beam", source_kinds[KIND_PATH], &beam, &(ew_sources_desc){.paths = &beam, .path_count = 1});
}

/* Outside of the cores. Next to them a chord that stands for a bent piece turns a narrow lobe away. */
static void glossy_surfaces_mirror_nearly_all_that_they_should(void **state)
{
    (void)state;
    static const float all_roughness[] = {0.3f, 0.7f};
    const ew_point point = {.position = {0.1, -0.2, 0.3}, LIGHT};
    const ew_line line = {.position = {0.1, -0.2, 0.3}, .direction = {1, 2, -0.5}, LIGHT};
    const ew_torus torus = {.center = {0.1, -0.2, 0.3}, .axis = {1, 2, -0.5}, .radius = 1, LIGHT};
    ew_curve curve = {.domain = {0, 1}, .weights = pulse, .weight_count = 7, LIGHT};
    memcpy(curve.polynomial, bent, sizeof curve.polynomial);
    const ew_path path = {.kind = EW_PATH_CATMULL_ROM, .points = corners, .point_count = 7, LIGHT};
    for (int i = 0; i < 2; i++) {
        roughness = all_roughness[i];
        const light_error errors[] = {
            error_of("point", source_kinds[KIND_POINT], &point, &(ew_sources_desc){.points = &point, .point_count = 1}),
            error_of("line", source_kinds[KIND_LINE], &line, &(ew_sources_desc){.lines = &line, .line_count = 1}),
            error_of("torus", source_kinds[KIND_TORUS], &torus, &(ew_sources_desc){.tori = &torus, .torus_count = 1}),
            error_of("curve", source_kinds[KIND_CURVE], &curve, &(ew_sources_desc){.curves = &curve, .curve_count = 1}),
            error_of("path", source_kinds[KIND_PATH], &path, &(ew_sources_desc){.paths = &path, .path_count = 1}),
        };
        for (size_t k = 0; k < sizeof errors / sizeof *errors; k++)
            assert_true(errors[k].share <= 3e-2);
    }
    roughness = 0;
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: irradiance_test CONTEXT\n");
        return 2;
    }
    if (!stage_open(argv[1])) return 77;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_and_lines_light_surfaces),
        cmocka_unit_test(tori_light_surfaces),
        cmocka_unit_test(curves_light_surfaces),
        cmocka_unit_test(paths_light_surfaces),
        cmocka_unit_test(a_fold_within_its_core_lights_surfaces),
        cmocka_unit_test(glossy_surfaces_mirror_nearly_all_that_they_should),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    stage_close();
    return failed;
}
