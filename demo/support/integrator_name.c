/* Integrators by name: see integrator_name.h. */
#include "integrator_name.h"
#include "command_line.h"

#include <stdio.h>
#include <string.h>

static const char adaptive[] = "adaptive", simpson[] = "simpson:";

static const char *const error_names[] = {
    [EW_QUALITY_ERROR_1E_2] = "1e-2", [EW_QUALITY_ERROR_1E_3] = "1e-3", [EW_QUALITY_ERROR_1E_4] = "1e-4"};
enum { QUALITY_COUNT = sizeof error_names / sizeof *error_names };

/* `text` is what follows "adaptive". */
static bool read_quality(const char *text, ew_quality *quality)
{
    *quality = EW_QUALITY_ERROR_1E_3;
    if (*text == '\0') return true;
    for (int i = 0; *text == ':' && i < QUALITY_COUNT; i++)
        if (strcmp(text + 1, error_names[i]) == 0) {
            *quality = (ew_quality)i;
            return true;
        }
    return false;
}

bool integrator_from_name(const char *name, render_settings *settings)
{
    ew_quality quality;
    int divisions;
    if (strncmp(name, adaptive, sizeof adaptive - 1) == 0 && read_quality(name + sizeof adaptive - 1, &quality)) {
        settings->integrator = EW_INTEGRATOR_ADAPTIVE;
        settings->quality = quality;
        return true;
    }
    if (strncmp(name, simpson, sizeof simpson - 1) != 0) return false;
    if (!read_number(name + sizeof simpson - 1, 2, EW_MAX_SIMPSON_DIVISIONS, &divisions) || divisions % 2 != 0) return false;
    settings->integrator = EW_INTEGRATOR_SIMPSON;
    settings->simpson_divisions = divisions;
    return true;
}

void integrator_write_name(const render_settings *settings, char name[INTEGRATOR_NAME_SIZE])
{
    if (settings->integrator == EW_INTEGRATOR_SIMPSON)
        snprintf(name, INTEGRATOR_NAME_SIZE, "%s%d", simpson, settings->simpson_divisions);
    else
        snprintf(name, INTEGRATOR_NAME_SIZE, "%s:%s", adaptive, error_names[settings->quality]);
}
