/* Saving, setting and restoring the host's GL state. */
#include "host/state_guard.h"

#include "base/error.h"

#include <stdint.h>

/* Names that the core profile dropped. */
enum { COMPATIBILITY_CLAMP_FRAGMENT_COLOR = 0x891B, COMPATIBILITY_POINT_SPRITE = 0x8861 };

static GLint get_integer(const ew_gl *gl, GLenum name)
{
    GLint value = 0;
    gl->GetIntegerv(name, &value);
    return value;
}

/* Returns the name that is bound, or 0 if another context has deleted the object since. Binding such a name is an error in the
 * core profile, and makes a new object elsewhere. */
static GLuint get_binding(const ew_gl *gl, GLenum name, GLboolean(APIENTRYP is_object)(GLuint name))
{
    GLuint binding = (GLuint)get_integer(gl, name);
    return binding != 0 && is_object(binding) ? binding : 0;
}

GLuint ew_gl_uniform_buffer(const ew_gl *gl)
{
    return get_binding(gl, GL_UNIFORM_BUFFER_BINDING, gl->IsBuffer);
}

/* Once a program that is flagged for deletion is current nowhere, GL deletes it, unless it is the active program of a pipeline
 * (OpenGL 4.6 core, 7.3). So a pipeline of our own keeps it alive. */
static ew_result keep_program(const ew_gl *gl, ew_gl_state *state, ew_error *error)
{
    state->program_keeper = 0;
    if (state->program == 0) return EW_OK;
    GLint linked = GL_FALSE, deleted = GL_FALSE;
    gl->GetProgramiv(state->program, GL_LINK_STATUS, &linked);
    if (!linked)
        return ew_fail(error, EW_ERROR_OPENGL,
                       "the current program %u was linked again, without success, and could not be made current again; "
                       "call glUseProgram(0) first",
                       state->program);
    gl->GetProgramiv(state->program, GL_DELETE_STATUS, &deleted);
    if (!deleted) return EW_OK;
    if (gl->GenProgramPipelines == NULL)
        return ew_fail(
            error, EW_ERROR_OPENGL,
            "the current program %u is flagged for deletion and would be gone after the call; call glUseProgram(0) first",
            state->program);
    gl->GenProgramPipelines(1, &state->program_keeper);
    gl->ActiveShaderProgram(state->program_keeper, state->program);
    return EW_OK;
}

static void save_uniform_binding(const ew_gl *gl, GLuint index, ew_gl_buffer_binding *binding)
{
    GLint buffer = 0;
    gl->GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, index, &buffer);
    *binding = (ew_gl_buffer_binding){0};
    if (buffer == 0 || !gl->IsBuffer((GLuint)buffer)) return;
    binding->buffer = (GLuint)buffer;
    gl->GetInteger64i_v(GL_UNIFORM_BUFFER_START, index, &binding->start);
    gl->GetInteger64i_v(GL_UNIFORM_BUFFER_SIZE, index, &binding->size);
}

