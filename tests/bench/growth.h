/*
 * How the time of a frame grows: with its pixels, its sources, what they cover, and its samples; and what the sources of a
 * frame cost the thread that draws it.
 */
#ifndef GROWTH_H
#define GROWTH_H

#include "context.h"

#include <stdbool.h>
#include <stddef.h>

enum { GROWTH_POINTS = 16, GROWTH_SERIES = 3 };

typedef struct growth_point {
    double x;
    double y[GROWTH_SERIES];
    double beside; /* what the sweep has beside: see growth_sweep */
} growth_point;

/* One quantity that is varied. */
typedef struct growth_sweep {
    const char *name; /* of the plot's file */
    const char *title;
    const char *sentence; /* what is drawn */
    const char *x_title;
    const char *y_title;
    const char *series[GROWTH_SERIES]; /* up to a NULL */
    const char *beside;                /* the title of another column, or NULL */
    growth_point points[GROWTH_POINTS];
    size_t count;
    char end[400]; /* why there are no more points; empty if there are all */
} growth_sweep;

typedef struct growth_settings {
    const char *scene; /* the file of the frame whose pixels and samples are varied */
    int width;         /* of the sweeps that keep it */
    int height;
    int largest_side;  /* sizes beyond it are left out */
    int largest_count; /* numbers of sources beyond it are left out */
} growth_settings;

enum { GROWTH_SWEEPS = 5 };

/* Measures all of them. On failure returns false, with a message. */
bool growth_measure(gl_context *context, const growth_settings *settings, growth_sweep sweeps[GROWTH_SWEEPS], char *message,
                    size_t size);

/* The exponent p of the power law y ~ x^p that is nearest to the upper half of a series by least squares of logarithms: below,
 * what does not grow hides what does. */
double growth_exponent(const growth_sweep *sweep, size_t series);

#endif
