/* A view: see view.h. */
#include "model/view.h"

#include "base/error.h"
#include "model/limits.h"
#include "model/vector.h"

#include <string.h>

ew_view ew_view_of(const ew_frame_desc *frame)
{
    return (ew_view){frame->view, frame->projection, frame->clip_depth};
}

/* The largest entry of R^T R - 1, where R is the view's turn. */
static double deviation(const double view[16])
{
    double largest = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
            largest = fmax(largest, fabs(ew_dot(&view[4 * i], &view[4 * j]) - (i == j)));
    return largest;
}

static bool is_rigid(const double view[16])
{
    const double last_row_tolerance = 1e-6;
    for (int i = 0; i < 4; ++i)
        if (!(fabs(ew_element(view, 3, i) - (i == 3)) <= last_row_tolerance)) return false;
    return deviation(view) <= EW_MAX_VIEW_DEVIATION;
}

/* One step R <- R (3 - R^T R) / 2 of Newton's and Schulz's iteration for the rotation next to R. It squares the deviation,
 * about. */
static void approach_rotation(double view[16])
{
    double before[16];
    memcpy(before, view, sizeof before);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) {
            double product = 0;
            for (int k = 0; k < 3; ++k)
                product += before[4 * k + row] * ew_dot(&before[4 * k], &before[4 * column]);
            view[4 * column + row] = 1.5 * before[4 * column + row] - 0.5 * product;
        }
}

/* Where the eye is, which is -R^-1 t. */
static void eye_of(const double view[16], double eye[3])
{
    const double *x = &view[0], *y = &view[4], *z = &view[8], *t = &view[12];
    double yz[3], zx[3], xy[3];
    ew_cross(y, z, yz);
    ew_cross(z, x, zx);
    ew_cross(x, y, xy);
    double determinant = ew_dot(x, yz);
    eye[0] = -ew_dot(yz, t) / determinant;
    eye[1] = -ew_dot(zx, t) / determinant;
    eye[2] = -ew_dot(xy, t) / determinant;
}

void ew_settle_view(const double view[16], double settled[16])
{
    const double rounding = 1e-13;
    memcpy(settled, view, 16 * sizeof *settled);
    if (!ew_all_finite(view, 16) || !is_rigid(view)) return;
    for (int i = 0; i < 4; ++i)
        settled[4 * i + 3] = i == 3;
    if (deviation(view) <= rounding) return;
    double eye[3];
    eye_of(view, eye);
    for (int step = 0; step < 4; ++step)
        approach_rotation(settled);
    for (int row = 0; row < 3; ++row)
        settled[12 + row] = -(settled[row] * eye[0] + settled[4 + row] * eye[1] + settled[8 + row] * eye[2]);
}

bool ew_is_parallel(const ew_view *view)
{
    return ew_element(view->projection, 3, 2) == 0;
}

static ew_result check_projection(const ew_view *view, ew_error *error)
{
    const double *p = view->projection;
    bool parallel = ew_is_parallel(view);
    double w = parallel ? ew_element(p, 3, 3) : -ew_element(p, 3, 2);
    bool other_w = ew_element(p, 3, 0) != 0 || ew_element(p, 3, 1) != 0 || (!parallel && ew_element(p, 3, 3) != 0);
    if (!ew_all_finite(p, 16) || other_w || !(w > 0))
        return ew_fail(
            error, EW_ERROR_INVALID_ARGUMENT,
            "projection must be finite, its last row (0, 0, -w, 0) for perspective or (0, 0, 0, w) for parallel, w > 0");
    if (ew_element(p, 0, 0) * ew_element(p, 1, 1) - ew_element(p, 0, 1) * ew_element(p, 1, 0) == 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "projection must not flatten x and y");
    return EW_OK;
}

ew_result ew_check_view(const ew_view *view, ew_error *error)
{
    if (!ew_all_finite(view->view, 16) || !is_rigid(view->view))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "view must be finite, a rotation and a translation: R^T R may differ by at most 1e-3 from 1");
    if ((unsigned)view->clip_depth > EW_CLIP_DEPTH_ZERO_TO_ONE)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "clip_depth must be one of ew_clip_depth");
    return check_projection(view, error);
}

static double clip_w_at(const ew_view *view, double depth)
{
    return ew_is_parallel(view) ? ew_element(view->projection, 3, 3) : -ew_element(view->projection, 3, 2) * depth;
}

void ew_ray_at(const ew_view *view, double x, double y, double depth, double out[2])
{
    const double *p = view->projection;
    double w = clip_w_at(view, depth);
    double right[2], ndc[2] = {x, y};
    for (int row = 0; row < 2; ++row)
        right[row] = ndc[row] * w + ew_element(p, row, 2) * depth - ew_element(p, row, 3);
    double a = ew_element(p, 0, 0), b = ew_element(p, 0, 1);
    double c = ew_element(p, 1, 0), d = ew_element(p, 1, 1);
    double determinant = a * d - b * c;
    out[0] = (d * right[0] - b * right[1]) / determinant;
    out[1] = (a * right[1] - c * right[0]) / determinant;
}

double ew_window_depth_at(const ew_view *view, double x, double y, double depth)
{
    const double *p = view->projection;
    double position[2];
    ew_ray_at(view, x, y, depth, position);
    double ndc_depth = (ew_element(p, 2, 0) * position[0] + ew_element(p, 2, 1) * position[1] - ew_element(p, 2, 2) * depth +
                        ew_element(p, 2, 3)) /
                       clip_w_at(view, depth);
    return view->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? ndc_depth : 0.5 * ndc_depth + 0.5;
}

void ew_to_view(const ew_view *view, const double world[3], double out[3])
{
    for (int row = 0; row < 3; ++row) {
        out[row] = ew_element(view->view, row, 3);
        for (int column = 0; column < 3; ++column)
            out[row] += ew_element(view->view, row, column) * world[column];
    }
}

double ew_first_depth(const ew_view *view)
{
    if (!ew_is_parallel(view)) return 0;
    double at_0 = ew_window_depth_at(view, 0, 0, 0), growth = ew_window_depth_at(view, 0, 0, 1) - at_0;
    /* Window depth 0 is the near plane, or 1 if depth is reversed. */
    return growth != 0 ? ((growth > 0 ? 0 : 1) - at_0) / growth : 0;
}
