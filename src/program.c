/* Assembles shaders from the files of glsl/, compiles and keeps them. */
#include "program.h"

#include "error.h"
#include "glsl_text.h"
#include "state_guard.h"

#include <stdio.h>
#include <string.h>

unsigned ew_program_key(const ew_scene *scene, const ew_frame_desc *frame)
{
    unsigned key = 0;
    if (scene->sources.point_count > 0) key |= EW_PROGRAM_POINTS;
    if (scene->sources.line_count > 0) key |= EW_PROGRAM_LINES;
    if (scene->sources.torus_count > 0) key |= EW_PROGRAM_TORI;
    if (scene->sources.curve_count > 0) key |= EW_PROGRAM_CURVES;
    if (scene->weight_piece_count > 0) key |= EW_PROGRAM_WEIGHTS;
    if (frame->depth_texture) key |= EW_PROGRAM_DEPTH;
    if (frame->integrator == EW_INTEGRATOR_SIMPSON) key |= EW_PROGRAM_SIMPSON;
    if (frame->output == EW_OUTPUT_LUMINANCE) key |= EW_PROGRAM_LUMINANCE;
    if (frame->output == EW_OUTPUT_EVALUATIONS) key |= EW_PROGRAM_EVALUATIONS;
    return key;
}

/* The files of a fragment shader, in order; `needs` are the key's bits of which one must be set (0: always), `without` those
 * that must not be. */
static const struct {
    const char *text;
    unsigned needs;
    unsigned without;
} fragment_files[] = {
    {ew_glsl_layout_glsl, 0, 0},
    {ew_glsl_blocks_glsl, 0, 0},
    {ew_glsl_depth_glsl, EW_PROGRAM_DEPTH, 0},
    {ew_glsl_segment_glsl, 0, 0},
    {ew_glsl_weight_glsl, EW_PROGRAM_WEIGHTS, 0},
    {ew_glsl_simpson_glsl, EW_PROGRAM_SIMPSON, 0},
    {ew_glsl_quadrature_glsl, EW_PROGRAM_POINTS | EW_PROGRAM_LINES | EW_PROGRAM_TORI | EW_PROGRAM_CURVES, EW_PROGRAM_SIMPSON},
    {ew_glsl_point_glsl, EW_PROGRAM_POINTS, EW_PROGRAM_SIMPSON},
    {ew_glsl_line_glsl, EW_PROGRAM_LINES, EW_PROGRAM_SIMPSON},
    {ew_glsl_torus_glsl, EW_PROGRAM_TORI, EW_PROGRAM_SIMPSON},
    {ew_glsl_curve_glsl, EW_PROGRAM_CURVES, EW_PROGRAM_SIMPSON},
    {ew_glsl_wave_frag, 0, 0},
};

enum { FRAGMENT_FILE_COUNT = sizeof fragment_files / sizeof fragment_files[0], MAX_HEADER_LENGTH = 1024 };

/* Version, precision and the permutation's defines. `#line 1 N` before each file, so that a driver's messages say where. */
static void write_header(char header[MAX_HEADER_LENGTH], const ew_gl *gl, const ew_capacity *capacity, unsigned key)
{
    static const char *const defines[] = {"EW_POINTS", "EW_LINES",   "EW_TORI",      "EW_CURVES",     "EW_WEIGHTS",
                                          "EW_DEPTH",  "EW_SIMPSON", "EW_LUMINANCE", "EW_EVALUATIONS"};
    int used = snprintf(header, MAX_HEADER_LENGTH,
                        "%s"
                        "#define EW_POINT_CAPACITY %zu\n#define EW_LINE_CAPACITY %zu\n#define EW_TORUS_CAPACITY %zu\n"
                        "#define EW_CURVE_CAPACITY %zu\n#define EW_WEIGHT_CAPACITY %zu\n",
                        gl->es ? "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                               : "#version 330 core\n",
                        capacity->points, capacity->lines, capacity->tori, capacity->curves, capacity->weight_pieces);
    for (size_t i = 0; i < sizeof defines / sizeof defines[0]; ++i)
        if (key & (1u << i)) used += snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define %s\n", defines[i]);
}

/* Compiles the strings to a shader; 0 on failure. */
static GLuint compile(const ew_gl *gl, GLenum stage, int count, const char *const *strings, ew_error *error)
{
    GLuint shader = gl->CreateShader(stage);
    if (!shader) {
        ew_fail(error, EW_ERROR_SHADER, "the driver made no shader object: the context may be lost");
        return 0;
    }
    gl->ShaderSource(shader, count, strings, NULL);
    gl->CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled) return shader;

    char log[160] = "";
    gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
    log[strcspn(log, "\n")] = '\0';
    ew_fail(error, EW_ERROR_SHADER, "the driver does not compile the %s shader: %s",
            stage == GL_VERTEX_SHADER ? "vertex" : "fragment", log);
    gl->DeleteShader(shader);
    return 0;
}

