/* Ray space: see ray_space.h. */
#include "model/ray_space.h"

#include "model/vector.h"

void ew_ray_space_place(const ew_ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        double sum = ew_element(space->view, row, 3);
        for (int column = 0; column < 3; ++column)
            sum += ew_element(space->view, row, column) * world[column];
        if (row == 2) sum += space->start;
        out[row] = sum / space->length;
    }
}

void ew_ray_space_turn(const ew_ray_space *space, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        out[row] = 0;
        for (int column = 0; column < 3; ++column)
            out[row] += ew_element(space->view, row, column) * world[column];
    }
}

ew_vec4 ew_pack(const double v[3], double w)
{
    return (ew_vec4){(float)v[0], (float)v[1], (float)v[2], (float)w};
}
