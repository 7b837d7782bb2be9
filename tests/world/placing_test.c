/* What an artist relies on: a source looks the same from every distance and in every unit, a chain as its whole, and a thin
 * beam neither beads nor crawls.
 *
 *     placing_test CONTEXT    one of the names in context.h */
#include "program_context.h"
#include "stage.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- Distance and unit -------------------------------------------------------------------------------------------------- */

/* Halo and core, at every pixel: what the ray's distance from the middle says, and nothing else. */
static void an_orb_is_the_same_from_every_distance(void **state)
{
    (void)state;
    static const double distances[] = {0.05, 0.5, 1.5, 3, 6, 12, 25, 50};
    static stage_picture found;
    const double core = 0.3, reach = 2, brightness = 0.8;
    const ew_point orb = {.brightness = brightness, .core = core, .reach = reach};
    stage_set(&(ew_sources_desc){.points = &orb, .point_count = 1});
    for (size_t i = 0; i < sizeof distances / sizeof distances[0]; i++) {
        ew_frame_desc frame = stage_frame(distances[i]);
        frame.core_pixels = 0;
        stage_measure(&frame, found);
        double worst = 0;
        for (int row = 0; row < STAGE_HEIGHT; row += 4)
            for (int column = 0; column < STAGE_WIDTH; column += 4) {
                /* The ray begins at the eye, before the nearest place on it, or within the orb. */
                double miss = stage_ray_distance(distances[i], column, row);
                double before = sqrt(fmax(0, distances[i] * distances[i] - miss * miss));
                double expected = stage_orb(brightness, core, reach, miss, before);
                worst = fmax(worst, fabs((double)found[row][column][0] - expected) / fmax(expected, 1e-3 * brightness));
            }
        fprintf(stderr, "orb from %g: off by %.2g\n", distances[i], worst);
        assert_true(worst <= 1e-4);
    }
}

/* The middle of an orb, and of a beam across the picture, with the library's own choice of core_pixels. */
static void a_peak_keeps_its_brightness_until_the_core_is_but_a_few_pixels_wide(void **state)
{
    (void)state;
    static const double ends[2][3] = {{-200, 0, 0}, {200, 0, 0}};
    static stage_picture found;
    const double core = 0.3, reach = 3, brightness = 0.8;
    const ew_point orb = {.brightness = brightness, .core = core, .reach = reach};
    const ew_path beam = {.points = ends, .point_count = 2, .brightness = brightness, .core = core, .reach = reach};
    const ew_sources_desc sources[] = {{.points = &orb, .point_count = 1}, {.paths = &beam, .path_count = 1}};
    for (int kind = 0; kind < 2; kind++) {
        double before = brightness;
        stage_set(&sources[kind]);
        for (double distance = 4; distance < 100; distance *= 1.3) {
            ew_frame_desc frame = stage_frame(distance);
            frame.core_pixels = 0;
            stage_measure(&frame, found);
            assert_true(fabs((double)found[STAGE_HEIGHT / 2][STAGE_WIDTH / 2][0] / brightness - 1) <= 1e-3);
            frame.core_pixels = EW_CORE_PIXELS_DEFAULT;
            stage_measure(&frame, found);
            double peak = (double)found[STAGE_HEIGHT / 2][STAGE_WIDTH / 2][0], pixels = 2 * core / stage_pixel(distance);
            if (pixels >= 6) assert_true(fabs(peak / brightness - 1) <= 0.01);
            assert_true(peak <= before * 1.0001); /* then it fades, and never comes back */
            before = peak;
        }
    }
}

/* One source of each kind. */
typedef struct world {
    ew_point point;
    ew_line line;
    ew_torus torus;
    ew_curve curve;
    ew_path paths[4];
    double points[4][4][3];
    ew_sources_desc desc;
} world;