ew_result ew_gl_save_state(const ew_gl *gl, ew_gl_state *state, ew_error *error)
{
    state->program = (GLuint)get_integer(gl, GL_CURRENT_PROGRAM);
    ew_result result = keep_program(gl, state, error);
    if (result != EW_OK) return result;

    /* While transform feedback is active and not paused, glUseProgram is an error. */
    state->transform_feedback_paused = gl->PauseTransformFeedback && get_integer(gl, GL_TRANSFORM_FEEDBACK_ACTIVE) &&
                                       !get_integer(gl, GL_TRANSFORM_FEEDBACK_PAUSED);
    if (state->transform_feedback_paused) gl->PauseTransformFeedback();

    state->vertex_array = (GLuint)get_integer(gl, GL_VERTEX_ARRAY_BINDING);
    state->uniform_buffer = ew_gl_uniform_buffer(gl);
    for (GLuint index = 0; index < EW_GL_BINDING_COUNT; ++index)
        save_uniform_binding(gl, index, &state->uniform_bindings[index]);

    state->active_texture = (GLenum)get_integer(gl, GL_ACTIVE_TEXTURE);
    for (int unit = EW_GL_TEXTURE_UNIT_COUNT - 1; unit >= 0; --unit) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        state->textures[unit] = get_binding(gl, GL_TEXTURE_BINDING_2D, gl->IsTexture);
        state->samplers[unit] = get_binding(gl, GL_SAMPLER_BINDING, gl->IsSampler);
    }
    if (gl->SampleMaski) {
        state->multisampled_texture = get_binding(gl, GL_TEXTURE_BINDING_2D_MULTISAMPLE, gl->IsTexture);
        gl->GetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &state->sample_mask);
    }

    state->draw_framebuffer = (GLuint)get_integer(gl, GL_DRAW_FRAMEBUFFER_BINDING);
    state->read_framebuffer = (GLuint)get_integer(gl, GL_READ_FRAMEBUFFER_BINDING);
    state->draw_buffer_count = 0;
    gl->GetFloatv(GL_VIEWPORT, state->viewport);

    /* A query without an index should return draw buffer 0's state. But NVIDIA's driver returns true for GL_BLEND even if only
     * another draw buffer blends. */
    state->blend = gl->IsEnabledi ? gl->IsEnabledi(GL_BLEND, 0) : gl->IsEnabled(GL_BLEND);
    state->blend_source_rgb = (GLenum)get_integer(gl, GL_BLEND_SRC_RGB);
    state->blend_destination_rgb = (GLenum)get_integer(gl, GL_BLEND_DST_RGB);
    state->blend_source_alpha = (GLenum)get_integer(gl, GL_BLEND_SRC_ALPHA);
    state->blend_destination_alpha = (GLenum)get_integer(gl, GL_BLEND_DST_ALPHA);
    state->blend_equation_rgb = (GLenum)get_integer(gl, GL_BLEND_EQUATION_RGB);
    state->blend_equation_alpha = (GLenum)get_integer(gl, GL_BLEND_EQUATION_ALPHA);
    gl->GetBooleanv(GL_COLOR_WRITEMASK, state->color_mask);

    if (gl->PolygonMode) {
        GLint modes[2];
        gl->GetIntegerv(GL_POLYGON_MODE, modes);
        state->polygon_mode[0] = (GLenum)modes[0];
        /* Only the compatibility profile has a mode for each face; in the core profile, drivers return one value or two. */
        state->polygon_mode[1] = (GLenum)modes[gl->compatibility ? 1 : 0];
    }
    if (gl->ClampColor) state->clamp_fragment_color = (GLenum)get_integer(gl, COMPATIBILITY_CLAMP_FRAGMENT_COLOR);
    if (gl->multisample) state->multisample = gl->IsEnabled(GL_MULTISAMPLE);
    if (gl->framebuffer_srgb) state->framebuffer_srgb = gl->IsEnabled(GL_FRAMEBUFFER_SRGB);
    if (!gl->es) state->program_point_size = gl->IsEnabled(GL_PROGRAM_POINT_SIZE);
    if (gl->compatibility) state->point_sprite = gl->IsEnabled(COMPATIBILITY_POINT_SPRITE);
    state->is_grid_begun = false;
    for (int i = 0; i < gl->unwanted_capability_count; i++)
        state->capabilities[i] = gl->IsEnabled(gl->unwanted_capabilities[i]);
    return EW_OK;
}

void ew_gl_assume_state(const ew_gl *gl, ew_gl_state *state)
{
    *state = (ew_gl_state){0};
    for (int i = 0; i < gl->unwanted_capability_count; i++)
        state->capabilities[i] = true;
}

static void set_capability(const ew_gl *gl, GLenum capability, bool on)
{
    (on ? gl->Enable : gl->Disable)(capability);
}

static void set_viewport(const ew_gl *gl, const GLfloat viewport[4])
{
    /* glViewport would set every viewport of a viewport array. */
    if (gl->ViewportIndexedf)
        gl->ViewportIndexedf(0, viewport[0], viewport[1], viewport[2], viewport[3]);
    else
        gl->Viewport((GLint)viewport[0], (GLint)viewport[1], (GLsizei)viewport[2], (GLsizei)viewport[3]);
}

void ew_gl_set_viewport(const ew_gl *gl, const ew_viewport *viewport)
{
    set_viewport(gl, (const GLfloat[4]){(GLfloat)viewport->x, (GLfloat)viewport->y, (GLfloat)viewport->width,
                                        (GLfloat)viewport->height});
}

