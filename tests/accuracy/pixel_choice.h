/*
 * Which pixels of a picture to compare with the truth: always the same for the same picture.
 */
#ifndef PIXEL_CHOICE_H
#define PIXEL_CHOICE_H

#include "true_pixels.h"

/* Adds a pixel, unless it is among them. */
void choose_pixel(true_pixels *truth, const drawn_picture *picture, size_t index, bool representative);

/* Makes the choice that true_pixels_compute describes. Returns false, and nothing to free, where memory is exhausted. */
bool choose_pixels(const scene_rays *rays, const drawn_picture *picture, size_t count, true_pixels *truth);

typedef struct ranked_pixel {
    double value;
    size_t index;
} ranked_pixel;

/* The pixels by the picture's luminance or, with another picture of the scene, by how much of it (or of `dark` of the largest)
 * they differ, from the least to the largest; what is no number counts as large. The caller frees them. NULL where memory is
 * exhausted. */
ranked_pixel *rank_pixels(const drawn_picture *picture, const drawn_picture *other, double dark);

#endif
