/*
 * The library's integrators by the names that users write, with the errors that they promise.
 */
#ifndef NAMED_INTEGRATOR_H
#define NAMED_INTEGRATOR_H

#include "render.h"

typedef struct named_integrator {
    char name[24]; /* adaptive:1e-2, adaptive:1e-3, adaptive:1e-4 or simpson:N */
    render_settings settings;
    double largest_error; /* that it promises; infinite for Simpson's rule */
    double percentile_99;
} named_integrator;

/* False if there is none of that name. */
bool named_integrator_find(const char *name, named_integrator *result);

#endif
