/* Frames without a window: see offscreen.h. */
#include "offscreen.h"
#include "animation.h"
#include "display.h"
#include "files.h"
#include "image.h"
#include "message.h"
#include "scene_file.h"
#include "video.h"

#include <stdio.h>
#include <stdlib.h>

/* Draws a progress bar, if standard error is a terminal. */
static void show_progress(int done, int total)
{
    enum { WIDTH = 40 };
    if (!file_is_terminal(stderr)) return;
    int filled = (int)((long long)WIDTH * done / total);
    fprintf(stderr, "\r[%.*s%*s] %d of %d frames%s", filled, "########################################", WIDTH - filled, "",
            done, total, done == total ? "\n" : "");
}

static bool write_picture(const demo_options *options, int frame, const unsigned char *srgb, char *message, size_t size)
{
    char name[4096];
    /* options_read has checked that it has one conversion, of an integer. */
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    int length = snprintf(name, sizeof name, options->output, frame);
#pragma GCC diagnostic pop
    if (length < 0 || (size_t)length >= sizeof name) {
        message_write(message, size, "-o: the name is too long; use a shorter one");
        return false;
    }
    image_pixels picture = {.width = options->settings.width, .height = options->settings.height, .channels = 3, .srgb = srgb};
    return image_write(name, &picture, message, size);
}

static bool draw_frames(const demo_options *options, demo_display *display, demo_animation *animation, const demo_scene *scene,
                        demo_video *video, unsigned char *srgb, char *message, size_t size)
{
    display_view view = {.scene = scene,
                         .court_look = scene == &animation->scene,
                         .mode = options->mode,
                         .settings = options->settings,
                         .split = options->split,
                         .right = options->right,
                         .samples_per_axis = options->samples_per_axis};
    int total = options->last_frame - options->first_frame + 1;
    for (int i = 0; i < total; i++) {
        int frame = options->first_frame + i;
        show_progress(i, total);
        animation_set_time(animation, (double)frame / options->frames_per_second);
        if (!display_draw(display, &view, message, size)) return false;
        display_read(display, 3, srgb);
        if (options->output && !write_picture(options, frame, srgb, message, size)) return false;
        if (video && !video_write(video, srgb)) return false;
    }
    show_progress(total, total);
    return true;
}

static bool draw_on_display(const demo_options *options, demo_display *display, const demo_scene *file_scene, char *message,
                            size_t size)
{
    demo_animation *animation = malloc(sizeof *animation);
    unsigned char *srgb = malloc((size_t)options->settings.width * (size_t)options->settings.height * 3);
    demo_video *video = NULL;
    bool ok = false;
    if (!animation || !srgb) {
        message_write(message, size, "--size: the picture does not fit into memory; ask for a smaller one");
    } else if (!options->video || (video = video_open(options->video, options->settings.width, options->settings.height,
                                                      options->frames_per_second, message, size))) {
        animation_init(animation);
        animation->flies = options->flight;
        const demo_scene *scene = file_scene ? file_scene : &animation->scene;
        ok = draw_frames(options, display, animation, scene, video, srgb, message, size);
    }
    if (video) ok = video_close(video, message, size) && ok;
    free(srgb);
    free(animation);
    return ok;
}

bool offscreen_run(const demo_options *options, char *message, size_t size)
{
    demo_scene scene;
    if (options->scene && !scene_load(options->scene, &scene, message, size)) return false;
    gl_context *context = context_create(options->backend, message, size);
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    demo_display *display = context ? display_create(context_gl(context), &desc, message, size) : NULL;
    bool ok = display && draw_on_display(options, display, options->scene ? &scene : NULL, message, size);
    display_destroy(display);
    context_destroy(context);
    if (options->scene) scene_free(&scene);
    return ok;
}
