/* Values of options, and bad arguments: see command_line.h. */
#include "command_line.h"
#include "message.h"

#include <ctype.h>
#include <getopt.h>
#include <stdlib.h>
#include <string.h>

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

bool read_number(const char *text, int least, int most, int *number)
{
    const char *end;
    return read_count(text, &end, number) && *end == '\0' && *number >= least && *number <= most;
}

bool read_size(const char *text, int *width, int *height)
{
    const char *end;
    return read_count(text, &end, width) && *width >= 1 && *width <= RENDER_MAX_SIDE && *end == 'x' &&
           read_number(end + 1, 1, RENDER_MAX_SIDE, height);
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

/* A bad short option stands in optopt, perhaps amid others; a long one is the whole argument. */
bool refuse_option(int option, char **argv, const char *program, char *message, size_t size)
{
    if (option == ':')
        message_write(message, size, "%s: needs a value; see %s --help", argv[optind - 1], program);
    else if (optopt > 0 && optopt < 256)
        message_write(message, size, "-%c: is not an option; see %s --help", optopt, program);
    else
        message_write(message, size, "%s: is not an option; see %s --help", argv[optind - 1], program);
    return false;
}

bool read_scene_name(int argc, char **argv, const char *verb, const char **scene, char *message, size_t size)
{
    if (optind < argc) *scene = argv[optind++];
    if (optind == argc) return true;
    message_write(message, size, "%s: is one scene too many; %s them one by one", argv[optind], verb);
    return false;
}
