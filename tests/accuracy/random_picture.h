/*
 * The luminance of random scenes, as the library draws it at a few of a picture's pixels.
 *
 * Of a picture of 512 x 512 pixels, four square windows are drawn: one anywhere, two on the sources, and one where a preview of
 * the whole picture is brightest, since errors are relative to that.
 */
#ifndef RANDOM_PICTURE_H
#define RANDOM_PICTURE_H

#include "context.h"
#include "render.h"
#include "scene_file.h"
#include "scene_rays.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { RANDOM_PIXEL_COUNT = 64 };

/* A pixel that was drawn, and later the truth. */
typedef struct random_pixel {
    int x, y;
    float depth; /* as stored */
    float luminance;
    bool reliable;
    double truth;
    double error;
} random_pixel;

typedef struct random_picture {
    uint64_t seed;
    int kind; /* of the scene */
    random_pixel pixels[RANDOM_PIXEL_COUNT];
    const random_pixel *worst;
    double sensitivity; /* of the worst pixel's truth */
} random_picture;

typedef struct random_picture_scene {
    demo_scene scene;
    scene_rays rays;
} random_picture_scene;

/* The scene of a seed. On failure returns false, with a message and nothing to unload. */
bool random_picture_load(uint64_t seed, random_picture_scene *scene, char *message, size_t size);
void random_picture_unload(random_picture_scene *scene);

/* Draws the pixels of pictures that have their seeds. On failure returns false, with a message. */
bool random_pictures_draw(gl_context *context, const render_settings *settings, random_picture *pictures, size_t count,
                          char *message, size_t size);

#endif
