/* What the floor reflects: see reflection.h. */
#include "reflection.h"
#include "texture.h"

static void make_targets(const gl_functions *gl, floor_reflection *reflection, int width, int height)
{
    if (reflection->width == width && reflection->height == height) return;
    reflection_destroy(gl, reflection);
    bool complete = true;
    reflection->color = texture_create(gl, width, height, GL_RGBA16F, GL_RGBA);
    reflection->depth = texture_create(gl, width, height, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    gl->BindTexture(GL_TEXTURE_2D, reflection->color);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    reflection->effect_framebuffer = texture_framebuffer(gl, reflection->color, 0, &complete);
    reflection->width = width;
    reflection->height = height;
}

ew_result reflection_draw(const gl_functions *gl, floor_reflection *reflection, ew_effect *effect, lit_opaque *lit,
                          const demo_scene *scene, const render_settings *settings, ew_error *error)
{
    render_settings half = *settings;
    half.width = (settings->width + 1) / 2;
    half.height = (settings->height + 1) / 2;
    make_targets(gl, reflection, half.width, half.height);
    const lit_opaque_view view = {.scene = scene,
                                  .settings = &half,
                                  .is_mirrored = true,
                                  .depth = reflection->depth,
                                  .framebuffer = reflection->effect_framebuffer};
    ew_result result = lit_opaque_draw(lit, &view, effect, error);
    if (result) return result;

    render_target target = {.depth = reflection->depth, .effect_framebuffer = reflection->effect_framebuffer};
    ew_frame_desc frame = render_frame(scene, &half, &target);
    lit_opaque_mirror(frame.view);
    frame.fog.extinction *= 1e-9; /* the floor's fog hides what it mirrors; with some fog left, the picture's shader serves */
    return ew_draw(effect, &frame, error);
}

void reflection_destroy(const gl_functions *gl, floor_reflection *reflection)
{
    const GLuint textures[] = {reflection->color, reflection->depth};
    gl->DeleteFramebuffers(1, &reflection->effect_framebuffer);
    gl->DeleteTextures(2, textures);
    *reflection = (floor_reflection){0};
}
