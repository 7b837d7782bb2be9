/* The command line of a program: see command_line.h. */
#include "command_line.h"
#include "context.h"
#include "integrator_name.h"
#include "message.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Options ------------------------------------------------------------------------------------------------------------- */

static bool read_value(const command_option *option, const char *text, char *message, size_t size)
{
    if (option->read(text, option->target)) return true;
    message_write(message, size, "--%s: %s, not \"%s\"", option->name, option->remedy, text);
    return false;
}

/* An option as it was given: --name, --name=value, -l or -lvalue. */
typedef struct given_option {
    const char *argument;
    const char *name; /* without its dashes, and with what follows it */
    size_t name_length;
    bool is_long;
    const char *value; /* in the same argument; NULL if there is none */
} given_option;

static given_option take_apart(const char *argument)
{
    given_option given = {.argument = argument, .is_long = argument[1] == '-'};
    given.name = argument + (given.is_long ? 2 : 1);
    given.name_length = given.is_long ? strcspn(given.name, "=") : 1;
    const char *rest = given.name + given.name_length;
    if (*rest) given.value = given.is_long ? rest + 1 : rest;
    return given;
}

static bool is_called(const given_option *given, const char *name, char letter)
{
    if (!given->is_long) return letter && given->name[0] == letter;
    return strlen(name) == given->name_length && strncmp(name, given->name, given->name_length) == 0;
}

/* Returns whether the option asked for a text. */
static bool print_text(const command_program *program, const given_option *given)
{
    if (given->value) return false;
    if (is_called(given, "help", 'h'))
        fputs(program->help, stdout);
    else if (is_called(given, "version", 0))
        printf("%s %d.%d.%d\n", program->name, EW_VERSION_MAJOR, EW_VERSION_MINOR, EW_VERSION_PATCH);
    else
        return false;
    return true;
}

/* Reads one option. Its value is its own or else `next`, which may be NULL; `took_next` says if it was. */
static bool read_option(const command_program *program, const given_option *given, const char *next, bool *took_next,
                        char *message, size_t size)
{
    *took_next = false;
    if (print_text(program, given)) return false;
    for (size_t i = 0; i < program->option_count; i++) {
        const command_option *option = &program->options[i];
        if (!is_called(given, option->name, option->letter)) continue;
        if (!option->read && !given->value) return *(bool *)option->target = true;
        if (!option->read) break;
        *took_next = !given->value;
        const char *value = given->value ? given->value : next;
        if (value) return read_value(option, value, message, size);
        message_write(message, size, "%s: needs a value; see %s --help", given->argument, program->name);
        return false;
    }
    if (given->is_long)
        message_write(message, size, "%s: is not an option; see %s --help", given->argument, program->name);
    else
        message_write(message, size, "-%c: is not an option; see %s --help", given->name[0], program->name);
    return false;
}

bool command_line_read(int *argc, char **argv, const command_program *program, char *message, size_t size)
{
    int count = 1;
    bool may_be_options = true;
    message[0] = '\0';
    for (int i = 1; i < *argc; i++) {
        if (may_be_options && strcmp(argv[i], "--") == 0) {
            may_be_options = false;
        } else if (may_be_options && argv[i][0] == '-' && argv[i][1]) {
            const given_option given = take_apart(argv[i]);
            bool took_next;
            if (!read_option(program, &given, i + 1 < *argc ? argv[i + 1] : NULL, &took_next, message, size)) return false;
            i += took_next;
        } else {
            argv[count++] = argv[i];
        }
    }
    *argc = count;
    return true;
}

bool command_line_read_scene(int argc, char **argv, const char *verb, const char **scene, char *message, size_t size)
{
    if (argc > 1) *scene = argv[1];
    if (argc <= 2) return true;
    message_write(message, size, "%s: is one scene too many; %s them one by one", argv[2], verb);
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
