/* A scene set up to be drawn by any integrator: see stage.h. */
#include "stage.h"
#include "message.h"
#include "opaque.h"

static bool draw_opaque(bench_stage *stage, const demo_scene *scene, char *message, size_t size)
{
    const gl_functions *gl = stage->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->target.opaque_framebuffer);
    bool ok = opaque_draw(gl, scene, stage->width, stage->height, message, size);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

static bool create_effect(bench_stage *stage, gl_context *context, const demo_scene *scene, char *message, size_t size)
{
    ew_error error;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    if (!ew_create_effect(&desc, &stage->effect, &error) && !ew_set_sources(stage->effect, &scene->sources, &error))
        return true;
    message_write(message, size, "%s", error.text);
    return false;
}

bool stage_create(gl_context *context, const demo_scene *scene, int width, int height, bench_stage *stage, char *message,
                  size_t size)
{
    const render_settings settings = {.width = width, .height = height};
    *stage = (struct bench_stage){.gl = context_gl(context), .width = width, .height = height};
    if (!render_create_target(stage->gl, &settings, &stage->target, message, size)) return false;
    stage->frame = render_frame(scene, &settings, &stage->target);
    stage->frame.framebuffer = stage->target.luminance_framebuffer;
    if (scene->opaque_count == 0) stage->frame.depth_texture = 0;
    if (draw_opaque(stage, scene, message, size) && create_effect(stage, context, scene, message, size) &&
        (stage->peers = peers_create(context, &scene->sources, &stage->frame, message, size)))
        return true;
    stage_destroy(stage);
    return false;
}

void stage_destroy(bench_stage *stage)
{
    peers_destroy(stage->peers);
    ew_destroy_effect(stage->effect);
    render_destroy_target(stage->gl, &stage->target);
}

bool stage_draw(bench_stage *stage, const bench_integrator *integrator, ew_output output, char *message, size_t size)
{
    if (!integrator_is_ours(integrator) && integrator->family != FAMILY_SIMPSON)
        return peers_draw(stage->peers, integrator, output == EW_OUTPUT_ADD ? EW_OUTPUT_LUMINANCE : output, message, size);
    ew_error error;
    ew_frame_desc frame = stage->frame;
    frame.output = output;
    frame.quality = integrator->quality;
    frame.resolution = integrator->family == FAMILY_ADAPTIVE ? EW_RESOLUTION_ADAPTIVE : EW_RESOLUTION_FULL;
    if (integrator->family == FAMILY_SIMPSON) {
        frame.integrator = EW_INTEGRATOR_SIMPSON;
        frame.simpson_divisions = integrator->samples;
    } else {
        frame.integrator = EW_INTEGRATOR_ADAPTIVE;
    }
    if (!ew_draw(stage->effect, &frame, &error)) return true;
    message_write(message, size, "%s: %s", integrator->name, error.text);
    return false;
}

static void read_framebuffer(const bench_stage *stage, GLuint framebuffer, GLenum format, float *pixels)
{
    const gl_functions *gl = stage->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->ReadPixels(0, 0, stage->width, stage->height, format, GL_FLOAT, pixels);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void stage_read(const bench_stage *stage, float *pixels)
{
    read_framebuffer(stage, stage->target.luminance_framebuffer, GL_RED, pixels);
}

bool stage_read_depth(const bench_stage *stage, float *depth)
{
    if (!stage->frame.depth_texture) return false;
    read_framebuffer(stage, stage->target.opaque_framebuffer, GL_DEPTH_COMPONENT, depth);
    return true;
}
