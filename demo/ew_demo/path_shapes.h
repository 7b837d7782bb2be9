/*
 * The shapes of the court's paths, as points. Each is a pure function, and moves without a jump.
 */
#ifndef PATH_SHAPES_H
#define PATH_SHAPES_H

#include <stddef.h>

/* A clock that comes back to where it began after `period` seconds. */
typedef struct path_clock {
    double seconds;
    double period;
} path_clock;

/* Smooth noise in [-1, 1] that takes a new value `rate` times a second, where rate times the period is an integer. */
double path_noise(path_clock clock, int rate, unsigned seed);

/* A bolt of lightning from `start` to `end` that writhes. It strays from the straight line by some `spread` times its length.
 * Bolts of different seeds differ. */
void path_make_bolt(const double start[3], const double end[3], double spread, path_clock clock, unsigned seed,
                    double (*points)[3], size_t count);

typedef struct path_helix {
    double base[3]; /* the axis goes up from here */
    double height;
    double radii[2]; /* at the base and at the top */
    double turns;
    double start_angle; /* radians */
} path_helix;

void path_make_helix(const path_helix *helix, double (*points)[3], size_t count);

typedef struct path_arc {
    double center[3];
    double axis[3];  /* the arc lies across it */
    double start[3]; /* from the center towards the first point, if not across the axis then as near as can be */
    double radius;
    double angle; /* radians, about the axis */
} path_arc;

void path_make_arc(const path_arc *arc, double (*points)[3], size_t count);

#endif
