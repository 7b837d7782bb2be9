/* A scene as it is displayed: see display.h. */
#include "display.h"
#include "gpu_timer.h"
#include "lit_opaque.h"
#include "map.h"
#include "message.h"
#include "opaque.h"
#include "reflection.h"
#include "resolve.h"
#include "texture.h"

#include <stdlib.h>

struct demo_display {
    const gl_functions *gl;
    ew_effect *effect;
    lit_opaque *court;
    floor_reflection reflection;
    resolve_pass resolve;

    int width; /* of the picture; 0 while there are no targets */
    int height;
    int samples_per_axis;
    GLuint color, depth, measured, picture;
    GLuint opaque_framebuffer; /* colour and depth */
    GLuint effect_framebuffer; /* colour */
    GLuint measured_framebuffer, picture_framebuffer;

    gpu_timer timers[2];
    display_statistics statistics[2];
};

static void delete_targets(demo_display *display)
{
    const GLuint textures[] = {display->color, display->depth, display->measured, display->picture};
    const GLuint framebuffers[] = {display->opaque_framebuffer, display->effect_framebuffer, display->measured_framebuffer,
                                   display->picture_framebuffer};
    display->gl->DeleteFramebuffers(4, framebuffers);
    display->gl->DeleteTextures(4, textures);
    display->width = 0;
}

static bool make_targets(demo_display *display, const display_view *view, char *message, size_t size)
{
    const gl_functions *gl = display->gl;
    int width = view->settings.width, height = view->settings.height, samples = view->samples_per_axis;
    if (display->width == width && display->height == height && display->samples_per_axis == samples) return true;
    if (display->width) delete_targets(display);
    GLint limit = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width * samples > limit || height * samples > limit) {
        message_write(message, size, "--size: this GL draws pictures of %d x %d at most; ask for a smaller one",
                      limit / samples, limit / samples);
        return false;
    }
    bool complete = true;
    display->color = texture_create(gl, width * samples, height * samples, GL_RGBA16F, GL_RGBA);
    display->depth = texture_create(gl, width * samples, height * samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    display->measured = texture_create(gl, width * samples, height * samples, GL_R32F, GL_RED);
    display->picture = texture_create(gl, width, height, GL_RGBA8, GL_RGBA);
    display->opaque_framebuffer = texture_framebuffer(gl, display->color, display->depth, &complete);
    display->effect_framebuffer = texture_framebuffer(gl, display->color, 0, &complete);
    display->measured_framebuffer = texture_framebuffer(gl, display->measured, 0, &complete);
    display->picture_framebuffer = texture_framebuffer(gl, display->picture, 0, &complete);
    display->width = width;
    display->height = height;
    display->samples_per_axis = samples;
    const GLenum error = gl->GetError();
    if (complete && error == GL_NO_ERROR) return true;
    delete_targets(display);
    texture_write_refusal(error, width * samples, height * samples, message, size);
    return false;
}

demo_display *display_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size)
{
    demo_display *display = calloc(1, sizeof *display);
    ew_error error = {.text = "memory is exhausted"};
    if (!display || ew_create_effect(desc, &display->effect, &error)) {
        message_write(message, size, "%s", error.text);
        free(display);
        return NULL;
    }
    display->gl = gl;
    for (int half = 0; half < 2; half++)
        gpu_timer_create(gl, &display->timers[half]);
    if (resolve_create(gl, &display->resolve, message, size)) return display;
    display_destroy(display);
    return NULL;
}

/* The settings of a picture of samples. */
static render_settings sample_settings(const display_view *view)
{
    render_settings settings = view->settings;
    settings.width *= view->samples_per_axis;
    settings.height *= view->samples_per_axis;
    return settings;
}

static lit_opaque_view court_view(const demo_display *display, const display_view *view, const render_settings *settings)
{
    return (lit_opaque_view){.scene = view->scene,
                             .settings = settings,
                             .reflection = display->reflection.color,
                             .depth = display->depth,
                             .framebuffer = display->effect_framebuffer};
}

