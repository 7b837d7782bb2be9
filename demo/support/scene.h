/*
 * A scene: a camera, sources of energy, and opaque shapes. Lengths in world units, colours linear RGB.
 */
#ifndef SCENE_H
#define SCENE_H

#include "energywave.h"
#include "memory_chain.h"

#include <stdbool.h>
#include <stddef.h>

enum { MAX_OPAQUE_SHAPES = 256 };

typedef struct scene_camera {
    double eye[3];
    double target[3]; /* differs from eye */
    double up[3];     /* not parallel to target - eye */
    bool orthographic;
    double fov_y_degrees; /* of a perspective camera */
    double height;        /* of an orthographic camera's picture, in world units */
    double near_depth;    /* view depth of the near plane */
    double far_depth;     /* view depth of the far plane */
} scene_camera;

typedef enum opaque_kind { OPAQUE_BOX, OPAQUE_PLANE, OPAQUE_SPHERE } opaque_kind;

typedef struct opaque_shape {
    opaque_kind kind;
    union {
        struct {
            double min[3];
            double max[3];
        } box;
        struct {
            double point[3];
            double normal[3];
        } plane;
        struct {
            double center[3];
            double radius;
        } sphere;
    } shape;
    double color[3]; /* linear RGB */
} opaque_shape;

typedef struct demo_scene {
    scene_camera camera;
    double interval_start; /* a view depth, as is the end; both are 0 in the world integral */
    double interval_end;
    double decay_alpha;
    double decay_beta;
    double core_pixels;
    double exposure;
    double light_gain;       /* on the opaque shapes */
    double light_reach;      /* 0: the sources do not light these */
    double shadow_thickness; /* of them; 0: they cast no shadows */
    ew_fog fog;
    ew_medium *media;
    size_t medium_count;
    double background[3];
    double color[3];     /* the default of sources; those that name no other have it already */
    ew_output composite; /* EW_OUTPUT_LERP, EW_OUTPUT_ADD or EW_OUTPUT_SOFT */
    ew_sources_desc sources;
    opaque_shape *opaque;
    size_t opaque_count;
    memory_chain *memory; /* of a scene from a file: all its lists */
} demo_scene;

/* Whether the scene is of the world integral, not of the papers'. */
static inline bool scene_is_world(const demo_scene *scene)
{
    return scene->interval_start == 0 && scene->interval_end == 0;
}

#endif
