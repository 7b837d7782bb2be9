/* Textures that are drawn into: see texture.h. */
#include "texture.h"
#include "message.h"

GLuint texture_create(const gl_functions *gl, int width, int height, GLint internal_format, GLenum format)
{
    GLuint texture;
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    /* OpenGL ES takes only the types that suit the format, even where there is nothing to convert. */
    GLenum type = internal_format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT;
    gl->TexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

GLuint texture_framebuffer(const gl_functions *gl, GLuint color, GLuint depth, bool *complete)
{
    GLuint framebuffer;
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    if (depth) gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    *complete = *complete && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return framebuffer;
}

void texture_write_refusal(GLenum error, int width, int height, char *message, size_t size)
{
    if (error == GL_NO_ERROR)
        message_write(message, size,
                      "this GL does not draw to textures of floats; a browser needs EXT_color_buffer_float for that");
    else
        message_write(message, size, "--size: GL cannot make targets of %d x %d; ask for a smaller one", width, height);
}

void texture_clear(const gl_functions *gl, GLuint framebuffer)
{
    const float nothing[4] = {0, 0, 0, 0};
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->ClearBufferfv(GL_COLOR, 0, nothing);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void texture_read(const gl_functions *gl, GLuint framebuffer, pixel_rectangle from, GLenum format, GLenum type, void *pixels)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(from.x, from.y, from.width, from.height, format, type, pixels);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}
