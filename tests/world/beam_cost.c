/* What paths cost, at 320 x 180, beside infinite lines and curves. The commonest beam, straight and with two ends, beside an
 * infinite line, which has one closed form: one and 16 of them, that end in the picture or beyond it. And smooth paths, of 8
 * and 24 bent pieces, beside as many curves. Of each frame it prints the least processor time of rounds in which both take
 * turns, and their ratio, which on llvmpipe with LP_NUM_THREADS=0 repeats within 2 %, even on a machine that is busy.
 *
 *     beam_cost CONTEXT [LARGEST_RATIO]    fails if a ratio of beams to lines is larger, or one of paths to curves than 1.05
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

/* The same places for both: from (-1, y, 0) to (1, y + 0.1, 0.4), times the beams' length. */
typedef struct beams {
    double ends[BEAMS][2][3];
    ew_path paths[BEAMS];
    ew_line lines[BEAMS];
} beams;

static void make_beams(double length, beams *made)
{
    for (int i = 0; i < BEAMS; i++) {
        const double y = 0.1 * i - 0.8, middle[3] = {0, y + 0.05, 0.2}, half[3] = {1, 0.05, 0.2};
        for (int k = 0; k < 3; k++) {
            made->ends[i][0][k] = middle[k] - length * half[k];
            made->ends[i][1][k] = middle[k] + length * half[k];
        }
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
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &before);
    if (ew_draw(effect, frame, &error) != EW_OK) abort();
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel); /* waits */
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &after);
    return (double)(after.tv_sec - before.tv_sec) + 1e-9 * (double)(after.tv_nsec - before.tv_nsec);
}

static double measure_ratio(const char *what, const ew_sources_desc sources[2], const ew_frame_desc *frame)
{
    double least[2] = {1e9, 1e9};
    for (int round = -WARM_UP; round < ROUNDS; round++)
        for (int i = 0; i < 2; i++) {
            double seconds = draw(&sources[i], frame);
            if (round >= 0 && seconds < least[i]) least[i] = seconds;
        }
    printf("%s: %.2f and %.2f ms, %.2f times\n", what, 1e3 * least[0], 1e3 * least[1], least[1] / least[0]);
    return least[1] / least[0];
}

/* A wave from left to right as a B-spline, and its pieces as curves. */
static double measure_smooth_ratio(const char *what, int pieces, const ew_frame_desc *frame)
{
    enum { MOST = 24 };
    static double points[MOST + 2][3];
    ew_curve curves[MOST];
    for (int i = 0; i < pieces + 2; i++) {
        points[i][0] = 3.0 * i / (pieces + 1) - 1.5;
        points[i][1] = i % 2 ? 0.4 : -0.4;
        points[i][2] = i % 3 * 0.2;
    }
    for (int i = 0; i < pieces; i++) {
        double control[3][3];
        for (int k = 0; k < 3; k++) {
            control[0][k] = i == 0 ? points[0][k] : 0.5 * (points[i][k] + points[i + 1][k]);
            control[1][k] = points[i + 1][k];
            control[2][k] = i == pieces - 1 ? points[i + 2][k] : 0.5 * (points[i + 1][k] + points[i + 2][k]);
        }
        curves[i] = (ew_curve){.domain = {0, 1}};
        ew_bezier_polynomial(control[0], control[1], control[2], curves[i].polynomial);
        curves[i].brightness = 0.2;
        curves[i].core = 0.01;
        curves[i].reach = 0.5;
    }
    ew_path path = {.kind = EW_PATH_BSPLINE, .points = (const double(*)[3])points, .point_count = (size_t)pieces + 2};
    path.brightness = 0.2;
    path.core = 0.01;
    path.reach = 0.5;
    const ew_sources_desc sources[2] = {{.curves = curves, .curve_count = (size_t)pieces}, {.paths = &path, .path_count = 1}};
    return measure_ratio(what, sources, frame);
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* One and 16, that end in the picture and beyond it. */
static double measure_beams(const char *what, const ew_frame_desc *frame, bool has_reach)
{
    static const double lengths[2] = {1, 4};
    static beams made;
    double largest = 0;
    for (int length = 0; length < 2; length++) {
        make_beams(lengths[length], &made);
        for (int i = 0; i < BEAMS && !has_reach; i++) {
            made.paths[i].brightness = made.lines[i].brightness = made.paths[i].reach = made.lines[i].reach = 0;
            made.paths[i].coefficient = made.lines[i].coefficient = 0.03;
        }
        for (size_t count = 1; count <= BEAMS; count += BEAMS - 1) {
            const size_t first = count == 1 ? BEAMS / 2 : 0;
            const ew_sources_desc sources[2] = {{.lines = made.lines + first, .line_count = count},
                                                {.paths = made.paths + first, .path_count = count}};
            char text[120];
            snprintf(text, sizeof text, "%s: %zu lines and beams that end %s the picture", what, count,
                     length == 0 ? "in" : "beyond");
            largest = larger(largest, measure_ratio(text, sources, frame));
        }
    }
    return largest;
}

int main(int argc, char **argv)
{
    gl_context *context = argc >= 2 ? open_context(argv[1], NULL) : NULL;
    if (!context) return 2;
    target = canvas_create(WIDTH, HEIGHT, GL_RGBA32F, 0, 0);
    if (ew_create_effect(&(ew_effect_desc){.get_proc_address = context_get_proc_address, .user = context}, &effect, NULL) !=
        EW_OK)
        return 2;
    ew_frame_desc frame = make_frame();
    double of_beams = measure_beams("world integral", &frame, true);
    double smooth = measure_smooth_ratio("8 curves and a path of 8 pieces", 8, &frame);
    smooth = larger(smooth, measure_smooth_ratio("24 curves and a path of 24 pieces", 24, &frame));
    frame.core_pixels = 0;
    of_beams = larger(of_beams, measure_beams("with cores as they are", &frame, true));
    frame.interval_start = 2;
    frame.interval_end = 6;
    of_beams = larger(of_beams, measure_beams("papers' integral", &frame, true));
    of_beams = larger(of_beams, measure_beams("papers' integral without a reach", &frame, false));
    ew_destroy_effect(effect);
    canvas_destroy(&target);
    close_context(context);
    bool is_held = argc <= 2 || (smooth <= 1.05 && of_beams <= strtod(argv[2], NULL));
    return is_held ? EXIT_SUCCESS : EXIT_FAILURE;
}
