/* Hulls: see hull.h. */
#include "model/hull.h"

#include "model/vector.h"

ew_hull ew_see_hull(const ew_hull *hull, const ew_view *view)
{
    ew_hull seen = {.corner_count = hull->corner_count};
    for (size_t i = 0; i < hull->corner_count; ++i) {
        ew_to_view(view, hull->corners[i], seen.corners[i]);
        seen.corners[i][2] *= -1;
    }
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            seen.direction[row] += (row == 2 ? -1 : 1) * ew_element(view->view, row, column) * hull->direction[column];
    return seen;
}

bool ew_hull_is_line(const ew_hull *hull)
{
    return ew_dot(hull->direction, hull->direction) > 0;
}
