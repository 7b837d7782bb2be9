/* An opaque scene with samples: see sampled_scene.h. */
#include "sampled_scene.h"

#include "scramble.h" /* build_program */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

bool has_multisampled_textures(void)
{
    return api_has(33, 31, NULL);
}

GLuint make_float_texture(int width, int height)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

static GLuint make_multisampled_texture(GLenum format, int width, int height)
{
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    if (gl.es)
        gl.TexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SCENE_SAMPLES, format, width, height, GL_TRUE);
    else
        gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SCENE_SAMPLES, format, width, height, GL_TRUE);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    return texture;
}

GLuint make_framebuffer(GLenum texture_target, GLuint color, GLuint depth)
{
    GLuint framebuffer;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_target, color, 0);
    if (depth) gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture_target, depth, 0);
    assert_int_equal(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return framebuffer;
}

static void draw_triangle(GLuint program, const opaque_triangle *triangle)
{
    static const char *const names[3] = {"corners[0]", "corners[1]", "corners[2]"};
    gl.UseProgram(program);
    gl.Uniform4f(gl.GetUniformLocation(program, "fill"), triangle->color[0], triangle->color[1], triangle->color[2],
                 triangle->color[3]);
    for (int i = 0; i < 3; i++)
        gl.Uniform4f(gl.GetUniformLocation(program, names[i]), triangle->corners[i][0], triangle->corners[i][1],
                     triangle->corners[i][2], 1);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.UseProgram(0);
}

static void draw_triangles(const opaque_triangle *triangles, int count, int width, int height)
{
    static const GLfloat dark[4] = {0.1f, 0, 0.05f, 1}, far_depth = 1;
    GLuint program = build_program("uniform vec4 corners[3];\nvoid main() { gl_Position = corners[gl_VertexID]; }\n",
                                   "uniform vec4 fill;\nout vec4 color;\nvoid main() { color = fill; }\n", NULL);
    gl.Viewport(0, 0, width, height);
    gl.ClearBufferfv(GL_COLOR, 0, dark);
    gl.ClearBufferfv(GL_DEPTH, 0, &far_depth);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LESS);
    gl.DepthMask(GL_TRUE);
    for (int i = 0; i < count; i++)
        draw_triangle(program, &triangles[i]);
    gl.Disable(GL_DEPTH_TEST);
    gl.DeleteProgram(program);
}

/* Copies each sample of `texture` to a float texture. */
static void fetch_samples(GLuint texture, int width, int height, GLuint fetched[SCENE_SAMPLES])
{
    GLuint program = build_program("void main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : "
                                   "-1.0, 0.0, 1.0); }\n",
                                   "uniform highp sampler2DMS image;\nuniform int index;\nout vec4 color;\n"
                                   "void main() { color = texelFetch(image, ivec2(gl_FragCoord.xy), index); }\n",
                                   NULL);
    GLuint vertex_array;
    gl.GenVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    gl.Viewport(0, 0, width, height);
    gl.UseProgram(program);
    for (int i = 0; i < SCENE_SAMPLES; i++) {
        fetched[i] = make_float_texture(width, height);
        GLuint framebuffer = make_framebuffer(GL_TEXTURE_2D, fetched[i], 0);
        gl.Uniform1i(gl.GetUniformLocation(program, "index"), i);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        gl.DeleteFramebuffers(1, &framebuffer);
    }
    gl.UseProgram(0);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(1, &vertex_array);
    gl.DeleteProgram(program);
}

void sampled_scene_create(const opaque_triangle *triangles, int count, GLenum color_format, int width, int height,
                          sampled_scene *scene)
{
    GLuint vertex_array;
    gl.GenVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
    scene->color = make_multisampled_texture(color_format, width, height);
    scene->depth = make_multisampled_texture(GL_DEPTH_COMPONENT32F, width, height);
    GLuint framebuffer = make_framebuffer(GL_TEXTURE_2D_MULTISAMPLE, scene->color, scene->depth);
    draw_triangles(triangles, count, width, height);
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.BindVertexArray(0);
    gl.DeleteVertexArrays(1, &vertex_array);
    scene->framebuffer = make_framebuffer(GL_TEXTURE_2D_MULTISAMPLE, scene->color, 0);
    fetch_samples(scene->color, width, height, scene->sample_color);
    fetch_samples(scene->depth, width, height, scene->sample_depth);
    for (int i = 0; i < SCENE_SAMPLES; i++)
        scene->sample_framebuffers[i] = make_framebuffer(GL_TEXTURE_2D, scene->sample_color[i], 0);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

void sampled_scene_fetch_color(sampled_scene *scene, int width, int height)
{
    gl.DeleteTextures(SCENE_SAMPLES, scene->sample_color);
    gl.DeleteFramebuffers(SCENE_SAMPLES, scene->sample_framebuffers);
    fetch_samples(scene->color, width, height, scene->sample_color);
    for (int i = 0; i < SCENE_SAMPLES; i++)
        scene->sample_framebuffers[i] = make_framebuffer(GL_TEXTURE_2D, scene->sample_color[i], 0);
}

void sampled_scene_destroy(sampled_scene *scene)
{
    gl.DeleteTextures(1, &scene->color);
    gl.DeleteTextures(1, &scene->depth);
    gl.DeleteTextures(SCENE_SAMPLES, scene->sample_color);
    gl.DeleteTextures(SCENE_SAMPLES, scene->sample_depth);
    gl.DeleteFramebuffers(1, &scene->framebuffer);
    gl.DeleteFramebuffers(SCENE_SAMPLES, scene->sample_framebuffers);
}
