/* Random descriptors: see random_desc.h. */
#include "random_desc.h"

#include "random_numbers.h"
#include "vector.h"

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

static double between(uint64_t *random, double low, double high)
{
    return low + (high - low) * random_unit(random);
}

/* 10 to a power between the two. */
static double magnitude(uint64_t *random, double low, double high)
{
    return pow(10, between(random, low, high));
}

static bool chance(uint64_t *random, double probability)
{
    return random_unit(random) < probability;
}

/* ---- Valid ones --------------------------------------------------------------------------------------------------------- */

/* A random turn, by the axes of a random orthogonal frame; now and then mirrored. Rows of the view's rotation. */
static void random_axes(uint64_t *random, double axes[3][3])
{
    double seed[2][3];
    for (int i = 0; i < 6; i++)
        seed[i / 3][i % 3] = between(random, -1, 1);
    vector_normalize(seed[0], axes[0]);
    vector_cross(axes[0], seed[1], axes[1]);
    vector_normalize(axes[1], axes[1]);
    vector_cross(axes[0], axes[1], axes[2]);
    if (chance(random, 0.1))
        for (int i = 0; i < 3; i++)
            axes[2][i] = -axes[2][i];
}

/* The place of the sources and how large things are there. */
typedef struct place {
    uint64_t *random;
    bool extreme;
    double axes[3][3]; /* of the view, in the world */
    double eye[3];
    double start, end;        /* of the interval */
    double slope[2], size[2]; /* what is seen, from the view's axis: slope * depth + size */
} place;

static void to_world(const place *at, const double view[3], double world[3])
{
    for (int i = 0; i < 3; i++)
        world[i] = at->eye[i] + at->axes[0][i] * view[0] + at->axes[1][i] * view[1] + at->axes[2][i] * view[2];
}

/* A position that is seen, most often; of the extreme ones some are at the eye, on its axis, or where the interval ends. */
static void random_position(const place *at, double world[3])
{
    uint64_t *random = at->random;
    double depth = between(random, at->start, at->end), view[3];
    double wide = at->extreme && chance(random, 0.1) ? magnitude(random, 0, 4) : 1;
    if (at->extreme && chance(random, 0.2)) depth = chance(random, 0.5) ? at->start : at->end;
    if (at->extreme && chance(random, 0.05)) depth = 0;
    for (int i = 0; i < 2; i++)
        view[i] = wide * (at->slope[i] * depth + at->size[i]) * between(random, -1, 1);
    if (at->extreme && chance(random, 0.2)) view[0] = view[1] = 0;
    view[2] = -depth;
    to_world(at, view, world);
}

static void random_direction(const place *at, double world[3])
{
    double length = at->extreme ? magnitude(at->random, -300, 300) : 1;
    bool along_an_axis = at->extreme && chance(at->random, 0.3);
    size_t axis = random_index(at->random, 3);
    for (int i = 0; i < 3; i++)
        world[i] = length * (along_an_axis ? at->axes[axis][i] : between(at->random, -1, 1));
}

static void random_light(const place *at, double *coefficient, double color[3])
{
    *coefficient = at->extreme ? magnitude(at->random, -9, 9) : between(at->random, 0, 5);
    if (chance(at->random, 0.02)) *coefficient = 0;
    for (int i = 0; i < 3; i++)
        color[i] = at->extreme && chance(at->random, 0.1) ? 65504 : between(at->random, 0, 1);
}

static void random_arc(const place *at, ew_curve *curve)
{
    uint64_t *random = at->random;
    double points[3][3];
    for (int i = 0; i < 3; i++)
        random_position(at, points[i]);
    if (at->extreme) {
        double fold = between(random, -1, 2), close = magnitude(random, -12, 0);
        switch (random_index(random, 6)) {
        case 0: /* straight, or folded back on itself */
            for (int i = 0; i < 3; i++)
                points[1][i] = points[0][i] + fold * (points[2][i] - points[0][i]);
            break;
        case 1: /* nearly straight */
            for (int i = 0; i < 3; i++)
                points[1][i] = points[0][i] / 2 + points[2][i] / 2 + close * (points[1][i] - points[0][i]);
            break;
        case 2: /* two of them, or all, coincide or nearly so */
            for (int i = 0; i < 3; i++) {
                points[1][i] = points[0][i] + close * (points[1][i] - points[0][i]);
                if (fold < 0) points[2][i] = points[0][i];
            }
            break;
        case 3: /* a hairpin */
            for (int i = 0; i < 3; i++)
                points[2][i] = points[0][i] + close * (points[2][i] - points[0][i]);
            break;
        default:
            break;
        }
    }
    ew_bezier_polynomial(points, curve->polynomial);
    curve->domain[0] = 0;
    curve->domain[1] = 1;
    if (at->extreme && chance(random, 0.2)) {
        curve->domain[0] = between(random, -2, 2);
        curve->domain[1] = curve->domain[0] + magnitude(random, -6, 1);
    }
}

