/* The opaque scene's depth, brought before the shader: the host's texture whatever it is set to, or a copy of a framebuffer's.
 */
#ifndef EW_OPAQUE_DEPTH_H
#define EW_OPAQUE_DEPTH_H

#include "host/gl.h"

/* A framebuffer's depth, copied; starts as {0} and keeps its texture from frame to frame. */
typedef struct ew_depth_copy {
    GLenum target;
    GLuint texture;
    GLint depth_bits, stencil_bits, component_type, samples; /* of the framebuffer that the texture's format was found for */
    GLsizei width, height;                                   /* 0 x 0: no storage yet */
} ew_depth_copy;

enum { EW_DEPTH_PARAMETER_COUNT = 4 };

/* The texture that the shader reads, and what it was set to before. */
typedef struct ew_opaque_depth {
    GLenum target; /* see ew_opaque_depth_target */
    GLint samples; /* of a multisampled texture */
    bool changed[EW_DEPTH_PARAMETER_COUNT];
    GLint parameters[EW_DEPTH_PARAMETER_COUNT];
} ew_opaque_depth;

/* What the shader reads the frame's depth from: GL_TEXTURE_2D, GL_TEXTURE_2D_MULTISAMPLE, or 0 where there is none. Expects the
 * frame's framebuffer to be bound for drawing. */
GLenum ew_opaque_depth_target(const ew_gl *gl, const ew_frame_desc *frame);

/* Binds the frame's depth to its unit, copied first if it is the framebuffer's. Expects the guard's draw state, and leaves the
 * frame's draw framebuffer bound. After success ew_opaque_depth_release must follow; after failure nothing of the host's
 * objects is changed. */
ew_result ew_opaque_depth_bind(ew_depth_copy *copy, const ew_gl *gl, const ew_frame_desc *frame, ew_opaque_depth *depth,
                               ew_error *error);

/* Sets the host's texture, which is still bound, to what it was. */
void ew_opaque_depth_release(const ew_gl *gl, const ew_opaque_depth *depth);

void ew_depth_copy_destroy(ew_depth_copy *copy, const ew_gl *gl);

#endif
