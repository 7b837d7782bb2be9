/* Assembles shaders from the files of glsl/ and compiles them. */
#include "host/program.h"

#include "base/error.h"
#include "host/state_guard.h"
#include "plan/glsl_text.h"

#include <stdio.h>
#include <string.h>

/* The kinds of sources, in the order of their fields in a key. */
enum { POINTS, LINES, TORI, CURVES, KIND_COUNT };

static int count_shift(int kind)
{
    return EW_PROGRAM_FLAG_COUNT + kind * EW_PROGRAM_COUNT_BITS;
}

static unsigned count_of(unsigned key, int kind)
{
    return key >> count_shift(kind) & ((1u << EW_PROGRAM_COUNT_BITS) - 1);
}

static bool is_dithered(const ew_frame_desc *frame)
{
    bool is_picture = frame->output == EW_OUTPUT_LERP || frame->output == EW_OUTPUT_ADD;
    return frame->dither && is_picture && frame->encoding != EW_ENCODING_FLOAT;
}

unsigned ew_program_key(const ew_mix *mix, const ew_frame_desc *frame, GLenum depth_target)
{
    const size_t counts[KIND_COUNT] = {mix->point_count, mix->line_count, mix->torus_count, mix->curve_count};
    unsigned key = 0;
    if (mix->has_weights && mix->curve_count > 0) key |= EW_PROGRAM_WEIGHTS;
    if (depth_target) key |= EW_PROGRAM_DEPTH;
    if (depth_target == GL_TEXTURE_2D_MULTISAMPLE) key |= EW_PROGRAM_DEPTH_MULTISAMPLE;
    if (is_dithered(frame)) {
        key |= EW_PROGRAM_DITHER;
        if (frame->encoding == EW_ENCODING_SRGB_8BIT) key |= EW_PROGRAM_DITHER_SRGB;
    }
    if (frame->integrator == EW_INTEGRATOR_SIMPSON) key |= EW_PROGRAM_SIMPSON;
    if (frame->output == EW_OUTPUT_LUMINANCE) key |= EW_PROGRAM_LUMINANCE;
    if (frame->output == EW_OUTPUT_EVALUATIONS) key |= EW_PROGRAM_EVALUATIONS;
    for (int kind = 0; kind < KIND_COUNT; ++kind) {
        size_t count = counts[kind] <= EW_PROGRAM_MAX_UNROLLED ? counts[kind] : EW_PROGRAM_MAX_UNROLLED + 1;
        key |= (unsigned)count << count_shift(kind);
    }
    return key;
}

bool ew_program_covers(unsigned key, unsigned other)
{
    const unsigned flags = ((1u << EW_PROGRAM_FLAG_COUNT) - 1) & ~(unsigned)EW_PROGRAM_WEIGHTS;
    if ((key & flags) != (other & flags)) return false;
    if (other & EW_PROGRAM_WEIGHTS && !(key & EW_PROGRAM_WEIGHTS)) return false;
    for (int kind = 0; kind < KIND_COUNT; ++kind)
        if (count_of(key, kind) != count_of(other, kind) && count_of(key, kind) <= EW_PROGRAM_MAX_UNROLLED) return false;
    return true;
}

/* Which permutations need a file. */
static bool always(unsigned key)
{
    (void)key;
    return true;
}

static bool reads_depth(unsigned key)
{
    return key & EW_PROGRAM_DEPTH;
}

static bool reads_samples(unsigned key)
{
    return key & EW_PROGRAM_DEPTH_MULTISAMPLE;
}

static bool dithers(unsigned key)
{
    return key & EW_PROGRAM_DITHER;
}

static bool has_weights(unsigned key)
{
    return key & EW_PROGRAM_WEIGHTS;
}

static bool is_simpson(unsigned key)
{
    return key & EW_PROGRAM_SIMPSON;
}

static bool is_adaptive(unsigned key)
{
    return !is_simpson(key);
}

static bool integrates_points(unsigned key)
{
    return is_adaptive(key) && count_of(key, POINTS) > 0;
}

static bool integrates_lines(unsigned key)
{
    return is_adaptive(key) && count_of(key, LINES) > 0;
}

