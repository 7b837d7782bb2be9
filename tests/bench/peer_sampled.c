/* Peers that sample: see peer_sampled.h. */
#include "peer_sampled.h"
#include "message.h"
#include "peer_text.h"

/* What the library keeps to itself: its shaders with another integrator in them, and how it fills their uniform block. */
#include "base/allocator.h"
#include "host/binding_points.h"
#include "host/execute.h"
#include "model/sources.h"
#include "plan/plan.h"

#include <stdlib.h>

struct peer_sampled {
    ew_device device;
    ew_sources sources;
    ew_tile_lists lists;
    ew_plan plan;
    ew_frame_desc frame;
    GLuint vertex_array;
    ew_program programs[FAMILY_COUNT][2]; /* for luminance and for evaluations; name 0: not compiled yet */
};

static const ew_integrator_text *text_of(integrator_family family)
{
    static const char *const marching_before[] = {peer_glsl_peer_noise_glsl, peer_glsl_peer_marching_glsl, NULL};
    static const char *const equiangular_before[] = {peer_glsl_peer_noise_glsl, peer_glsl_peer_equiangular_glsl, NULL};
    static const ew_integrator_text marching = {marching_before, peer_glsl_peer_sum_glsl, true};
    static const ew_integrator_text equiangular = {equiangular_before, peer_glsl_peer_sum_glsl, true};
    return family == FAMILY_EQUIANGULAR ? &equiangular : &marching;
}

/* The shader's key: with lists of the sources by tile, if the library has them for these. */
static ew_key key_of(const peer_sampled *peer, ew_output output)
{
    ew_frame_desc frame = peer->frame;
    frame.output = output;
    const ew_mix mix = ew_sources_mix(&peer->sources);
    ew_key key = ew_permutation_with_depth(ew_permutation_of(&mix, &frame),
                                           frame.depth_texture ? EW_DEPTH_KIND_SINGLE : EW_DEPTH_KIND_NONE);
    return peer->plan.lists ? ew_permutation_with_lists(key) : key;
}

/* Returns the program of a family and an output, compiled if this is the first time; 0 with a message on failure. */
static GLuint get_program(peer_sampled *peer, integrator_family family, ew_output output, char *message, size_t size)
{
    ew_program *program = &peer->programs[family][output == EW_OUTPUT_EVALUATIONS];
    if (program->name) return program->name;
    ew_error error;
    ew_result result = ew_program_start(&peer->device.gl, EW_PASS_WAVE, key_of(peer, output), text_of(family), program, &error);
    if (result == EW_OK) result = ew_program_finish(&peer->device.gl, program, &error);
    if (result == EW_OK) return program->name;
    message_write(message, size, "%s: %s", integrator_family_names[family], error.text);
    return 0;
}

/* What ew_execute does for the library's own integrators. */
static void upload_lists(const peer_sampled *peer)
{
    const ew_gl *gl = &peer->device.gl;
    const ew_tile_lists *lists = &peer->lists;
    gl->BindBuffer(GL_UNIFORM_BUFFER, peer->device.list_buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)(ew_gl_dialect(gl).list_size * sizeof(ew_vec4)), NULL, GL_STATIC_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)(lists->word_count * sizeof *lists->words), lists->words);
    gl->BindBuffer(GL_UNIFORM_BUFFER, 0);
}

peer_sampled *peer_sampled_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame,
                                  char *message, size_t size)
{
    peer_sampled *made = calloc(1, sizeof *made);
    if (!made) {
        message_write(message, size, "the peers do not fit into memory");
        return NULL;
    }
    ew_error error;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    ew_result result = ew_device_create(&made->device, &desc, &error);
    if (result != EW_OK) {
        message_write(message, size, "%s", error.text);
        free(made);
        return NULL;
    }
    made->frame = *frame;
    made->device.gl.software = false; /* the peers read the uniform block as it is */
    made->device.gl.GenVertexArrays(1, &made->vertex_array);
    result = ew_sources_set(&made->sources, sources, &ew_default_allocator, &error);
    if (result == EW_OK) result = ew_plan_frame(&made->plan, &made->sources, NULL, frame, &error);
    const ew_list_room room = ew_list_room_of_block(ew_gl_dialect(&made->device.gl).list_size);
    if (result == EW_OK)
        result = ew_plan_lists(&made->plan, &made->lists, &made->sources, frame, room, &ew_default_allocator, &error);
    if (result == EW_OK && made->plan.lists) upload_lists(made);
    if (result == EW_OK) return made;
    message_write(message, size, "%s", error.text);
    peer_sampled_destroy(made);
    return NULL;
}

void peer_sampled_destroy(peer_sampled *peer)
{
    if (!peer) return;
    const ew_gl *gl = &peer->device.gl;
    for (int family = 0; family < FAMILY_COUNT; family++)
        for (int output = 0; output < 2; output++)
            gl->DeleteProgram(peer->programs[family][output].name);
    gl->DeleteVertexArrays(1, &peer->vertex_array);
    ew_device_destroy(&peer->device);
    ew_device_abandon(&peer->device, &ew_default_allocator);
    ew_destroy_tile_lists(&peer->lists, &ew_default_allocator);
    ew_sources_destroy(&peer->sources, &ew_default_allocator);
    free(peer);
}

bool peer_sampled_draw(peer_sampled *peer, integrator_family family, int samples, ew_output output, char *message, size_t size)
{
    const ew_gl *gl = &peer->device.gl;
    const ew_frame_desc *frame = &peer->frame;
    GLuint program = get_program(peer, family, output, message, size);
    if (!program) return false;

    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl->Viewport(frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    gl->BindTexture(GL_TEXTURE_2D, frame->depth_texture);
    peer->plan.uniforms.frame.choices.x = samples;
    ew_error error;
    if (ew_upload(&peer->device, &peer->plan, &error) != EW_OK) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, peer->device.uniform_buffer);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_LIST_BINDING, peer->device.list_buffer);
    gl->UseProgram(program);
    gl->BindVertexArray(peer->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}
