/* Arcs in ray space: see arc.h. */
#include "model/arc.h"

#include "model/vector.h"

#include <string.h>

/* A parabola's vertex farther than this from the arc, in lengths of the arc's parameter domain, is no longer taken as origin:
 * the arc turns by less than 7 degrees then, and coordinates from the vertex would lose digits. */
#define MAX_VERTEX_DISTANCE 4.0

ew_arc ew_arc_in_ray_space(const ew_ray_space *space, const double polynomial[3][3], const double domain[2])
{
    double t0 = domain[0], length = domain[1] - domain[0];
    double world_start[3], world_tangent[3], world_bend[3];
    for (int i = 0; i < 3; ++i) {
        double c0 = polynomial[0][i], c1 = polynomial[1][i], c2 = polynomial[2][i];
        world_start[i] = c0 + t0 * (c1 + t0 * c2);
        world_tangent[i] = (c1 + 2 * t0 * c2) * length / space->length;
        world_bend[i] = c2 * length * length / space->length;
    }
    ew_arc made;
    ew_ray_space_place(space, world_start, made.start);
    ew_ray_space_turn(space, world_tangent, made.tangent);
    ew_ray_space_turn(space, world_bend, made.bend);
    return made;
}

/* Where the arc's origin goes: to its vertex, or to its middle where the vertex is far away. */
static double choose_origin(const ew_arc *arc, bool *at_vertex)
{
    const double middle = 0.5;
    double bend2 = ew_dot(arc->bend, arc->bend);
    *at_vertex = false;
    if (!(bend2 > 0)) return middle;
    double vertex = -ew_dot(arc->tangent, arc->bend) / (2 * bend2);
    *at_vertex = fabs(vertex - middle) <= 0.5 + MAX_VERTEX_DISTANCE;
    if (!*at_vertex) return middle;
    /* Two control points that coincide make an arc end at its vertex, up to rounding. */
    if (fabs(vertex) < 1e-9) return 0;
    return fabs(vertex - 1) < 1e-9 ? 1 : vertex;
}

/* The polynomial's polar form, B(s, t) = C0 + (s + t) / 2 C1 + s t C2, has the control points of all parts: B(a, a), B(a, b)
 * and B(b, b) are those of the part from a to b. */
ew_hull ew_hull_of_arc(const double polynomial[3][3], const double domain[2])
{
    const double first = domain[0], last = domain[1], middle = 0.5 * first + 0.5 * last;
    const double parameters[4][2] = {{first, first}, {first, middle}, {middle, last}, {last, last}};
    ew_hull hull = {.corner_count = 4};
    for (int corner = 0; corner < 4; ++corner) {
        double s = parameters[corner][0], t = parameters[corner][1];
        for (int i = 0; i < 3; ++i)
            hull.corners[corner][i] = polynomial[0][i] + 0.5 * (s + t) * polynomial[1][i] + s * t * polynomial[2][i];
    }
    return hull;
}

/* The derivative in the middle. C(1/2 + x) - C(1/2) = x slope + x^2 bend. */
static void middle_slope(const ew_arc *arc, double slope[3])
{
    for (int i = 0; i < 3; ++i)
        slope[i] = arc->tangent[i] + arc->bend[i];
}

ew_ball ew_ball_of_arc(const ew_arc *arc)
{
    double slope[3];
    middle_slope(arc, slope);
    ew_ball ball = {.radius = 0.5 * sqrt(ew_dot(slope, slope)) + 0.25 * sqrt(ew_dot(arc->bend, arc->bend))};
    for (int i = 0; i < 3; ++i)
        ball.center[i] = arc->start[i] + 0.5 * (arc->tangent[i] + 0.5 * arc->bend[i]);
    return ball;
}

/* An arc along which the axis is rounded to floats may be a little farther away. */
double ew_cylinder_of_arc(const ew_arc *arc, double axis[3])
{
    const double rounding = 1e-7;
    double slope[3], across[3];
    middle_slope(arc, slope);
    if (!ew_normalize(slope, axis)) ew_perpendicular(arc->bend, axis);
    ew_cross(arc->bend, axis, across);
    return 0.25 * sqrt(ew_dot(across, across)) + rounding * sqrt(ew_dot(slope, slope));
}

ew_result ew_check_arc(const ew_arc *arc, const ew_source_name *name, ew_error *error)
{
    ew_result result = ew_check_coordinates(name, arc->start, error);
    if (result == EW_OK) result = ew_check_coordinates(name, arc->tangent, error);
    return result == EW_OK ? ew_check_coordinates(name, arc->bend, error) : result;
}

ew_arc_frame ew_find_arc_frame(const ew_arc *arc)
{
    bool at_vertex;
    double tau = choose_origin(arc, &at_vertex);
    double origin[3], tangent[3], axis_x[3], axis_y[3], axis_z[3];
    for (int i = 0; i < 3; ++i) {
        origin[i] = arc->start[i] + tau * (arc->tangent[i] + tau * arc->bend[i]);
        tangent[i] = arc->tangent[i] + 2 * tau * arc->bend[i];
    }
    if (!ew_normalize(arc->bend, axis_y)) {
        double unit_tangent[3] = {1, 0, 0};
        ew_normalize(tangent, unit_tangent);
        ew_perpendicular(unit_tangent, axis_y);
    }
    double slope_y = at_vertex ? 0 : ew_dot(tangent, axis_y);
    double rest[3];
    for (int i = 0; i < 3; ++i)
        rest[i] = tangent[i] - ew_dot(tangent, axis_y) * axis_y[i];
    double slope_x = sqrt(ew_dot(rest, rest));
    /* Of a tangent along the bend only rounding errors are left, and they have no direction. */
    double bend = sqrt(ew_dot(arc->bend, arc->bend)), length = sqrt(ew_dot(arc->tangent, arc->tangent)) + bend;
    if (slope_x <= 1e-12 * length || !ew_normalize(rest, axis_x)) {
        slope_x = 0;
        ew_perpendicular(axis_y, axis_x);
    }
    ew_cross(axis_x, axis_y, axis_z);
    ew_arc_frame frame = {.slope_x = slope_x, .slope_y = slope_y, .bend = bend, .first = -tau, .last = 1 - tau};
    memcpy(frame.origin, origin, sizeof origin);
    memcpy(frame.axis_x, axis_x, sizeof axis_x);
    memcpy(frame.axis_y, axis_y, sizeof axis_y);
    memcpy(frame.axis_z, axis_z, sizeof axis_z);
    return frame;
}
