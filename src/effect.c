/* The effect: sources, shader permutations and GL objects together. */
#include "energywave.h"

#include "base/allocator.h"
#include "base/error.h"
#include "host/gl.h"
#include "host/opaque_depth.h"
#include "host/program_cache.h"
#include "host/state_guard.h"
#include "model/scene.h"

struct ew_effect {
    ew_allocator allocator;
    ew_gl gl;
    size_t capacity; /* units of sources */
    ew_scene scene;
    ew_program_cache programs;
    ew_depth_copy depth_copy;
    GLuint sampler; /* reads depth as it is, whatever the texture's own parameters say */
    GLuint uniform_buffer;
    char *shader_text; /* what ew_get_shader_text returned last */
};

static void create_objects(ew_effect *effect)
{
    const ew_gl *gl = &effect->gl;
    gl->GenBuffers(1, &effect->uniform_buffer);
    gl->GenSamplers(1, &effect->sampler);
    gl->SamplerParameteri(effect->sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->SamplerParameteri(effect->sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->SamplerParameteri(effect->sampler, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

ew_result ew_create_effect(const ew_effect_desc *desc, ew_effect **effect, ew_error *error)
{
    if (!desc || !desc->get_proc_address)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "desc and its get_proc_address must not be NULL");
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");

    const ew_allocator *allocator = desc->allocator ? desc->allocator : &ew_default_allocator;
    if (!allocator->allocate || !allocator->deallocate)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "desc->allocator's allocate and deallocate must not be NULL");

    ew_effect *made = allocator->allocate(allocator->user, sizeof *made);
    if (!made) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for an effect of %zu bytes", sizeof *made);
    *made = (ew_effect){.allocator = *allocator};
    ew_result result = ew_gl_load(&made->gl, desc->get_proc_address, desc->user, error);
    if (result != EW_OK) {
        allocator->deallocate(allocator->user, made);
        return result;
    }
    made->capacity = ew_scene_capacity((size_t)made->gl.max_uniform_block_size);
    made->scene.sources.epsilon = 1;
    create_objects(made);
    *effect = made;
    return EW_OK;
}

void ew_destroy_effect(ew_effect *effect)
{
    if (!effect) return;
    const ew_gl *gl = &effect->gl;
    const ew_allocator allocator = effect->allocator;
    ew_program_cache_destroy(&effect->programs, gl, &allocator);
    ew_depth_copy_destroy(&effect->depth_copy, gl);
    gl->DeleteSamplers(1, &effect->sampler);
    gl->DeleteBuffers(1, &effect->uniform_buffer);
    ew_scene_destroy(&effect->scene, &allocator);
    if (effect->shader_text) allocator.deallocate(allocator.user, effect->shader_text);
    allocator.deallocate(allocator.user, effect);
}

ew_result ew_set_sources(ew_effect *effect, const ew_sources_desc *sources, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    return ew_scene_set(&effect->scene, sources, effect->capacity, &effect->allocator, error);
}

/* Fills the uniform buffer. Its storage is orphaned first: the GPU may still be reading what the last frame left there, and
 * waiting for it would stall. Orphaning leaves it to the driver to keep as many copies as frames are under way, which a ring of
 * our own would have to guess, or learn from fences; and the buffer is small enough that a new one costs the driver nothing. */
static void upload(const ew_effect *effect, const struct ew_frame_block *frame)
{
    const ew_gl *gl = &effect->gl;
    const ew_scene *scene = &effect->scene;
    size_t size = sizeof *frame + effect->capacity * sizeof(ew_vec4);
    gl->BindBuffer(GL_UNIFORM_BUFFER, effect->uniform_buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, NULL, GL_STREAM_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof *frame, frame);
    if (scene->source_data_size > 0)
        gl->BufferSubData(GL_UNIFORM_BUFFER, sizeof *frame, (GLsizeiptr)scene->source_data_size, scene->source_data);
}

static ew_gl_draw_state draw_state(const ew_frame_desc *frame)
{
    ew_gl_draw_state state = {
        .framebuffer = frame->framebuffer,
        .viewport = {frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height},
        .blend = frame->output == EW_OUTPUT_LERP || frame->output == EW_OUTPUT_ADD,
        .source_rgb = GL_ONE,
        .framebuffer_srgb = frame->encoding == EW_ENCODING_SRGB_8BIT,
    };
    /* The shader's alpha is min(1, B). */
    bool lerp = frame->output == EW_OUTPUT_LERP;
    state.destination_rgb = state.destination_alpha = lerp ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
    state.source_alpha = lerp ? GL_ONE : GL_ZERO;
    return state;
}

/* Four vertices are the quad; the next ones lie beyond its upper edge, and the triangles that they make are clipped away. */
enum { QUAD_VERTEX = 0, OUTSIDE_VERTEX = 4, QUAD_VERTEX_COUNT = 4 };

static void draw_quad(const ew_gl *gl, GLint first_vertex)
{
    gl->DrawArrays(GL_TRIANGLE_STRIP, first_vertex, QUAD_VERTEX_COUNT);
}

/* Draws each sample of the target with its own depth, or, where the target has other samples, each pixel with them all. Masks
 * do what gl_SampleID would, in every context that has multisampled textures. */
static void draw_samples(const ew_gl *gl, GLuint program, GLint samples, GLint first_vertex)
{
    GLint target_samples = 0, location = gl->GetUniformLocation(program, "ew_samples");
    gl->GetIntegerv(GL_SAMPLES, &target_samples);
    if (target_samples != samples) {
        gl->Uniform2i(location, 0, samples);
        draw_quad(gl, first_vertex);
        return;
    }
    if (gl->multisample) gl->Enable(GL_MULTISAMPLE);
    gl->Enable(GL_SAMPLE_MASK);
    for (GLint i = 0; i < samples; i++) {
        gl->SampleMaski(0, (GLbitfield)1 << i);
        gl->Uniform2i(location, i, i + 1);
        draw_quad(gl, first_vertex);
    }
    gl->Disable(GL_SAMPLE_MASK);
}

static ew_result draw(ew_effect *effect, const ew_frame_desc *frame, const struct ew_frame_block *block, GLuint program,
                      GLint first_vertex, ew_error *error)
{
    const ew_gl *gl = &effect->gl;
    ew_opaque_depth depth;
    ew_result result = ew_opaque_depth_bind(&effect->depth_copy, gl, frame, &depth, error);
    if (result != EW_OK) return result;
    gl->BindSampler(EW_GL_DEPTH_TEXTURE_UNIT, effect->sampler);
    upload(effect, block);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, effect->uniform_buffer);
    gl->UseProgram(program);
    /* Vertex arrays are not shared between contexts, and one without attributes costs nothing to make. */
    GLuint vertex_array;
    gl->GenVertexArrays(1, &vertex_array);
    gl->BindVertexArray(vertex_array);
    if (depth.samples > 0)
        draw_samples(gl, program, depth.samples, first_vertex);
    else
        draw_quad(gl, first_vertex);
    gl->DeleteVertexArrays(1, &vertex_array);
    ew_opaque_depth_release(gl, &depth);
    return EW_OK;
}

/* Checks what can be checked of a frame before any state is touched. */
static ew_result validate_names(const ew_gl *gl, const ew_frame_desc *frame, ew_error *error)
{
    if (frame->framebuffer && !gl->IsFramebuffer(frame->framebuffer))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "framebuffer %u is none of this context's", frame->framebuffer);
    if (frame->depth_source == EW_DEPTH_TEXTURE_MULTISAMPLE && !gl->SampleMaski)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "depth_source is EW_DEPTH_TEXTURE_MULTISAMPLE, but OpenGL ES has multisampled textures from 3.1 on, and "
                       "this context is older");
    if (frame->depth_source != EW_DEPTH_FRAMEBUFFER && frame->depth_texture && !gl->IsTexture(frame->depth_texture))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is no texture", frame->depth_texture);
    return EW_OK;
}

