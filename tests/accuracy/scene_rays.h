/*
 * A scene's pixels as rays for the reference: from the scene's camera alone, in double precision, with nothing of the
 * library's or the demo's matrices. Places are relative to the eye, in the world's directions, so that a world far from its
 * origin costs no digits.
 */
#ifndef SCENE_RAYS_H
#define SCENE_RAYS_H

#include "opaque.h"
#include "reference.h"
#include "scene_file.h"

#include <stdbool.h>

typedef struct scene_rays {
    scene_camera camera;
    double right[3], up[3], forward[3]; /* unit, in the world */
    bool is_world;                      /* then there is neither interval nor decay */
    double interval_start, interval_end;
    double decay_alpha, decay_beta;
    double core_pixels;
    ew_fog fog;
    ew_medium media[EW_MAX_MEDIA]; /* relative to the eye */
    size_t medium_count;
    int width, height;
    ew_sources_desc sources; /* relative to the eye */
    opaque_mesh mesh;        /* the scene's opaque triangles, relative to the eye */
} scene_rays;

/* Returns false, and nothing to free, where memory is exhausted. */
bool scene_rays_create(const demo_scene *scene, int width, int height, scene_rays *rays);
void scene_rays_free(scene_rays *rays);

/* The ray through (x, y) in pixels from the lower left corner (pixel centres are at halves), up to where it meets what lies
 * at the view depth `opaque_depth`, which may be HUGE_VAL. */
reference_ray scene_rays_ray(const scene_rays *rays, double x, double y, double opaque_depth);

/* The ray through the centre of a pixel, up to what a value of the depth buffer stands for. A cleared buffer's 1 is no surface:
 * there a ray of the world integral has no end. */
reference_ray scene_rays_pixel(const scene_rays *rays, int x, int y, double stored);

/* The view depth about which the scene's light is, and by how much it may be nearer or farther: the interval or, in the world
 * integral, where the camera looks. */
void scene_rays_depth_range(const scene_rays *rays, double *middle, double *length);

/* Where a place relative to the eye is seen, in pixels from the lower left corner, and its view depth. */
void scene_rays_project(const scene_rays *rays, const double place[3], double *x, double *y, double *view_depth);

/* The view depth that a value of the depth buffer stands for. A cleared buffer's 1 is the far plane. */
double scene_rays_stored_depth(const scene_rays *rays, double stored);

/* What the depth buffer holds where the nearest surface is at a view depth; 1 beyond the far plane. */
float scene_rays_depth_to_store(const scene_rays *rays, double view_depth);

/* The view depth of the nearest opaque triangle at (x, y) between the near and the far plane; HUGE_VAL where there is none. */
double scene_rays_cast(const scene_rays *rays, double x, double y);

/* Fills what the depth buffer holds at all pixels' centres, rows from the bottom up. */
void scene_rays_cast_all(const scene_rays *rays, float *depth);

#endif