static GLuint compile_vertex_shader(const ew_gl *gl, ew_error *error)
{
    const char *strings[] = {gl->es ? "#version 300 es\n" : "#version 330 core\n", "#line 1 0\n", ew_glsl_quad_vert};
    return compile(gl, GL_VERTEX_SHADER, 3, strings, error);
}

static GLuint compile_fragment_shader(const ew_gl *gl, const ew_capacity *capacity, unsigned key, ew_error *error)
{
    char header[MAX_HEADER_LENGTH];
    char lines[FRAGMENT_FILE_COUNT][24];
    const char *strings[1 + 2 * FRAGMENT_FILE_COUNT];
    int count = 0;
    write_header(header, gl, capacity, key);
    strings[count++] = header;
    for (int i = 0; i < FRAGMENT_FILE_COUNT; ++i) {
        if (fragment_files[i].needs && !(fragment_files[i].needs & key)) continue;
        if (fragment_files[i].without & key) continue;
        snprintf(lines[i], sizeof lines[i], "#line 1 %d\n", i);
        strings[count++] = lines[i];
        strings[count++] = fragment_files[i].text;
    }
    return compile(gl, GL_FRAGMENT_SHADER, count, strings, error);
}

static ew_result link(const ew_gl *gl, GLuint vertex_shader, GLuint fragment_shader, GLuint *program, ew_error *error)
{
    GLuint linked = gl->CreateProgram();
    gl->AttachShader(linked, vertex_shader);
    gl->AttachShader(linked, fragment_shader);
    gl->LinkProgram(linked);
    gl->DetachShader(linked, vertex_shader);
    gl->DetachShader(linked, fragment_shader);
    GLint status = GL_FALSE;
    gl->GetProgramiv(linked, GL_LINK_STATUS, &status);
    if (!status) {
        char log[160] = "";
        gl->GetProgramInfoLog(linked, sizeof log, NULL, log);
        log[strcspn(log, "\n")] = '\0';
        gl->DeleteProgram(linked);
        return ew_fail(error, EW_ERROR_SHADER, "the driver does not link the shaders: %s", log);
    }
    *program = linked;
    return EW_OK;
}

static void assign_bindings(const ew_gl *gl, GLuint program)
{
    static const char *const blocks[EW_BINDING_COUNT] = {
        [EW_FRAME_BINDING] = "ew_frame_uniforms", [EW_POINT_BINDING] = "ew_point_uniforms",
        [EW_LINE_BINDING] = "ew_line_uniforms",   [EW_TORUS_BINDING] = "ew_torus_uniforms",
        [EW_CURVE_BINDING] = "ew_curve_uniforms", [EW_WEIGHT_BINDING] = "ew_weight_uniforms",
    };
    for (GLuint binding = 0; binding < EW_BINDING_COUNT; ++binding) {
        GLuint index = gl->GetUniformBlockIndex(program, blocks[binding]);
        if (index != GL_INVALID_INDEX) gl->UniformBlockBinding(program, index, binding);
    }
    GLint depth = gl->GetUniformLocation(program, "ew_depth_texture");
    if (depth >= 0) {
        gl->UseProgram(program);
        gl->Uniform1i(depth, EW_GL_DEPTH_TEXTURE_UNIT);
    }
}

ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, const ew_capacity *capacity, unsigned key, GLuint *program,
                         ew_error *error)
{
    if (!cache->programs[key]) {
        GLuint vertex_shader = compile_vertex_shader(gl, error);
        if (!vertex_shader) return EW_ERROR_SHADER;
        GLuint fragment_shader = compile_fragment_shader(gl, capacity, key, error);
        ew_result result = EW_ERROR_SHADER;
        if (fragment_shader) result = link(gl, vertex_shader, fragment_shader, &cache->programs[key], error);
        gl->DeleteShader(vertex_shader);
        gl->DeleteShader(fragment_shader);
        if (result != EW_OK) return result;
        assign_bindings(gl, cache->programs[key]);
    }
    *program = cache->programs[key];
    return EW_OK;
}

void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl)
{
    for (int key = 0; key < EW_PROGRAM_KEY_COUNT; ++key)
        if (cache->programs[key]) gl->DeleteProgram(cache->programs[key]);
    *cache = (ew_program_cache){{0}};
}