void ew_gl_set_blend(const ew_gl *gl, bool blend)
{
    if (gl->Enablei)
        (blend ? gl->Enablei : gl->Disablei)(GL_BLEND, 0);
    else
        set_capability(gl, GL_BLEND, blend);
}

static void set_blend_factors(const ew_gl *gl, GLenum source_rgb, GLenum destination_rgb, GLenum source_alpha,
                              GLenum destination_alpha)
{
    if (gl->BlendFuncSeparatei)
        gl->BlendFuncSeparatei(0, source_rgb, destination_rgb, source_alpha, destination_alpha);
    else
        gl->BlendFuncSeparate(source_rgb, destination_rgb, source_alpha, destination_alpha);
}

static void set_blend_equation(const ew_gl *gl, GLenum rgb, GLenum alpha)
{
    /* An advanced equation (GL_MULTIPLY_KHR, ...) is the same for RGB and alpha, and the separate functions refuse it. */
    if (rgb == alpha) {
        if (gl->BlendEquationi)
            gl->BlendEquationi(0, rgb);
        else
            gl->BlendEquation(rgb);
    } else {
        if (gl->BlendEquationSeparatei)
            gl->BlendEquationSeparatei(0, rgb, alpha);
        else
            gl->BlendEquationSeparate(rgb, alpha);
    }
}

static void set_color_mask(const ew_gl *gl, const GLboolean mask[4])
{
    if (gl->ColorMaski)
        gl->ColorMaski(0, mask[0], mask[1], mask[2], mask[3]);
    else
        gl->ColorMask(mask[0], mask[1], mask[2], mask[3]);
}

/* The effect's shader has one output. It would write undefined values to further draw buffers, so they are removed. */
static void keep_first_draw_buffer(const ew_gl *gl, ew_gl_state *state)
{
    for (int i = 0; i < gl->max_draw_buffers && i < EW_GL_MAX_DRAW_BUFFERS; i++) {
        state->draw_buffers[i] = (GLenum)get_integer(gl, GL_DRAW_BUFFER0 + (GLenum)i);
        if (i > 0 && state->draw_buffers[i] != GL_NONE) state->draw_buffer_count = i + 1;
    }
    if (state->draw_buffer_count == 0) return;
    gl->DrawBuffers(1, state->draw_buffers);
    /* Mesa 22.3 checks the draw buffers against the blend factors only when the program changes. */
    gl->UseProgram(0);
}

void ew_gl_set_blending(const ew_gl *gl, const ew_gl_draw_state *draw)
{
    ew_gl_set_blend(gl, draw->blend);
    /* Set even without blending: an advanced equation, or a factor of a second colour, may be an error all the same. */
    set_blend_factors(gl, draw->source_rgb, draw->destination_rgb, draw->source_alpha, draw->destination_alpha);
    set_blend_equation(gl, GL_FUNC_ADD, GL_FUNC_ADD);
}

void ew_gl_set_sum(const ew_gl *gl, bool adds)
{
    ew_gl_set_blending(gl, &(ew_gl_draw_state){.blend = adds,
                                               .source_rgb = GL_ONE,
                                               .destination_rgb = GL_ONE,
                                               .source_alpha = GL_ONE,
                                               .destination_alpha = GL_ONE});
}

void ew_gl_set_draw_state(const ew_gl *gl, ew_gl_state *state, const ew_gl_draw_state *draw)
{
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, draw->framebuffer);
    keep_first_draw_buffer(gl, state);
    set_viewport(gl, (const GLfloat[4]){(GLfloat)draw->viewport[0], (GLfloat)draw->viewport[1], (GLfloat)draw->viewport[2],
                                        (GLfloat)draw->viewport[3]});
    ew_gl_set_blending(gl, draw);
    set_color_mask(gl, (const GLboolean[4]){GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE});
    if (gl->PolygonMode) gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    if (gl->ClampColor) gl->ClampColor(COMPATIBILITY_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    if (gl->framebuffer_srgb) set_capability(gl, GL_FRAMEBUFFER_SRGB, draw->framebuffer_srgb);
    for (int i = 0; i < gl->unwanted_capability_count; i++) {
        const GLenum capability = gl->unwanted_capabilities[i];
        if (state->capabilities[i] && !(capability == GL_STENCIL_TEST && draw->keep_stencil_test)) gl->Disable(capability);
    }
}

