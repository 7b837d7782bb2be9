/* Where on one axis of the screen light is seen. */
#ifndef EW_SCREEN_AXIS_H
#define EW_SCREEN_AXIS_H

#include "model/rays.h"

/* One axis of NDC, and what is seen there between two depths and within a radius of places, edges and lines. It is a matter of
 * a plane: the x in which the axis grows, and depth. */
typedef struct ew_screen_axis {
    bool is_parallel;
    ew_interval depths;
    double radius;
    double toward[2], offset; /* x of a place in view space */
    double scale, drift;      /* NDC = scale (x - drift depth), over depth in perspective */
    double low, high;         /* of the NDC found so far */
} ew_screen_axis;

/* Nothing is found yet. The axis is x, 0, or y, 1. */
ew_screen_axis ew_make_screen_axis(const ew_view *view, int index, double radius, const ew_interval *depths);

/* Brings a place, or with `is_direction` a direction, of x, y and depth in view space to the plane. */
void ew_screen_axis_project(const ew_screen_axis *axis, const double view[3], bool is_direction, double out[2]);

/* Takes what is around a place. */
void ew_screen_axis_take_disc(ew_screen_axis *axis, const double center[2]);

/* Takes what is around an edge, but for its ends. */
void ew_screen_axis_take_edge(ew_screen_axis *axis, const double start[2], const double end[2]);

/* Takes what is around a line without end. The direction is what is left of a unit vector. */
void ew_screen_axis_take_line(ew_screen_axis *axis, const double place[2], const double direction[2]);

/* What counts as a change over depth; less is rounding of none. */
#define EW_LEAST_DRIFT 1e-12

#endif
