/*
 * The demo's energy as a pure function of time: an orb that charges by two beams and fires, the shock ring and the bolt of
 * that, and a blade that circles. It repeats itself every ANIMATION_SECONDS without a seam.
 */
#ifndef ANIMATION_H
#define ANIMATION_H

#include "court.h"
#include "scene.h"

#define ANIMATION_SECONDS 10.0

enum { ANIMATION_BEAMS = 2, ANIMATION_BOLT = ANIMATION_BEAMS, ANIMATION_BLADE, ANIMATION_CURVES };
enum { ANIMATION_WEIGHTS = 12 };

/* The scene of one moment, with all that it points to; so it must not be copied, nor given to scene_free. */
typedef struct demo_animation {
    demo_scene scene;
    ew_point orb;
    ew_torus ring;
    ew_curve curves[ANIMATION_CURVES];
    double weights[ANIMATION_CURVES][ANIMATION_WEIGHTS];
    opaque_shape shapes[COURT_MAX_SHAPES];
} demo_animation;

/* Fills in the court and what never changes of the energy. */
void animation_init(demo_animation *animation);

/* Sets the sources and the camera to what they are at `seconds`, any finite number. The camera is the one of the recorded
 * path, which sways and comes back. */
void animation_set_time(demo_animation *animation, double seconds);

#endif
