/* Whether a texture of the host's is a depth that can be read: what GL tells of it before the draw. */
#ifndef EW_DEPTH_CHECK_H
#define EW_DEPTH_CHECK_H

#include "host/gl.h"
#include "plan/plan.h"

/* Refuses a texture of which the shader would read anything but depth, or nothing for some pixels, as far as the context can
 * be asked. The plan's depth texture must be bound to `texture_target`, and its framebuffer for drawing. */
ew_result ew_depth_check(const ew_gl *gl, const ew_plan *plan, GLenum texture_target, ew_error *error);

#endif
