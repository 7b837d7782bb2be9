/* The list of the kinds, and what their rows share. */
#include "model/kinds.h"

#include "base/error.h"
#include "model/limits.h"
#include "model/vector.h"

extern const ew_kind ew_point_kind, ew_line_kind, ew_torus_kind, ew_curve_kind, ew_path_kind_row;

const ew_kind *const ew_kinds[EW_KIND_COUNT] = {&ew_point_kind, &ew_line_kind, &ew_torus_kind, &ew_curve_kind,
                                                &ew_path_kind_row};

ew_result ew_check_vector(const ew_source_name *name, const char *field, const double v[3], ew_error *error)
{
    if (ew_all_finite(v, 3)) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].%s must be finite", name->list, name->index, field);
}

ew_result ew_check_direction(const ew_source_name *name, const char *field, const double v[3], ew_error *error)
{
    double unit[3];
    ew_result result = ew_check_vector(name, field, v, error);
    if (result != EW_OK || ew_normalize(v, unit)) return result;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].%s must not be zero", name->list, name->index, field);
}

ew_result ew_refuse_coordinates(const ew_source_name *name, ew_error *error)
{
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                   "%s[%zu] is more than %g times the interval's length away from the camera or as large", name->list,
                   name->index, EW_MAX_COORDINATE);
}