static void random_sources(random_desc *desc, const shader_mix *mix, const place *at)
{
    uint64_t *random = at->random;
    double length = at->end - at->start;
    desc->sources = (ew_sources_desc){
        .points = desc->points,
        .point_count = mix->points,
        .lines = desc->lines,
        .line_count = mix->lines,
        .tori = desc->tori,
        .torus_count = mix->tori,
        .curves = desc->curves,
        .curve_count = mix->curves,
        .epsilon = length * (at->extreme ? magnitude(random, -9, 1) : magnitude(random, -4, -1)),
    };
    for (size_t i = 0; i < mix->points; i++) {
        random_position(at, desc->points[i].position);
        random_light(at, &desc->points[i].coefficient, desc->points[i].color);
    }
    for (size_t i = 0; i < mix->lines; i++) {
        random_position(at, desc->lines[i].position);
        random_direction(at, desc->lines[i].direction);
        random_light(at, &desc->lines[i].coefficient, desc->lines[i].color);
    }
    for (size_t i = 0; i < mix->tori; i++) {
        random_position(at, desc->tori[i].center);
        random_direction(at, desc->tori[i].axis);
        desc->tori[i].radius = length * (at->extreme ? magnitude(random, -9, 3) : between(random, 0, 1));
        if (at->extreme && chance(random, 0.1)) desc->tori[i].radius = 0;
        random_light(at, &desc->tori[i].coefficient, desc->tori[i].color);
    }
    for (size_t i = 0; i < mix->curves; i++) {
        ew_curve *curve = &desc->curves[i];
        *curve = (ew_curve){0};
        random_arc(at, curve);
        random_light(at, &curve->coefficient, curve->color);
        if (mix->weighted) {
            curve->weights = desc->weights[i];
            curve->weight_count = 1 + random_index(random, MAX_WEIGHTS);
            for (size_t j = 0; j < MAX_WEIGHTS; j++)
                desc->weights[i][j] =
                    at->extreme ? magnitude(random, -9, 3) * (double)random_index(random, 3) : random_unit(random);
        }
    }
}

static void random_view(place *at, double distance_from_the_origin, double view[16])
{
    random_axes(at->random, at->axes);
    for (int i = 0; i < 3; i++)
        at->eye[i] = distance_from_the_origin * between(at->random, -1, 1);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            view[4 * column + row] = at->axes[row][column];
        view[12 + row] = -vector_dot(at->axes[row], at->eye);
        view[4 * row + 3] = 0;
    }
    view[15] = 1;
}

static void random_projection(place *at, ew_frame_desc *frame, double aspect)
{
    uint64_t *random = at->random;
    double near = at->start * between(random, 0.5, 1), far = at->end * between(random, 1, 2), *p = frame->projection;
    bool parallel = chance(random, 0.2), infinite = !parallel && chance(random, 0.3);
    double half = parallel ? (at->end - at->start) * between(random, 0.1, 2)
                           : tan(between(random, 0.5, at->extreme ? 89 : 60) * 3.14159265358979 / 180);
    memset(p, 0, 16 * sizeof *p);
    p[0] = 1 / (half * aspect);
    p[5] = 1 / half;
    frame->clip_depth = chance(random, 0.5) ? EW_CLIP_DEPTH_ZERO_TO_ONE : EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE;
    if (chance(random, 0.3)) { /* off-axis */
        p[parallel ? 12 : 8] = between(random, -1, 1);
        p[parallel ? 13 : 9] = between(random, -1, 1);
    }
    /* Window depth is `nearest` at near and `farthest` at far, reversed or not. */
    double nearest = frame->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? 0 : -1, farthest = 1;
    if (chance(random, 0.5)) {
        farthest = nearest;
        nearest = 1;
    }
    if (parallel) {
        p[10] = (nearest - farthest) / (far - near);
        p[14] = nearest + near * p[10];
        p[15] = 1;
    } else {
        p[11] = -1;
        p[10] = infinite ? -farthest : (nearest * near - farthest * far) / (far - near);
        p[14] = infinite ? near * (nearest - farthest) : near * far * (nearest - farthest) / (far - near);
    }
    at->slope[0] = parallel ? 0 : half * aspect;
    at->slope[1] = parallel ? 0 : half;
    at->size[0] = parallel ? half * aspect : 0;
    at->size[1] = parallel ? half : 0;
}

