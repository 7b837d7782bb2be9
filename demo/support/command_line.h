/*
 * What the programs' command lines share: values of options, and what is said of arguments that no program takes.
 */
#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include "context.h"
#include "render.h"

#include <stdbool.h>
#include <stddef.h>

/* ---- Values: whether `text` is one; a remedy says what it must be ------------------------------------------------------- */

/* A number of 1 to 9 digits; `end` is what follows it. */
bool read_count(const char *text, const char **end, int *count);
/* Such a number and nothing else. */
bool read_number(const char *text, int least, int most, int *number);

#define SIZE_REMEDY "must be WIDTHxHEIGHT, each from 1 to 8192, as in 640x360"
bool read_size(const char *text, int *width, int *height);

#define INTEGRATOR_REMEDY "must be adaptive, adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 or simpson:N, N even"
bool read_integrator(const char *text, render_settings *settings);

#define BACKEND_REMEDY "must be auto, egl or osmesa"
bool read_backend(const char *text, context_backend *backend);

/* ---- Bad arguments: false, with a message ------------------------------------------------------------------------------- */

/* What is wrong where getopt_long has just returned `option`, ':' or '?'. The list of short options begins with ':', and the
 * values of long ones without an argument are beyond characters: by them it tells --help=please from a bad short option. */
bool refuse_option(int option, char **argv, const char *program, char *message, size_t size);

/* Reads what is left after the options: one scene file or none, which leaves `scene` alone. `verb` is what the program does to
 * a scene. */
bool read_scene_name(int argc, char **argv, const char *verb, const char **scene, char *message, size_t size);

#endif
