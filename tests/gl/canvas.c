/* Framebuffers for tests: see canvas.h. */
#include "canvas.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>

static GLuint make_image(const canvas *made, GLenum format, int samples)
{
    GLuint image;
    gl.GenRenderbuffers(1, &image);
    gl.BindRenderbuffer(GL_RENDERBUFFER, image);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, made->width, made->height);
    return image;
}

static bool has_stencil(GLenum format)
{
    return format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
}

canvas canvas_create(int width, int height, GLenum color_format, GLenum depth_format, int samples)
{
    canvas made = {.width = width, .height = height, .color_format = color_format};
    made.color = make_image(&made, color_format, samples);
    if (depth_format) made.depth = make_image(&made, depth_format, samples);
    gl.GenFramebuffers(1, &made.framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, made.framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, made.color);
    GLenum attachment = has_stencil(depth_format) ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
    if (depth_format) gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, made.depth);
    assert_int_equal(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return made;
}

void canvas_destroy(canvas *made)
{
    gl.DeleteFramebuffers(1, &made->framebuffer);
    gl.DeleteRenderbuffers(1, &made->color);
    gl.DeleteRenderbuffers(1, &made->depth);
    *made = (canvas){0};
}

void canvas_clear(const canvas *cleared, const GLfloat color[4])
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, cleared->framebuffer);
    /* glClearBufferfv misses the back buffer of Mesa's windows without a surface. */
    gl.ClearColor(color[0], color[1], color[2], color[3]);
    gl.Clear(GL_COLOR_BUFFER_BIT);
}

void canvas_clear_depth(const canvas *cleared, GLfloat far_depth, const GLint rectangle[4], GLfloat near_depth)
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, cleared->framebuffer);
    gl.ClearBufferfv(GL_DEPTH, 0, &far_depth);
    gl.Scissor(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
    gl.Enable(GL_SCISSOR_TEST);
    gl.ClearBufferfv(GL_DEPTH, 0, &near_depth);
    gl.Disable(GL_SCISSOR_TEST);
}

void canvas_read(const canvas *read, GLfloat *pixels)
{
    const bool is_float = read->color_format == GL_RGBA32F;
    const size_t count = (size_t)read->width * (size_t)read->height * 4;
    gl.BindFramebuffer(GL_FRAMEBUFFER, read->framebuffer);
    /* Mesa's windows without a surface draw to the back buffer, but read from the front buffer. */
    GLint drawn = GL_NONE;
    gl.GetIntegerv(GL_DRAW_BUFFER0, &drawn);
    gl.ReadBuffer((GLenum)drawn);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    if (is_float) {
        gl.ReadPixels(0, 0, read->width, read->height, GL_RGBA, GL_FLOAT, pixels);
        return;
    }
    GLubyte *bytes = malloc(count);
    if (bytes == NULL) abort();
    gl.ReadPixels(0, 0, read->width, read->height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    for (size_t i = 0; i < count; i++)
        pixels[i] = (GLfloat)bytes[i] / 255;
    free(bytes);
}

void canvas_resolve(const canvas *from, const canvas *to)
{
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from->framebuffer);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to->framebuffer);
    gl.BlitFramebuffer(0, 0, from->width, from->height, 0, 0, to->width, to->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}
