/* Whether textures of the host's are what the shader reads: what GL tells of them before the draw. */
#ifndef EW_TEXTURE_CHECK_H
#define EW_TEXTURE_CHECK_H

#include "host/gl.h"
#include "plan/plan.h"

/* Refuses a texture of which the shader would read anything but depth, or nothing for some pixels, as far as the context can
 * be asked. The plan's depth texture must be bound to `texture_target`, and its framebuffer for drawing. */
ew_result ew_depth_check(const ew_gl *gl, const ew_plan *plan, GLenum texture_target, ew_error *error);

/* Likewise of the plan's texture of normals, which must be bound to GL_TEXTURE_2D. */
ew_result ew_normal_check(const ew_gl *gl, const ew_plan *plan, ew_error *error);

#endif
