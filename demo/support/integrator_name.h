/*
 * The library's integrators by the names that users write: adaptive:1e-2, adaptive:1e-3, adaptive:1e-4, simpson:N.
 */
#ifndef INTEGRATOR_NAME_H
#define INTEGRATOR_NAME_H

#include "render.h"

enum { INTEGRATOR_NAME_SIZE = 24 };

/* Sets the settings' integrator, and nothing else, to the one called `name`; "adaptive" alone is adaptive:1e-3. Returns whether
 * there is one. */
bool integrator_from_name(const char *name, render_settings *settings);

/* Writes the name of the settings' integrator. */
void integrator_write_name(const render_settings *settings, char name[INTEGRATOR_NAME_SIZE]);

#endif