static void make_world(world *w, double scale)
{
    static const double shape[4][3] = {{-1, -0.7, 0.2}, {-0.4, 0.8, -0.3}, {0.5, -0.6, 0.4}, {1.1, 0.6, 0}};
    const double core = 0.03 * scale, reach = 0.9 * scale;
    *w = (world){
        .point = {.position = {0.3 * scale, 0.2 * scale, 0}, .brightness = 0.7, .core = core, .reach = reach},
        .line = {.position = {0, -0.5 * scale, 0}, .direction = {1, 0.2, 0.3}, .brightness = 0.5, .core = core, .reach = reach},
        .torus = {.axis = {0.2, 1, 0.4}, .radius = 0.8 * scale, .brightness = 0.6, .core = core, .reach = reach},
        .curve = {.polynomial = {{-scale, 0.4 * scale, 0}, {scale, 1.4 * scale, 0.2 * scale}, {scale, -1.6 * scale, 0}},
                  .domain = {0, 1},
                  .brightness = 0.4,
                  .core = core,
                  .reach = reach,
                  .sharpness = 2},
        .desc = {.points = &w->point,
                 .point_count = 1,
                 .lines = &w->line,
                 .line_count = 1,
                 .tori = &w->torus,
                 .torus_count = 1,
                 .curves = &w->curve,
                 .curve_count = 1,
                 .paths = w->paths,
                 .path_count = 4},
    };
    for (int kind = 0; kind < 4; kind++) {
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++)
                w->points[kind][i][k] = scale * (shape[(i + kind) % 4][k] + 0.1 * kind);
        w->paths[kind] = (ew_path){.kind = (ew_path_kind)kind,
                                   .points = (const double(*)[3])w->points[kind],
                                   .point_count = 4,
                                   .brightness = 0.3,
                                   .core = core,
                                   .reach = reach};
    }
}

static void a_world_is_the_same_in_every_unit_of_length(void **state)
{
    (void)state;
    static const double scales[] = {1e-3, 1e4};
    static stage_picture expected, found;
    world w;
    make_world(&w, 1);
    stage_set(&w.desc);
    ew_frame_desc frame = stage_frame(4);
    stage_measure(&frame, expected);
    assert_true(stage_peak(expected) > 0.5);
    for (int i = 0; i < 2; i++) {
        make_world(&w, scales[i]);
        stage_set(&w.desc);
        frame = stage_frame(4 * scales[i]);
        stage_measure(&frame, found);
        double difference = stage_difference(found, expected);
        fprintf(stderr, "scaled by %g: off by %.2g\n", scales[i], difference);
        assert_true(difference <= 2e-4);
    }
}

/* ---- Joints ------------------------------------------------------------------------------------------------------------- */

enum { MAX_PIECES = 48 };

/* A chain of straight pieces, from corner to corner, each cut into `cuts`. */
typedef struct chain {
    const char *name;
    int corner_count;
    double corners[5][3];
    int is_closed;
} chain;

static const chain chains[] = {
    {"a beam", 2, {{-3, -0.2, 0}, {3, 0.3, 0.4}}, 0},
    {"a beam along the view", 2, {{0.1, 0, -4}, {0.1, 0.02, 4}}, 0},
    {"a corner", 3, {{-2, -1, 0}, {0.2, 0.8, 0.3}, {2, -1, -0.5}}, 0},
    {"a hairpin", 3, {{-2, 0, 0}, {2, 0.1, 0}, {-2, 0.2, 0}}, 0},
    {"a square", 4, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, 1},
};

static size_t cut(const chain *whole, int cuts, double points[][3])
{
    size_t count = 0;
    int spans = whole->corner_count - (whole->is_closed ? 0 : 1);
    for (int span = 0; span < spans; span++)
        for (int i = 0; i < cuts; i++, count++)
            for (int k = 0; k < 3; k++) {
                double from = whole->corners[span][k], to = whole->corners[(span + 1) % whole->corner_count][k];
                points[count][k] = from + (to - from) * i / cuts;
            }
    if (!whole->is_closed) memcpy(points[count++], whole->corners[whole->corner_count - 1], sizeof points[0]);
    return count;
}

