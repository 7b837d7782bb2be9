/*
 * The court in which the demo takes place: a floor, steps, pillars and spheres, none of which move.
 */
#ifndef COURT_H
#define COURT_H

#include "scene.h"

#include <stddef.h>

/* World units are metres; y is up, and 0 on the floor. */
#define COURT_FLOOR_HALF_SIDE 60.0
/* Where the orb hovers. */
extern const double court_orb[3];

/* Where the energy that charges it comes from. */
extern const double court_emitters[2][3];

/* What the orb fires at: a place on a pillar. */
extern const double court_target[3];

/* The middle of that pillar. */
extern const double court_shield[3];

/* The foot of the pillar round which a spiral winds. */
extern const double court_spiral_base[3];

enum { COURT_MAX_SHAPES = 64 };

/* Fills `shapes` with boxes and spheres, and returns their count. */
size_t court_make_shapes(opaque_shape shapes[COURT_MAX_SHAPES]);

#endif