/* Scissors come in arrays where viewports do, and the effect draws with the first. */
static bool has_scissor(const ew_gl *gl)
{
    return gl->ScissorIndexed && gl->IsEnabledi ? gl->IsEnabledi(GL_SCISSOR_TEST, 0) : gl->IsEnabled(GL_SCISSOR_TEST);
}

static void set_scissor(const ew_gl *gl, bool on, const GLint box[4])
{
    if (gl->ScissorIndexed && gl->Enablei) {
        (on ? gl->Enablei : gl->Disablei)(GL_SCISSOR_TEST, 0);
        gl->ScissorIndexed(0, box[0], box[1], box[2], box[3]);
    } else {
        set_capability(gl, GL_SCISSOR_TEST, on);
        gl->Scissor(box[0], box[1], box[2], box[3]);
    }
}

void ew_gl_begin_grid(const ew_gl *gl, ew_gl_state *state)
{
    state->is_grid_begun = true;
    state->scissor_test = has_scissor(gl);
    gl->GetIntegerv(GL_SCISSOR_BOX, state->scissor);
    set_scissor(gl, false, state->scissor);
    if (gl->clip_control) {
        gl->GetIntegerv(GL_CLIP_ORIGIN, &state->clip_origin);
        gl->GetIntegerv(GL_CLIP_DEPTH_MODE, &state->clip_depth_mode);
        gl->ClipControl(GL_LOWER_LEFT, (GLenum)state->clip_depth_mode);
    }
    if (!gl->es) gl->Enable(GL_PROGRAM_POINT_SIZE);
    if (gl->compatibility) gl->Enable(COMPATIBILITY_POINT_SPRITE);
}

static int64_t larger(int64_t a, int64_t b)
{
    return a > b ? a : b;
}

