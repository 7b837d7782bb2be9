#include <EGL/egl.h>
#include <energywave.h>
#include <string.h>

static ew_effect *effect;

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return eglGetProcAddress(name); /* or glfwGetProcAddress, SDL_GL_GetProcAddress, ... */
}

ew_result create_glow(ew_error *error) /* once, with the game's context current */
{
    ew_point orb = {.position = {0, 1, 0}, .coefficient = 0.5, .color = {0.2, 0.5, 1}};
    ew_sources_desc sources = {.points = &orb, .point_count = 1, .epsilon = 0.001};
    ew_result result = ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, error);
    return result == EW_OK ? ew_set_sources(effect, &sources, error) : result;
}

ew_result draw_glow(const double view[16], const double projection[16], unsigned framebuffer, unsigned depth_texture, int width,
                    int height, ew_error *error) /* every frame, after the opaque scene */
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    memcpy(frame.view, view, sizeof frame.view);
    memcpy(frame.projection, projection, sizeof frame.projection);
    frame.interval_start = 2; /* the glow lies between these two depths */
    frame.interval_end = 20;
    frame.framebuffer = framebuffer;
    frame.depth_texture = depth_texture;
    frame.viewport_width = width;
    frame.viewport_height = height;
    return ew_draw(effect, &frame, error);
}
