/* Ray space, in which the shader computes: see glsl/base/layout.glsl. */
#ifndef EW_RAY_SPACE_H
#define EW_RAY_SPACE_H

#include "model/layout.h"
#include "model/vector.h"

typedef struct ew_ray_space {
    const double *view; /* world to view */
    double start;       /* view depth of the anchor */
    double length;      /* of the interval, in world units */
} ew_ray_space;

/* These are inline: they take most of the time of bringing a source to ray space. */

/* Brings a place of the world to ray space. */
static inline void ew_ray_space_place(const ew_ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        double sum = ew_element(space->view, row, 3);
        for (int column = 0; column < 3; ++column)
            sum += ew_element(space->view, row, column) * world[column];
        if (row == 2) sum += space->start;
        out[row] = sum / space->length;
    }
}

/* Turns a vector of the world into the axes of ray space, and leaves its length alone. */
static inline void ew_ray_space_turn(const ew_ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        out[row] = 0;
        for (int column = 0; column < 3; ++column)
            out[row] += ew_element(space->view, row, column) * world[column];
    }
}

/* Rounds `v` to floats, with `w` as the fourth. */
static inline ew_vec4 ew_pack(const double v[3], double w)
{
    return (ew_vec4){(float)v[0], (float)v[1], (float)v[2], (float)w};
}

#endif
