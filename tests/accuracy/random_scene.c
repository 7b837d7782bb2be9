/* Scenes made up at random: see random_scene.h. */
#include "random_scene.h"
#include "random_numbers.h"
#include "vector.h"

#include <stdio.h>
#include <stdlib.h>

const char *const random_scene_kind_names[RANDOM_SCENE_KIND_COUNT] = {
    "point", "line", "torus", "curve", "weighted curve", "two curves", "mix", "many",
};

/* A scene in the making. */
typedef struct maker {
    uint64_t random;
    FILE *file;
    double distance; /* from the eye to the place that it looks at: D */
    double epsilon;
    double eye[3];
    double place[3];   /* on the first source */
    double forward[3]; /* unit */
} maker;

/* ---- Numbers ------------------------------------------------------------------------------------------------------------ */

static double uniform(maker *m, double low, double high)
{
    return low + random_unit(&m->random) * (high - low);
}

/* Of all magnitudes alike. */
static double magnitude(maker *m, double low, double high)
{
    return low * pow(high / low, random_unit(&m->random));
}

static bool chance(maker *m, double probability)
{
    return random_unit(&m->random) < probability;
}

/* A unit vector, all directions alike. */
static void random_direction(maker *m, double result[3])
{
    double z = uniform(m, -1, 1), angle = uniform(m, 0, 2 * M_PI), across = sqrt(1 - z * z);
    result[0] = across * cos(angle);
    result[1] = across * sin(angle);
    result[2] = z;
}

/* A vector in the ball of the given radius. */
static void random_offset(maker *m, double radius, double result[3])
{
    double direction[3], zero[3] = {0, 0, 0};
    random_direction(m, direction);
    vector_add_scaled(zero, radius * cbrt(uniform(m, 0, 1)), direction, result);
}

/* ---- Sources ------------------------------------------------------------------------------------------------------------ */

static void write_vector(maker *m, const char *key, const double vector[3])
{
    fprintf(m->file, "\"%s\": [%.17g, %.17g, %.17g], ", key, vector[0], vector[1], vector[2]);
}

static void write_coefficient(maker *m)
{
    fprintf(m->file, "\"coefficient\": %.3g", m->distance * uniform(m, 0.1, 1));
}

static double source_size(maker *m)
{
    return m->distance * magnitude(m, 3e-3, 5);
}

/* A place that a source is to go through: the one that the eye looks at, or for all but the first one around it. */
static void source_place(maker *m, bool first, double place[3])
{
    double offset[3];
    random_offset(m, first ? 0 : source_size(m), offset);
    vector_add_scaled(m->place, 1, offset, place);
}

static void write_point(maker *m, bool first)
{
    double place[3];
    source_place(m, first, place);
    write_vector(m, "position", place);
}

static void write_line(maker *m, bool first)
{
    double place[3], direction[3], along[3];
    source_place(m, first, place);
    random_direction(m, direction);
    if (chance(m, 0.15)) { /* nearly along the view */
        vector_add_scaled(m->forward, magnitude(m, 1e-5, 1e-1), direction, along);
        vector_copy(along, direction);
    }
    vector_add_scaled(place, uniform(m, -1, 1) * m->distance, direction, place);
    write_vector(m, "position", place);
    write_vector(m, "direction", direction);
}

static void write_torus(maker *m, bool first)
{
    double center[3], axis[3], across[3], radial[3], radius = source_size(m);
    source_place(m, first, center);
    random_direction(m, axis);
    random_direction(m, across);
    if (chance(m, 0.1)) { /* seen along its axis, but for so little */
        vector_add_scaled(m->forward, magnitude(m, 1e-5, 1e-1), across, axis);
        random_direction(m, across);
    }
    vector_cross(axis, across, radial);
    vector_normalize(radial, radial);
    vector_add_scaled(center, -radius, radial, center);
    write_vector(m, "center", center);
    write_vector(m, "axis", axis);
    fprintf(m->file, "\"radius\": %.17g, ", radius);
}

