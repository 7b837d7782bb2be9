/*
 * The values of options that the programs share. Each function returns whether `text` is such a value; a remedy says what it
 * must be.
 */
#ifndef OPTION_VALUES_H
#define OPTION_VALUES_H

#include "context.h"
#include "render.h"

#include <stdbool.h>

/* A number of 1 to 9 digits; `end` is what follows it. */
bool read_count(const char *text, const char **end, int *count);

#define SIZE_REMEDY "must be WIDTHxHEIGHT, each from 1 to 8192, as in 640x360"
bool read_size(const char *text, render_settings *settings);

#define INTEGRATOR_REMEDY "must be adaptive, adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 or simpson:N, N even"
bool read_integrator(const char *text, render_settings *settings);

#define BACKEND_REMEDY "must be auto, egl or osmesa"
bool read_backend(const char *text, context_backend *backend);

#endif
