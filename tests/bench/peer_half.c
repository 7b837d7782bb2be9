/* Marching at half the resolution: see peer_half.h. */
#include "peer_half.h"
#include "message.h"
#include "peer_sampled.h"
#include "peer_text.h"
#include "shader.h"
#include "texture.h"

#include <stdlib.h>

struct peer_half {
    const gl_functions *gl;
    ew_frame_desc frame;
    int width; /* of half the resolution */
    int height;
    GLuint depth; /* 0 where nothing is opaque */
    GLuint light;
    GLuint depth_framebuffer;
    GLuint light_framebuffer;
    GLuint depth_program;
    GLuint upsample_program;
    GLuint vertex_array;
    peer_sampled *sampled;
};

/* The frame at half the resolution: the same rays, two by two as one, and the same cores. */
static ew_frame_desc half_frame(const peer_half *peer)
{
    ew_frame_desc frame = peer->frame;
    const double shares[2] = {frame.viewport_width / (2.0 * peer->width), frame.viewport_height / (2.0 * peer->height)};
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 2; row++) {
            double *element = &frame.projection[4 * column + row];
            *element = shares[row] * *element + (shares[row] - 1) * frame.projection[4 * column + 3];
        }
    frame.viewport_x = frame.viewport_y = 0;
    frame.viewport_width = peer->width;
    frame.viewport_height = peer->height;
    frame.framebuffer = peer->light_framebuffer;
    frame.depth_texture = peer->depth;
    frame.core_pixels *= 0.5;
    return frame;
}

static bool create_targets(peer_half *peer)
{
    const gl_functions *gl = peer->gl;
    bool complete = true;
    peer->light = texture_create(gl, peer->width, peer->height, GL_R32F, GL_RED);
    peer->light_framebuffer = texture_framebuffer(gl, peer->light, 0, &complete);
    if (peer->frame.depth_texture) {
        peer->depth = texture_create(gl, peer->width, peer->height, GL_R32F, GL_RED);
        peer->depth_framebuffer = texture_framebuffer(gl, peer->depth, 0, &complete);
    }
    return complete;
}

static void set_uniforms(const peer_half *peer)
{
    const gl_functions *gl = peer->gl;
    const double *p = peer->frame.projection;
    const float projection[4] = {(float)p[10], (float)p[14], (float)p[11], (float)p[15]};
    GLuint program = peer->upsample_program;
    gl->UseProgram(program);
    gl->Uniform1i(gl->GetUniformLocation(program, "light"), 0);
    gl->Uniform1i(gl->GetUniformLocation(program, "half_depth"), 1);
    gl->Uniform1i(gl->GetUniformLocation(program, "depth"), 2);
    gl->Uniform1i(gl->GetUniformLocation(program, "has_depth"), peer->depth != 0);
    gl->Uniform4fv(gl->GetUniformLocation(program, "projection"), 1, projection);
    gl->UseProgram(peer->depth_program);
    gl->Uniform1i(gl->GetUniformLocation(peer->depth_program, "depth"), 2);
    gl->UseProgram(0);
}

peer_half *peer_half_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, char *message,
                            size_t size)
{
    peer_half *made = calloc(1, sizeof *made);
    if (!made) {
        message_write(message, size, "half-marching does not fit into memory");
        return NULL;
    }
    *made = (peer_half){.gl = context_gl(context),
                        .frame = *frame,
                        .width = (frame->viewport_width + 1) / 2,
                        .height = (frame->viewport_height + 1) / 2};
    made->gl->GenVertexArrays(1, &made->vertex_array);
    const char *vertex = peer_glsl_peer_quad_glsl;
    bool ok = create_targets(made);
    if (!ok) message_write(message, size, "half-marching: GL cannot make a float target");
    ok = ok &&
         (made->depth_program =
              shader_link(made->gl, vertex, peer_glsl_peer_half_depth_glsl, "half-marching's depth", message, size)) &&
         (made->upsample_program =
              shader_link(made->gl, vertex, peer_glsl_peer_half_upsample_glsl, "half-marching's upsampling", message, size));
    if (ok) {
        const ew_frame_desc half = half_frame(made);
        set_uniforms(made);
        made->sampled = peer_sampled_create(context, sources, &half, message, size);
    }
    if (made->sampled) return made;
    peer_half_destroy(made);
    return NULL;
}

void peer_half_destroy(peer_half *peer)
{
    if (!peer) return;
    const gl_functions *gl = peer->gl;
    const GLuint textures[] = {peer->depth, peer->light};
    const GLuint framebuffers[] = {peer->depth_framebuffer, peer->light_framebuffer};
    peer_sampled_destroy(peer->sampled);
    gl->DeleteTextures(2, textures);
    gl->DeleteFramebuffers(2, framebuffers);
    gl->DeleteProgram(peer->depth_program);
    gl->DeleteProgram(peer->upsample_program);
    gl->DeleteVertexArrays(1, &peer->vertex_array);
    free(peer);
}

static void draw_quad(const peer_half *peer, GLuint framebuffer, GLuint program, int x, int y, int width, int height)
{
    const gl_functions *gl = peer->gl;
    const GLuint textures[] = {peer->light, peer->depth, peer->frame.depth_texture};
    for (int unit = 0; unit < 3; unit++) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        gl->BindTexture(GL_TEXTURE_2D, program == peer->depth_program && unit < 2 ? 0 : textures[unit]);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->Viewport(x, y, width, height);
    gl->UseProgram(program);
    gl->BindVertexArray(peer->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    for (int unit = 2; unit >= 0; unit--) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        gl->BindTexture(GL_TEXTURE_2D, 0);
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool peer_half_draw(peer_half *peer, int samples, char *message, size_t size)
{
    const ew_frame_desc *frame = &peer->frame;
    if (peer->depth) draw_quad(peer, peer->depth_framebuffer, peer->depth_program, 0, 0, peer->width, peer->height);
    if (!peer_sampled_draw(peer->sampled, FAMILY_MARCHING, samples, EW_OUTPUT_LUMINANCE, message, size)) return false;
    draw_quad(peer, frame->framebuffer, peer->upsample_program, frame->viewport_x, frame->viewport_y, frame->viewport_width,
              frame->viewport_height);
    return true;
}
