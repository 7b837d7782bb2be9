/* The command line of a program: see command_line.h. */
#include "command_line.h"
#include "context.h"
#include "integrator_name.h"
#include "message.h"

#include <ctype.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Options ------------------------------------------------------------------------------------------------------------- */

enum { MAX_OPTIONS = 16 };

/* What getopt_long returns for an option: beyond the characters, so that refuse can tell --help=please from a bad -z. */
enum { OPTION_HELP = 256, OPTION_VERSION, OPTION_FIRST };

/* getopt's description of a program's options. */
typedef struct getopt_tables {
    struct option long_options[MAX_OPTIONS + 3];
    char short_options[2 * MAX_OPTIONS + 3];
} getopt_tables;

static getopt_tables make_tables(const command_program *program)
{
    getopt_tables tables = {
        .long_options = {{"help", no_argument, NULL, OPTION_HELP}, {"version", no_argument, NULL, OPTION_VERSION}},
        .short_options = ":h"};
    char *letter = tables.short_options + 2;
    for (size_t i = 0; i < program->option_count; i++) {
        const command_option *option = &program->options[i];
        tables.long_options[2 + i] =
            (struct option){option->name, option->read ? required_argument : no_argument, NULL, OPTION_FIRST + (int)i};
        if (!option->letter) continue;
        *letter++ = option->letter;
        if (option->read) *letter++ = ':';
    }
    return tables;
}

/* getopt puts a bad short option into optopt, for it may stand among others; a bad long one is the whole argument. */
static void refuse(int option, char **argv, const char *program, char *message, size_t size)
{
    if (option == ':')
        message_write(message, size, "%s: needs a value; see %s --help", argv[optind - 1], program);
    else if (optopt > 0 && optopt < OPTION_HELP)
        message_write(message, size, "-%c: is not an option; see %s --help", optopt, program);
    else
        message_write(message, size, "%s: is not an option; see %s --help", argv[optind - 1], program);
}

static const command_option *find_option(const command_program *program, int returned)
{
    for (size_t i = 0; i < program->option_count; i++)
        if (returned == OPTION_FIRST + (int)i || returned == program->options[i].letter) return &program->options[i];
    return NULL;
}

static bool read_value(const command_option *option, const char *text, char *message, size_t size)
{
    if (!option->read) return *(bool *)option->target = true;
    if (option->read(text, option->target)) return true;
    message_write(message, size, "--%s: %s, not \"%s\"", option->name, option->remedy, text);
    return false;
}

bool command_line_read(int argc, char **argv, const command_program *program, char *message, size_t size)
{
    const getopt_tables tables = make_tables(program);
    message[0] = '\0';
    opterr = 0;
    for (int returned; (returned = getopt_long(argc, argv, tables.short_options, tables.long_options, NULL)) != -1;) {
        const command_option *option = find_option(program, returned);
        if (option) {
            if (!read_value(option, optarg, message, size)) return false;
            continue;
        }
        if (returned == 'h' || returned == OPTION_HELP)
            fputs(program->help, stdout);
        else if (returned == OPTION_VERSION)
            printf("%s %d.%d.%d\n", program->name, EW_VERSION_MAJOR, EW_VERSION_MINOR, EW_VERSION_PATCH);
        else
            refuse(returned, argv, program->name, message, size);
        return false;
    }
    return true;
}

bool command_line_read_scene(int argc, char **argv, const char *verb, const char **scene, char *message, size_t size)
{
    if (optind < argc) *scene = argv[optind++];
    if (optind == argc) return true;
    message_write(message, size, "%s: is one scene too many; %s them one by one", argv[optind], verb);
    return false;
}

/* ---- Values of options --------------------------------------------------------------------------------------------------- */

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

bool read_text(const char *text, void *target)
{
    *(const char **)target = text;
    return true;
}

bool read_backend(const char *text, void *target)
{
    for (int i = 0; context_backend_names[i]; i++)
        if (strcmp(text, context_backend_names[i]) == 0) {
            *(context_backend *)target = (context_backend)i;
            return true;
        }
    return false;
}

bool read_resolution(const char *text, void *target)
{
    static const char *const names[] = {[EW_RESOLUTION_ADAPTIVE] = "adaptive", [EW_RESOLUTION_FULL] = "full"};
    for (int i = 0; i < 2; i++)
        if (strcmp(text, names[i]) == 0) {
            *(ew_resolution *)target = (ew_resolution)i;
            return true;
        }
    return false;
}

bool read_integrator(const char *text, void *target)
{
    return integrator_from_name(text, target);
}