/* What ew_draw and ew_prepare have in common; the latter goes on only if the program is ready, and draws outside of the view.
 */
typedef enum draw_purpose { DRAWING, PREPARING } draw_purpose;

static ew_result draw_mix(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, const struct ew_frame_block *block,
                          draw_purpose purpose, GLuint *program, ew_gl_state *state, ew_error *error)
{
    const ew_gl *gl = &effect->gl;
    ew_gl_draw_state wanted = draw_state(frame);
    ew_gl_set_draw_state(gl, state, &wanted);
    if (gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return ew_fail(error, EW_ERROR_OPENGL, "framebuffer %u is not complete", frame->framebuffer);

    ew_mix current = ew_scene_mix(&effect->scene);
    unsigned key = ew_program_key(mix ? mix : &current, frame, ew_opaque_depth_target(gl, frame));
    ew_result result = (purpose == DRAWING ? ew_program_get : ew_program_prepare)(&effect->programs, gl, effect->capacity,
                                                                                  &effect->allocator, key, program, error);
    if (result != EW_OK || *program == 0) return result;
    return draw(effect, frame, block, *program, purpose == DRAWING ? QUAD_VERTEX : OUTSIDE_VERTEX, error);
}

/* `mix`: NULL for the current sources. `program` becomes 0 if it is being prepared. */
static ew_result draw_frame(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, draw_purpose purpose,
                            GLuint *program, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    ew_result result = ew_validate_frame(frame, error);
    if (result != EW_OK) return result;
    const ew_gl *gl = &effect->gl;
    result = validate_names(gl, frame, error);
    if (result != EW_OK) return result;

    struct ew_frame_block block;
    result = ew_scene_pack(&effect->scene, frame, &block, error);
    if (result != EW_OK) return result;
    ew_gl_state state;
    if (frame->skip_restore) {
        ew_gl_assume_state(gl, &state);
        result = draw_mix(effect, mix, frame, &block, purpose, program, &state, error);
        ew_gl_restore_objects(gl, &state);
        return result;
    }
    result = ew_gl_save_state(gl, &state, error);
    if (result != EW_OK) return result;
    result = draw_mix(effect, mix, frame, &block, purpose, program, &state, error);
    ew_gl_restore_state(gl, &state);
    return result;
}

ew_result ew_draw(ew_effect *effect, const ew_frame_desc *frame, ew_error *error)
{
    GLuint program;
    return draw_frame(effect, NULL, frame, DRAWING, &program, error);
}

ew_result ew_prepare(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *is_ready, ew_error *error)
{
    if (!is_ready) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "is_ready must not be NULL");
    GLuint program;
    ew_result result = draw_frame(effect, mix, frame, PREPARING, &program, error);
    if (result == EW_OK) *is_ready = program != 0;
    return result;
}

