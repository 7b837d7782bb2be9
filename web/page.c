/* The page: see page.h. */
#include "page.h"
#include "animation.h"
#include "camera_ray.h"
#include "context.h"
#include "display.h"
#include "message.h"
#include "scene_file.h"
#include "scene_pick.h"
#include "scene_write.h"

#include <emscripten.h>

#include <stdlib.h>
#include <string.h>

static struct {
    gl_context *context;
    demo_display *display;
    demo_animation court;
    demo_scene file;
    bool shows_court;
    display_view view;
    char message[600];
    char *text;
    unsigned char *pixels;
} page;

EMSCRIPTEN_KEEPALIVE const char *page_start(void)
{
    page.message[0] = '\0';
    page.context = context_create(CONTEXT_AUTO, page.message, sizeof page.message);
    if (!page.context) return page.message;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = page.context};
    page.display = display_create(context_gl(page.context), &desc, page.message, sizeof page.message);
    if (!page.display) return page.message;
    animation_init(&page.court);
    animation_set_time(&page.court, 0);
    page.shows_court = true;
    page.view.settings = (render_settings){0, 0, EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200, EW_RESOLUTION_ADAPTIVE};
    page.view.right = page.view.settings;
    page.message[0] = '\0';
    return page.message;
}

EMSCRIPTEN_KEEPALIVE const char *page_renderer(void)
{
    return context_description(page.context);
}

static demo_scene *shown_scene(void)
{
    return page.shows_court ? &page.court.scene : &page.file;
}

EMSCRIPTEN_KEEPALIVE void page_show_court(double seconds)
{
    page.shows_court = true;
    animation_set_time(&page.court, seconds);
}

EMSCRIPTEN_KEEPALIVE const char *page_show_file(const char *text, size_t length)
{
    demo_scene scene;
    page.message[0] = '\0';
    if (!scene_parse(text, length, "scene", &scene, page.message, sizeof page.message)) return page.message;
    char fault[300];
    if (!display_set_sources(page.display, &scene.sources, fault, sizeof fault)) {
        message_write(page.message, sizeof page.message, "scene: %s", fault);
        scene_free(&scene);
        return page.message;
    }
    scene_free(&page.file);
    page.file = scene;
    page.shows_court = false;
    return page.message;
}

EMSCRIPTEN_KEEPALIVE const char *page_write(void)
{
    free(page.text);
    page.text = scene_write(shown_scene());
    return page.text;
}

EMSCRIPTEN_KEEPALIVE void page_set_camera(double eye_x, double eye_y, double eye_z, double target_x, double target_y,
                                          double target_z, double up_x, double up_y, double up_z, double height)
{
    scene_camera *camera = &shown_scene()->camera;
    memcpy(camera->eye, (double[3]){eye_x, eye_y, eye_z}, sizeof camera->eye);
    memcpy(camera->target, (double[3]){target_x, target_y, target_z}, sizeof camera->target);
    memcpy(camera->up, (double[3]){up_x, up_y, up_z}, sizeof camera->up);
    camera->height = height;
}

EMSCRIPTEN_KEEPALIVE const char *page_pick(double x, double y, double aspect, double width)
{
    const demo_scene *scene = shown_scene();
    camera_ray ray = camera_ray_at(&scene->camera, aspect, (double[]){x, y});
    scene_part part;
    page.message[0] = '\0';
    if (scene_pick(scene, &ray, width * camera_half_height(&scene->camera, 1), &part))
        message_write(page.message, sizeof page.message, "%s/%zu", scene_part_list(part.kind), part.index);
    return page.message;
}

EMSCRIPTEN_KEEPALIVE void page_fill_pulse(double frame, double *weights, size_t count)
{
    ew_fill_pulse_weights(frame, weights, count);
}

EMSCRIPTEN_KEEPALIVE void page_set_integrator(bool is_right, int integrator, int quality, int divisions)
{
    render_settings *settings = is_right ? &page.view.right : &page.view.settings;
    settings->integrator = (ew_integrator)integrator;
    settings->quality = (ew_quality)quality;
    settings->simpson_divisions = divisions;
}

EMSCRIPTEN_KEEPALIVE void page_set_view(int mode, bool split)
{
    page.view.mode = (display_mode)mode;
    page.view.split = split;
}

static display_view *view_of_size(int width, int height)
{
    page.view.scene = shown_scene();
    page.view.court_look = page.shows_court;
    page.view.settings.width = page.view.right.width = width;
    page.view.settings.height = page.view.right.height = height;
    page.view.samples_per_axis = 1;
    return &page.view;
}

EMSCRIPTEN_KEEPALIVE int page_prepare(int width, int height)
{
    return display_prepare(page.display, view_of_size(width, height));
}

EMSCRIPTEN_KEEPALIVE const char *page_draw(int width, int height)
{
    page.message[0] = '\0';
    display_draw(page.display, view_of_size(width, height), page.message, sizeof page.message);
    return page.message;
}

EMSCRIPTEN_KEEPALIVE void page_present(void)
{
    const gl_functions *gl = context_gl(page.context);
    int width, height;
    display_size(page.display, &width, &height);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, display_framebuffer(page.display));
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

EMSCRIPTEN_KEEPALIVE const unsigned char *page_read(void)
{
    int width, height;
    display_size(page.display, &width, &height);
    free(page.pixels);
    page.pixels = malloc((size_t)width * (size_t)height * 4);
    if (page.pixels) display_read(page.display, 4, page.pixels);
    return page.pixels;
}

EMSCRIPTEN_KEEPALIVE double page_statistic(int half, int which)
{
    map_statistics map = display_statistics_of(page.display, half).map;
    const double statistics[] = {map.mean_evaluations, map.largest_error, map.error_of_99_percent};
    return statistics[which];
}
