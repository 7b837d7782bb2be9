/* Pixels around the sources: see core_pixels.h. */
#include "core_pixels.h"
#include "random_numbers.h"
#include "source_kinds.h"

#include <math.h>

bool random_source_place(const scene_rays *rays, uint64_t *random, double place[3], double *core)
{
    size_t index = random_index(random, source_count_of_all_kinds(&rays->sources));
    double u = random_unit(random), middle;
    source_view view;
    scene_rays_depth_range(rays, &middle, &view.length);
    for (int i = 0; i < 3; i++)
        view.middle[i] = middle * rays->forward[i];
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        size_t count = source_count(kind, &rays->sources);
        if (index < count) {
            const void *source = source_at(kind, &rays->sources, index);
            kind->place(source, &view, u, place);
            *core = source_light_of(kind, source).core;
            if (*core == 0) *core = rays->sources.epsilon;
            return true;
        }
        index -= count;
    }
    return false;
}

bool random_core_pixel(const scene_rays *rays, uint64_t *random, int *x, int *y)
{
    double place[3], core, column, row, depth;
    if (!random_source_place(rays, random, place, &core)) return false;
    double distance = 0.25 * pow(128, random_unit(random)), angle = 2 * M_PI * random_unit(random);
    scene_rays_project(rays, place, &column, &row, &depth);
    if (rays->is_world ? !(depth > 0) : !(depth >= rays->interval_start && depth <= rays->interval_end)) return false;
    column += distance * cos(angle);
    row += distance * sin(angle);
    if (!(column >= 0 && column < rays->width && row >= 0 && row < rays->height)) return false;
    *x = (int)column;
    *y = (int)row;
    return true;
}
