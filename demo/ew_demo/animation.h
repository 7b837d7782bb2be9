/*
 * The demo's energy as a pure function of time. Lightning and a stream charge an orb, which fires a beam and sends out a shock
 * ring; a spiral winds round a pillar, and a blade slashes. The animation repeats every ANIMATION_SECONDS without a seam.
 */
#ifndef ANIMATION_H
#define ANIMATION_H

#include "court.h"
#include "scene.h"

#define ANIMATION_SECONDS 10.0

enum { ANIMATION_ORB, ANIMATION_IMPACT, ANIMATION_POINTS };
enum { ANIMATION_BOLT, ANIMATION_BRANCH, ANIMATION_STREAM, ANIMATION_SPIRAL, ANIMATION_SLASH, ANIMATION_BEAM, ANIMATION_PATHS };
/* Globes of gas round the emitters, and a force field round the pillar that the orb fires at. */
enum { ANIMATION_GLOBES = 2, ANIMATION_SHIELD = ANIMATION_GLOBES, ANIMATION_MEDIA };
enum { ANIMATION_PATH_POINTS = 40, ANIMATION_WEIGHTS = 40 };

/* The scene at one moment. It points into this structure, which must therefore not be copied. */
typedef struct demo_animation {
    demo_scene scene;
    bool flies; /* the camera flies from 100 m away into the orb, rather than sway before the court */
    ew_point points[ANIMATION_POINTS];
    ew_torus ring;
    ew_medium media[ANIMATION_MEDIA];
    ew_path paths[ANIMATION_PATHS];
    double path_points[ANIMATION_PATHS][ANIMATION_PATH_POINTS][3];
    double weights[ANIMATION_PATHS][ANIMATION_WEIGHTS];
    opaque_shape shapes[COURT_MAX_SHAPES];
} demo_animation;

/* Fills in the court and everything that does not change with time. */
void animation_init(demo_animation *animation);

/* Sets the sources and the camera to what they are at `seconds`, which may be any finite number. The camera sways along its
 * path and comes back. */
void animation_set_time(demo_animation *animation, double seconds);

#endif
