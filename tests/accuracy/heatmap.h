/*
 * A picture of where another one is wrong.
 */
#ifndef HEATMAP_H
#define HEATMAP_H

#include "true_pixels.h"

/* Writes where the errors are as a picture: black below 1e-6, then blue, green, yellow and red by powers of 10 up to 1e-1,
 * white above; grey where the pixel was not compared. On failure returns false, with a message. */
bool heatmap_write(const char *path, const true_pixels *truth, const drawn_picture *picture, char *message, size_t size);

#endif
