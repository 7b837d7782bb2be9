/* The last step of a picture: see film.h. */
#include "film.h"
#include "demo_shaders.h"
#include "shader.h"

bool film_create(const gl_functions *gl, demo_film *film, char *message, size_t size)
{
    film->program = shader_link(gl, demo_shader_screen_vert, demo_shader_film_frag, "the film's", message, size);
    if (film->program) gl->GenVertexArrays(1, &film->no_vertices);
    return film->program != 0;
}

void film_destroy(const gl_functions *gl, demo_film *film)
{
    gl->DeleteProgram(film->program);
    gl->DeleteVertexArrays(1, &film->no_vertices);
}

void film_develop(const gl_functions *gl, const demo_film *film, const film_exposure *exposure, GLuint framebuffer, int width,
                  int height)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->Viewport(0, 0, width, height);
    gl->UseProgram(film->program);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "opaque_scene"), 0);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "energy"), 1);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "soft"), exposure->soft);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "samples_per_axis"), exposure->samples_per_axis);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "graded"), exposure->graded);
    gl->Uniform1i(gl->GetUniformLocation(film->program, "encoded"), exposure->encoded);
    gl->Uniform1f(gl->GetUniformLocation(film->program, "sensitivity"), (float)exposure->sensitivity);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, exposure->energy);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, exposure->opaque);
    gl->BindVertexArray(film->no_vertices);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindVertexArray(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}