static void measure_cut(const chain *whole, int cuts, ew_path_kind kind, const ew_frame_desc *frame, stage_picture found)
{
    double points[5 * MAX_PIECES + 1][3];
    ew_path path = {.kind = kind, .points = (const double(*)[3])points, .is_closed = whole->is_closed};
    path.point_count = cut(whole, cuts, points);
    path.brightness = 0.8;
    path.core = 0.05;
    path.reach = 1.5;
    stage_set(&(ew_sources_desc){.paths = &path, .path_count = 1});
    stage_measure(frame, found);
}

static void check_cuts(const ew_frame_desc *frame, const char *how)
{
    static const int cuts[] = {2, 6, 24};
    static stage_picture whole, found;
    for (size_t i = 0; i < sizeof chains / sizeof chains[0]; i++) {
        measure_cut(&chains[i], 1, EW_PATH_POLYLINE, frame, whole);
        assert_true(stage_peak(whole) > 0.01);
        for (int j = 0; j < 3; j++) {
            measure_cut(&chains[i], cuts[j], EW_PATH_POLYLINE, frame, found);
            double difference = stage_difference(found, whole);
            fprintf(stderr, "%s cut into %d, %s: off by %.2g\n", chains[i].name, cuts[j], how, difference);
            assert_true(difference <= 1e-4);
        }
    }
}

static void a_path_cut_into_pieces_is_the_same(void **state)
{
    (void)state;
    ew_frame_desc frame = stage_frame(8);
    check_cuts(&frame, "from afar");
    frame.core_pixels = 0;
    check_cuts(&frame, "with cores as they are");
    frame = stage_frame(0.7);
    check_cuts(&frame, "from within the reach");
    frame = stage_frame(8);
    frame.interval_start = 6;
    frame.interval_end = 12;
    check_cuts(&frame, "by the papers' integral");
}

/* Splines through points that lie evenly on a line are that line. */
static void a_straight_spline_is_a_straight_beam(void **state)
{
    (void)state;
    static const ew_path_kind kinds[] = {EW_PATH_BSPLINE, EW_PATH_BEZIER, EW_PATH_CATMULL_ROM};
    static stage_picture whole, found;
    ew_frame_desc frame = stage_frame(8);
    for (int i = 0; i < 2; i++) {
        measure_cut(&chains[i], 1, EW_PATH_POLYLINE, &frame, whole);
        for (int kind = 0; kind < 3; kind++) {
            measure_cut(&chains[i], 6, kinds[kind], &frame, found);
            double difference = stage_difference(found, whole);
            fprintf(stderr, "%s as kind %d: off by %.2g\n", chains[i].name, (int)kinds[kind], difference);
            assert_true(difference <= 1e-4);
        }
    }
}

/* ---- Thin beams --------------------------------------------------------------------------------------------------------- */

/* Cores from well over a pixel to far below one, at a distance of 60, where a pixel is about 0.76. */
static const double thin_cores[] = {0.8, 0.3, 0.1, 0.03, 0.001};
enum { THIN_COUNT = sizeof thin_cores / sizeof thin_cores[0] };

typedef enum beam_kind { BEAM_LINE, BEAM_PATH, BEAM_CHAIN, BEAM_CURVE, BEAM_SPLINE, BEAM_COUNT } beam_kind;

