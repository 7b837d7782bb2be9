/* Compiles and links a permutation's shaders: see program.h. */
#include "host/program.h"

#include "base/error.h"
#include "host/binding_points.h"
#include "model/sources.h"

#include <string.h>

ew_dialect ew_gl_dialect(const ew_gl *gl)
{
    return (ew_dialect){.es = gl->es,
                        .sample_mask = gl->sample_mask,
                        .software = gl->software,
                        .max_varying_vectors = gl->max_varying_vectors,
                        .capacity = ew_sources_capacity((size_t)gl->max_uniform_block_size),
                        .list_size = ew_largest_block((size_t)gl->max_uniform_block_size) / sizeof(ew_vec4)};
}

/* Hands the text to the compiler. Whether it takes it is not asked here: the answer would have to be waited for. */
static GLuint compile(const ew_gl *gl, GLenum stage, const ew_shader_text *text)
{
    GLuint shader = gl->CreateShader(stage);
    if (!shader) return 0;
    gl->ShaderSource(shader, text->count, text->strings, NULL);
    gl->CompileShader(shader);
    return shader;
}

static GLuint compile_vertex_shader(const ew_gl *gl, ew_pass pass, ew_key key)
{
    const ew_dialect dialect = ew_gl_dialect(gl);
    ew_shader_text text;
    ew_write_vertex_shader(&text, &dialect, pass, key);
    return compile(gl, GL_VERTEX_SHADER, &text);
}

static GLuint compile_fragment_shader(const ew_gl *gl, ew_pass pass, ew_key key, const ew_integrator_text *integrator)
{
    const ew_dialect dialect = ew_gl_dialect(gl);
    ew_shader_text text;
    if (integrator)
        ew_write_fragment_shader_with(&text, &dialect, key, integrator);
    else
        ew_write_fragment_shader(&text, &dialect, pass, key);
    return compile(gl, GL_FRAGMENT_SHADER, &text);
}

static void assign_bindings(const ew_gl *gl, GLuint program)
{
    static const char *const blocks[] = {[EW_GL_UNIFORM_BINDING] = "ew_uniforms", [EW_GL_LIST_BINDING] = "ew_lists"};
    for (GLuint binding = 0; binding < EW_GL_BINDING_COUNT; ++binding) {
        GLuint index = gl->GetUniformBlockIndex(program, blocks[binding]);
        if (index != GL_INVALID_INDEX) gl->UniformBlockBinding(program, index, binding);
    }
    static const struct {
        const char *name;
        GLint unit;
    } textures[] = {{"ew_depth_texture", EW_GL_DEPTH_TEXTURE_UNIT},   {"ew_source_texture", EW_GL_SOURCE_TEXTURE_UNIT},
                    {"ew_node_texture", EW_GL_NODE_TEXTURE_UNIT},     {"ew_middle_texture", EW_GL_MIDDLE_TEXTURE_UNIT},
                    {"ew_field_texture", EW_GL_FIELD_TEXTURE_UNIT},   {"ew_cell_texture", EW_GL_CELL_TEXTURE_UNIT},
                    {"ew_block_texture", EW_GL_BLOCK_TEXTURE_UNIT},   {"ew_peak_texture", EW_GL_BLOCK_TEXTURE_UNIT},
                    {"ew_normal_texture", EW_GL_NORMAL_TEXTURE_UNIT}, {"ew_light_texture", EW_GL_LIGHT_TEXTURE_UNIT}};
    gl->UseProgram(program);
    for (size_t i = 0; i < sizeof textures / sizeof textures[0]; ++i) {
        GLint location = gl->GetUniformLocation(program, textures[i].name);
        if (location >= 0) gl->Uniform1i(location, textures[i].unit);
    }
}

ew_result ew_program_start(const ew_gl *gl, ew_pass pass, ew_key key, const ew_integrator_text *integrator, ew_program *program,
                           ew_error *error)
{
    ew_program made = {
        .name = gl->CreateProgram(),
        .vertex_shader = compile_vertex_shader(gl, pass, key),
        .fragment_shader = compile_fragment_shader(gl, pass, key, integrator),
    };
    if (!made.name || !made.vertex_shader || !made.fragment_shader) {
        ew_program_destroy(gl, &made);
        return ew_fail(error, EW_ERROR_SHADER, "the driver made no shader or program object: the context may be lost");
    }
    gl->AttachShader(made.name, made.vertex_shader);
    gl->AttachShader(made.name, made.fragment_shader);
    *program = made;
    return EW_OK;
}

void ew_program_link(const ew_gl *gl, ew_program *program)
{
    if (!program->is_linking) gl->LinkProgram(program->name);
    program->is_linking = true;
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
    ew_program_link(gl, program);
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
    *program = (ew_program){.name = program->name, .is_linking = true, .is_ready = true};
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
