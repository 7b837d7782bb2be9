/*
 * Point lights in place of the energy, to light the opaque scene. They look right; they are no integral.
 */
#ifndef ENERGY_LIGHTS_H
#define ENERGY_LIGHTS_H

#include "energywave.h"

#include <stddef.h>

enum { ENERGY_MAX_LIGHTS = 64 };

typedef struct energy_light {
    double position[3];
    double radius; /* closer than this it grows no brighter: half the distance to the source's next light */
    double color[3];
} energy_light;

/* Puts one light at each point and several along each torus and path, until `lights` is full. Only sources with a reach and a
 * brightness count. Returns their count. */
size_t energy_make_lights(const ew_sources_desc *sources, energy_light lights[ENERGY_MAX_LIGHTS]);

#endif
