/*
 * The court in which the demo's energy plays: a floor, steps, pillars and spheres. Nothing of it moves.
 */
#ifndef COURT_H
#define COURT_H

#include "scene.h"

#include <stddef.h>

/* World units are metres, y is up and 0 on the floor. The orb hovers in the middle; two beams rise from the emitters. */
#define COURT_FLOOR_HALF_SIDE 60.0
extern const double court_orb[3];
extern const double court_emitters[2][3];

enum { COURT_MAX_SHAPES = 64 };

/* Fills `shapes` with boxes and spheres; returns how many there are. */
size_t court_make_shapes(opaque_shape shapes[COURT_MAX_SHAPES]);

#endif
