/* What the commonest beam costs, straight and with two ends: 16 of them beside 16 infinite lines, which have one closed form,
 * at 320 x 180. Prints the medians of rounds in which both take turns, and their ratio.
 *
 *     beam_cost CONTEXT [LARGEST_RATIO]    fails if the ratio is larger
 *     contexts are those of context.h */
#define _POSIX_C_SOURCE 200112L
#include "canvas.h"
#include "energywave.h"
#include "program_context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { WIDTH = 320, HEIGHT = 180, BEAMS = 16, ROUNDS = 15, WARM_UP = 3 };

static ew_effect *effect;
static canvas target;

/* The same places for both: from (-1, y, 0) to (1, y + 0.1, 0.4). */
typedef struct beams {
    double ends[BEAMS][2][3];
    ew_path paths[BEAMS];
    ew_line lines[BEAMS];
} beams;

static void make_beams(beams *made)
{
    for (int i = 0; i < BEAMS; i++) {
        const double y = 0.1 * i - 0.8, ends[2][3] = {{-1, y, 0}, {1, y + 0.1, 0.4}};
        memcpy(made->ends[i], ends, sizeof ends);
        made->paths[i] = (ew_path){.points = (const double(*)[3])made->ends[i], .point_count = 2};
        made->paths[i].brightness = 0.2;
        made->paths[i].core = 0.01;
        made->paths[i].reach = 0.5;
        made->lines[i] =
            (ew_line){.position = {-1, y, 0}, .direction = {2, 0.1, 0.4}, .brightness = 0.2, .core = 0.01, .reach = 0.5};
    }
}

static ew_frame_desc make_frame(void)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    const double slope = 0.4663; /* of a field of view of 50 degrees */
    frame.view[14] = -4;
    frame.projection[0] = HEIGHT / (slope * WIDTH);
    frame.projection[5] = 1 / slope;
    frame.framebuffer = target.framebuffer;
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.encoding = EW_ENCODING_FLOAT;
    return frame;
}

static double draw(const ew_sources_desc *sources, const ew_frame_desc *frame)
{
    struct timespec before, after;
    GLfloat pixel[4];
    ew_error error;
    if (ew_set_sources(effect, sources, &error) != EW_OK) abort();
    clock_gettime(CLOCK_MONOTONIC, &before);
    if (ew_draw(effect, frame, &error) != EW_OK) abort();
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel); /* waits */
    clock_gettime(CLOCK_MONOTONIC, &after);
    return (double)(after.tv_sec - before.tv_sec) + 1e-9 * (double)(after.tv_nsec - before.tv_nsec);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double measure_ratio(const char *what, const ew_sources_desc sources[2], const ew_frame_desc *frame)
{
    double seconds[2][ROUNDS];
    for (int round = -WARM_UP; round < ROUNDS; round++)
        for (int i = 0; i < 2; i++)
            seconds[i][round < 0 ? 0 : round] = draw(&sources[i], frame);
    for (int i = 0; i < 2; i++)
        qsort(seconds[i], ROUNDS, sizeof seconds[i][0], compare);
    double lines = seconds[0][ROUNDS / 2], paths = seconds[1][ROUNDS / 2];
    printf("%s: 16 infinite lines %.2f ms, 16 beams %.2f ms, %.2f times\n", what, 1e3 * lines, 1e3 * paths, paths / lines);
    return paths / lines;
}

int main(int argc, char **argv)
{
    gl_context *context = argc >= 2 ? open_context(argv[1], NULL) : NULL;
    if (!context) return 2;
    static beams made;
    make_beams(&made);
    const ew_sources_desc sources[2] = {{.lines = made.lines, .line_count = BEAMS}, {.paths = made.paths, .path_count = BEAMS}};
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, 0, 0);
    if (ew_create_effect(&(ew_effect_desc){.get_proc_address = context_get_proc_address, .user = context}, &effect, NULL) !=
        EW_OK)
        return 2;
    ew_frame_desc frame = make_frame();
    double ratio = measure_ratio("the world integral", sources, &frame);
    frame.core_pixels = 0;
    double without = measure_ratio("with cores as they are", sources, &frame);
    frame.interval_start = 2;
    frame.interval_end = 6;
    double papers = measure_ratio("the papers' integral", sources, &frame);
    for (int i = 0; i < BEAMS; i++) {
        made.paths[i].brightness = made.lines[i].brightness = made.paths[i].reach = made.lines[i].reach = 0;
        made.paths[i].coefficient = made.lines[i].coefficient = 0.03;
    }
    double endless = measure_ratio("the papers' integral, without a reach", sources, &frame);
    ew_destroy_effect(effect);
    canvas_destroy(&target);
    close_context(context);
    double largest = argc > 2 ? strtod(argv[2], NULL) : 1e9;
    return ratio <= largest && without <= largest && papers <= largest && endless <= largest ? EXIT_SUCCESS : EXIT_FAILURE;
}
