/* What a comparison found: see accuracy_result.h. */
#include "accuracy_result.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

double accuracy_excess(const accuracy_result *result)
{
    const picture_comparison *comparison = &result->comparison;
    const named_integrator *integrator = result->integrator;
    if (comparison->bad_count) return HUGE_VAL;
    if (isinf(integrator->largest_error)) return comparison->largest_error;
    return fmax(comparison->largest_error / integrator->largest_error, comparison->percentile_99 / integrator->percentile_99);
}

static const char *scene_name(const accuracy_result *result)
{
    const char *slash = strrchr(result->path, '/');
    return slash ? slash + 1 : result->path;
}

void accuracy_describe(const accuracy_result *result, char *text, size_t size)
{
    const picture_comparison *comparison = &result->comparison;
    char bad[80] = "";
    if (comparison->bad_count)
        snprintf(bad, sizeof bad, "; %zu pixels are negative, infinite or no number", comparison->bad_count);
    snprintf(text, size, "%-44s %-13s max %.1e at (%3d, %3d): %.6g for %.6g; 99 %%: %.1e%s", scene_name(result),
             result->integrator->name, comparison->largest_error, comparison->worst_x, comparison->worst_y,
             comparison->worst_luminance, comparison->worst_truth, comparison->percentile_99, bad);
}

bool accuracy_append_csv(const accuracy_result *result, const char *path)
{
    const picture_comparison *comparison = &result->comparison;
    FILE *file = fopen(path, "a");
    if (!file) return false;
    if (ftell(file) == 0)
        fprintf(file, "scene,integrator,size,pixels,max_rel_error,p99_rel_error,worst_x,worst_y,worst_luminance,"
                      "worst_truth,bad_pixels,unreliable_pixels,renderer\n");
    fprintf(file, "%s,%s,%dx%d,%zu,%.3g,%.3g,%d,%d,%.9g,%.9g,%zu,%zu,\"%s\"\n", scene_name(result), result->integrator->name,
            result->picture->width, result->picture->height, result->truth->count, comparison->largest_error,
            comparison->percentile_99, comparison->worst_x, comparison->worst_y, comparison->worst_luminance,
            comparison->worst_truth, comparison->bad_count, result->truth->unreliable_count, result->renderer);
    return fclose(file) == 0;
}