static bool integrates_tori(unsigned key)
{
    return is_adaptive(key) && count_of(key, TORI) > 0;
}

static bool integrates_curves(unsigned key)
{
    return is_adaptive(key) && count_of(key, CURVES) > 0;
}

typedef struct shader_file {
    const char *text;
    bool (*is_needed)(unsigned key);
} shader_file;

/* The files that make up the light along a segment of a ray, in order, */
static const shader_file light_files[] = {
    {ew_glsl_layout_glsl, always},
    {ew_glsl_blocks_glsl, always},
    {ew_glsl_segment_glsl, always},
    {ew_glsl_components_glsl, always},
    {ew_glsl_weight_glsl, has_weights},
    {ew_glsl_simpson_glsl, is_simpson},
    {ew_glsl_quadrature_glsl, is_adaptive},
    {ew_glsl_point_glsl, integrates_points},
    {ew_glsl_line_glsl, integrates_lines},
    {ew_glsl_torus_side_glsl, integrates_tori},
    {ew_glsl_torus_core_glsl, integrates_tori},
    {ew_glsl_torus_panel_glsl, integrates_tori},
    {ew_glsl_torus_glsl, integrates_tori},
    {ew_glsl_arc_glsl, integrates_curves},
    {ew_glsl_passage_glsl, integrates_curves},
    {ew_glsl_cell_glsl, integrates_curves},
    {ew_glsl_stretch_glsl, integrates_curves},
    {ew_glsl_rest_glsl, integrates_curves},
    {ew_glsl_knot_glsl, integrates_curves},
    {ew_glsl_rest_panels_glsl, integrates_curves},
    {ew_glsl_curve_glsl, integrates_curves},
    {ew_glsl_light_glsl, always},
};
/* and those that make a picture of it. */
static const shader_file picture_files[] = {
    {ew_glsl_depth_glsl, reads_depth},
    {ew_glsl_dither_glsl, dithers},
    {ew_glsl_wave_frag, always},
};

enum {
    LIGHT_FILE_COUNT = sizeof light_files / sizeof light_files[0],
    PICTURE_FILE_COUNT = sizeof picture_files / sizeof picture_files[0],
    FILE_COUNT = LIGHT_FILE_COUNT + PICTURE_FILE_COUNT,
    MAX_HEADER_LENGTH = 1024
};

/* Multisampled textures came to OpenGL with GLSL 1.50, and to OpenGL ES with 3.10. */
static const char *version_of(const ew_gl *gl, unsigned key)
{
    if (!gl->es) return "#version 330 core\n";
    return reads_samples(key) ? "#version 310 es\n" : "#version 300 es\n";
}

static const char *precision_of(const ew_gl *gl, unsigned key)
{
    if (!gl->es) return "";
    return reads_samples(key) ? "precision highp float;\nprecision highp int;\nprecision highp sampler2DMS;\n"
                              : "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
}

/* The permutation's defines. */
static void write_defines(char header[MAX_HEADER_LENGTH], size_t capacity, unsigned key)
{
    static const char *const flags[EW_PROGRAM_FLAG_COUNT] = {"EW_WEIGHTS",   "EW_DEPTH",       "EW_SIMPSON",
                                                             "EW_LUMINANCE", "EW_EVALUATIONS", "EW_DEPTH_MULTISAMPLE",
                                                             "EW_DITHER",    "EW_DITHER_SRGB"};
    static const struct {
        const char *lists, *kind, *count;
    } names[KIND_COUNT] = {{"POINTS", "POINT", "x"}, {"LINES", "LINE", "y"}, {"TORI", "TORUS", "z"}, {"CURVES", "CURVE", "w"}};

    int used = snprintf(header, MAX_HEADER_LENGTH, "#define EW_SOURCE_DATA_SIZE %zu\n", capacity);
    for (int i = 0; i < EW_PROGRAM_FLAG_COUNT; ++i)
        if (key & (1u << i)) used += snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define %s\n", flags[i]);
    for (int kind = 0; kind < KIND_COUNT; ++kind) {
        unsigned count = count_of(key, kind);
        if (count > 0) used += snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define EW_%s\n", names[kind].lists);
        if (count <= EW_PROGRAM_MAX_UNROLLED)
            used +=
                snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define EW_%s_COUNT %u\n", names[kind].kind, count);
        else
            used += snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define EW_%s_COUNT ew_frame.source_count.%s\n",
                             names[kind].kind, names[kind].count);
    }
}