ew_result ew_get_shader_text(ew_effect *effect, const ew_mix *mix, ew_integrator integrator, const char **text, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    if (!text) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "text must not be NULL");
    if (integrator != EW_INTEGRATOR_ADAPTIVE && integrator != EW_INTEGRATOR_SIMPSON)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "integrator must be one of ew_integrator");
    const ew_allocator *allocator = &effect->allocator;
    ew_mix current = ew_scene_mix(&effect->scene);
    unsigned key = ew_program_key(mix ? mix : &current, &(ew_frame_desc){.integrator = integrator}, 0);
    size_t length = ew_program_write_include(effect->capacity, key, NULL);
    char *made = allocator->allocate(allocator->user, length + 1);
    if (!made) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for a shader of %zu characters", length);
    ew_program_write_include(effect->capacity, key, made);
    if (effect->shader_text) allocator->deallocate(allocator->user, effect->shader_text);
    *text = effect->shader_text = made;
    return EW_OK;
}

ew_result ew_update_uniform_buffer(ew_effect *effect, const ew_frame_desc *frame, unsigned *buffer, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    if (!buffer) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "buffer must not be NULL");
    ew_result result = ew_validate_frame(frame, error);
    if (result != EW_OK) return result;
    struct ew_frame_block block;
    result = ew_scene_pack(&effect->scene, frame, &block, error);
    if (result != EW_OK) return result;
    const ew_gl *gl = &effect->gl;
    GLuint bound = ew_gl_uniform_buffer(gl);
    upload(effect, &block);
    gl->BindBuffer(GL_UNIFORM_BUFFER, bound);
    *buffer = effect->uniform_buffer;
    return EW_OK;
}
