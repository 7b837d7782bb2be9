/* The showpiece's light in a context of each kind, one after the other: all draw the same picture.
 *
 *     showpiece_test SCENE.json CONTEXT...    the first is what the others are compared with; names in context.h */
#include "camera.h"
#include "canvas.h"
#include "debug_output.h"
#include "program_context.h"
#include "scene_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 160, HEIGHT = 90, VALUES = WIDTH * HEIGHT * 4 };

static bool draw_in(const char *name, const ew_scene *scene, GLfloat pixels[VALUES])
{
    test_context *context = open_context(name, NULL);
    if (context == NULL) return false;
    canvas made = canvas_create(WIDTH, HEIGHT, GL_RGBA8, 0, 0);
    canvas_clear(&made, (const GLfloat[4]){0, 0, 0, 1});

    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    camera_view(&scene->camera, frame.view);
    camera_projection(&scene->camera, (double)WIDTH / HEIGHT, frame.projection);
    frame.interval_start = scene->interval_start;
    frame.interval_end = scene->interval_end;
    frame.decay_alpha = scene->decay_alpha;
    frame.decay_beta = scene->decay_beta;
    frame.framebuffer = made.framebuffer;
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;

    const ew_effect_desc desc = {.get_proc_address = test_context_get_proc_address, .user = context};
    ew_effect *effect = NULL;
    ew_error error;
    bool drawn = ew_create_effect(&desc, &effect, &error) == EW_OK &&
                 ew_set_sources(effect, &scene->sources, &error) == EW_OK && ew_draw(effect, &frame, &error) == EW_OK;
    if (drawn)
        canvas_read(&made, pixels);
    else
        fprintf(stderr, "%s: %s\n", name, error.text);
    ew_destroy_effect(effect);
    canvas_destroy(&made);
    close_context(context);
    return drawn;
}

/* As between rasterisers: at most 2/255 anywhere, and more than 1/255 in 0.1 % of the pixels. */
static bool is_alike(const GLfloat expected[VALUES], const GLfloat found[VALUES])
{
    int above = 0;
    for (int pixel = 0; pixel < VALUES; pixel += 4) {
        int difference = 0;
        for (int i = pixel; i < pixel + 4; i++)
            difference = (int)fmaxf((float)difference, roundf(255 * fabsf(expected[i] - found[i])));
        if (difference > 2) return false;
        above += difference > 1;
    }
    return above * 1000 <= WIDTH * HEIGHT;
}

int main(int argc, char **argv)
{
    if (argc < 3) return 2;
    ew_scene scene;
    char message[400];
    if (!scene_load(argv[1], &scene, message, sizeof message)) {
        fprintf(stderr, "%s\n", message);
        return 2;
    }
    static GLfloat expected[VALUES], found[VALUES];
    int failures = !draw_in(argv[2], &scene, expected);
    float brightest = 0;
    for (int i = 0; i < VALUES; i += 4)
        brightest = fmaxf(brightest, expected[i]);
    if (brightest < 0.9f) {
        printf("%s: there is hardly any light\n", argv[2]);
        failures++;
    }
    for (int i = 3; i < argc; i++) {
        if (draw_in(argv[i], &scene, found) && is_alike(expected, found)) continue;
        printf("%s: not the picture of %s\n", argv[i], argv[2]);
        failures++;
    }
    printf("%d contexts, %d failures\n", argc - 2, failures);
    scene_free(&scene);
    return failures == 0 && debug_output_count() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
