/* Media: see media.h. */
#include "model/media.h"

#include "base/error.h"
#include "model/limits.h"

_Static_assert(EW_MAX_MEDIA == EW_MEDIUM_ROOM, "the uniform block has another number of media");

/* ---- Checks ---- */

static bool spans_space(const double axes[3][3])
{
    double across[3];
    ew_cross(axes[1], axes[2], across);
    double lengths = sqrt(ew_dot(axes[0], axes[0])) * sqrt(ew_dot(axes[1], axes[1])) * sqrt(ew_dot(axes[2], axes[2]));
    /* Not for a product that is no number or 0, because too large or too small. */
    return isfinite(lengths) && fabs(ew_dot(axes[0], across)) > EW_MIN_FLATNESS * lengths;
}

static ew_result check_medium(const ew_medium *medium, size_t i, ew_error *error)
{
    const ew_result invalid = EW_ERROR_INVALID_ARGUMENT;
    if ((int)medium->shape < 0 || medium->shape > EW_MEDIUM_ELLIPSOID)
        return ew_fail(error, invalid, "media[%zu].shape must be one of ew_medium_shape", i);
    if (!ew_all_finite(medium->center, 3)) return ew_fail(error, invalid, "media[%zu].center must be finite", i);
    if (!ew_all_finite(medium->half_axes[0], 9)) return ew_fail(error, invalid, "media[%zu].half_axes must be finite", i);
    if (!spans_space(medium->half_axes))
        return ew_fail(error, invalid, "media[%zu].half_axes must span a space: the body has no volume", i);
    if (!(medium->extinction >= 0 && medium->extinction <= EW_MAX_EXTINCTION))
        return ew_fail(error, invalid, "media[%zu].extinction must be in [0, %g]", i, EW_MAX_EXTINCTION);
    if (!(medium->albedo >= 0 && medium->albedo <= 1)) return ew_fail(error, invalid, "media[%zu].albedo must be in [0, 1]", i);
    for (int channel = 0; channel < 3; ++channel)
        if (!(medium->ambient[channel] >= 0 && medium->ambient[channel] <= EW_MAX_COLOR))
            return ew_fail(error, invalid, "media[%zu].ambient must have components in [0, %g]", i, EW_MAX_COLOR);
    return EW_OK;
}

ew_result ew_check_media(const ew_medium *media, size_t count, ew_error *error)
{
    if (count > EW_MAX_MEDIA)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "medium_count must be at most %d, but is %zu", EW_MAX_MEDIA, count);
    if (count > 0 && !media) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "media must not be NULL with a medium_count > 0");
    ew_result result = EW_OK;
    for (size_t i = 0; i < count && result == EW_OK; ++i)
        result = check_medium(&media[i], i, error);
    return result;
}

/* ---- Ray space ---- */

/* A row of the inverse of the matrix whose columns are the half axes, in ray space, and what it is of the center, negative: the
 * cross product of the two other axes over the determinant. */
static ew_vec4 row_of(double axes[3][3], const double center[3], int i, double *largest)
{
    double row[3];
    ew_cross(axes[(i + 1) % 3], axes[(i + 2) % 3], row);
    double determinant = ew_dot(axes[i], row);
    for (int k = 0; k < 3; ++k)
        row[k] /= determinant;
    double at_anchor = -ew_dot(row, center);
    *largest = fmax(*largest, fmax(fabs(at_anchor), sqrt(ew_dot(row, row))));
    return ew_pack(row, at_anchor);
}

static struct ew_medium_block block_of(const ew_medium *medium, const ew_ray_space *space, double exposure, double *largest)
{
    double center[3], axes[3][3], light[3];
    ew_ray_space_place(space, medium->center, center);
    for (int i = 0; i < 3; ++i) {
        ew_ray_space_turn(space, medium->half_axes[i], axes[i]);
        for (int k = 0; k < 3; ++k)
            axes[i][k] /= space->length;
        light[i] = fmin(exposure * medium->albedo * medium->ambient[i], EW_MAX_COLOR);
    }
    *largest = 0;
    return (struct ew_medium_block){row_of(axes, center, 0, largest), row_of(axes, center, 1, largest),
                                    row_of(axes, center, 2, largest),
                                    ew_pack(light, fmin(medium->extinction * space->length, EW_MAX_BODY_MAP))};
}

ew_result ew_pack_media(const ew_medium *media, size_t count, const ew_ray_space *space, double exposure,
                        struct ew_uniform_head *head, ew_error *error)
{
    int packed = 0;
    for (int shape = EW_MEDIUM_BOX; shape <= EW_MEDIUM_ELLIPSOID; ++shape) {
        for (size_t i = 0; i < count; ++i) {
            if ((int)media[i].shape != shape) continue;
            double largest;
            head->media[packed++] = block_of(&media[i], space, exposure, &largest);
            if (!(largest <= EW_MAX_BODY_MAP))
                return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                               "media[%zu] is too small for the distance from which it is seen", i);
        }
        if (shape == EW_MEDIUM_BOX) head->fog.bodies.y = packed;
    }
    head->fog.bodies.x = packed;
    return EW_OK;
}

/* How far a body goes from its center along a unit vector. */
static double extent_along(const ew_medium *medium, const double direction[3])
{
    double sum = 0, squares = 0;
    for (int i = 0; i < 3; ++i) {
        double along = ew_dot(medium->half_axes[i], direction);
        sum += fabs(along);
        squares += along * along;
    }
    return medium->shape == EW_MEDIUM_BOX ? sum : sqrt(squares);
}

bool ew_find_media_space(const ew_medium *media, size_t count, const ew_view *view, ew_lit_space *space)
{
    const double backward[3] = {ew_element(view->view, 2, 0), ew_element(view->view, 2, 1), ew_element(view->view, 2, 2)};
    ew_interval depths = {ew_first_depth(view), -HUGE_VAL};
    for (size_t i = 0; i < count; ++i) {
        double center[3];
        ew_to_view(view, media[i].center, center);
        depths.end = fmax(depths.end, -center[2] + extent_along(&media[i], backward));
    }
    if (!(depths.end > depths.start)) return false;
    *space = (ew_lit_space){depths, depths.end - depths.start};
    return true;
}

ew_hull ew_face_of_medium(const ew_medium *medium, int face)
{
    static const int around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const double *out = medium->half_axes[face / 2], *right = medium->half_axes[(face / 2 + 1) % 3];
    const double *up = medium->half_axes[(face / 2 + 2) % 3];
    ew_hull hull = {.corner_count = 4};
    for (int corner = 0; corner < 4; ++corner)
        for (int k = 0; k < 3; ++k)
            hull.corners[corner][k] =
                medium->center[k] + (face % 2 ? out[k] : -out[k]) + around[corner][0] * right[k] + around[corner][1] * up[k];
    return hull;
}
