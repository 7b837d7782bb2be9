/* Draws a scene whose sources are those that the page copied as C, "copied.h"; the scene file has only what stands around them.
 * Usage: copied_c SCENE PICTURE WIDTH HEIGHT */
#include "camera.h"
#include "context.h"
#include "image.h"
#include "render.h"
#include "scene.h"
#include "scene_file.h"

#include "copied.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    char message[600];
    demo_scene scene;
    if (argc != 5 || !scene_load(argv[1], &scene, message, sizeof message)) return EXIT_FAILURE;
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    scene_set_frame(&frame);
    scene.sources = scene_sources;
    scene.composite = frame.output;
    scene.exposure = frame.exposure;
    scene.light_gain = frame.light_gain;
    scene.light_reach = frame.light_reach;
    scene.shadow_thickness = frame.shadow_thickness;
    scene.core_pixels = frame.core_pixels;
    scene.fog = frame.fog;
    scene.media = (ew_medium *)frame.media;
    scene.medium_count = frame.medium_count;
    int width = atoi(argv[3]), height = atoi(argv[4]);
    const render_settings settings = {width, height, EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200, EW_RESOLUTION_FULL};
    float *color = malloc(sizeof(float) * 4 * (size_t)width * (size_t)height);
    gl_context *context = context_create(CONTEXT_AUTO, message, sizeof message);
    if (!color || !context || !render_scene(context, &scene, &settings, color, NULL, message, sizeof message)) {
        fprintf(stderr, "%s\n", message);
        return EXIT_FAILURE;
    }
    image_pixels picture = {.width = width, .height = height, .channels = 4, .pixels = color};
    return image_write(argv[2], &picture, message, sizeof message) ? EXIT_SUCCESS : EXIT_FAILURE;
}
