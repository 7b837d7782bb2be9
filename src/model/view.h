/* A view: the camera as a host describes it, and its rays. It knows of no target. */
#ifndef EW_VIEW_H
#define EW_VIEW_H

#include "energywave.h"

#include <stdbool.h>

typedef struct ew_view {
    const double *view;       /* world to view, column-major */
    const double *projection; /* view to clip */
    ew_clip_depth clip_depth;
} ew_view;

ew_view ew_view_of(const ew_frame_desc *frame);

/* Checks the matrices and clip_depth. */
ew_result ew_check_view(const ew_view *view, ew_error *error);

/* The rigid view next to a view that ew_check_view takes, with the same eye: rounding in floats makes views drift. Any other
 * view is copied, as is one that is rigid but for rounding in doubles. */
void ew_settle_view(const double view[16], double settled[16]);

bool ew_is_parallel(const ew_view *view);

/* Brings a place of the world to view space. */
void ew_to_view(const ew_view *view, const double world[3], double out[3]);

/* The view depth at which rays begin: the near plane's of a parallel projection; 0, the eye's, of a perspective one. */
double ew_first_depth(const ew_view *view);

/* Where the ray through NDC (x, y) is at view depth `depth`, in view space. */
void ew_ray_at(const ew_view *view, double x, double y, double depth, double out[2]);

/* Window depth at view depth `depth` on the ray through NDC (x, y). */
double ew_window_depth_at(const ew_view *view, double x, double y, double depth);

#endif
