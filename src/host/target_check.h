/* Whether the light would arrive in the target: what GL tells of a framebuffer that is bound for drawing. */
#ifndef EW_TARGET_CHECK_H
#define EW_TARGET_CHECK_H

#include "host/gl.h"
#include "plan/plan.h"

/* Refuses a target to which GL would draw nothing, or only a part, without an error. The target's framebuffer must be bound for
 * drawing. */
ew_result ew_target_check(const ew_gl *gl, const ew_target *target, ew_error *error);

/* Finds the size of the first image of the framebuffer that is bound for drawing, which must not be the window's. Returns false
 * where GL does not tell. */
bool ew_find_target_size(const ew_gl *gl, GLint size[2]);

#endif
