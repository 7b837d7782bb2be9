/*
 * Where the light is, and with it the error: places on the sources, and the pixels around them.
 */
#ifndef CORE_PIXELS_H
#define CORE_PIXELS_H

#include "scene_rays.h"

#include <stdint.h>

/* A random place on a random source, relative to the eye, and the radius of the source's core. False if there is no source. */
bool random_source_place(const scene_rays *rays, uint64_t *random, double place[3], double *core);

/* Chooses at random a pixel from a quarter to 32 pixels away from a random place on a random source, all magnitudes alike.
 * False if there is none: it would lie outside of the picture, or the place is not in the interval. */
bool random_core_pixel(const scene_rays *rays, uint64_t *random, int *x, int *y);

#endif
