/* Shader programs: see shader.h. */
#include "shader.h"
#include "message.h"

GLuint shader_link(const gl_functions *gl, const char *vertex_text, const char *fragment_text, const char *name, char *message,
                   size_t size)
{
    GLuint program = gl->CreateProgram();
    const GLenum stages[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
    const char *const texts[] = {vertex_text, fragment_text};
    for (int i = 0; i < 2; i++) {
        GLuint shader = gl->CreateShader(stages[i]);
        gl->ShaderSource(shader, 1, &texts[i], NULL);
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
