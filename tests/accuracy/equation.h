/*
 * Equations between luminances, which a scene's pictures must satisfy.
 *
 * Each picture may be wrong by the default quality's bound, relative to itself or, where it is darker, to 1e-3 of its largest
 * luminance. So the two sides may differ by the sum of that: by twice the bound for an equation of two pictures.
 */
#ifndef EQUATION_H
#define EQUATION_H

#include "field_drawer.h"
#include "scene_file.h"
#include "scene_rays.h"

#include <stdbool.h>

enum { EQUATION_SIDE = 48, EQUATION_PIXEL_COUNT = EQUATION_SIDE * EQUATION_SIDE };

typedef struct equation_stage {
    const char *path;
    const demo_scene *scene;
    scene_rays rays;
    field_drawer drawer;
    float depth[EQUATION_PIXEL_COUNT];
    bool wrong;
} equation_stage;

/* One side of an equation: a sum, and by how much it may be wrong. NaN where the equation says nothing. */
typedef struct luminance_sum {
    double sum[EQUATION_PIXEL_COUNT];
    double allowance[EQUATION_PIXEL_COUNT];
} luminance_sum;

/* The frame that draws the stage's scene. */
ew_frame_desc equation_frame(const equation_stage *s);

/* Adds `sign` times a picture to a sum. On failure says why and returns false. */
bool equation_add_picture(equation_stage *s, const ew_sources_desc *sources, const ew_frame_desc *frame, const float *depth,
                          double sign, luminance_sum *sum);

/* Compares the sides where `applies` (NULL for everywhere), and says what was found. */
void equation_compare(equation_stage *s, const char *relation, const luminance_sum *left, const luminance_sum *right,
                      const bool *applies);

#endif