/* Draws the court, and what its floor reflects. */
static ew_result draw_court(demo_display *display, const display_view *view, ew_error *error)
{
    const render_settings settings = sample_settings(view);
    ew_result result =
        reflection_draw(display->gl, &display->reflection, display->effect, display->court, view->scene, &settings, error);
    if (result) return result;
    const lit_opaque_view lit = court_view(display, view, &settings);
    return lit_opaque_draw(display->court, &lit, display->effect, error);
}

/* Reduces a frame to the columns from `first` to before `end`, by stretching their part of the NDC square over all of it. */
static void crop(ew_frame_desc *frame, int first, int end)
{
    double left = 2.0 * first / frame->viewport_width - 1, right = 2.0 * end / frame->viewport_width - 1;
    for (int column = 0; column < 4; column++) {
        double *x = &frame->projection[4 * column], w = frame->projection[4 * column + 3];
        *x = (2 * *x - (right + left) * w) / (right - left);
    }
    frame->viewport_x += first;
    frame->viewport_width = end - first;
}

/* The columns of one half of the picture, in samples. A picture one pixel wide is not split: either half is all of it. */
static void columns_of(const display_view *view, int half, int *first, int *end)
{
    int middle = view->settings.width / 2 * view->samples_per_axis, width = view->settings.width * view->samples_per_axis;
    bool is_split = view->split && middle > 0;
    *first = is_split && half ? middle : 0;
    *end = is_split && !half ? middle : width;
}

/* The frame that draws one half of the picture by its own integrator. */
static ew_frame_desc half_frame(const demo_display *display, const display_view *view, int half, GLuint framebuffer)
{
    render_target target = {.depth = display->depth, .effect_framebuffer = framebuffer};
    render_settings settings = half ? view->right : view->settings;
    settings.width = view->settings.width * view->samples_per_axis;
    settings.height = view->settings.height * view->samples_per_axis;
    ew_frame_desc frame = render_frame(view->scene, &settings, &target);
    int first, end;
    columns_of(view, half, &first, &end);
    crop(&frame, first, end);
    return frame;
}

static ew_result draw_energy(demo_display *display, const display_view *view, ew_error *error)
{
    const gl_functions *gl = display->gl;
    ew_result result = EW_OK;
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(display, view, half, display->effect_framebuffer);
        gpu_timer_begin(gl, &display->timers[half]);
        result = ew_draw(display->effect, &frame, error);
        gpu_timer_end(gl, &display->timers[half]);
    }
    return result;
}

static ew_result draw_maps(demo_display *display, const display_view *view, ew_error *error)
{
    ew_result result = EW_OK;
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(display, view, half, display->measured_framebuffer);
        result = map_draw(display->gl, display->effect, &frame, view->mode == DISPLAY_ERROR, display->picture,
                          &display->statistics[half].map, error);
    }
    return result;
}

static ew_result count_evaluations(demo_display *display, const display_view *view, ew_error *error)
{
    ew_result result = EW_OK;
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(display, view, half, display->measured_framebuffer);
        double *mean = &display->statistics[half].map.mean_evaluations;
        result = map_count_evaluations(display->gl, display->effect, &frame, mean, error);
        if (!result) *mean *= view->samples_per_axis * view->samples_per_axis;
    }
    return result;
}

/* The frame that has the energy light the opaque scene. */
static ew_frame_desc light_frame(demo_display *display, const display_view *view)
{
    const render_settings settings = sample_settings(view);
    if (view->court_look) {
        const lit_opaque_view lit = court_view(display, view, &settings);
        return lit_opaque_frame(display->court, &lit);
    }
    const render_target target = {.depth = display->depth, .effect_framebuffer = display->effect_framebuffer};
    return render_light_frame(view->scene, &settings, &target);
}

/* Lights the opaque shapes of a scene file, if it says so. */
static ew_result light_file_opaque(demo_display *display, const display_view *view, ew_error *error)
{
    const ew_frame_desc frame = light_frame(display, view);
    return view->scene->light_reach > 0 ? ew_draw(display->effect, &frame, error) : EW_OK;
}

/* The opaque scene comes first, because everything else needs its depth. */
static ew_result draw_all(demo_display *display, const display_view *view, ew_error *error)
{
    ew_result result = view->court_look ? draw_court(display, view, error) : light_file_opaque(display, view, error);
    if (result) return result;
    if (view->mode != DISPLAY_PICTURE) return draw_maps(display, view, error);
    result = draw_energy(display, view, error);
    if (!result && view->count_evaluations) result = count_evaluations(display, view, error);
    resolve_input input = {.color = display->color, .samples_per_axis = display->samples_per_axis, .dithers = view->court_look};
    resolve_draw(display->gl, &display->resolve, &input, display->picture_framebuffer, display->width, display->height);
    return result;
}

