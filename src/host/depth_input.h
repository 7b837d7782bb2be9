/* The opaque scene's depth, brought before the shader: the host's texture whatever it is set to, or a copy of a framebuffer's.
 */
#ifndef EW_DEPTH_INPUT_H
#define EW_DEPTH_INPUT_H

#include "host/gl.h"
#include "plan/plan.h"

/* A framebuffer's depth, copied; starts as {0} and keeps its texture from frame to frame. */
typedef struct ew_depth_copy {
    GLenum target;
    GLuint texture;
    GLint depth_bits, stencil_bits, component_type, samples; /* of the framebuffer that the texture's format was found for */
    GLsizei width, height;                                   /* 0 x 0: no storage yet */
} ew_depth_copy;

enum { EW_DEPTH_PARAMETER_COUNT = 4 };

/* The texture that the shader reads, and what it was set to before. */
typedef struct ew_depth_input {
    GLenum target; /* GL_TEXTURE_2D or GL_TEXTURE_2D_MULTISAMPLE; 0 where nothing is opaque */
    GLint samples; /* of a multisampled texture */
    bool changed[EW_DEPTH_PARAMETER_COUNT];
    GLint parameters[EW_DEPTH_PARAMETER_COUNT];
} ew_depth_input;

/* What the shader reads the plan's depth from. Expects the target's framebuffer to be bound for drawing. */
ew_depth_kind ew_depth_input_kind(const ew_gl *gl, const ew_depth_request *request);

/* Binds the plan's depth, of the kind that ew_depth_input_kind told, to its unit: copied first if it is the framebuffer's.
 * Expects the guard's draw state, and leaves the target's framebuffer bound for drawing. After success ew_depth_input_release
 * must follow; after failure nothing of the host's objects is changed. */
ew_result ew_depth_input_bind(ew_depth_copy *copy, const ew_gl *gl, const ew_plan *plan, ew_depth_kind kind,
                              ew_depth_input *depth, ew_error *error);

/* Sets the host's texture, which is still bound, to what it was. */
void ew_depth_input_release(const ew_gl *gl, const ew_depth_input *depth);

void ew_depth_copy_destroy(ew_depth_copy *copy, const ew_gl *gl);

#endif
