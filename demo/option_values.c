/* The values of options: see option_values.h. */
#include "option_values.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Returns whether `text` is a number of 1 to 9 digits, and that number. */
bool read_count(const char *text, const char **end, int *count)
{
    char *stop;
    if (!isdigit((unsigned char)text[0])) return false;
    unsigned long value = strtoul(text, &stop, 10);
    if (stop - text > 9) return false;
    *end = stop;
    *count = (int)value;
    return true;
}

bool read_size(const char *text, render_settings *settings)
{
    const char *end;
    return read_count(text, &end, &settings->width) && *end == 'x' && read_count(end + 1, &end, &settings->height) &&
           *end == '\0' && settings->width >= 1 && settings->width <= RENDER_MAX_SIDE && settings->height >= 1 &&
           settings->height <= RENDER_MAX_SIDE;
}

bool read_integrator(const char *text, render_settings *settings)
{
    static const struct {
        const char *name;
        ew_quality quality;
    } adaptive[] = {{"adaptive", EW_QUALITY_ERROR_1E_3},
                    {"adaptive:1e-2", EW_QUALITY_ERROR_1E_2},
                    {"adaptive:1e-3", EW_QUALITY_ERROR_1E_3},
                    {"adaptive:1e-4", EW_QUALITY_ERROR_1E_4}};
    static const char simpson[] = "simpson:";
    for (size_t i = 0; i < sizeof adaptive / sizeof *adaptive; i++)
        if (strcmp(text, adaptive[i].name) == 0) {
            settings->integrator = EW_INTEGRATOR_ADAPTIVE;
            settings->quality = adaptive[i].quality;
            return true;
        }
    const char *end;
    int divisions;
    if (strncmp(text, simpson, sizeof simpson - 1) != 0) return false;
    if (!read_count(text + sizeof simpson - 1, &end, &divisions) || *end != '\0') return false;
    if (divisions < 2 || divisions > EW_MAX_SIMPSON_DIVISIONS || divisions % 2 != 0) return false;
    settings->integrator = EW_INTEGRATOR_SIMPSON;
    settings->simpson_divisions = divisions;
    return true;
}

bool read_backend(const char *text, context_backend *backend)
{
    for (int i = 0; context_backend_names[i]; i++)
        if (strcmp(text, context_backend_names[i]) == 0) {
            *backend = (context_backend)i;
            return true;
        }
    return false;
}
