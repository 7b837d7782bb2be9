/* One source: see source_part.h. */
#include "source_part.h"

size_t source_part_count(const ew_sources_desc *sources, source_kind kind)
{
    const size_t counts[SOURCE_KIND_COUNT] = {[SOURCE_POINT] = sources->point_count,
                                              [SOURCE_LINE] = sources->line_count,
                                              [SOURCE_TORUS] = sources->torus_count,
                                              [SOURCE_CURVE] = sources->curve_count,
                                              [SOURCE_PATH] = sources->path_count};
    return counts[kind];
}

source_light source_part_light(const ew_sources_desc *sources, source_part part)
{
    switch (part.kind) {
    case SOURCE_POINT:
        return SOURCE_LIGHT(&sources->points[part.index]);
    case SOURCE_LINE:
        return SOURCE_LIGHT(&sources->lines[part.index]);
    case SOURCE_TORUS:
        return SOURCE_LIGHT(&sources->tori[part.index]);
    case SOURCE_CURVE:
        return SOURCE_LIGHT(&sources->curves[part.index]);
    case SOURCE_PATH:
        break;
    }
    return SOURCE_LIGHT(&sources->paths[part.index]);
}
