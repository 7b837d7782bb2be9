/* Gives the shader the opaque depth: the host's texture, whatever its parameters, or a copy of the depth of a framebuffer. */
#ifndef EW_OPAQUE_DEPTH_H
#define EW_OPAQUE_DEPTH_H

#include "host/gl.h"

/* A copy of a framebuffer's depth. Starts as {0}, and keeps its texture from frame to frame. */
typedef struct ew_depth_copy {
    GLenum target;
    GLuint texture;
    GLint depth_bits, stencil_bits, component_type, samples; /* of the framebuffer that this copies */
    GLsizei width, height;                                   /* 0 x 0: no storage yet */
} ew_depth_copy;

enum { EW_DEPTH_PARAMETER_COUNT = 4 };

/* The texture that the shader reads, and the host's values of the parameters that were changed. */
typedef struct ew_opaque_depth {
    GLenum target; /* see ew_opaque_depth_target */
    GLint samples; /* 0: not multisampled */
    bool changed[EW_DEPTH_PARAMETER_COUNT];
    GLint parameters[EW_DEPTH_PARAMETER_COUNT];
} ew_opaque_depth;

/* Returns the target of the texture that holds the frame's depth: GL_TEXTURE_2D, GL_TEXTURE_2D_MULTISAMPLE, or 0 if there is no
 * depth. The frame's framebuffer must be bound for drawing. */
GLenum ew_opaque_depth_target(const ew_gl *gl, const ew_frame_desc *frame);

/* Binds the frame's depth to EW_GL_DEPTH_TEXTURE_UNIT; the framebuffer's own depth is copied first. Needs the guard's draw
 * state, and leaves the frame's framebuffer bound for drawing. After success, the caller must call ew_opaque_depth_release.
 * After failure, none of the host's objects is changed. */
ew_result ew_opaque_depth_bind(ew_depth_copy *copy, const ew_gl *gl, const ew_frame_desc *frame, ew_opaque_depth *depth,
                               ew_error *error);

/* Restores the parameters of the host's texture, which must still be bound. */
void ew_opaque_depth_release(const ew_gl *gl, const ew_opaque_depth *depth);

void ew_depth_copy_destroy(ew_depth_copy *copy, const ew_gl *gl);

#endif
