/* The integrators that are not the library's: see peers.h. */
#include "peers.h"
#include "message.h"
#include "peer_billboards.h"
#include "peer_half.h"
#include "peer_ribbon.h"
#include "peer_sampled.h"
#include "peer_text.h"
#include "shader.h"

#include <stdlib.h>

/* How many meshes are kept, so that integrators which take turns need not make them again. */
enum { MESHES = 8 };

typedef struct kept_mesh {
    integrator_family family;
    int samples;
    peer_mesh mesh;
} kept_mesh;

struct bench_peers {
    gl_context *context;
    const ew_sources_desc *sources;
    ew_frame_desc frame;
    peer_sampled *sampled;
    peer_half *half; /* NULL: not drawn yet */
    kept_mesh meshes[MESHES];
    int mesh_count;
    GLuint bare_program; /* 0: not drawn yet */
    GLuint vertex_array; /* without arrays */
};

bench_peers *peers_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                          size_t size)
{
    bench_peers *made = calloc(1, sizeof *made);
    if (!made) {
        message_write(message, size, "the peers do not fit into memory");
        return NULL;
    }
    *made = (bench_peers){.context = context, .sources = sources, .frame = *frame};
    context_gl(context)->GenVertexArrays(1, &made->vertex_array);
    made->sampled = peer_sampled_create(context, sources, frame, message, size);
    if (made->sampled) return made;
    peers_destroy(made);
    return NULL;
}

void peers_destroy(bench_peers *peers)
{
    if (!peers) return;
    const gl_functions *gl = context_gl(peers->context);
    peer_sampled_destroy(peers->sampled);
    peer_half_destroy(peers->half);
    for (int i = 0; i < peers->mesh_count; i++)
        peer_mesh_destroy(gl, &peers->meshes[i].mesh);
    gl->DeleteProgram(peers->bare_program);
    gl->DeleteVertexArrays(1, &peers->vertex_array);
    free(peers);
}

static bool draw_bare(bench_peers *peers, char *message, size_t size)
{
    const gl_functions *gl = context_gl(peers->context);
    const ew_frame_desc *frame = &peers->frame;
    if (!peers->bare_program) {
        const char *fragment = "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(0.5); }\n";
        peers->bare_program = shader_link(gl, peer_glsl_peer_quad_glsl, fragment, "the bare pass's", message, size);
    }
    if (!peers->bare_program) return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl->Viewport(frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height);
    gl->UseProgram(peers->bare_program);
    gl->BindVertexArray(peers->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}

static bool draw_half(bench_peers *peers, int samples, char *message, size_t size)
{
    if (!peers->half) peers->half = peer_half_create(peers->context, peers->sources, &peers->frame, message, size);
    return peers->half && peer_half_draw(peers->half, samples, message, size);
}

static const peer_mesh *get_mesh(bench_peers *peers, const bench_integrator *integrator, char *message, size_t size)
{
    for (int i = 0; i < peers->mesh_count; i++)
        if (peers->meshes[i].family == integrator->family && peers->meshes[i].samples == integrator->samples)
            return &peers->meshes[i].mesh;
    if (peers->mesh_count == MESHES) {
        message_write(message, size, "--integrators: %d of billboards and ribbon are too many; name fewer", MESHES + 1);
        return NULL;
    }
    kept_mesh *kept = &peers->meshes[peers->mesh_count];
    *kept = (kept_mesh){.family = integrator->family, .samples = integrator->samples};
    const mesh_style *style = integrator->family == FAMILY_RIBBON ? &peer_ribbon_style : &peer_billboards_style;
    bool made =
        peer_mesh_create(peers->context, peers->sources, &peers->frame, style, kept->samples, &kept->mesh, message, size);
    if (!made) return NULL;
    peers->mesh_count++;
    return &kept->mesh;
}

static bool draw_mesh(bench_peers *peers, const bench_integrator *integrator, char *message, size_t size)
{
    const peer_mesh *mesh = get_mesh(peers, integrator, message, size);
    if (mesh) peer_mesh_draw(context_gl(peers->context), mesh, &peers->frame);
    return mesh != NULL;
}

bool peers_draw(bench_peers *peers, const bench_integrator *integrator, ew_output output, char *message, size_t size)
{
    switch (integrator->family) {
    case FAMILY_BARE:
        return draw_bare(peers, message, size);
    case FAMILY_HALF_MARCHING:
        return draw_half(peers, integrator->samples, message, size);
    case FAMILY_BILLBOARDS:
    case FAMILY_RIBBON:
        return draw_mesh(peers, integrator, message, size);
    default:
        return peer_sampled_draw(peers->sampled, integrator->family, integrator->samples, output, message, size);
    }
}
