/* Luminance drawn against any depth: see field_drawer.h. */
#include "field_drawer.h"

bool field_drawer_create(gl_context *context, ew_effect *effect, int width, int height, field_drawer *drawer, char *message,
                         size_t size)
{
    render_settings settings = {.width = width, .height = height};
    *drawer = (field_drawer){.gl = context_gl(context), .width = width, .height = height, .effect = effect};
    return render_create_target(drawer->gl, &settings, &drawer->target, message, size);
}

void field_drawer_destroy(field_drawer *drawer)
{
    render_destroy_target(drawer->gl, &drawer->target);
}

bool field_drawer_draw(field_drawer *drawer, const ew_sources_desc *sources, const ew_frame_desc *frame, const float *depth,
                       float *output, ew_error *error)
{
    const gl_functions *gl = drawer->gl;
    ew_frame_desc own = *frame;
    own.framebuffer = drawer->target.luminance_framebuffer;
    own.depth_texture = drawer->target.depth;
    gl->BindTexture(GL_TEXTURE_2D, drawer->target.depth);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, drawer->width, drawer->height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                   depth);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    if (ew_set_sources(drawer->effect, sources, error) || ew_draw(drawer->effect, &own, error)) return false;
    gl->BindFramebuffer(GL_FRAMEBUFFER, drawer->target.luminance_framebuffer);
    gl->ReadPixels(0, 0, drawer->width, drawer->height, GL_RED, GL_FLOAT, output);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}
