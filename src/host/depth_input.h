/* Gives the shader the opaque depth: the host's texture, whatever its parameters, or a copy of the depth of a framebuffer. */
#ifndef EW_DEPTH_INPUT_H
#define EW_DEPTH_INPUT_H

#include "host/gl.h"
#include "plan/plan.h"

/* A copy of a framebuffer's depth. Starts as {0}, and keeps its texture from frame to frame. */
typedef struct ew_depth_copy {
    GLenum target;
    GLuint texture;
    GLint depth_bits, stencil_bits, component_type, samples; /* of the framebuffer that this copies */
    GLsizei width, height;                                   /* 0 x 0: no storage yet */
} ew_depth_copy;

enum { EW_DEPTH_PARAMETER_COUNT = 4 };

/* The texture that the shader reads, and the host's values of the parameters that were changed. */
typedef struct ew_depth_input {
    GLenum target; /* GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE; 0: nothing is opaque */
    GLint samples; /* 0: not multisampled */
    bool changed[EW_DEPTH_PARAMETER_COUNT];
    GLint parameters[EW_DEPTH_PARAMETER_COUNT];
} ew_depth_input;

/* Says which kind of texture has the requested depth. The target's framebuffer must be bound for drawing. */
ew_depth_kind ew_depth_input_kind(const ew_gl *gl, const ew_depth_request *request);

/* Binds the plan's depth, of the kind that ew_depth_input_kind said, to EW_GL_DEPTH_TEXTURE_UNIT; the framebuffer's own depth
 * is copied first. Needs the guard's draw state, and leaves the target's framebuffer bound for drawing. After success, the
 * caller must call ew_depth_input_release. After failure, none of the host's objects is changed. */
ew_result ew_depth_input_bind(ew_depth_copy *copy, const ew_gl *gl, const ew_plan *plan, ew_depth_kind kind,
                              ew_depth_input *depth, ew_error *error);

/* Restores the parameters of the host's texture, which must still be bound. */
void ew_depth_input_release(const ew_gl *gl, const ew_depth_input *depth);

void ew_depth_copy_destroy(ew_depth_copy *copy, const ew_gl *gl);

#endif
