/* The rays of a view: see rays.h. */
#include "model/rays.h"

#include "base/error.h"
#include "model/limits.h"
#include "model/vector.h"

#include <float.h>

ew_result ew_check_interval(const ew_interval *interval, const ew_view *view, ew_error *error)
{
    double start = interval->start, end = interval->end;
    if (!isfinite(start) || !isfinite(end) || !(start < end) || !isfinite(end - start))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "interval_start must be less than interval_end, both finite");
    if (ew_is_parallel(view)) return EW_OK;
    if (!(start > 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "interval_start must be > 0 for a perspective projection");
    if (!(end <= EW_MAX_INTERVAL_RATIO * start))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "interval_end must be at most %g times interval_start for a perspective projection",
                       EW_MAX_INTERVAL_RATIO);
    return EW_OK;
}

/* The first depth of the interval that has a window depth. */
static double first_window_depth(const ew_view *view, const ew_interval *interval)
{
    return interval->start == 0 && !ew_is_parallel(view) ? EW_MIN_DEPTH_RATIO * interval->end : interval->start;
}

/* Rays and their window depths change linearly over the picture and between the interval's ends, so its corners bound all. */
ew_result ew_check_rays(const ew_view *view, const ew_interval *interval, ew_error *error)
{
    double most = EW_MAX_COORDINATE * (interval->end - interval->start);
    for (int corner = 0; corner < 8; ++corner) {
        double x = corner & 1 ? 1 : -1, y = corner & 2 ? 1 : -1, position[2];
        double depth = corner & 4 ? interval->end : first_window_depth(view, interval);
        ew_ray_at(view, x, y, depth, position);
        if (!(fabs(position[0]) <= most && fabs(position[1]) <= most))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "projection must show no more than %g times the interval's length",
                           EW_MAX_COORDINATE);
        if (!(fabs(ew_window_depth_at(view, x, y, depth)) <= EW_MAX_WINDOW_DEPTH))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                           "projection must give depths of at most %g at interval_start and interval_end", EW_MAX_WINDOW_DEPTH);
    }
    return EW_OK;
}

static ew_vec4 pack_window_depth(const ew_view *view, const ew_viewport *viewport, double depth)
{
    double center = ew_window_depth_at(view, 0, 0, depth);
    double right = ew_window_depth_at(view, 2.0 / viewport->width, 0, depth) - center;
    double up = ew_window_depth_at(view, 0, 2.0 / viewport->height, depth) - center;
    float rounded = (float)center;
    return (ew_vec4){rounded, (float)(center - (double)rounded), (float)right, (float)up};
}

/* The ray through NDC (x, y): S.xy and V.xy. */
static void ray_through(const ew_view *view, const ew_interval *interval, double unit, double x, double y, double ray[4])
{
    double start[2], end[2], length = interval->end - interval->start;
    ew_ray_at(view, x, y, interval->start, start);
    ew_ray_at(view, x, y, interval->end, end);
    for (int i = 0; i < 2; ++i) {
        ray[i] = start[i] / unit;
        ray[2 + i] = (end[i] - start[i]) / length;
    }
}

static ew_vec4 pack_growth(const double ray[4], const double from[4])
{
    return (ew_vec4){(float)(ray[0] - from[0]), (float)(ray[1] - from[1]), (float)(ray[2] - from[2]),
                     (float)(ray[3] - from[3])};
}

void ew_pack_rays(const ew_view *view, const ew_interval *interval, double unit, const ew_viewport *viewport,
                  struct ew_frame_block *block)
{
    const double nothing[4] = {0};
    double center[4], right[4], up[4];
    ray_through(view, interval, unit, 0, 0, center);
    ray_through(view, interval, unit, 2.0 / viewport->width, 0, right);
    ray_through(view, interval, unit, 0, 2.0 / viewport->height, up);
    block->pixel_center =
        (ew_vec4){(float)(viewport->x + 0.5 * viewport->width), (float)(viewport->y + 0.5 * viewport->height), 0, 0};
    block->ray_center = pack_growth(center, nothing);
    block->ray_right = pack_growth(right, center);
    block->ray_up = pack_growth(up, center);

    double first = first_window_depth(view, interval);
    block->depth_start = pack_window_depth(view, viewport, first);
    block->depth_end = pack_window_depth(view, viewport, interval->end);
    double w_start = ew_is_parallel(view) ? 1 : first / interval->end;
    double sign = ew_window_depth_at(view, 0, 0, first) < ew_window_depth_at(view, 0, 0, interval->end) ? 1 : -1;
    block->depth_scale =
        (ew_vec4){(float)(sign * w_start), (float)sign, sign > 0 ? 1 : 0, (float)((first - interval->start) / unit)};
}

static ew_vec4 pack_view_depth(double depth)
{
    float rounded = (float)depth;
    return (ew_vec4){rounded, (float)(depth - (double)rounded), 0, 0};
}

void ew_pack_linear_depth(const ew_interval *interval, struct ew_frame_block *block)
{
    block->depth_start = pack_view_depth(interval->start);
    block->depth_end = pack_view_depth(interval->end);
    block->depth_scale = (ew_vec4){1, 1, FLT_MAX, 0};
}

double ew_pixel_height(const ew_view *view, const ew_viewport *viewport)
{
    double here[2], above[2];
    double step = 2.0 / viewport->height;
    if (ew_is_parallel(view)) {
        ew_ray_at(view, 0, 0, 0, here);
        ew_ray_at(view, 0, step, 0, above);
        return hypot(above[0] - here[0], above[1] - here[1]);
    }
    /* Rays are linear in depth, so that a difference over one unit is the slope. */
    double here_at_0[2], above_at_0[2];
    ew_ray_at(view, 0, 0, 0, here_at_0);
    ew_ray_at(view, 0, step, 0, above_at_0);
    ew_ray_at(view, 0, 0, 1, here);
    ew_ray_at(view, 0, step, 1, above);
    return hypot((above[0] - above_at_0[0]) - (here[0] - here_at_0[0]), (above[1] - above_at_0[1]) - (here[1] - here_at_0[1]));
}

void ew_pack_ray_space(const ew_ray_space *space, struct ew_frame_block *block)
{
    ew_vec4 *const rows[3] = {&block->ray_space_x, &block->ray_space_y, &block->ray_space_z};
    for (int row = 0; row < 3; ++row) {
        double scaled[3];
        for (int column = 0; column < 3; ++column)
            scaled[column] = ew_element(space->view, row, column) / space->length;
        *rows[row] = ew_pack(scaled, row == 2 ? space->start / space->length : 0);
    }
}
