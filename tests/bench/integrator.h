/*
 * What is compared, by the names that users write: "adaptive:1e-3", "full:1e-3", "simpson:200", "marching:64",
 * "equiangular:64", "half-marching:32", "billboards:64", "ribbon:64", "bare".
 */
#ifndef INTEGRATOR_H
#define INTEGRATOR_H

#include "energywave.h"

#include <stdbool.h>
#include <stddef.h>

typedef enum integrator_family {
    FAMILY_ADAPTIVE, /* the library's, at adaptive resolution */
    FAMILY_FULL,     /* the library's, at every pixel */
    FAMILY_SIMPSON,  /* the published method, as the library has it */
    FAMILY_MARCHING, /* peers: the benchmark's own shaders, from here on */
    FAMILY_EQUIANGULAR,
    FAMILY_HALF_MARCHING, /* as games draw glows */
    FAMILY_BILLBOARDS,
    FAMILY_RIBBON,
    FAMILY_BARE, /* no integrator: a pass over the same target that writes a constant */
    FAMILY_COUNT
} integrator_family;

extern const char *const integrator_family_names[FAMILY_COUNT];

/* The largest number of samples of the peers. */
#define INTEGRATOR_MAX_SAMPLES 65536

/* The largest number of billboards or of a ribbon's sections. */
#define INTEGRATOR_MAX_SECTIONS 4096

typedef struct bench_integrator {
    char name[24];
    integrator_family family;
    ew_quality quality; /* of FAMILY_ADAPTIVE and FAMILY_FULL */
    int samples; /* of FAMILY_SIMPSON: divisions; of billboards and ribbons: how many a source has; of the other peers: samples
                  */
} bench_integrator;

/* Whether it is the library's own. */
static inline bool integrator_is_ours(const bench_integrator *integrator)
{
    return integrator->family == FAMILY_ADAPTIVE || integrator->family == FAMILY_FULL;
}

/* Whether it evaluates the field, in a shader that can count how often. */
static inline bool integrator_counts_evaluations(const bench_integrator *integrator)
{
    return integrator->family < FAMILY_HALF_MARCHING;
}

/* All that a report compares: of the papers' integral, and of frames as games have them. */
extern const char integrator_default_list[], integrator_frame_list[];

/* Reads names separated by commas into an array that the caller frees; NULL with a message if one is unknown or a duplicate. */
bench_integrator *integrator_parse_list(const char *text, size_t *count, char *message, size_t size);

#endif
