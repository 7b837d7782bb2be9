/*
 * Adaptive resolution against the same picture at every pixel, at all pixels of whole frames:
 *
 *     resolution_test BOUND FRAMES SCENE.json...
 *
 * Each scene is drawn FRAMES times, and its camera moves an eighth of a pixel to the right each time. No pixel of any frame may
 * be off by more than BOUND of max(B, 0.03 of the frame's largest B). Light that crawls would be.
 *
 * Exit status: 0; 1 for a scene that is beyond; 2 for bad input; 77 if there is no context.
 */
#include "effect_context.h"
#include "picture.h"
#include "scene_file.h"
#include "true_pixels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 400, HEIGHT = 256 };

/* How far adaptive resolution is off at the worst pixel of a frame, and for how many pixels it makes a difference. */
typedef struct frame_difference {
    double largest;
    int x, y;
    double different_share;
} frame_difference;

static frame_difference compare(const drawn_picture *full, const drawn_picture *adaptive)
{
    frame_difference difference = {0};
    double peak = 0;
    int different = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        peak = fmax(peak, (double)full->luminance[i]);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double truth = (double)full->luminance[i], off = fabs((double)adaptive->luminance[i] - truth);
        different += off > 0;
        double relative = off == 0 ? 0 : off / fmax(truth, TRUTH_DARK_INTERPOLATED * peak);
        if (relative <= difference.largest) continue; /* what is no number goes on */
        difference.largest = relative;
        difference.x = i % WIDTH;
        difference.y = i / WIDTH;
    }
    difference.different_share = (double)different / (WIDTH * HEIGHT);
    return difference;
}

/* Moves the camera by pixels of the plane through its target. */
static void pan(scene_camera *camera, double pixels)
{
    double forward[3], distance = 0;
    for (int i = 0; i < 3; i++) {
        forward[i] = camera->target[i] - camera->eye[i];
        distance += forward[i] * forward[i];
    }
    distance = sqrt(distance);
    const double *up = camera->up;
    double right[3] = {forward[1] * up[2] - forward[2] * up[1], forward[2] * up[0] - forward[0] * up[2],
                       forward[0] * up[1] - forward[1] * up[0]};
    double length = sqrt(right[0] * right[0] + right[1] * right[1] + right[2] * right[2]);
    double height = camera->orthographic ? camera->height : 2 * distance * tan(camera->fov_y_degrees * acos(-1.0) / 360);
    for (int i = 0; i < 3; i++) {
        double step = pixels * height / HEIGHT * right[i] / length;
        camera->eye[i] += step;
        camera->target[i] += step;
    }
}

static bool draw(gl_context *context, const demo_scene *scene, ew_resolution resolution, drawn_picture *picture)
{
    const render_settings settings = {.width = WIDTH,
                                      .height = HEIGHT,
                                      .integrator = EW_INTEGRATOR_ADAPTIVE,
                                      .quality = EW_QUALITY_ERROR_1E_3,
                                      .resolution = resolution};
    char message[300];
    if (picture_draw(context, scene, &settings, picture, message, sizeof message)) return true;
    fprintf(stderr, "resolution_test: %s\n", message);
    return false;
}

static bool compare_frame(gl_context *context, const demo_scene *scene, frame_difference *difference)
{
    drawn_picture full, adaptive;
    if (!draw(context, scene, EW_RESOLUTION_FULL, &full)) return false;
    bool ok = draw(context, scene, EW_RESOLUTION_ADAPTIVE, &adaptive);
    if (ok) {
        *difference = compare(&full, &adaptive);
        picture_free(&adaptive);
    }
    picture_free(&full);
    return ok;
}

/* Returns false for bad input. */
static bool check_scene(gl_context *context, const char *path, double bound, int frames, bool *wrong)
{
    char message[400];
    demo_scene scene;
    if (!scene_load(path, &scene, message, sizeof message)) {
        fprintf(stderr, "resolution_test: %s\n", message);
        return false;
    }
    frame_difference worst = {.largest = -1};
    double different_share = 0;
    bool ok = true;
    for (int i = 0; ok && i < frames; i++) {
        frame_difference difference;
        ok = compare_frame(context, &scene, &difference);
        if (ok && !(difference.largest <= worst.largest)) worst = difference;
        if (ok) different_share = fmax(different_share, difference.different_share);
        pan(&scene.camera, 0.125);
    }
    bool is_beyond = !(worst.largest <= bound);
    const char *slash = strrchr(path, '/');
    printf("%-48s %.1e at (%3d, %3d), %4.1f %% of the pixels differ%s\n", slash ? slash + 1 : path, worst.largest, worst.x,
           worst.y, 100 * different_share, is_beyond ? "  WRONG" : "");
    *wrong = *wrong || is_beyond;
    scene_free(&scene);
    return ok;
}

int main(int argc, char **argv)
{
    char message[300];
    double bound = argc > 3 ? atof(argv[1]) : 0;
    int frames = argc > 3 ? atoi(argv[2]) : 0;
    if (!(bound > 0) || frames < 1) {
        fputs("usage: resolution_test BOUND FRAMES SCENE.json...\n", stderr);
        return EXIT_BAD_INPUT;
    }
    gl_context *context = context_create(CONTEXT_AUTO, message, sizeof message);
    if (!context) return EXIT_NO_CONTEXT;
    bool ok = true, wrong = false;
    for (int i = 3; ok && i < argc; i++)
        ok = check_scene(context, argv[i], bound, frames, &wrong);
    context_destroy(context);
    if (!ok) return EXIT_BAD_INPUT;
    return wrong ? EXIT_WRONG : EXIT_SUCCESS;
}
