/* The integrators that are not the library's: see peers.h. */
#include "peers.h"
#include "message.h"

/* What the library keeps to itself: its GL functions, its shaders and how it fills their uniform blocks. */
#include "base/allocator.h"
#include "host/gl.h"
#include "host/program.h"
#include "model/scene.h"
#include "plan/glsl_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

extern const char ew_glsl_peer_noise_glsl[];
extern const char ew_glsl_peer_value_glsl[];
extern const char ew_glsl_peer_marching_glsl[];
extern const char ew_glsl_peer_equiangular_glsl[];
extern const char ew_glsl_peer_sum_glsl[];
extern const char ew_glsl_peer_curve_glsl[];

struct bench_peers {
    ew_gl gl;
    ew_scene scene;
    struct ew_frame_block frame_block;
    ew_frame_desc frame;
    GLuint vertex_array;
    GLuint uniform_buffer;
    GLuint programs[FAMILY_COUNT][2]; /* for luminance and for evaluations; 0: not compiled yet */
};

/* ---- Shaders ------------------------------------------------------------------------------------------------------------ */

enum { POINTS, LINES, TORI, CURVES, KIND_COUNT };

/* How wave.frag names each kind, its count and its integrator; which type and function peer_sum.glsl makes that of, */
static const struct {
    const char *kinds, *kind, *count, *integrator, *source, *sum;
} names[KIND_COUNT] = {
    {"POINTS", "POINT", "ew_frame.source_count.x", "ew_integrate", "ew_point_block", "ew_integrate"},
    {"LINES", "LINE", "ew_frame.source_count.y", "ew_integrate", "ew_line_block", "ew_integrate"},
    {"TORI", "TORUS", "ew_frame.source_count.z", "ew_integrate", "ew_torus_block", "ew_integrate"},
    /* and for curves, which are brought into another form first, peer_curve.glsl. */
    {"CURVES", "CURVE", "ew_frame.source_count.w", "ew_integrate", "peer_curve", "peer_integrate_curve"},
};

/* A shader in the making: strings, some of which it holds itself. */
typedef struct shader_text {
    const char *strings[48];
    int count;
    char memory[4096];
    size_t used;
} shader_text;

static void add_text(shader_text *text, const char *string)
{
    text->strings[text->count++] = string;
}

__attribute__((format(printf, 2, 3))) static void add_line(shader_text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    add_text(text, text->memory + text->used);
    text->used += (size_t)vsnprintf(text->memory + text->used, sizeof text->memory - text->used, format, arguments) + 1;
    va_end(arguments);
}

static void write_fragment_shader(const bench_peers *peers, integrator_family family, ew_output output, shader_text *text)
{
    const ew_sources_desc *sources = &peers->scene.sources;
    const size_t counts[KIND_COUNT] = {sources->point_count, sources->line_count, sources->torus_count, sources->curve_count};
    *text = (shader_text){.count = 0};
    add_text(text, "#version 330 core\n");
    if (family == FAMILY_BARE) {
        add_text(text, "out vec4 color;\nvoid main() { color = vec4(0.5); }\n");
        return;
    }

    add_line(text, "#define %s\n", output == EW_OUTPUT_LUMINANCE ? "EW_LUMINANCE" : "EW_EVALUATIONS");
    if (family == FAMILY_EQUIANGULAR) add_text(text, "#define PEER_EQUIANGULAR\n");
    if (peers->frame.depth_texture) add_text(text, "#define EW_DEPTH\n");
    if (peers->scene.weight_piece_count > 0) add_text(text, "#define EW_WEIGHTS\n");
    add_line(text, "#define EW_SOURCE_DATA_SIZE %zu\n", ew_scene_capacity((size_t)peers->gl.max_uniform_block_size));
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        char count[24];
        if (counts[kind] > 0) add_line(text, "#define EW_%s\n", names[kind].kinds);
        /* A literal for few sources, as the library has it: see blocks.glsl. */
        snprintf(count, sizeof count, "%zu", counts[kind]);
        add_line(text, "#define EW_%s_COUNT %s\n", names[kind].kind,
                 counts[kind] <= EW_PROGRAM_MAX_UNROLLED ? count : names[kind].count);
    }
    add_text(text, ew_glsl_layout_glsl);
    add_text(text, ew_glsl_blocks_glsl);
    if (peers->frame.depth_texture) add_text(text, ew_glsl_depth_glsl);
    add_text(text, ew_glsl_segment_glsl);
    if (peers->scene.weight_piece_count > 0) add_text(text, ew_glsl_weight_glsl);

    /* Of simpson.glsl only the distances are wanted: its integrators make way. */
    for (int kind = 0; kind < KIND_COUNT; kind++)
        add_line(text, "#define %s simpson_%s\n", names[kind].integrator, names[kind].integrator);
    add_text(text, ew_glsl_simpson_glsl);
    for (int kind = 0; kind < KIND_COUNT; kind++)
        add_line(text, "#undef %s\n", names[kind].integrator);

    add_text(text, ew_glsl_peer_noise_glsl);
    add_text(text, ew_glsl_peer_value_glsl);
    add_text(text, family == FAMILY_EQUIANGULAR ? ew_glsl_peer_equiangular_glsl : ew_glsl_peer_marching_glsl);
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        if (counts[kind] == 0) continue;
        add_line(text, "#define PEER_INTEGRATE %s\n#define PEER_SOURCE %s\n", names[kind].sum, names[kind].source);
        add_text(text, ew_glsl_peer_sum_glsl);
        add_text(text, "#undef PEER_INTEGRATE\n#undef PEER_SOURCE\n");
    }
    if (counts[CURVES] > 0) add_text(text, ew_glsl_peer_curve_glsl);
    add_text(text, ew_glsl_light_glsl);
    add_text(text, ew_glsl_wave_frag);
}

