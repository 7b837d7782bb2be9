/* Saves and restores the host's GL state: all that the effect's draw changes, and all that could spoil the draw. */
#ifndef EW_STATE_GUARD_H
#define EW_STATE_GUARD_H

#include "host/binding_points.h"
#include "host/gl.h"
#include "model/rays.h"

/* GL has enumerators for this many. */
enum { EW_GL_MAX_DRAW_BUFFERS = 16 };

typedef struct ew_gl_buffer_binding {
    GLuint buffer;
    GLint64 start;
    GLint64 size; /* 0: the whole buffer */
} ew_gl_buffer_binding;

typedef struct ew_gl_state {
    GLuint program;
    GLuint program_keeper; /* a pipeline that keeps a program alive that is flagged for deletion, or 0 */
    bool transform_feedback_paused;
    GLuint vertex_array;
    GLuint uniform_buffer;
    ew_gl_buffer_binding uniform_bindings[EW_GL_BINDING_COUNT];
    GLenum active_texture;
    GLuint textures[EW_GL_TEXTURE_UNIT_COUNT]; /* GL_TEXTURE_2D */
    GLuint samplers[EW_GL_TEXTURE_UNIT_COUNT];
    GLuint multisampled_texture; /* of the depth's unit */
    GLuint draw_framebuffer;
    GLuint read_framebuffer;
    GLenum draw_buffers[EW_GL_MAX_DRAW_BUFFERS]; /* of the framebuffer that the effect draws to */
    int draw_buffer_count;                       /* 0: unchanged */
    GLfloat viewport[4];
    bool blend;
    GLenum blend_source_rgb, blend_destination_rgb, blend_source_alpha, blend_destination_alpha;
    GLenum blend_equation_rgb, blend_equation_alpha;
    GLboolean color_mask[4];
    GLenum polygon_mode[2];
    GLenum clamp_fragment_color;
    GLint sample_mask;
    bool multisample;
    bool framebuffer_srgb;
    bool program_point_size;
    bool point_sprite;  /* of the compatibility profile: points are squares */
    bool is_grid_begun; /* what follows is saved */
    GLint clip_origin, clip_depth_mode;
    bool scissor_test;
    GLint scissor[4];
    bool capabilities[EW_GL_MAX_CAPABILITIES];
} ew_gl_state;

/* Returns the buffer to bind to GL_UNIFORM_BUFFER when restoring. */
GLuint ew_gl_uniform_buffer(const ew_gl *gl);

/* Where and how the effect draws. */
typedef struct ew_gl_draw_state {
    GLuint framebuffer;
    GLint viewport[4];
    bool blend; /* with the factors below and GL_FUNC_ADD */
    GLenum source_rgb, destination_rgb, source_alpha, destination_alpha;
    bool framebuffer_srgb;
    bool keep_stencil_test;
} ew_gl_draw_state;

/* The guard has three limits. Samples that the effect draws count in the host's active queries. An object that was bound, and
 * that another context has deleted since, cannot be bound again: 0 is bound instead. Where transform feedback cannot be paused
 * (OpenGL 3.3 without ARB_transform_feedback2), it must be inactive. */

/* Saves the host's state, and pauses transform feedback so that the program can change. After success, the caller may change
 * all state that ew_gl_state names, and must call ew_gl_restore_state.
 *
 * Errors: OPENGL, if GL could not return to the current state; then nothing is changed. */
ew_result ew_gl_save_state(const ew_gl *gl, ew_gl_state *state, ew_error *error);

/* Replaces ew_gl_save_state for a host that wants no restoration. Assumes that every unwanted capability is on, so that all are
 * switched off. The caller must call ew_gl_restore_objects. */
void ew_gl_assume_state(const ew_gl *gl, ew_gl_state *state);

/* Sets all state that could influence triangles over the viewport, drawn with the effect's program and vertex array. The host's
 * scissor, GL_DITHER and conditional rendering stay in force, and its stencil test if that is to be kept. Multisampling stays
 * the host's, with the sample mask off. Until the restore, the caller may change GL_MULTISAMPLE, GL_SAMPLE_MASK and word 0 of
 * the mask; it must switch GL_SAMPLE_MASK off again. */
void ew_gl_set_draw_state(const ew_gl *gl, ew_gl_state *state, const ew_gl_draw_state *draw);

/* Sets the part of it that says what becomes of the target's colour. */
void ew_gl_set_blending(const ew_gl *gl, const ew_gl_draw_state *draw);

/* Changes what is set, for passes to other targets. */
void ew_gl_set_viewport(const ew_gl *gl, const ew_viewport *viewport);
void ew_gl_set_blend(const ew_gl *gl, bool blend);

/* Adds what is drawn to the target, alpha too, or replaces that. */
void ew_gl_set_sum(const ew_gl *gl, bool adds);

/* Lets points have the size that the shader gives them, switches the host's scissor off, and has NDC's y point up. (Turned
 * over, Mesa's llvmpipe draws points a row beyond the scissor.) */
void ew_gl_begin_grid(const ew_gl *gl, ew_gl_state *state);

/* Confines drawing to a viewport of the target, and to the host's scissor again. */
void ew_gl_clip_to(const ew_gl *gl, const ew_gl_state *state, const ew_viewport *viewport);

/* Confines drawing to the same part of a picture that begins at the viewport's corner, as far as it is on the target. NULL:
 * nobody knows the target's size. */
void ew_gl_clip_copy_to(const ew_gl *gl, const ew_gl_state *state, const ew_viewport *viewport, const GLint *target_size);

/* Restores the host's objects, its scissor and clip origin, and the samplers that state names. The effect's framebuffer must
 * still be bound for drawing. */
void ew_gl_restore_objects(const ew_gl *gl, const ew_gl_state *state);

/* Restores the saved state, objects included. */
void ew_gl_restore_state(const ew_gl *gl, const ew_gl_state *state);

#endif