/* A parabola's polynomial, but for where it is, and its domain. */
static void random_arc(maker *m, double polynomial[3][3], double domain[2])
{
    double size = source_size(m), points[3][3], shape = uniform(m, 0, 1);
    for (int i = 0; i < 3; i++)
        random_offset(m, size, points[i]);
    domain[0] = 0;
    domain[1] = 1;
    if (shape < 0.1) { /* nearly straight */
        double bend = magnitude(m, 1e-7, 1e-1);
        for (int i = 0; i < 3; i++)
            points[1][i] = 0.5 * (points[0][i] + points[2][i]) + bend * points[1][i];
    } else if (shape < 0.15) { /* two points coincide */
        vector_copy(points[chance(m, 0.5) ? 0 : 2], points[1]);
    } else if (shape < 0.25) { /* a bend about the vertex */
        double width = magnitude(m, 1e-4, 1);
        for (int i = 0; i < 3; i++) {
            polynomial[1][i] = width * points[1][i];
            polynomial[2][i] = points[2][i];
        }
        domain[0] = uniform(m, -1, 0.5);
        return;
    } else if (shape < 0.3) { /* far from the vertex */
        double length = magnitude(m, 1e-2, 1), start = uniform(m, -20, 20);
        for (int i = 0; i < 3; i++) {
            polynomial[1][i] = points[1][i] / length - 2 * start * points[2][i];
            polynomial[2][i] = points[2][i];
        }
        domain[0] = start;
        domain[1] = start + length;
        return;
    }
    for (int i = 0; i < 3; i++) {
        polynomial[1][i] = 2 * (points[1][i] - points[0][i]);
        polynomial[2][i] = points[0][i] - 2 * points[1][i] + points[2][i];
    }
}

static void write_weights(maker *m)
{
    static const int counts[] = {1, 2, 3, 4, 5, 7, 16, 64};
    int count = counts[random_index(&m->random, sizeof counts / sizeof *counts)];
    fputs("\"weights\": [", m->file);
    for (int i = 0; i < count; i++)
        fprintf(m->file, "%s%.3g", i ? ", " : "", chance(m, 0.2) ? 0 : uniform(m, 0, 1));
    fputs("], ", m->file);
}

static void write_curve(maker *m, bool first, bool weighted)
{
    double polynomial[3][3], domain[2], place[3];
    random_arc(m, polynomial, domain);
    source_place(m, first, place);
    /* Ends are looked at more often than their share. */
    double t = chance(m, 0.3) ? domain[chance(m, 0.5)] : uniform(m, domain[0], domain[1]);
    for (int i = 0; i < 3; i++)
        polynomial[0][i] = place[i] - t * (polynomial[1][i] + t * polynomial[2][i]);
    fputs("\"polynomial\": [", m->file);
    for (int i = 0; i < 3; i++)
        fprintf(m->file, "[%.17g, %.17g, %.17g]%s", polynomial[i][0], polynomial[i][1], polynomial[i][2], i < 2 ? ", " : "");
    fprintf(m->file, "], \"domain\": [%.17g, %.17g], ", domain[0], domain[1]);
    if (weighted) write_weights(m);
}

static void write_sources(maker *m, random_scene_kind kind)
{
    static const char *const keys[] = {"points", "lines", "tori", "curves"};
    static const int counts[RANDOM_SCENE_KIND_COUNT][4] = {
        [RANDOM_POINT] = {1, 0, 0, 0}, [RANDOM_LINE] = {0, 1, 0, 0},           [RANDOM_TORUS] = {0, 0, 1, 0},
        [RANDOM_CURVE] = {0, 0, 0, 1}, [RANDOM_WEIGHTED_CURVE] = {0, 0, 0, 1}, [RANDOM_TWO_CURVES] = {0, 0, 0, 2},
        [RANDOM_MIX] = {1, 1, 1, 1},   [RANDOM_MANY] = {5, 5, 5, 5},
    };
    bool first = true;
    for (int list = 0; list < 4; list++)
        for (int i = 0; i < counts[kind][list]; i++) {
            fprintf(m->file, i == 0 ? ",\n  \"%s\": [\n    { " : ",\n    { ", keys[list]);
            if (list == 0) write_point(m, first);
            if (list == 1) write_line(m, first);
            if (list == 2) write_torus(m, first);
            /* Of two curves, the first has weights. */
            if (list == 3) write_curve(m, first, kind != RANDOM_CURVE && i == 0);
            write_coefficient(m);
            fputs(i + 1 == counts[kind][list] ? " }\n  ]" : " }", m->file);
            first = false;
        }
}

/* ---- The rest of the scene ---------------------------------------------------------------------------------------------- */

