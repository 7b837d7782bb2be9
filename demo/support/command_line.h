/*
 * The command line of a program as a table of its options.
 */
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include <stdbool.h>
#include <stddef.h>

typedef struct command_option {
    const char *name; /* without its dashes */
    char letter;      /* the option's short form, or 0 */
    /* Reads the option's value into `target`, and returns whether it is one. NULL: the option has no value, and `target` is a
     * bool that becomes true. */
    bool (*read)(const char *text, void *target);
    void *target;
    const char *remedy; /* what a value must be, as in "must be a number from 1 to 4" */
} command_option;

typedef struct command_program {
    const char *name;
    const char *help; /* for --help, which every program has, as well as -h and --version */
    const command_option *options;
    size_t option_count;
} command_program;

/* Reads the options, which may stand between the other arguments, and leaves only these in `argc` and `argv`. Returns false
 * with a message; with an empty one where the options asked for a text, which has been printed. */
bool command_line_read(int *argc, char **argv, const command_program *program, char *message, size_t size);

/* Reads what the options left: one scene file, or none, which leaves `scene` alone. On failure returns false, with a
 * message that asks to `verb` the scenes one by one. */
bool command_line_read_scene(int argc, char **argv, const char *verb, const char **scene, char *message, size_t size);

/* ---- Values of options --------------------------------------------------------------------------------------------------- */

/* A number of 1 to 9 digits; `end` is what follows it. */
bool read_count(const char *text, const char **end, int *count);

/* Such a number and nothing else. */
bool read_number(const char *text, int least, int most, int *number);

#define SIZE_REMEDY "must be WIDTHxHEIGHT, each from 1 to 8192, as in 640x360"
bool read_size(const char *text, int *width, int *height);

/* Any text. `target` is a const char *. */
bool read_text(const char *text, void *target);

/* The name of a backend. `target` is a context_backend. */
#ifdef _WIN32
#define BACKEND_HELP "wgl or auto (default), which is WGL"
#define BACKEND_REMEDY "must be auto or wgl"
#elif defined(__EMSCRIPTEN__)
#define BACKEND_HELP "webgl or auto (default), which is WebGL"
#define BACKEND_REMEDY "must be auto or webgl"
#else
#define BACKEND_HELP "egl, osmesa or auto (default): EGL or else OSMesa"
#define BACKEND_REMEDY "must be auto, egl or osmesa"
#endif
bool read_backend(const char *text, void *target);

/* The name of an integrator. `target` is a render_settings, of which the size is left alone. */
#define INTEGRATOR_REMEDY "must be adaptive, adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 or simpson:N, N even"
bool read_integrator(const char *text, void *target);

/* The name of a resolution. `target` is an ew_resolution. */
#define RESOLUTION_REMEDY "must be adaptive or full"
bool read_resolution(const char *text, void *target);

#endif