/* A beam through (0, y, 0), level or aslant, of every kind that has beams. */
static void set_beam(beam_kind kind, double core, double y, double rise)
{
    enum { COUNT = 9 };
    double points[COUNT][3];
    for (int i = 0; i < COUNT; i++) {
        double x = 15.0 * (i - COUNT / 2);
        memcpy(points[i], (const double[3]){x, y + rise * x, 0}, sizeof points[i]);
    }
    double ends[2][3], reach = 8;
    memcpy(ends[0], points[0], sizeof ends[0]);
    memcpy(ends[1], points[COUNT - 1], sizeof ends[1]);
    const ew_line line = {.position = {0, y, 0}, .direction = {1, rise, 0}, .brightness = 1, .core = core, .reach = reach};
    const ew_curve curve = {.polynomial = {{-60, y - 60 * rise, 0}, {120, 120 * rise, 0}, {0}},
                            .domain = {0, 1},
                            .brightness = 1,
                            .core = core,
                            .reach = reach};
    ew_path path = {.points = (const double(*)[3])ends, .point_count = 2, .brightness = 1, .core = core, .reach = reach};
    if (kind == BEAM_CHAIN || kind == BEAM_SPLINE) {
        path.points = (const double(*)[3])points;
        path.point_count = COUNT;
        if (kind == BEAM_SPLINE) path.kind = EW_PATH_CATMULL_ROM;
    }
    ew_sources_desc desc = {.lines = &line, .line_count = kind == BEAM_LINE};
    desc.curves = &curve;
    desc.curve_count = kind == BEAM_CURVE;
    desc.paths = &path;
    desc.path_count = kind == BEAM_PATH || kind == BEAM_CHAIN || kind == BEAM_SPLINE;
    stage_set(&desc);
}

/* The brightest pixel of a column, less what is brighter because the ray goes through the beam aslant. */
static double brightest_of_column(stage_picture found, int column, double rise)
{
    double brightest = 0, x = (2 * column + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT, along = x * (1 + rise * rise);
    for (int row = 0; row < STAGE_HEIGHT; row++)
        brightest = fmax(brightest, (double)found[row][column][0]);
    return brightest * sqrt(1 - along * along / ((1 + along * x) * (1 + rise * rise)));
}

static void a_slanted_beam_has_no_beads(void **state)
{
    (void)state;
    static stage_picture found;
    const double rise = 0.06;
    ew_frame_desc frame = stage_frame(60);
    for (int kind = 0; kind < BEAM_COUNT; kind++)
        for (int i = 0; i < THIN_COUNT; i++) {
            double least = 1e9, most = 0;
            set_beam((beam_kind)kind, thin_cores[i], 0, rise);
            stage_measure(&frame, found);
            for (int column = 10; column < STAGE_WIDTH - 10; column++) {
                double brightest = brightest_of_column(found, column, rise);
                least = fmin(least, brightest);
                most = fmax(most, brightest);
            }
            fprintf(stderr, "beam %d, core of %.3f pixels: beads of %.3f\n", kind, thin_cores[i] / stage_pixel(60),
                    most / least);
            assert_true(most <= 1.05 * least);
        }
}

static void a_drifting_beam_does_not_flicker(void **state)
{
    (void)state;
    static stage_picture found;
    ew_frame_desc frame = stage_frame(60);
    for (int kind = 0; kind < BEAM_COUNT; kind++)
        for (int i = 0; i < THIN_COUNT; i++) {
            double least = 1e9, most = 0;
            for (int step = 0; step < 16; step++) {
                set_beam((beam_kind)kind, thin_cores[i], step / 16.0 * stage_pixel(60), 0);
                stage_measure(&frame, found);
                double brightest = brightest_of_column(found, STAGE_WIDTH / 2, 0);
                least = fmin(least, brightest);
                most = fmax(most, brightest);
            }
            fprintf(stderr, "beam %d, core of %.3f pixels: flicker of %.3f\n", kind, thin_cores[i] / stage_pixel(60),
                    most / least);
            assert_true(most <= 1.05 * least);
        }
}

int main(int argc, char **argv)
{
    if (argc != 2 || !stage_open(argv[1])) return 2;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_orb_is_the_same_from_every_distance),
        cmocka_unit_test(a_peak_keeps_its_brightness_until_the_core_is_but_a_few_pixels_wide),
        cmocka_unit_test(a_world_is_the_same_in_every_unit_of_length),
        cmocka_unit_test(a_path_cut_into_pieces_is_the_same),
        cmocka_unit_test(a_straight_spline_is_a_straight_beam),
        cmocka_unit_test(a_slanted_beam_has_no_beads),
        cmocka_unit_test(a_drifting_beam_does_not_flicker),
        cmocka_unit_test(gl_has_nothing_to_say),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    stage_close();
    return failed;
}
