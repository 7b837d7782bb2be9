/* Ray space, in which the shader computes: see glsl/base/layout.glsl. */
#ifndef EW_RAY_SPACE_H
#define EW_RAY_SPACE_H

#include "model/layout.h"

typedef struct ew_ray_space {
    const double *view; /* world to view */
    double start;       /* view depth of the anchor */
    double length;      /* of the interval, in world units */
} ew_ray_space;

/* Brings a place of the world to ray space. */
void ew_ray_space_place(const ew_ray_space *space, const double world[3], double out[3]);

/* Turns a vector of the world into the axes of ray space, and leaves its length alone. */
void ew_ray_space_turn(const ew_ray_space *space, const double world[3], double out[3]);

/* Rounds `v` to floats, with `w` as the fourth. */
ew_vec4 ew_pack(const double v[3], double w);

#endif
