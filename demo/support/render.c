/* Renders a scene: see render.h. */
#include "render.h"
#include "camera.h"
#include "message.h"
#include "opaque.h"
#include "texture.h"

bool render_create_target(const gl_functions *gl, const render_settings *settings, render_target *target, char *message,
                          size_t size)
{
    GLint limit = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (settings->width > limit || settings->height > limit) {
        message_write(message, size, "--size: this GL draws pictures of %d x %d at most; ask for a smaller one", limit, limit);
        return false;
    }
    bool complete = true;
    target->color = texture_create(gl, settings->width, settings->height, GL_RGBA32F, GL_RGBA);
    target->depth = texture_create(gl, settings->width, settings->height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    target->luminance = texture_create(gl, settings->width, settings->height, GL_R32F, GL_RED);
    target->opaque_framebuffer = texture_framebuffer(gl, target->color, target->depth, &complete);
    target->effect_framebuffer = texture_framebuffer(gl, target->color, 0, &complete);
    target->luminance_framebuffer = texture_framebuffer(gl, target->luminance, 0, &complete);
    const GLenum error = gl->GetError();
    if (complete && error == GL_NO_ERROR) return true;
    render_destroy_target(gl, target);
    texture_write_refusal(error, settings->width, settings->height, message, size);
    return false;
}

void render_destroy_target(const gl_functions *gl, render_target *target)
{
    const GLuint framebuffers[] = {target->opaque_framebuffer, target->effect_framebuffer, target->luminance_framebuffer};
    const GLuint textures[] = {target->color, target->depth, target->luminance};
    gl->DeleteFramebuffers(3, framebuffers);
    gl->DeleteTextures(3, textures);
}

ew_frame_desc render_frame(const demo_scene *scene, const render_settings *settings, const render_target *target)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    camera_view(&scene->camera, frame.view);
    camera_projection(&scene->camera, (double)settings->width / settings->height, frame.projection);
    frame.interval_start = scene->interval_start;
    frame.interval_end = scene->interval_end;
    frame.decay_alpha = scene->decay_alpha;
    frame.decay_beta = scene->decay_beta;
    frame.core_pixels = scene->core_pixels;
    frame.exposure = scene->exposure;
    frame.light_gain = scene->light_gain;
    frame.light_reach = scene->light_reach;
    frame.shadow_thickness = scene->shadow_thickness;
    frame.fog = scene->fog;
    frame.media = scene->media;
    frame.medium_count = scene->medium_count;
    frame.integrator = settings->integrator;
    frame.quality = settings->quality;
    frame.simpson_divisions = settings->simpson_divisions;
    frame.resolution = settings->resolution;
    frame.output = scene->composite;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.framebuffer = target->effect_framebuffer;
    frame.viewport_width = settings->width;
    frame.viewport_height = settings->height;
    frame.depth_texture = target->depth;
    return frame;
}

ew_frame_desc render_light_frame(const demo_scene *scene, const render_settings *settings, const render_target *target)
{
    ew_frame_desc frame = render_frame(scene, settings, target);
    frame.output = EW_OUTPUT_SURFACES;
    return frame;
}

static bool draw_effect(const gl_functions *gl, ew_effect *effect, const demo_scene *scene, const render_settings *settings,
                        const render_target *target, float *color, float *luminance, ew_error *error)
{
    const pixel_rectangle whole = {0, 0, settings->width, settings->height};
    ew_frame_desc frame = render_frame(scene, settings, target);
    if (color) {
        const ew_frame_desc lit = render_light_frame(scene, settings, target);
        if (scene->light_reach > 0 && ew_draw(effect, &lit, error)) return false;
        if (ew_draw(effect, &frame, error)) return false;
        texture_read(gl, target->effect_framebuffer, whole, GL_RGBA, GL_FLOAT, color);
    }
    if (luminance) {
        texture_clear(gl, target->luminance_framebuffer);
        frame.framebuffer = target->luminance_framebuffer;
        frame.output = EW_OUTPUT_LUMINANCE;
        if (ew_draw(effect, &frame, error)) return false;
        texture_read(gl, target->luminance_framebuffer, whole, GL_RED, GL_FLOAT, luminance);
    }
    return true;
}

bool render_opaque(const gl_functions *gl, const demo_scene *scene, const render_settings *settings,
                   const render_target *target, char *message, size_t size)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->opaque_framebuffer);
    bool ok = opaque_draw(gl, scene, settings->width, settings->height, message, size);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

bool render_scene(gl_context *context, const demo_scene *scene, const render_settings *settings, float *color, float *luminance,
                  char *message, size_t size)
{
    const gl_functions *gl = context_gl(context);
    render_target target;
    if (!context_make_current(context)) {
        message_write(message, size, "--backend: the context is lost; try another backend");
        return false;
    }
    if (!render_create_target(gl, settings, &target, message, size)) return false;
    bool ok = render_opaque(gl, scene, settings, &target, message, size);
    if (ok) {
        ew_effect *effect = NULL;
        ew_error error;
        ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
        ok = !ew_create_effect(&desc, &effect, &error) && !ew_set_sources(effect, &scene->sources, &error) &&
             draw_effect(gl, effect, scene, settings, &target, color, luminance, &error);
        if (!ok) message_write(message, size, "%s", error.text);
        ew_destroy_effect(effect);
    }
    if (ok && gl->GetError() != GL_NO_ERROR) {
        message_write(message, size, "--backend: GL reported an error while drawing; try another backend");
        ok = false;
    }
    render_destroy_target(gl, &target);
    return ok;
}