static int64_t smaller(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/* Pixels from the lower left corner, inclusive, to the upper right corner, exclusive. A corner of a host's rectangle may lie
   beyond an int. */
typedef struct clip_box {
    int64_t left, bottom, right, top;
} clip_box;

static clip_box box_of(const GLint *rectangle)
{
    return (clip_box){rectangle[0], rectangle[1], (int64_t)rectangle[0] + rectangle[2], (int64_t)rectangle[1] + rectangle[3]};
}

static clip_box common_box(const clip_box *a, const clip_box *b)
{
    return (clip_box){larger(a->left, b->left), larger(a->bottom, b->bottom), smaller(a->right, b->right),
                      smaller(a->top, b->top)};
}

/* What the host's scissor leaves of a viewport. */
static clip_box scissored(const ew_gl_state *state, const ew_viewport *viewport)
{
    const clip_box box = box_of((const GLint[4]){viewport->x, viewport->y, viewport->width, viewport->height});
    if (!state->scissor_test) return box;
    const clip_box host = box_of(state->scissor);
    return common_box(&box, &host);
}

/* The scissor of a target whose pixel (0, 0) is pixel (x, y) of the box's. */
static void set_clip_box(const ew_gl *gl, const clip_box *box, int x, int y)
{
    const bool empty = box->right <= box->left || box->top <= box->bottom;
    if (empty) {
        set_scissor(gl, true, (const GLint[4]){0, 0, 0, 0});
        return;
    }
    set_scissor(gl, true,
                (const GLint[4]){(GLint)(box->left - x), (GLint)(box->bottom - y), (GLint)(box->right - box->left),
                                 (GLint)(box->top - box->bottom)});
}

void ew_gl_clip_to(const ew_gl *gl, const ew_gl_state *state, const ew_viewport *viewport)
{
    const clip_box box = scissored(state, viewport);
    set_clip_box(gl, &box, 0, 0);
}

void ew_gl_clip_copy_to(const ew_gl *gl, const ew_gl_state *state, const ew_viewport *viewport, const GLint *target_size)
{
    clip_box box = scissored(state, viewport);
    box.left = larger(box.left, 0);
    box.bottom = larger(box.bottom, 0);
    if (target_size) {
        box.right = smaller(box.right, target_size[0]);
        box.top = smaller(box.top, target_size[1]);
    }
    set_clip_box(gl, &box, viewport->x, viewport->y);
}

static void restore_uniform_bindings(const ew_gl *gl, const ew_gl_state *state)
{
    for (GLuint index = 0; index < EW_GL_BINDING_COUNT; ++index) {
        const ew_gl_buffer_binding *binding = &state->uniform_bindings[index];
        if (binding->size > 0)
            gl->BindBufferRange(GL_UNIFORM_BUFFER, index, binding->buffer, (GLintptr)binding->start, (GLsizeiptr)binding->size);
        else /* the whole buffer, even if its size changes */
            gl->BindBufferBase(GL_UNIFORM_BUFFER, index, binding->buffer);
    }
    gl->BindBuffer(GL_UNIFORM_BUFFER, state->uniform_buffer); /* last: the calls above change this binding, too */
}

void ew_gl_restore_objects(const ew_gl *gl, const ew_gl_state *state)
{
    if (state->draw_buffer_count > 0) gl->DrawBuffers(state->draw_buffer_count, state->draw_buffers);
    if (state->is_grid_begun) {
        set_scissor(gl, state->scissor_test, state->scissor);
        if (gl->clip_control) gl->ClipControl((GLenum)state->clip_origin, (GLenum)state->clip_depth_mode);
    }
    for (int unit = 0; unit < EW_GL_TEXTURE_UNIT_COUNT; ++unit)
        gl->BindSampler((GLuint)unit, state->samplers[unit]);
}

void ew_gl_restore_state(const ew_gl *gl, const ew_gl_state *state)
{
    ew_gl_restore_objects(gl, state);
    for (int i = 0; i < gl->unwanted_capability_count; i++)
        if (state->capabilities[i]) gl->Enable(gl->unwanted_capabilities[i]);
    if (gl->framebuffer_srgb) set_capability(gl, GL_FRAMEBUFFER_SRGB, state->framebuffer_srgb);
    if (!gl->es) set_capability(gl, GL_PROGRAM_POINT_SIZE, state->program_point_size);
    if (gl->compatibility) set_capability(gl, COMPATIBILITY_POINT_SPRITE, state->point_sprite);
    if (gl->multisample) set_capability(gl, GL_MULTISAMPLE, state->multisample);
    if (gl->ClampColor) gl->ClampColor(COMPATIBILITY_CLAMP_FRAGMENT_COLOR, state->clamp_fragment_color);
    if (gl->PolygonMode) {
        if (state->polygon_mode[0] == state->polygon_mode[1]) {
            gl->PolygonMode(GL_FRONT_AND_BACK, state->polygon_mode[0]);
        } else {
            gl->PolygonMode(GL_FRONT, state->polygon_mode[0]);
            gl->PolygonMode(GL_BACK, state->polygon_mode[1]);
        }
    }
    set_color_mask(gl, state->color_mask);
    set_blend_equation(gl, state->blend_equation_rgb, state->blend_equation_alpha);
    set_blend_factors(gl, state->blend_source_rgb, state->blend_destination_rgb, state->blend_source_alpha,
                      state->blend_destination_alpha);
    ew_gl_set_blend(gl, state->blend);
    set_viewport(gl, state->viewport);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, state->draw_framebuffer);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, state->read_framebuffer);

    for (int unit = EW_GL_TEXTURE_UNIT_COUNT - 1; unit >= 0; --unit) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        gl->BindTexture(GL_TEXTURE_2D, state->textures[unit]);
    }
    if (gl->SampleMaski) {
        gl->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, state->multisampled_texture);
        gl->SampleMaski(0, (GLbitfield)state->sample_mask);
    }
    gl->ActiveTexture(state->active_texture);

    restore_uniform_bindings(gl, state);
    gl->BindVertexArray(state->vertex_array);
    gl->UseProgram(state->program);
    if (state->program_keeper) gl->DeleteProgramPipelines(1, &state->program_keeper);
    if (state->transform_feedback_paused) gl->ResumeTransformFeedback();
}