void random_desc_make(random_desc *desc, const shader_mix *mix, bool extreme, int width, int height, uint64_t *random)
{
    place at = {.random = random, .extreme = extreme};
    ew_frame_desc *frame = &desc->frame;
    *frame = (ew_frame_desc)EW_FRAME_DEFAULTS;
    double scale = extreme ? magnitude(random, -5, 5) : 1;
    at.start = scale * (extreme ? magnitude(random, -4, 1) : between(random, 0.1, 5));
    at.end = at.start * (1 + (extreme ? magnitude(random, -3, 4) : between(random, 0.5, 10)));
    frame->interval_start = at.start;
    frame->interval_end = at.end;
    random_view(&at, extreme ? scale * magnitude(random, -2, 5) : 10, frame->view);
    random_projection(&at, frame, (double)width / height);
    frame->decay_alpha = extreme ? magnitude(random, -3, 3) : 1;
    frame->decay_beta = extreme ? magnitude(random, -6, 6) : 1;
    frame->integrator = mix->integrator;
    frame->quality = (ew_quality)random_index(random, 3);
    frame->simpson_divisions = 2 * (int)magnitude(random, 0, 2);
    frame->output = mix->output;
    frame->encoding = mix->encoding;
    frame->dither = mix->dither;
    frame->skip_restore = chance(random, 0.2);
    frame->viewport_width = width;
    frame->viewport_height = height;
    random_sources(desc, mix, &at);
}

/* ---- Hostile ones ------------------------------------------------------------------------------------------------------- */

static double hostile_number(uint64_t *random)
{
    static const double numbers[] = {
        NAN,     -NAN,        INFINITY, -INFINITY, 0,    -0.0,  5e-324, -5e-324, DBL_MIN,     DBL_MAX, -DBL_MAX,
        FLT_MIN, 1e-45,       FLT_MAX,  -FLT_MAX,  1e39, 1e-39, 1e18,   -1e18,   1e154,       1e-154,  1e308,
        1e-300,  4294967296., 65504,    65505,     1e12, 1e6,   1e-6,   1e-12,   DBL_EPSILON, -1,      2,
    };
    return numbers[random_index(random, COUNT(numbers))];
}

static double any_number(uint64_t *random)
{
    if (chance(random, 0.1)) return hostile_number(random);
    return magnitude(random, -20, 20) * (chance(random, 0.5) ? 1 : -1);
}

/* The numbers of a descriptor, as runs of doubles. */
typedef struct number_run {
    double *first;
    size_t count;
} number_run;

enum { MAX_RUNS = 4 + 8 * MAX_KIND };

static size_t source_runs(random_desc *desc, number_run runs[MAX_RUNS])
{
    const ew_sources_desc *sources = &desc->sources;
    size_t count = 0;
    runs[count++] = (number_run){&desc->sources.epsilon, 1};
    for (size_t i = 0; i < sources->point_count; i++)
        runs[count++] = (number_run){(double *)&desc->points[i], sizeof(ew_point) / sizeof(double)};
    for (size_t i = 0; i < sources->line_count; i++)
        runs[count++] = (number_run){(double *)&desc->lines[i], sizeof(ew_line) / sizeof(double)};
    for (size_t i = 0; i < sources->torus_count; i++)
        runs[count++] = (number_run){(double *)&desc->tori[i], sizeof(ew_torus) / sizeof(double)};
    for (size_t i = 0; i < sources->curve_count; i++) {
        ew_curve *curve = &desc->curves[i];
        runs[count++] = (number_run){&curve->polynomial[0][0], 9};
        runs[count++] = (number_run){curve->domain, 2};
        runs[count++] = (number_run){&curve->coefficient, 1};
        runs[count++] = (number_run){curve->color, 3};
        runs[count++] = (number_run){desc->weights[i], curve->weight_count};
    }
    return count;
}

