/* Arcs of parabolas in ray space. */
#ifndef EW_ARC_H
#define EW_ARC_H

#include "model/kinds.h"

/* The arc C(u) = start + u tangent + u^2 bend with u in [0, 1]. */
typedef struct ew_arc {
    double start[3], tangent[3], bend[3];
} ew_arc;

/* The arc of a polynomial over its domain, in ray space. */
ew_arc ew_arc_in_ray_space(const ew_ray_space *space, const double polynomial[3][3], const double domain[2]);

/* Four corners around an arc: both ends, and the control points that its halves have in between. A straight arc's are on it. */
ew_hull ew_hull_of_arc(const double polynomial[3][3], const double domain[2]);

/* A ball around an arc, in ray space. */
ew_ball ew_ball_of_arc(const ew_arc *arc);

/* The direction of a cylinder around an arc, whose axis goes through the ball's centre. Returns its radius. */
double ew_cylinder_of_arc(const ew_arc *arc, double axis[3]);

/* Refuses an arc that is too far away or too large. */
ew_result ew_check_arc(const ew_arc *arc, const ew_source_name *name, ew_error *error);

/* The arc in the frame of its plane: C(tau) = origin + slope_x tau axis_x + (slope_y tau + bend tau^2) axis_y with tau in
 * [first, last]. See ew_curve_block in glsl/base/layout.glsl. */
typedef struct ew_arc_frame {
    double origin[3], axis_x[3], axis_y[3], axis_z[3];
    double slope_x, slope_y, bend;
    double first, last;
} ew_arc_frame;

/* Finds that frame: axis_y along the bend, axis_x along the rest of the tangent. A straight or folded arc lies in many planes;
 * any will do. */
ew_arc_frame ew_find_arc_frame(const ew_arc *arc);

#endif
