/* Integrators by name: see named_integrator.h. */
#include "named_integrator.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool named_integrator_find(const char *name, named_integrator *result)
{
    static const named_integrator adaptive[] = {
        {"adaptive:1e-2", {.quality = EW_QUALITY_ERROR_1E_2}, 1e-2, HUGE_VAL},
        {"adaptive:1e-3", {.quality = EW_QUALITY_ERROR_1E_3}, 1e-3, 1e-4},
        {"adaptive:1e-4", {.quality = EW_QUALITY_ERROR_1E_4}, 1e-4, HUGE_VAL},
    };
    for (size_t i = 0; i < sizeof adaptive / sizeof *adaptive; i++)
        if (strcmp(name, adaptive[i].name) == 0) {
            *result = adaptive[i];
            result->settings.integrator = EW_INTEGRATOR_ADAPTIVE;
            return true;
        }
    int divisions = 0, end = 0;
    if (sscanf(name, "simpson:%4d%n", &divisions, &end) != 1 || name[end] != '\0') return false;
    if (divisions < 2 || divisions > EW_MAX_SIMPSON_DIVISIONS || divisions % 2 != 0) return false;
    *result = (named_integrator){.settings = {.integrator = EW_INTEGRATOR_SIMPSON, .simpson_divisions = divisions},
                                 .largest_error = HUGE_VAL,
                                 .percentile_99 = HUGE_VAL};
    snprintf(result->name, sizeof result->name, "%s", name);
    return true;
}