static size_t frame_runs(random_desc *desc, number_run runs[MAX_RUNS])
{
    ew_frame_desc *frame = &desc->frame;
    runs[0] = (number_run){frame->view, 16};
    runs[1] = (number_run){frame->projection, 16};
    runs[2] = (number_run){&frame->interval_start, 1};
    runs[3] = (number_run){&frame->interval_end, 1};
    runs[4] = (number_run){&frame->decay_alpha, 1};
    runs[5] = (number_run){&frame->decay_beta, 1};
    return 6;
}

static void spoil_one(const number_run *runs, size_t count, uint64_t *random)
{
    size_t run = random_index(random, count);
    if (runs[run].count > 0) runs[run].first[random_index(random, runs[run].count)] = hostile_number(random);
}

static void spoil_all(const number_run *runs, size_t count, uint64_t *random)
{
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < runs[i].count; j++)
            runs[i].first[j] = any_number(random);
}

void spoil_source_number(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_one(runs, source_runs(desc, runs), random);
}

void spoil_frame_number(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_one(runs, frame_runs(desc, runs), random);
}

void spoil_all_source_numbers(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_all(runs, source_runs(desc, runs), random);
}

void spoil_all_frame_numbers(random_desc *desc, uint64_t *random)
{
    number_run runs[MAX_RUNS];
    spoil_all(runs, frame_runs(desc, runs), random);
}

void spoil_lists(random_desc *desc, uint64_t *random)
{
    static const size_t too_many[] = {100000, SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / sizeof(ew_curve) + 1};
    ew_sources_desc *sources = &desc->sources;
    size_t count = too_many[random_index(random, COUNT(too_many))];
    bool missing = chance(random, 0.5);
    size_t missing_count = 1 + random_index(random, 3);
    switch (random_index(random, sources->curve_count > 0 ? 5 : 4)) {
    case 0:
        if (missing) sources->points = NULL;
        sources->point_count = missing ? missing_count : count;
        break;
    case 1:
        if (missing) sources->lines = NULL;
        sources->line_count = missing ? missing_count : count;
        break;
    case 2:
        if (missing) sources->tori = NULL;
        sources->torus_count = missing ? missing_count : count;
        break;
    case 3:
        if (missing) sources->curves = NULL;
        sources->curve_count = missing ? missing_count : count;
        break;
    default: {
        ew_curve *curve = &desc->curves[random_index(random, sources->curve_count)];
        curve->weights = missing ? NULL : desc->weights[0];
        curve->weight_count = missing ? missing_count : chance(random, 0.5) ? count : 0;
        break;
    }
    }
}

void spoil_frame_integer(random_desc *desc, uint64_t *random)
{
    static const int integers[] = {-1, 99, INT_MAX, INT_MIN, 255, 0x7fc00000};
    ew_frame_desc *frame = &desc->frame;
    int integer = integers[random_index(random, COUNT(integers))];
    switch (random_index(random, 11)) {
    case 0:
        frame->clip_depth = (ew_clip_depth)integer;
        break;
    case 1:
        frame->integrator = (ew_integrator)integer;
        break;
    case 2:
        frame->quality = (ew_quality)integer;
        break;
    case 3:
        frame->output = (ew_output)integer;
        break;
    case 4:
        frame->simpson_divisions = integer;
        break;
    case 5:
        frame->viewport_x = integer;
        break;
    case 6:
        frame->viewport_y = integer;
        break;
    case 7:
        frame->viewport_width = integer;
        break;
    case 8:
        frame->encoding = (ew_encoding)integer;
        break;
    case 9:
        frame->depth_source = (ew_depth_source)integer;
        break;
    default:
        frame->viewport_height = integer;
        break;
    }
}
