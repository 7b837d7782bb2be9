/*
 * A picture's luminance against the reference, pixel by pixel: at all pixels or at a sample of them.
 */
#ifndef COMPARISON_H
#define COMPARISON_H

#include "true_pixels.h"

typedef struct picture_comparison {
    double largest_error; /* relative; infinite if any pixel's luminance is not finite */
    double percentile_99; /* of the representative pixels' errors */
    int worst_x, worst_y;
    double worst_luminance, worst_truth;
    size_t bad_count; /* of all the picture's pixels, those that are not finite or below 0 */
} picture_comparison;

/* Returns false where memory is exhausted. */
bool comparison_make(const true_pixels *truth, const drawn_picture *picture, picture_comparison *comparison);

/* How many of up to 400 of the pixels have a depth in the picture's buffer that no ray sees within 1/32 pixel of their
 * centre: the check that the depth buffer shows the scene file's shapes. */
size_t depth_misses(const scene_rays *rays, const true_pixels *truth, const drawn_picture *picture);

#endif
