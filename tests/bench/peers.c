/* The integrators that are not the library's: see peers.h. */
#include "peers.h"
#include "message.h"
#include "peer_text.h"
#include "shader.h"

/* What the library keeps to itself: its shaders with another integrator in them, and how it fills their uniform block. */
#include "base/allocator.h"
#include "host/binding_points.h"
#include "host/execute.h"
#include "model/sources.h"
#include "plan/plan.h"

#include <stdlib.h>

struct bench_peers {
    gl_context *context;
    ew_device device;
    ew_sources sources;
    ew_plan plan;
    ew_frame_desc frame;
    GLuint vertex_array;
    ew_program programs[FAMILY_COUNT][2]; /* for luminance and for evaluations; name 0: not compiled yet */
};

/* ---- Shaders ------------------------------------------------------------------------------------------------------------ */

static const ew_integrator_text *text_of(integrator_family family)
{
    static const char *const marching_before[] = {peer_glsl_peer_noise_glsl, peer_glsl_peer_marching_glsl, NULL};
    static const char *const equiangular_before[] = {peer_glsl_peer_noise_glsl, peer_glsl_peer_equiangular_glsl, NULL};
    static const ew_integrator_text marching = {marching_before, peer_glsl_peer_sum_glsl, true};
    static const ew_integrator_text equiangular = {equiangular_before, peer_glsl_peer_sum_glsl, true};
    return family == FAMILY_EQUIANGULAR ? &equiangular : &marching;
}

static bool make_bare_program(const bench_peers *peers, ew_program *program, char *message, size_t size)
{
    program->name = shader_link(
        context_gl(peers->context),
        "#version 330 core\nvoid main() { gl_Position = vec4(2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) "
        "- 1.0, 0.0, 1.0); }\n",
        "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(0.5); }\n", "the bare pass's", message, size);
    return program->name != 0;
}

static bool make_peer_program(const bench_peers *peers, integrator_family family, ew_output output, ew_program *program,
                              char *message, size_t size)
{
    ew_frame_desc frame = peers->frame;
    frame.output = output;
    const ew_mix mix = ew_sources_mix(&peers->sources);
    unsigned key = ew_permutation_with_depth(ew_permutation_of(&mix, &frame),
                                             frame.depth_texture ? EW_DEPTH_KIND_SINGLE : EW_DEPTH_KIND_NONE);
    ew_error error;
    ew_result result = ew_program_start(&peers->device.gl, EW_PASS_WAVE, key, text_of(family), program, &error);
    if (result == EW_OK) result = ew_program_finish(&peers->device.gl, program, &error);
    if (result != EW_OK) message_write(message, size, "%s: %s", integrator_family_names[family], error.text);
    return result == EW_OK;
}

/* Returns the program of a family and an output, compiled if this is the first time; 0 with a message on failure. */
static GLuint get_program(bench_peers *peers, integrator_family family, ew_output output, char *message, size_t size)
{
    ew_program *program = &peers->programs[family][output == EW_OUTPUT_EVALUATIONS];
    if (program->name) return program->name;
    bool made = family == FAMILY_BARE ? make_bare_program(peers, program, message, size)
                                      : make_peer_program(peers, family, output, program, message, size);
    return made ? program->name : 0;
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

bench_peers *peers_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                          size_t size)
{
    bench_peers *made = calloc(1, sizeof *made);
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
    made->context = context;
    made->frame = *frame;
    made->device.gl.software = false; /* the peers read the uniform block as it is */
    made->device.gl.GenVertexArrays(1, &made->vertex_array);
    result = ew_sources_set(&made->sources, sources, &ew_default_allocator, &error);
    if (result == EW_OK) result = ew_plan_frame(&made->plan, &made->sources, NULL, frame, &error);
    if (result == EW_OK) return made;
    message_write(message, size, "%s", error.text);
    peers_destroy(made);
    return NULL;
}

void peers_destroy(bench_peers *peers)
{
    if (!peers) return;
    const ew_gl *gl = &peers->device.gl;
    for (int family = 0; family < FAMILY_COUNT; family++)
        for (int output = 0; output < 2; output++)
            gl->DeleteProgram(peers->programs[family][output].name);
    gl->DeleteVertexArrays(1, &peers->vertex_array);
    ew_device_destroy(&peers->device);
    ew_device_abandon(&peers->device, &ew_default_allocator);
    ew_sources_destroy(&peers->sources, &ew_default_allocator);
    free(peers);
}

bool peers_draw(bench_peers *peers, const bench_integrator *integrator, ew_output output, char *message, size_t size)
{
    const ew_gl *gl = &peers->device.gl;
    const ew_frame_desc *frame = &peers->frame;
    GLuint program = get_program(peers, integrator->family, output, message, size);
    if (!program) return false;

    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl->Viewport(frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    gl->BindTexture(GL_TEXTURE_2D, frame->depth_texture);
    peers->plan.uniforms.frame.simpson.x = integrator->samples;
    ew_error error;
    if (ew_upload(&peers->device, &peers->plan, &error) != EW_OK) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, peers->device.uniform_buffer);
    gl->UseProgram(program);
    gl->BindVertexArray(peers->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}
