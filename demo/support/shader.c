/* Shader programs: see shader.h. */
#include "shader.h"
#include "message.h"

#include <string.h>

/* OpenGL ES 3.0 has all that the shaders use, under another version. */
static void set_source(const gl_functions *gl, GLuint shader, const char *text)
{
    bool is_es = strncmp((const char *)gl->GetString(GL_VERSION), "OpenGL ES", 9) == 0;
    const char *const strings[] = {"#version 300 es\nprecision highp float;\n", strchr(text, '\n')};
    if (is_es)
        gl->ShaderSource(shader, 2, strings, NULL);
    else
        gl->ShaderSource(shader, 1, &text, NULL);
}

GLuint shader_link(const gl_functions *gl, const char *vertex_text, const char *fragment_text, const char *name, char *message,
                   size_t size)
{
    GLuint program = gl->CreateProgram();
    const GLenum stages[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    const char *const texts[] = {vertex_text, fragment_text};
    for (int i = 0; i < 2; i++) {
        GLuint shader = gl->CreateShader(stages[i]);
        set_source(gl, shader, texts[i]);
        gl->CompileShader(shader);
        gl->AttachShader(program, shader);
        gl->DeleteShader(shader);
    }
    gl->LinkProgram(program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked) return program;
    char log[200] = "";
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    message_write(message, size, "%s shader does not link (%s); update the GL driver", name, log);
    gl->DeleteProgram(program);
    return 0;
}