static bool draw_file_opaque(const demo_display *display, const display_view *view, char *message, size_t size)
{
    display->gl->BindFramebuffer(GL_FRAMEBUFFER, display->opaque_framebuffer);
    bool ok = opaque_draw(display->gl, view->scene, view->settings.width * view->samples_per_axis,
                          view->settings.height * view->samples_per_axis, message, size);
    display->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

bool display_set_sources(demo_display *display, const ew_sources_desc *sources, char *message, size_t size)
{
    ew_error error;
    if (!ew_set_sources(display->effect, sources, &error)) return true;
    message_write(message, size, "%s", error.text);
    return false;
}

/* Makes the court, if the view shows it, and its layers. */
static bool make_court(demo_display *display, const display_view *view, char *message, size_t size)
{
    if (!view->court_look) return true;
    if (!display->court) display->court = lit_opaque_create(display->gl, view->scene, message, size);
    if (!display->court) return false;
    const render_settings settings = sample_settings(view);
    const lit_opaque_view lit = court_view(display, view, &settings);
    lit_opaque_fit(display->court, &lit);
    return true;
}

int display_prepare(demo_display *display, const display_view *view)
{
    char message[200];
    int sum = 0, steps_left;
    if (!make_targets(display, view, message, sizeof message) || !make_court(display, view, message, sizeof message) ||
        ew_set_sources(display->effect, &view->scene->sources, NULL))
        return -1;
    if (view->scene->light_reach > 0) {
        const ew_frame_desc frame = light_frame(display, view);
        if (ew_prepare_step(display->effect, NULL, &frame, &sum, NULL)) return -1;
    }
    for (int half = 0; half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(display, view, half, display->effect_framebuffer);
        if (ew_prepare_step(display->effect, NULL, &frame, &steps_left, NULL)) return -1;
        sum += steps_left;
    }
    return sum;
}

bool display_draw(demo_display *display, const display_view *asked_view, char *message, size_t size)
{
    display_view view = *asked_view;
    ew_error error;
    if (view.mode != DISPLAY_PICTURE) view.samples_per_axis = 1;
    if (!make_targets(display, &view, message, size)) return false;
    if (!make_court(display, &view, message, size)) return false;
    if (!view.court_look && !draw_file_opaque(display, &view, message, size)) return false;
    for (int half = 0; half < 2; half++)
        display->statistics[half] = (display_statistics){.map = {-1, -1, -1}};
    if (ew_set_sources(display->effect, &view.scene->sources, &error) || draw_all(display, &view, &error)) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    if (display->gl->GetError() == GL_NO_ERROR) return true;
    message_write(message, size, "GL reported an error while drawing; update the GL driver");
    return false;
}

display_statistics display_statistics_of(const demo_display *display, int half)
{
    display_statistics statistics = display->statistics[half];
    statistics.gpu_milliseconds = display->timers[half].milliseconds;
    return statistics;
}

GLuint display_framebuffer(const demo_display *display)
{
    return display->picture_framebuffer;
}

void display_size(const demo_display *display, int *width, int *height)
{
    *width = display->width;
    *height = display->height;
}

void display_read(const demo_display *display, int channels, unsigned char *srgb)
{
    const pixel_rectangle whole = {0, 0, display->width, display->height};
    GLenum format = channels == 4 ? GL_RGBA : GL_RGB;
    texture_read(display->gl, display->picture_framebuffer, whole, format, GL_UNSIGNED_BYTE, srgb);
}

void display_destroy(demo_display *display)
{
    if (!display) return;
    if (display->width) delete_targets(display);
    for (int half = 0; half < 2; half++)
        gpu_timer_destroy(display->gl, &display->timers[half]);
    lit_opaque_destroy(display->court);
    resolve_destroy(display->gl, &display->resolve);
    reflection_destroy(display->gl, &display->reflection);
    ew_destroy_effect(display->effect);
    free(display);
}
