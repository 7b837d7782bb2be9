/* Parts of the pictures of random scenes: see random_picture.h. */
#include "random_picture.h"
#include "core_pixels.h"
#include "field_drawer.h"
#include "random_numbers.h"
#include "random_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, PREVIEW = 16, WINDOW = 4, WINDOW_COUNT = RANDOM_PIXEL_COUNT / (WINDOW * WINDOW) };

typedef struct window_stage {
    render_settings settings; /* of the whole picture */
    field_drawer window, preview;
} window_stage;

bool random_picture_load(uint64_t seed, random_picture_scene *scene, char *message, size_t size)
{
    char name[40];
    char *text = random_scene_text(seed);
    snprintf(name, sizeof name, "random scene %llu", (unsigned long long)seed);
    if (!text) {
        snprintf(message, size, "%s: memory is exhausted", name);
        return false;
    }
    bool ok = scene_parse(text, strlen(text), name, &scene->scene, message, size);
    free(text);
    if (ok && !scene_rays_create(&scene->scene, SIDE, SIDE, &scene->rays)) {
        scene_free(&scene->scene);
        snprintf(message, size, "%s: memory is exhausted", name);
        ok = false;
    }
    return ok;
}

void random_picture_unload(random_picture_scene *scene)
{
    scene_rays_free(&scene->rays);
    scene_free(&scene->scene);
}

/* A window's lower left corner, for a pixel in its middle. */
static void window_around(int x, int y, int corner[2])
{
    const int middle[2] = {x, y};
    for (int i = 0; i < 2; i++) {
        corner[i] = middle[i] - WINDOW / 2;
        if (corner[i] < 0) corner[i] = 0;
        if (corner[i] > SIDE - WINDOW) corner[i] = SIDE - WINDOW;
    }
}

/* Draws the luminance of a part of a picture of `side` x `side` pixels: of as many from `corner` on as the drawer has. */
static bool draw_part(window_stage *stage, field_drawer *drawer, const random_picture_scene *scene, int side,
                      const int corner[2], float *depth, float *luminance, ew_error *error)
{
    for (int i = 0; i < drawer->width * drawer->height; i++) {
        double scale = (double)SIDE / side, x = corner[0] + i % drawer->width + 0.5, y = corner[1] + i / drawer->width + 0.5;
        depth[i] = scene_rays_depth_to_store(&scene->rays, scene_rays_cast(&scene->rays, scale * x, scale * y));
    }
    render_settings settings = stage->settings;
    settings.width = settings.height = side;
    ew_frame_desc frame = render_frame(&scene->scene, &settings, &drawer->target);
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.viewport_x = -corner[0];
    frame.viewport_y = -corner[1];
    return field_drawer_draw(drawer, &scene->scene.sources, &frame, depth, luminance, error);
}

/* The window where the preview is brightest; what is no number is no light. */
static bool find_brightest(window_stage *stage, const random_picture_scene *scene, int corner[2], ew_error *error)
{
    float depth[PREVIEW * PREVIEW], luminance[PREVIEW * PREVIEW];
    if (!draw_part(stage, &stage->preview, scene, PREVIEW, (const int[2]){0, 0}, depth, luminance, error)) return false;
    int brightest = 0;
    for (int i = 0; i < PREVIEW * PREVIEW; i++)
        if (luminance[i] > luminance[brightest] && isfinite(luminance[i])) brightest = i;
    window_around((2 * (brightest % PREVIEW) + 1) * SIDE / (2 * PREVIEW),
                  (2 * (brightest / PREVIEW) + 1) * SIDE / (2 * PREVIEW), corner);
    return true;
}

static bool draw_windows(window_stage *stage, const random_picture_scene *scene, random_picture *picture, ew_error *error)
{
    uint64_t random = ~picture->seed;
    int corners[WINDOW_COUNT][2];
    for (int window = 0; window < WINDOW_COUNT; window++) {
        int x = (int)random_index(&random, SIDE), y = (int)random_index(&random, SIDE);
        for (int attempt = 0; window > 0 && attempt < 20; attempt++)
            if (random_core_pixel(&scene->rays, &random, &x, &y)) break;
        window_around(x, y, corners[window]);
    }
    if (!find_brightest(stage, scene, corners[WINDOW_COUNT - 1], error)) return false;
    for (int window = 0; window < WINDOW_COUNT; window++) {
        float depth[WINDOW * WINDOW], luminance[WINDOW * WINDOW];
        if (!draw_part(stage, &stage->window, scene, SIDE, corners[window], depth, luminance, error)) return false;
        for (int i = 0; i < WINDOW * WINDOW; i++)
            picture->pixels[window * WINDOW * WINDOW + i] = (random_pixel){
                .x = corners[window][0] + i % WINDOW,
                .y = corners[window][1] + i / WINDOW,
                .depth = depth[i],
                .luminance = luminance[i],
            };
    }
    return true;
}

static bool draw_picture(window_stage *stage, random_picture *picture, char *message, size_t size)
{
    random_picture_scene scene;
    ew_error error;
    if (!random_picture_load(picture->seed, &scene, message, size)) return false;
    bool ok = draw_windows(stage, &scene, picture, &error);
    if (!ok) snprintf(message, size, "random scene %llu: %s", (unsigned long long)picture->seed, error.text);
    random_picture_unload(&scene);
    return ok;
}

static bool draw_all(window_stage *stage, gl_context *context, ew_effect *effect, random_picture *pictures, size_t count,
                     char *message, size_t size)
{
    if (!field_drawer_create(context, effect, WINDOW, WINDOW, &stage->window, message, size)) return false;
    bool ok = field_drawer_create(context, effect, PREVIEW, PREVIEW, &stage->preview, message, size);
    if (ok) {
        for (size_t i = 0; ok && i < count; i++)
            ok = draw_picture(stage, &pictures[i], message, size);
        field_drawer_destroy(&stage->preview);
    }
    field_drawer_destroy(&stage->window);
    return ok;
}

bool random_pictures_draw(gl_context *context, const render_settings *settings, random_picture *pictures, size_t count,
                          char *message, size_t size)
{
    window_stage stage = {.settings = *settings};
    ew_effect *effect;
    ew_error error;
    ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    if (ew_create_effect(&desc, &effect, &error)) {
        snprintf(message, size, "%s", error.text);
        return false;
    }
    bool ok = draw_all(&stage, context, effect, pictures, count, message, size);
    ew_destroy_effect(effect);
    return ok;
}
