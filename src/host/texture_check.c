/* The format, the size and the attachment of the host's textures: see texture_check.h. */
#include "host/texture_check.h"

#include "base/error.h"
#include "host/target_check.h"

static GLint attachment_parameter(const ew_gl *gl, GLenum attachment, GLenum name)
{
    GLint value = 0;
    gl->GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
}

static bool is_attached(const ew_gl *gl, GLenum attachment, GLuint texture)
{
    return attachment_parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_TEXTURE &&
           (GLuint)attachment_parameter(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) == texture;
}

/* `name` is the frame's member. */
static ew_result check_no_color(const ew_gl *gl, const ew_plan *plan, const char *name, GLuint texture, ew_error *error)
{
    for (GLint i = 0; i < gl->max_draw_buffers; i++)
        if (is_attached(gl, GL_COLOR_ATTACHMENT0 + (GLenum)i, texture))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                           "%s %u is attached to framebuffer %u, which GL cannot draw to while it reads the texture; draw the "
                           "light to a framebuffer without it",
                           name, texture, plan->target.framebuffer);
    return EW_OK;
}

static ew_result check_not_attached(const ew_gl *gl, const ew_plan *plan, ew_error *error)
{
    const GLuint texture = plan->depth.texture, framebuffer = plan->target.framebuffer;
    if (framebuffer == 0) return EW_OK;
    if (is_attached(gl, GL_DEPTH_ATTACHMENT, texture))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "depth_texture %u is attached to framebuffer %u, which GL cannot draw to while it reads the texture; "
                       "detach it, or set depth_source to EW_DEPTH_FRAMEBUFFER",
                       texture, framebuffer);
    return plan->depth.source == EW_DEPTH_TEXTURE_LINEAR ? check_no_color(gl, plan, "depth_texture", texture, error) : EW_OK;
}

static GLint level_parameter(const ew_gl *gl, GLenum texture_target, GLenum name)
{
    GLint value = 0;
    gl->GetTexLevelParameteriv(texture_target, 0, name, &value);
    return value;
}

static ew_result check_storage(const ew_gl *gl, GLenum texture_target, const char *name, GLuint texture, ew_error *error)
{
    if (level_parameter(gl, texture_target, GL_TEXTURE_WIDTH) > 0) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s %u has no storage", name, texture);
}

static ew_result check_format(const ew_gl *gl, const ew_plan *plan, GLenum texture_target, ew_error *error)
{
    const GLuint texture = plan->depth.texture;
    ew_result result = check_storage(gl, texture_target, "depth_texture", texture, error);
    if (result != EW_OK) return result;
    if (level_parameter(gl, texture_target, GL_TEXTURE_RED_TYPE) == GL_FLOAT) return EW_OK;
    if (plan->depth.source == EW_DEPTH_TEXTURE_LINEAR)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is not of a float format, which view depth needs",
                       texture);
    if (level_parameter(gl, texture_target, GL_TEXTURE_DEPTH_SIZE) > 0) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is neither of a depth format nor of a float format",
                   texture);
}

/* Every pixel of the viewport that is on the target needs a texel. Nothing tells the window's size: its viewport is taken to be
 * on it. */
static ew_result check_size(const ew_gl *gl, const ew_plan *plan, GLenum texture_target, const char *name, GLuint texture,
                            ew_error *error)
{
    const ew_viewport *viewport = &plan->target.viewport;
    const GLint width = level_parameter(gl, texture_target, GL_TEXTURE_WIDTH);
    const GLint height = level_parameter(gl, texture_target, GL_TEXTURE_HEIGHT);
    const long long right = (long long)viewport->x + viewport->width, top = (long long)viewport->y + viewport->height;
    if (right <= width && top <= height) return EW_OK;
    GLint target[2] = {0, 0};
    if (plan->target.framebuffer && !ew_find_target_size(gl, target)) return EW_OK;
    if (plan->target.framebuffer && (right <= width || target[0] <= width) && (top <= height || target[1] <= height))
        return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                   "%s %u is %d x %d pixels, and the viewport goes up to %lld, %lld; its pixels must be the target's", name,
                   texture, width, height, right, top);
}

ew_result ew_depth_check(const ew_gl *gl, const ew_plan *plan, GLenum texture_target, ew_error *error)
{
    ew_result result = check_not_attached(gl, plan, error);
    if (result != EW_OK || !gl->GetTexLevelParameteriv) return result;
    result = check_format(gl, plan, texture_target, error);
    return result == EW_OK ? check_size(gl, plan, texture_target, "depth_texture", plan->depth.texture, error) : result;
}

ew_result ew_normal_check(const ew_gl *gl, const ew_plan *plan, ew_error *error)
{
    const GLuint texture = plan->normal_texture;
    ew_result result = plan->target.framebuffer ? check_no_color(gl, plan, "normal_texture", texture, error) : EW_OK;
    if (result != EW_OK || !gl->GetTexLevelParameteriv) return result;
    result = check_storage(gl, GL_TEXTURE_2D, "normal_texture", texture, error);
    if (result != EW_OK) return result;
    const GLint type = level_parameter(gl, GL_TEXTURE_2D, GL_TEXTURE_BLUE_TYPE);
    if (type == GL_NONE || type == GL_INT || type == GL_UNSIGNED_INT)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "normal_texture %u has no red, green and blue channels that are not of integers", texture);
    return check_size(gl, plan, GL_TEXTURE_2D, "normal_texture", texture, error);
}
