/*
 * What is compared, by the names that users write: "adaptive:1e-3", "full:1e-3", "simpson:200", "marching:64",
 * "equiangular:64", "bare".
 */
#ifndef INTEGRATOR_H
#define INTEGRATOR_H

#include "energywave.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum integrator_family {
    FAMILY_ADAPTIVE,    /* the library's, at adaptive resolution */
    FAMILY_FULL,        /* the library's, at every pixel */
    FAMILY_SIMPSON,     /* the published method, as the library has it */
    FAMILY_MARCHING,    /* peers: the benchmark's own shaders */
    FAMILY_EQUIANGULAR, /*  */
    FAMILY_BARE,        /* no integrator: a pass over the same target that writes a constant */
    FAMILY_COUNT
} integrator_family;

extern const char *const integrator_family_names[FAMILY_COUNT];

/* The largest number of samples of the peers. */
#define INTEGRATOR_MAX_SAMPLES 65536

typedef struct bench_integrator {
    char name[24];
    integrator_family family;
    ew_quality quality; /* of FAMILY_ADAPTIVE and FAMILY_FULL */
    int samples;        /* of FAMILY_SIMPSON: divisions; of the peers: samples */
} bench_integrator;

/* Whether it is the library's own. */
static inline bool integrator_is_ours(const bench_integrator *integrator)
{
    return integrator->family == FAMILY_ADAPTIVE || integrator->family == FAMILY_FULL;
}

/* All that a report compares. */
extern const char integrator_default_list[];

/* Reads names separated by commas into an array that the caller frees; NULL with a message if one is unknown or a duplicate. */
bench_integrator *integrator_parse_list(const char *text, size_t *count, char *message, size_t size);

#endif
