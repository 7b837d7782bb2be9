/* Counts and plays: see watched_gl.h. */
#include "watched_gl.h"

#include <GL/glcorearb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COMPLETION_STATUS = 0x91B1, MAX_PROGRAMS = 4096 };

static watched_gl *watched;

static ew_gl_function real(const char *name)
{
    ew_gl_function function = context_get_proc_address(watched->context, name);
    if (function == NULL) abort();
    return function;
}

#define GEN_AND_DELETE(Kind, KIND)                                                                                             \
    static void APIENTRY gen_##Kind(GLsizei count, GLuint *names)                                                              \
    {                                                                                                                          \
        watched->objects += count;                                                                                             \
        ((PFNGLGEN##KIND##PROC)real("glGen" #Kind))(count, names);                                                             \
    }                                                                                                                          \
    static void APIENTRY delete_##Kind(GLsizei count, const GLuint *names)                                                     \
    {                                                                                                                          \
        for (GLsizei i = 0; i < count; i++)                                                                                    \
            watched->objects -= names[i] != 0;                                                                                 \
        ((PFNGLDELETE##KIND##PROC)real("glDelete" #Kind))(count, names);                                                       \
    }
GEN_AND_DELETE(Buffers, BUFFERS)
GEN_AND_DELETE(Framebuffers, FRAMEBUFFERS)
GEN_AND_DELETE(ProgramPipelines, PROGRAMPIPELINES)
GEN_AND_DELETE(Samplers, SAMPLERS)
GEN_AND_DELETE(Textures, TEXTURES)
GEN_AND_DELETE(VertexArrays, VERTEXARRAYS)

static GLuint APIENTRY create_program(void)
{
    watched->objects++;
    return ((PFNGLCREATEPROGRAMPROC)real("glCreateProgram"))();
}

static void APIENTRY delete_program(GLuint program)
{
    watched->objects -= program != 0;
    ((PFNGLDELETEPROGRAMPROC)real("glDeleteProgram"))(program);
}

static GLenum stages[MAX_PROGRAMS];

static GLuint APIENTRY create_shader(GLenum stage)
{
    GLuint shader = ((PFNGLCREATESHADERPROC)real("glCreateShader"))(stage);
    watched->objects++;
    if (shader < MAX_PROGRAMS) stages[shader] = stage;
    return shader;
}

static void APIENTRY delete_shader(GLuint shader)
{
    watched->objects -= shader != 0;
    ((PFNGLDELETESHADERPROC)real("glDeleteShader"))(shader);
}

static void APIENTRY shader_source(GLuint shader, GLsizei count, const GLchar *const *strings, const GLint *lengths)
{
    static const GLchar *const nonsense[] = {"#version 300 es\nthis is no GLSL"};
    const char *stage = stages[shader] == GL_VERTEX_SHADER ? "vertex" : "fragment";
    bool refused = watched->refused_stage && strcmp(watched->refused_stage, stage) == 0;
    PFNGLSHADERSOURCEPROC set_source = (PFNGLSHADERSOURCEPROC)real("glShaderSource");
    if (refused)
        set_source(shader, 1, nonsense, NULL);
    else
        set_source(shader, count, strings, lengths);
}

static void APIENTRY compile_shader(GLuint shader)
{
    watched->compiled++;
    ((PFNGLCOMPILESHADERPROC)real("glCompileShader"))(shader);
}

/* For each program: how often it will say that it is not complete. */
static int delays[MAX_PROGRAMS];

static void APIENTRY link_program(GLuint program)
{
    watched->linked++;
    if (program < MAX_PROGRAMS) delays[program] = watched->completion_delay;
    ((PFNGLLINKPROGRAMPROC)real("glLinkProgram"))(program);
}

static void APIENTRY draw_arrays(GLenum mode, GLint first, GLsizei count)
{
    watched->drawn++;
    ((PFNGLDRAWARRAYSPROC)real("glDrawArrays"))(mode, first, count);
}

static void APIENTRY get_programiv(GLuint program, GLenum name, GLint *value)
{
    int *delay = &delays[program < MAX_PROGRAMS ? program : 0];
    if (name == COMPLETION_STATUS && watched->completion_delay >= 0) {
        *value = *delay == 0;
        *delay -= *delay > 0;
        return;
    }
    if (*delay > 0 && name != GL_DELETE_STATUS) watched->asked_too_early++;
    ((PFNGLGETPROGRAMIVPROC)real("glGetProgramiv"))(program, name, value);
}

static void APIENTRY get_shaderiv(GLuint shader, GLenum name, GLint *value)
{
    for (int i = 0; i < MAX_PROGRAMS; i++)
        watched->asked_too_early += delays[i] > 0;
    ((PFNGLGETSHADERIVPROC)real("glGetShaderiv"))(shader, name, value);
}

static void APIENTRY use_program(GLuint program)
{
    if (program < MAX_PROGRAMS) watched->asked_too_early += delays[program] > 0;
    ((PFNGLUSEPROGRAMPROC)real("glUseProgram"))(program);
}

static void APIENTRY get_integerv(GLenum name, GLint *value)
{
    ((PFNGLGETINTEGERVPROC)real("glGetIntegerv"))(name, value);
    if (name == GL_NUM_EXTENSIONS && watched->completion_delay >= 0) ++*value;
}

static const GLubyte *APIENTRY get_stringi(GLenum name, GLuint index)
{
    GLint count = 0;
    ((PFNGLGETINTEGERVPROC)real("glGetIntegerv"))(GL_NUM_EXTENSIONS, &count);
    if (name == GL_EXTENSIONS && index == (GLuint)count) return (const GLubyte *)"GL_KHR_parallel_shader_compile";
    return ((PFNGLGETSTRINGIPROC)real("glGetStringi"))(name, index);
}

void watched_gl_start(watched_gl *started, gl_context *context)
{
    *started = (watched_gl){.context = context, .completion_delay = -1};
    memset(delays, 0, sizeof delays);
    watched = started;
}

ew_gl_function watched_gl_get_proc_address(void *user, const char *name)
{
    static const struct {
        const char *name;
        ew_gl_function function;
    } replaced[] = {
        {"glGenBuffers", (ew_gl_function)gen_Buffers},
        {"glDeleteBuffers", (ew_gl_function)delete_Buffers},
        {"glGenFramebuffers", (ew_gl_function)gen_Framebuffers},
        {"glDeleteFramebuffers", (ew_gl_function)delete_Framebuffers},
        {"glGenProgramPipelines", (ew_gl_function)gen_ProgramPipelines},
        {"glDeleteProgramPipelines", (ew_gl_function)delete_ProgramPipelines},
        {"glGenSamplers", (ew_gl_function)gen_Samplers},
        {"glDeleteSamplers", (ew_gl_function)delete_Samplers},
        {"glGenTextures", (ew_gl_function)gen_Textures},
        {"glDeleteTextures", (ew_gl_function)delete_Textures},
        {"glGenVertexArrays", (ew_gl_function)gen_VertexArrays},
        {"glDeleteVertexArrays", (ew_gl_function)delete_VertexArrays},
        {"glCreateProgram", (ew_gl_function)create_program},
        {"glDeleteProgram", (ew_gl_function)delete_program},
        {"glCreateShader", (ew_gl_function)create_shader},
        {"glDeleteShader", (ew_gl_function)delete_shader},
        {"glShaderSource", (ew_gl_function)shader_source},
        {"glCompileShader", (ew_gl_function)compile_shader},
        {"glLinkProgram", (ew_gl_function)link_program},
        {"glDrawArrays", (ew_gl_function)draw_arrays},
        {"glGetProgramiv", (ew_gl_function)get_programiv},
        {"glGetShaderiv", (ew_gl_function)get_shaderiv},
        {"glUseProgram", (ew_gl_function)use_program},
        {"glGetIntegerv", (ew_gl_function)get_integerv},
        {"glGetStringi", (ew_gl_function)get_stringi},
    };
    (void)user;
    watched->loaded++;
    for (size_t i = 0; i < sizeof replaced / sizeof replaced[0]; i++)
        if (strcmp(name, replaced[i].name) == 0) return replaced[i].function;
    /* An object that is not counted would be lost unseen. */
    if (strncmp(name, "glGen", 5) == 0 || strncmp(name, "glCreate", 8) == 0) {
        fprintf(stderr, "%s is not watched\n", name);
        abort();
    }
    return context_get_proc_address(watched->context, name);
}
