/* A scene's luminance and depth: see picture.h. */
#include "picture.h"
#include "message.h"

#include <stdlib.h>

static bool draw_luminance(gl_context *context, const demo_scene *scene, const render_settings *settings,
                           const render_target *target, ew_error *error)
{
    const gl_functions *gl = context_gl(context);
    ew_effect *effect = NULL;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    ew_frame_desc frame = render_frame(scene, settings, target);
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.framebuffer = target->luminance_framebuffer;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->luminance_framebuffer);
    gl->ClearBufferfv(GL_COLOR, 0, (const float[4]){0, 0, 0, 0});
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    bool ok = !ew_create_effect(&desc, &effect, error) && !ew_set_sources(effect, &scene->sources, error) &&
              !ew_draw(effect, &frame, error);
    ew_destroy_effect(effect);
    return ok;
}

static void read_pixels(const gl_functions *gl, GLuint framebuffer, const render_settings *settings, GLenum format,
                        float *pixels)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->ReadPixels(0, 0, settings->width, settings->height, format, GL_FLOAT, pixels);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool picture_draw(gl_context *context, const demo_scene *scene, const render_settings *settings, drawn_picture *picture,
                  char *message, size_t size)
{
    const gl_functions *gl = context_gl(context);
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    *picture =
        (drawn_picture){settings->width, settings->height, malloc(pixels * sizeof(float)), malloc(pixels * sizeof(float))};
    render_target target;
    if (!picture->luminance || !picture->depth) {
        message_write(message, size, "--size: the picture does not fit into memory; ask for a smaller one");
    } else if (render_create_target(gl, settings, &target, message, size)) {
        ew_error error;
        bool ok = render_opaque(gl, scene, settings, &target, message, size);
        if (ok && !(ok = draw_luminance(context, scene, settings, &target, &error)))
            message_write(message, size, "%s", error.text);
        if (ok) {
            read_pixels(gl, target.luminance_framebuffer, settings, GL_RED, picture->luminance);
            read_pixels(gl, target.opaque_framebuffer, settings, GL_DEPTH_COMPONENT, picture->depth);
        }
        render_destroy_target(gl, &target);
        if (ok) return true;
    }
    picture_free(picture);
    return false;
}

void picture_free(drawn_picture *picture)
{
    free(picture->luminance);
    free(picture->depth);
    *picture = (drawn_picture){0};
}