/* How many vec4 the sources take as varyings; 0 where their number is not known, or too large. */
static int source_varyings(const ew_gl *gl, unsigned key)
{
    static const int sizes[KIND_COUNT] = {EW_POINT_SIZE, EW_LINE_SIZE, EW_TORUS_SIZE, EW_CURVE_SIZE};
    enum { FRAME_VARYINGS = sizeof(struct ew_frame_block) / sizeof(ew_vec4) };
    int size = 0;
    for (int kind = 0; kind < KIND_COUNT; ++kind) {
        if (count_of(key, kind) > EW_PROGRAM_MAX_UNROLLED) return 0;
        size += (int)count_of(key, kind) * sizes[kind];
    }
    return FRAME_VARYINGS + size <= gl->max_varying_vectors ? size : 0;
}

/* The defines that both stages of a program share beside write_defines: see glsl/blocks.glsl. The published method, kept as a
 * baseline, reads its sources from the uniform block, as published. */
static void write_software_defines(char header[MAX_HEADER_LENGTH], const ew_gl *gl, unsigned key)
{
    int size = source_varyings(gl, key);
    header[0] = '\0';
    if (is_simpson(key) || !gl->software) return;
    int used = snprintf(header, MAX_HEADER_LENGTH, "#define EW_SOFTWARE\n");
    if (size > 0) snprintf(header + used, MAX_HEADER_LENGTH - (size_t)used, "#define EW_SOURCE_VARYINGS %d\n", size);
}

/* Hands the strings to the compiler. Whether it takes them is not asked here: the answer would have to be waited for. */
static GLuint compile(const ew_gl *gl, GLenum stage, int count, const char *const *strings)
{
    GLuint shader = gl->CreateShader(stage);
    if (!shader) return 0;
    gl->ShaderSource(shader, count, strings, NULL);
    gl->CompileShader(shader);
    return shader;
}

static GLuint compile_vertex_shader(const ew_gl *gl, size_t capacity, unsigned key)
{
    char defines[MAX_HEADER_LENGTH], software_defines[MAX_HEADER_LENGTH];
    write_defines(defines, capacity, key);
    write_software_defines(software_defines, gl, key);
    const char *strings[] = {version_of(gl, key),
                             gl->es ? "precision highp float;\nprecision highp int;\n" : "",
                             defines,
                             software_defines,
                             "#define EW_VERTEX_STAGE\n#line 1 0\n",
                             ew_glsl_layout_glsl,
                             "#line 1 1\n",
                             ew_glsl_blocks_glsl,
                             "#line 1 2\n",
                             ew_glsl_quad_vert};
    return compile(gl, GL_VERTEX_SHADER, sizeof strings / sizeof strings[0], strings);
}

static GLuint compile_fragment_shader(const ew_gl *gl, size_t capacity, unsigned key)
{
    char defines[MAX_HEADER_LENGTH], software_defines[MAX_HEADER_LENGTH];
    char lines[FILE_COUNT][24];
    const char *strings[4 + 2 * FILE_COUNT];
    int count = 0;
    write_defines(defines, capacity, key);
    write_software_defines(software_defines, gl, key);
    strings[count++] = version_of(gl, key);
    strings[count++] = precision_of(gl, key);
    strings[count++] = defines;
    strings[count++] = software_defines;
    for (int i = 0; i < FILE_COUNT; ++i) {
        const shader_file *file = i < LIGHT_FILE_COUNT ? &light_files[i] : &picture_files[i - LIGHT_FILE_COUNT];
        if (!file->is_needed(key)) continue;
        snprintf(lines[i], sizeof lines[i], "#line 1 %d\n", i);
        strings[count++] = lines[i];
        strings[count++] = file->text;
    }
    return compile(gl, GL_FRAGMENT_SHADER, count, strings);
}

static size_t append(char *text, size_t used, const char *part)
{
    size_t length = strlen(part);
    if (text) memcpy(text + used, part, length + 1);
    return used + length;
}

