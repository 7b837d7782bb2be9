/*
 * The demo's energy as a pure function of time. Two beams charge an orb, which fires a bolt and sends out a shock ring, while a
 * blade circles. The animation repeats every ANIMATION_SECONDS without a seam.
 */
#ifndef ANIMATION_H
#define ANIMATION_H

#include "court.h"
#include "scene.h"

#define ANIMATION_SECONDS 10.0

enum { ANIMATION_BEAMS = 2, ANIMATION_BOLT = ANIMATION_BEAMS, ANIMATION_BLADE, ANIMATION_CURVES };
enum { ANIMATION_WEIGHTS = 12 };

/* The scene at one moment. It points into this structure, which must therefore not be copied. */
typedef struct demo_animation {
    demo_scene scene;
    ew_point orb;
    ew_torus ring;
    ew_curve curves[ANIMATION_CURVES];
    double weights[ANIMATION_CURVES][ANIMATION_WEIGHTS];
    opaque_shape shapes[COURT_MAX_SHAPES];
} demo_animation;

/* Fills in the court and everything that does not change with time. */
void animation_init(demo_animation *animation);

/* Sets the sources and the camera to what they are at `seconds`, which may be any finite number. The camera sways along its
 * path and comes back. */
void animation_set_time(demo_animation *animation, double seconds);

#endif
