// The header is C++, too: its functions link, its defaults initialise, and control points may be const.
#include <energywave.h>

#include <cstring>

int main()
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    if (frame.projection[14] != -0.2 || frame.simpson_divisions != 200 || frame.skip_restore != 0) return 1;
    const double points[3][3] = {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}};
    double moving_points[3][3] = {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}};
    ew_curve curve = {};
    ew_bezier_polynomial(points[0], points[1], points[2], curve.polynomial);
    ew_bezier_polynomial(moving_points[0], moving_points[1], moving_points[2], curve.polynomial);
    if (curve.polynomial[1][0] != 2 || curve.polynomial[2][1] != -4) return 1;
    ew_path path = {};
    path.points = points;
    path.points = moving_points;
    double weights[2];
    ew_fill_pulse_weights(25, weights, 2);
    return weights[0] == 1 && path.points[1][1] == 2 && std::strlen(ew_result_text(EW_OK)) > 0 ? 0 : 1;
}
