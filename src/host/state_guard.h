/* The guard of the host's GL state: everything that the effect's drawing touches, or that could spoil it. */
#ifndef EW_STATE_GUARD_H
#define EW_STATE_GUARD_H

#include "host/binding_points.h"
#include "host/gl.h"

/* As many as GL has enumerators for. */
enum { EW_GL_MAX_DRAW_BUFFERS = 16 };

typedef struct ew_gl_buffer_binding {
    GLuint buffer;
    GLint64 start;
    GLint64 size; /* 0: all of it */
} ew_gl_buffer_binding;

typedef struct ew_gl_state {
    GLuint program;
    GLuint program_keeper; /* a pipeline that keeps alive a program that is flagged for deletion, or 0 */
    bool transform_feedback_paused;
    GLuint vertex_array;
    GLuint uniform_buffer;
    ew_gl_buffer_binding uniform_binding;
    GLenum active_texture;
    GLuint texture;
    GLuint multisampled_texture;
    GLuint sampler;
    GLuint draw_framebuffer;
    GLuint read_framebuffer;
    GLenum draw_buffers[EW_GL_MAX_DRAW_BUFFERS]; /* of the framebuffer that the effect draws to */
    int draw_buffer_count;                       /* 0: not changed */
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
    bool capabilities[EW_GL_MAX_CAPABILITIES];
} ew_gl_state;

/* The buffer that GL_UNIFORM_BUFFER must be returned to. */
GLuint ew_gl_uniform_buffer(const ew_gl *gl);

/* Where and how the effect draws. */
typedef struct ew_gl_draw_state {
    GLuint framebuffer;
    GLint viewport[4];
    bool blend; /* with these factors, adding */
    GLenum source_rgb, destination_rgb, source_alpha, destination_alpha;
    bool framebuffer_srgb;
} ew_gl_draw_state;

/* What the guard cannot keep: samples that the effect draws count in the host's active queries; an object that another context
 * has deleted while it was bound here cannot be bound again, and leaves 0 in its place; and in contexts that cannot pause
 * transform feedback (OpenGL 3.3 without ARB_transform_feedback2) it must not be active. */

/* Saves the host's state and makes room for the effect's program: pauses transform feedback. After success, all of the state
 * that ew_gl_state names may be changed, and ew_gl_restore_state must follow.
 *
 * Errors: OPENGL, if the state is one that GL cannot return to; then nothing is changed. */
ew_result ew_gl_save_state(const ew_gl *gl, ew_gl_state *state, ew_error *error);

/* Instead of saving, for a host that wants no restoration: takes every unwanted capability to be on. ew_gl_restore_objects must
 * follow. */
void ew_gl_assume_state(const ew_gl *gl, ew_gl_state *state);

/* Puts everything that could influence a triangle that covers the viewport, drawn with the effect's program and vertex array,
 * into a known state. The host's scissor stays in force; so do GL_DITHER and conditional rendering. Multisampling is the
 * host's, without a sample mask; but that, its word 0 and GL_MULTISAMPLE may be changed until the state is restored, when the
 * mask must be off again. */
void ew_gl_set_draw_state(const ew_gl *gl, ew_gl_state *state, const ew_gl_draw_state *draw);

/* Returns the host's objects to what they were, while the effect's framebuffer is still bound for drawing. */
void ew_gl_restore_objects(const ew_gl *gl, const ew_gl_state *state);

/* Returns to the saved state, objects included. */
void ew_gl_restore_state(const ew_gl *gl, const ew_gl_state *state);

#endif
