/*
 * A picture's luminance against the reference, pixel by pixel: at all pixels or at a sample of them.
 */
#ifndef COMPARISON_H
#define COMPARISON_H

#include "picture.h"
#include "scene_rays.h"

#include <stdbool.h>
#include <stddef.h>

/* Errors are relative to the truth or, where it is darker, to this share of the largest truth of the picture. */
#define COMPARISON_DARK 1e-3

/* A pixel and what the reference says of it. */
typedef struct true_pixel {
    int x;
    int y;               /* from the bottom */
    bool representative; /* one of the evenly spread, not chosen for being hard */
    bool reliable;       /* the reference vouches for the luminance */
    double luminance;
} true_pixel;

typedef struct true_pixels {
    true_pixel *pixels;
    size_t count;
    size_t first_count;    /* without those of true_pixels_refine */
    unsigned char *chosen; /* for each of the picture's pixels, whether it is among them */
    size_t unreliable_count;
    double largest; /* luminance */
} true_pixels;

/* Chooses about `count` pixels (0: all), always the same for the same picture: half of them spread evenly, one at random in
 * each cell of a grid, and the others where it is hard: the brightest and the darkest of the picture and those at the opaque
 * shapes' silhouettes. Computes their luminance on `threads` threads, each ray ending at the surface in the picture's depth
 * buffer: what the effect is held to is the depth it is given; how finely the host's rasteriser resolves its geometry is not
 * the effect's doing. Returns false, and nothing to free, where memory is exhausted. */
bool true_pixels_compute(const scene_rays *rays, const drawn_picture *picture, size_t count, int threads, true_pixels *truth);
void true_pixels_free(true_pixels *truth);

/* Looks for pixels at which the picture is more wrong than at those so far: adds those at which it differs most from another
 * picture of the scene, then the neighbours of the worst, and again those of the worst then, until there are half as many more
 * as there were first. Returns false where memory is exhausted. */
bool true_pixels_refine(const scene_rays *rays, const drawn_picture *picture, const drawn_picture *other, int threads,
                        true_pixels *truth);

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

/* Writes where the errors are as a picture: black below 1e-6, then blue, green, yellow and red by powers of 10 up to 1e-1,
 * white above; grey where the pixel was not compared. On failure returns false, with a message. */
bool heatmap_write(const char *path, const true_pixels *truth, const drawn_picture *picture, char *message, size_t size);

#endif
