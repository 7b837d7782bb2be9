/* The effect: sources, shader permutations and GL objects together. */
#include "energywave.h"

#include "error.h"
#include "gl.h"
#include "program.h"
#include "scene.h"
#include "state_guard.h"

#include <stdlib.h>

struct ew_effect {
    ew_gl gl;
    ew_capacity capacity;
    ew_scene scene;
    ew_program_cache programs;
    GLuint vertex_array;
    GLuint sampler; /* reads depth as it is, whatever the texture's own parameters say */
    GLuint buffers[EW_BINDING_COUNT];
};

static void create_objects(ew_effect *effect)
{
    const ew_gl *gl = &effect->gl;
    gl->GenVertexArrays(1, &effect->vertex_array);
    gl->GenBuffers(EW_BINDING_COUNT, effect->buffers);
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

    ew_effect *made = calloc(1, sizeof *made);
    if (!made) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for an effect of %zu bytes", sizeof *made);
    ew_result result = ew_gl_load(&made->gl, desc->get_proc_address, desc->user, error);
    if (result != EW_OK) {
        free(made);
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
    ew_program_cache_destroy(&effect->programs, gl);
    gl->DeleteSamplers(1, &effect->sampler);
    gl->DeleteBuffers(EW_BINDING_COUNT, effect->buffers);
    gl->DeleteVertexArrays(1, &effect->vertex_array);
    ew_scene_destroy(&effect->scene);
    free(effect);
}

ew_result ew_set_sources(ew_effect *effect, const ew_sources_desc *sources, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    ew_scene scene;
    ew_result result = ew_scene_create(sources, &effect->capacity, &scene, error);
    if (result != EW_OK) return result;
    ew_scene_destroy(&effect->scene);
    effect->scene = scene;
    return EW_OK;
}

/* Writes `used` bytes to the start of a block of `size` bytes. The storage is orphaned first: the GPU may still be reading what
 * the last frame left there, and waiting for it would stall. */
static void upload(const ew_effect *effect, GLuint binding, size_t size, const void *data, size_t used)
{
    const ew_gl *gl = &effect->gl;
    if (used == 0) return;
    gl->BindBuffer(GL_UNIFORM_BUFFER, effect->buffers[binding]);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, NULL, GL_STREAM_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)used, data);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, binding, effect->buffers[binding]);
}

static void upload_all(const ew_effect *effect, const struct ew_frame_block *frame)
{
    const ew_scene *scene = &effect->scene;
    const ew_sources_desc *sources = &scene->sources;
    const ew_capacity *capacity = &effect->capacity;
    upload(effect, EW_FRAME_BINDING, sizeof *frame, frame, sizeof *frame);
    upload(effect, EW_POINT_BINDING, capacity->points * sizeof *scene->points, scene->points,
           sources->point_count * sizeof *scene->points);
    upload(effect, EW_LINE_BINDING, capacity->lines * sizeof *scene->lines, scene->lines,
           sources->line_count * sizeof *scene->lines);
    upload(effect, EW_TORUS_BINDING, capacity->tori * sizeof *scene->tori, scene->tori,
           sources->torus_count * sizeof *scene->tori);
    upload(effect, EW_CURVE_BINDING, capacity->curves * sizeof *scene->curves, scene->curves,
           sources->curve_count * sizeof *scene->curves);
    upload(effect, EW_WEIGHT_BINDING, capacity->weight_pieces * sizeof *scene->weight_pieces, scene->weight_pieces,
           scene->weight_piece_count * sizeof *scene->weight_pieces);
}

static ew_gl_draw_state draw_state(const ew_frame_desc *frame)
{
    ew_gl_draw_state state = {
        .framebuffer = frame->framebuffer,
        .viewport = {frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height},
        .blend = frame->output == EW_OUTPUT_LERP || frame->output == EW_OUTPUT_ADD,
        .source_rgb = GL_ONE,
    };
    /* The shader's alpha is min(1, B). */
    bool lerp = frame->output == EW_OUTPUT_LERP;
    state.destination_rgb = state.destination_alpha = lerp ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE;
    state.source_alpha = lerp ? GL_ONE : GL_ZERO;
    return state;
}

static ew_result draw(ew_effect *effect, const ew_frame_desc *frame, const struct ew_frame_block *block, ew_gl_state *state,
                      ew_error *error)
{
    const ew_gl *gl = &effect->gl;
    GLuint program;
    ew_result result =
        ew_program_get(&effect->programs, gl, &effect->capacity, ew_program_key(&effect->scene, frame), &program, error);
    if (result != EW_OK) return result;

    ew_gl_draw_state wanted = draw_state(frame);
    ew_gl_set_draw_state(gl, state, &wanted);
    if (gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return ew_fail(error, EW_ERROR_OPENGL, "framebuffer %u is not complete", frame->framebuffer);

    upload_all(effect, block);
    if (frame->depth_texture) {
        gl->ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
        gl->BindTexture(GL_TEXTURE_2D, frame->depth_texture);
        gl->BindSampler(EW_GL_DEPTH_TEXTURE_UNIT, effect->sampler);
    }
    gl->UseProgram(program);
    gl->BindVertexArray(effect->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    return EW_OK;
}

ew_result ew_draw(ew_effect *effect, const ew_frame_desc *frame, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    ew_result result = ew_validate_frame(frame, error);
    if (result != EW_OK) return result;
    const ew_gl *gl = &effect->gl;
    if (frame->framebuffer && !gl->IsFramebuffer(frame->framebuffer))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "framebuffer %u is none of this context's", frame->framebuffer);
    if (frame->depth_texture && !gl->IsTexture(frame->depth_texture))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is no texture", frame->depth_texture);

    struct ew_frame_block block;
    result = ew_scene_pack(&effect->scene, frame, &block, error);
    if (result != EW_OK) return result;
    ew_gl_state state;
    result = ew_gl_save_state(gl, &state, error);
    if (result != EW_OK) return result;
    result = draw(effect, frame, &block, &state, error);
    ew_gl_restore_state(gl, &state);
    return result;
}
