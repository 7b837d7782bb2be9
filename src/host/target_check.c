/* The images of a framebuffer: see target_check.h. */
#include "host/target_check.h"

#include "base/error.h"

static GLint attachment_parameter(const ew_gl *gl, GLenum attachment, GLenum name)
{
    GLint value = 0;
    gl->GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
}

static bool has_many_layers(const ew_gl *gl, GLenum attachment)
{
    enum { NUM_VIEWS = 0x9630 }; /* of OVR_multiview */
    if (gl->layered_framebuffers && attachment_parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_LAYERED)) return true;
    return gl->multiview && attachment_parameter(gl, attachment, NUM_VIEWS) > 1;
}

static bool has_integers(const ew_gl *gl, GLenum attachment)
{
    GLint type = attachment_parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
    return type == GL_INT || type == GL_UNSIGNED_INT;
}

static void find_renderbuffer_size(const ew_gl *gl, GLuint renderbuffer, GLint size[2])
{
    GLint bound = 0;
    gl->GetIntegerv(GL_RENDERBUFFER_BINDING, &bound);
    gl->BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl->GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &size[0]);
    gl->GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_HEIGHT, &size[1]);
    gl->BindRenderbuffer(GL_RENDERBUFFER, (GLuint)bound);
}

bool ew_find_target_size(const ew_gl *gl, GLint size[2])
{
    GLint buffer = GL_NONE;
    gl->GetIntegerv(GL_DRAW_BUFFER0, &buffer);
    const GLenum image = (GLenum)buffer;
    const GLuint name = (GLuint)attachment_parameter(gl, image, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME);
    if (attachment_parameter(gl, image, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_RENDERBUFFER) {
        find_renderbuffer_size(gl, name, size);
        return true;
    }
    if (!gl->GetTextureLevelParameteriv) return false;
    const GLint level = attachment_parameter(gl, image, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL);
    gl->GetTextureLevelParameteriv(name, level, GL_TEXTURE_WIDTH, &size[0]);
    gl->GetTextureLevelParameteriv(name, level, GL_TEXTURE_HEIGHT, &size[1]);
    return true;
}

/* GL clamps a larger viewport without an error, and what it clamps away would stay dark. */
static ew_result check_viewport(const ew_gl *gl, const ew_viewport *viewport, ew_error *error)
{
    if (viewport->width <= gl->max_viewport[0] && viewport->height <= gl->max_viewport[1]) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                   "viewport_width and viewport_height must be at most %d and %d, this context's GL_MAX_VIEWPORT_DIMS; draw a "
                   "larger picture in tiles, each with its part of the projection",
                   gl->max_viewport[0], gl->max_viewport[1]);
}

static ew_result check_image(const ew_gl *gl, unsigned framebuffer, GLenum image, ew_error *error)
{
    const GLint type = attachment_parameter(gl, image, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE);
    if (type == GL_NONE)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "framebuffer %u has no image for its draw buffer 0", framebuffer);
    if (type == GL_TEXTURE && has_many_layers(gl, image))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "framebuffer %u has several layers of a texture attached, but a frame has one view; attach one layer at "
                       "a time, and draw each with its own view",
                       framebuffer);
    if (has_integers(gl, image))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "framebuffer %u has an integer format, which holds no light",
                       framebuffer);
    return EW_OK;
}

ew_result ew_target_check(const ew_gl *gl, const ew_target *target, ew_error *error)
{
    ew_result result = check_viewport(gl, &target->viewport, error);
    if (result != EW_OK) return result;
    GLint image = GL_NONE;
    gl->GetIntegerv(GL_DRAW_BUFFER0, &image);
    if (image == GL_NONE)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "draw buffer 0 of framebuffer %u is GL_NONE, so that the light would go nowhere; call glDrawBuffers",
                       target->framebuffer);
    /* Of the window, GL takes other names for its buffers, and none of these can go wrong. */
    return target->framebuffer ? check_image(gl, target->framebuffer, (GLenum)image, error) : EW_OK;
}