static void write_camera(maker *m)
{
    double target[3], up[3], offset[3];
    bool orthographic = chance(m, 0.15), in_core = chance(m, 0.05);
    double least = fmax(1e-4, 20 * m->epsilon / m->distance);
    double height = m->distance * (chance(m, 0.6) ? magnitude(m, 0.1, 3) : magnitude(m, fmin(least, 1), 1));
    random_direction(m, up);
    random_offset(m, 0.4 * height, offset);
    vector_add_scaled(m->place, 1, offset, target);
    if (in_core) {
        random_offset(m, m->epsilon, offset);
        vector_add_scaled(m->place, 1, offset, m->eye);
        vector_add_scaled(m->eye, m->distance, m->forward, target);
    }
    fputs("  \"camera\": { ", m->file);
    write_vector(m, "eye", m->eye);
    write_vector(m, "target", target);
    write_vector(m, "up", up);
    if (orthographic)
        fprintf(m->file, "\"projection\": \"orthographic\", \"height\": %.17g, ", height);
    else
        fprintf(m->file, "\"fov_y_degrees\": %.17g, ", 360 / M_PI * atan(0.5 * height / m->distance));

    double ratio = magnitude(m, 1.2, 1e4), share = chance(m, 0.85) ? uniform(m, 0.02, 0.98) : uniform(m, -0.2, 1.2);
    double start = m->distance * pow(ratio, -share), end = start * ratio;
    double near_depth = fmax(start, 1e-3 * m->distance) * magnitude(m, 0.1, 0.9), far_depth = fmax(end, m->distance) * 2;
    fprintf(m->file, "\"near\": %.17g, \"far\": %.17g },\n", near_depth, far_depth);
    fprintf(m->file, "  \"interval\": { \"start\": %.17g, \"end\": %.17g },\n", start, end);
    fprintf(m->file, "  \"decay\": { \"alpha\": 1, \"beta\": %.17g },\n", magnitude(m, 0.05, 4));
    fprintf(m->file, "  \"epsilon\": %.17g", m->epsilon);
}

static void write_opaque(maker *m)
{
    double place[3], across[3], normal[3], along, which = uniform(m, 0, 1);
    if (which < 0.3)
        along = -magnitude(m, m->epsilon, 0.5 * m->distance);
    else if (which < 0.6)
        along = uniform(m, -1, 1) * m->epsilon;
    else
        along = magnitude(m, m->epsilon, 0.5 * m->distance);
    vector_add_scaled(m->place, along, m->forward, place);
    random_direction(m, across);
    if (chance(m, 0.7)) {
        vector_add_scaled(m->forward, 0.8, across, normal);
        fputs(",\n  \"opaque\": [ { \"shape\": \"plane\", ", m->file);
        write_vector(m, "point", place);
        fprintf(m->file, "\"normal\": [%.17g, %.17g, %.17g] } ]", -normal[0], -normal[1], -normal[2]);
        return;
    }
    double size = m->distance * magnitude(m, 1e-3, 1), min[3], max[3];
    vector_add_scaled(place, size, m->forward, place);
    for (int i = 0; i < 3; i++) {
        min[i] = place[i] - size;
        max[i] = place[i] + size;
    }
    fputs(",\n  \"opaque\": [ { \"shape\": \"box\", ", m->file);
    write_vector(m, "min", min);
    fprintf(m->file, "\"max\": [%.17g, %.17g, %.17g] } ]", max[0], max[1], max[2]);
}

/* The first numbers of a seed's sequence choose the kind. */
static random_scene_kind choose_kind(maker *m)
{
    static const double shares[RANDOM_SCENE_KIND_COUNT] = {
        [RANDOM_POINT] = 0.06,          [RANDOM_LINE] = 0.08,       [RANDOM_TORUS] = 0.16, [RANDOM_CURVE] = 0.2,
        [RANDOM_WEIGHTED_CURVE] = 0.25, [RANDOM_TWO_CURVES] = 0.08, [RANDOM_MIX] = 0.12,   [RANDOM_MANY] = 0.05,
    };
    double left = random_unit(&m->random);
    int kind = 0;
    while (kind < RANDOM_SCENE_KIND_COUNT - 1 && left >= shares[kind])
        left -= shares[kind++];
    return (random_scene_kind)kind;
}

random_scene_kind random_scene_kind_of(uint64_t seed)
{
    maker m = {.random = seed};
    return choose_kind(&m);
}

char *random_scene_text(uint64_t seed)
{
    char *text = NULL;
    size_t size;
    maker m = {.random = seed, .file = open_memstream(&text, &size)};
    if (!m.file) return NULL;
    random_scene_kind kind = choose_kind(&m);
    m.distance = magnitude(&m, 1e-3, 1e5);
    m.epsilon = m.distance * magnitude(&m, 1e-6, 1e-1);
    random_direction(&m, m.forward);
    random_offset(&m, chance(&m, 0.5) ? 0 : m.distance * magnitude(&m, 1, 1e5), m.eye);
    vector_add_scaled(m.eye, m.distance, m.forward, m.place);

    fprintf(m.file, "{\n  \"comment\": \"Random scene %llu.\",\n", (unsigned long long)seed);
    write_camera(&m);
    write_sources(&m, kind);
    if (chance(&m, 0.5)) write_opaque(&m);
    fputs("\n}\n", m.file);
    bool ok = !ferror(m.file);
    if (fclose(m.file) == 0 && ok) return text;
    free(text);
    return NULL;
}
