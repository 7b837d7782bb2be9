/* The last step of a picture: see resolve.h. */
#include "resolve.h"
#include "demo_shaders.h"
#include "shader.h"

bool resolve_create(const gl_functions *gl, resolve_pass *pass, char *message, size_t size)
{
    pass->program = shader_link(gl, demo_shader_screen_vert, demo_shader_resolve_frag, "the last step's", message, size);
    if (pass->program) gl->GenVertexArrays(1, &pass->no_vertices);
    return pass->program != 0;
}

void resolve_destroy(const gl_functions *gl, resolve_pass *pass)
{
    gl->DeleteProgram(pass->program);
    gl->DeleteVertexArrays(1, &pass->no_vertices);
}

void resolve_draw(const gl_functions *gl, const resolve_pass *pass, const resolve_input *input, GLuint framebuffer, int width,
                  int height)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->Viewport(0, 0, width, height);
    gl->UseProgram(pass->program);
    gl->Uniform1i(gl->GetUniformLocation(pass->program, "color"), 0);
    gl->Uniform1i(gl->GetUniformLocation(pass->program, "samples_per_axis"), input->samples_per_axis);
    gl->Uniform1i(gl->GetUniformLocation(pass->program, "dithers"), input->dithers);
    gl->BindTexture(GL_TEXTURE_2D, input->color);
    gl->BindVertexArray(pass->no_vertices);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindVertexArray(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}
