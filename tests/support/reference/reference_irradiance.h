/*
 * The irradiance of surfaces by its definition, in double precision: adaptive quadrature along the sources' shapes. Paths are
 * the cubics that their points say, not the quadratic pieces that the library makes of them.
 */
#ifndef REFERENCE_IRRADIANCE_H
#define REFERENCE_IRRADIANCE_H

#include "energywave.h"

typedef struct reference_surface {
    double position[3];
    double normal[3]; /* unit */
} reference_surface;

/* Phong's lobe, of ew_specular. */
typedef struct reference_gloss {
    double mirrored[3]; /* unit: the lobe's axis */
    double exponent;
} reference_gloss;

/* E of ew_irradiance for a gain of 1; with a gloss, that of ew_specular. */
void reference_irradiance(const ew_sources_desc *sources, double light_reach, const reference_surface *surface,
                          const reference_gloss *gloss, double irradiance[3]);

#endif