/* Compiles the strings into the program; on failure returns false, with the driver's log. */
static bool attach(const ew_gl *gl, GLuint program, GLenum stage, int count, const char *const *strings, char *log, size_t size)
{
    GLuint shader = gl->CreateShader(stage);
    gl->ShaderSource(shader, count, strings, NULL);
    gl->CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) gl->GetShaderInfoLog(shader, (GLsizei)size, NULL, log);
    gl->AttachShader(program, shader);
    gl->DeleteShader(shader);
    return compiled;
}

static bool link(const ew_gl *gl, GLuint program, char *log, size_t size)
{
    gl->LinkProgram(program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) gl->GetProgramInfoLog(program, (GLsizei)size, NULL, log);
    return linked;
}

/* Returns the program of a family and an output, compiled if this is the first time; 0 with a message on failure. */
static GLuint get_program(bench_peers *peers, integrator_family family, ew_output output, char *message, size_t size)
{
    const ew_gl *gl = &peers->gl;
    GLuint *program = &peers->programs[family][output == EW_OUTPUT_EVALUATIONS];
    if (*program) return *program;

    const char *const vertex_strings[] = {"#version 330 core\n", ew_glsl_quad_vert};
    char log[300] = "";
    shader_text text;
    write_fragment_shader(peers, family, output, &text);
    *program = gl->CreateProgram();
    if (attach(gl, *program, GL_VERTEX_SHADER, 2, vertex_strings, log, sizeof log) &&
        attach(gl, *program, GL_FRAGMENT_SHADER, text.count, text.strings, log, sizeof log) &&
        link(gl, *program, log, sizeof log)) {
        GLuint block = gl->GetUniformBlockIndex(*program, "ew_uniforms");
        if (block != GL_INVALID_INDEX) gl->UniformBlockBinding(*program, block, 0);
        return *program;
    }
    message_write(message, size, "the driver refuses the shader of %s (%s)", integrator_family_names[family], log);
    gl->DeleteProgram(*program);
    return *program = 0;
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

static void upload(const bench_peers *peers)
{
    const ew_gl *gl = &peers->gl;
    const ew_scene *scene = &peers->scene;
    size_t frame_size = sizeof peers->frame_block;
    size_t size = frame_size + ew_scene_capacity((size_t)gl->max_uniform_block_size) * sizeof(ew_vec4);
    gl->BindBuffer(GL_UNIFORM_BUFFER, peers->uniform_buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, NULL, GL_DYNAMIC_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)frame_size, &peers->frame_block);
    if (scene->source_data_size > 0)
        gl->BufferSubData(GL_UNIFORM_BUFFER, (GLintptr)frame_size, (GLsizeiptr)scene->source_data_size, scene->source_data);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, 0, peers->uniform_buffer);
}

bench_peers *peers_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                          size_t size)
{
    bench_peers *made = calloc(1, sizeof *made);
    if (!made) {
        message_write(message, size, "the peers do not fit into memory");
        return NULL;
    }
    ew_error error;
    ew_result result = ew_gl_load(&made->gl, context_get_proc_address, context, &error);
    if (result == EW_OK) {
        size_t capacity = ew_scene_capacity((size_t)made->gl.max_uniform_block_size);
        result = ew_scene_set(&made->scene, sources, capacity, &ew_default_allocator, &error);
    }
    if (result == EW_OK) result = ew_scene_pack(&made->scene, frame, &made->frame_block, &error);
    if (result != EW_OK) {
        message_write(message, size, "%s", error.text);
        ew_scene_destroy(&made->scene, &ew_default_allocator);
        free(made);
        return NULL;
    }
    made->frame = *frame;
    made->gl.GenVertexArrays(1, &made->vertex_array);
    made->gl.GenBuffers(1, &made->uniform_buffer);
    return made;
}

void peers_destroy(bench_peers *peers)
{
    if (!peers) return;
    const ew_gl *gl = &peers->gl;
    for (int family = 0; family < FAMILY_COUNT; family++)
        for (int output = 0; output < 2; output++)
            gl->DeleteProgram(peers->programs[family][output]);
    gl->DeleteBuffers(1, &peers->uniform_buffer);
    gl->DeleteVertexArrays(1, &peers->vertex_array);
    ew_scene_destroy(&peers->scene, &ew_default_allocator);
    free(peers);
}

bool peers_draw(bench_peers *peers, const bench_integrator *integrator, ew_output output, char *message, size_t size)
{
    const ew_gl *gl = &peers->gl;
    const ew_frame_desc *frame = &peers->frame;
    GLuint program = get_program(peers, integrator->family, output, message, size);
    if (!program) return false;

    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl->Viewport(frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, frame->depth_texture);
    peers->frame_block.simpson.x = integrator->samples;
    upload(peers);
    gl->UseProgram(program);
    gl->BindVertexArray(peers->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}
