#include <EGL/egl.h>
#include <energywave.h>
#include <string.h>

static ew_effect *effect;

static ew_gl_function get_proc_address(void *, const char *name)
{
    return eglGetProcAddress(name); // or glfwGetProcAddress, SDL_GL_GetProcAddress, ...
}

ew_result create_glow(ew_error *error) // once, with the game's context current
{
    // Lengths are in the game's own unit; here it is the metre.
    const double ends[][3] = {{-2, 1.2, 0}, {3, 1.2, 0}}, blue[3] = {0.1, 0.4, 1};
    ew_point orb = {};
    memcpy(orb.position, ends[0], sizeof orb.position);
    memcpy(orb.color, blue, sizeof orb.color);
    orb.core = 0.15;
    orb.reach = 1.2;
    orb.brightness = 3;
    orb.sharpness = 2;
    ew_path beam = {};
    memcpy(beam.color, blue, sizeof beam.color);
    beam.points = ends;
    beam.point_count = 2;
    beam.core = 0.03;
    beam.reach = 0.6;
    beam.brightness = 3;
    beam.sharpness = 2;
    ew_sources_desc sources = {};
    sources.points = &orb;
    sources.point_count = 1;
    sources.paths = &beam;
    sources.path_count = 1;
    ew_effect_desc desc = {};
    desc.get_proc_address = get_proc_address;
    ew_result result = ew_create_effect(&desc, &effect, error);
    return result == EW_OK ? ew_set_sources(effect, &sources, error) : result;
}

ew_result draw_glow(const double view[16], const double projection[16], unsigned framebuffer, unsigned depth_texture, int width,
                    int height, ew_error *error) /* every frame, after the opaque scene */
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    memcpy(frame.view, view, sizeof frame.view);
    memcpy(frame.projection, projection, sizeof frame.projection);
    frame.framebuffer = framebuffer;
    frame.viewport_width = width;
    frame.viewport_height = height;
    frame.encoding = EW_ENCODING_SRGB_8BIT; /* or what else the framebuffer's format is */
    frame.output = EW_OUTPUT_SOFT;          /* glow that never clips */
    frame.depth_texture = depth_texture;
    return ew_draw(effect, &frame, error);
}
