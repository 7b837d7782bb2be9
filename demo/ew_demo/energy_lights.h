/*
 * The energy as point lights, for the opaque scene to be lit by: the look of it, not its integral.
 */
#ifndef ENERGY_LIGHTS_H
#define ENERGY_LIGHTS_H

#include "energywave.h"

#include <stddef.h>

enum { ENERGY_MAX_LIGHTS = 64 };

typedef struct energy_light {
    double position[3];
    double radius; /* within which it grows no brighter: half the distance to the next light of the same source */
    double color[3];
} energy_light;

/* Spreads lights along the sources, tori and curves getting several each; returns how many there are. Sources that find no
 * room light nothing. */
size_t energy_make_lights(const ew_sources_desc *sources, energy_light lights[ENERGY_MAX_LIGHTS]);

#endif