size_t ew_program_write_include(size_t capacity, unsigned key, char *text)
{
    char defines[MAX_HEADER_LENGTH];
    write_defines(defines, capacity, key);
    size_t used = append(text, 0, "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n");
    used = append(text, used, defines);
    for (int i = 0; i < LIGHT_FILE_COUNT; ++i)
        if (light_files[i].is_needed(key)) used = append(text, used, light_files[i].text);
    return append(text, used, ew_glsl_include_glsl);
}

static void assign_bindings(const ew_gl *gl, GLuint program)
{
    gl->UniformBlockBinding(program, gl->GetUniformBlockIndex(program, "ew_uniforms"), EW_GL_UNIFORM_BINDING);
    GLint depth = gl->GetUniformLocation(program, "ew_depth_texture");
    if (depth >= 0) {
        gl->UseProgram(program);
        gl->Uniform1i(depth, EW_GL_DEPTH_TEXTURE_UNIT);
    }
}

ew_result ew_program_start(const ew_gl *gl, size_t capacity, unsigned key, ew_program *program, ew_error *error)
{
    ew_program made = {
        .name = gl->CreateProgram(),
        .vertex_shader = compile_vertex_shader(gl, capacity, key),
        .fragment_shader = compile_fragment_shader(gl, capacity, key),
    };
    if (!made.name || !made.vertex_shader || !made.fragment_shader) {
        ew_program_destroy(gl, &made);
        return ew_fail(error, EW_ERROR_SHADER, "the driver made no shader or program object: the context may be lost");
    }
    gl->AttachShader(made.name, made.vertex_shader);
    gl->AttachShader(made.name, made.fragment_shader);
    gl->LinkProgram(made.name);
    *program = made;
    return EW_OK;
}

bool ew_program_is_complete(const ew_gl *gl, const ew_program *program)
{
    enum { COMPLETION_STATUS = 0x91B1 }; /* of KHR_ and ARB_parallel_shader_compile */
    if (program->is_ready || !gl->parallel_shader_compile) return true;
    GLint complete = GL_FALSE;
    gl->GetProgramiv(program->name, COMPLETION_STATUS, &complete);
    return complete;
}

static bool is_compiled(const ew_gl *gl, GLuint shader)
{
    GLint compiled = GL_FALSE;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    return compiled;
}

/* Says why a program is not linked, in the words of whichever part of the driver failed first. */
static ew_result fail_to_link(const ew_gl *gl, const ew_program *program, ew_error *error)
{
    char log[160] = "";
    const char *failure = "does not link the shaders";
    if (!is_compiled(gl, program->vertex_shader)) {
        failure = "does not compile the vertex shader";
        gl->GetShaderInfoLog(program->vertex_shader, sizeof log, NULL, log);
    } else if (!is_compiled(gl, program->fragment_shader)) {
        failure = "does not compile the fragment shader";
        gl->GetShaderInfoLog(program->fragment_shader, sizeof log, NULL, log);
    } else {
        gl->GetProgramInfoLog(program->name, sizeof log, NULL, log);
    }
    log[strcspn(log, "\n")] = '\0';
    return ew_fail(error, EW_ERROR_SHADER, "the driver %s: %s", failure, log);
}

ew_result ew_program_finish(const ew_gl *gl, ew_program *program, ew_error *error)
{
    if (program->is_ready) return EW_OK;
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program->name, GL_LINK_STATUS, &linked);
    if (!linked) {
        ew_result result = fail_to_link(gl, program, error);
        ew_program_destroy(gl, program);
        return result;
    }
    gl->DetachShader(program->name, program->vertex_shader);
    gl->DetachShader(program->name, program->fragment_shader);
    gl->DeleteShader(program->vertex_shader);
    gl->DeleteShader(program->fragment_shader);
    *program = (ew_program){.name = program->name, .is_ready = true};
    assign_bindings(gl, program->name);
    return EW_OK;
}

void ew_program_destroy(const ew_gl *gl, ew_program *program)
{
    gl->DeleteProgram(program->name);
    gl->DeleteShader(program->vertex_shader);
    gl->DeleteShader(program->fragment_shader);
    *program = (ew_program){0};
}
