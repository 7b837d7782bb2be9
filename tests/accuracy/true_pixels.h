/*
 * What the reference says of a picture's pixels: of all of them or of a sample.
 */
#ifndef TRUE_PIXELS_H
#define TRUE_PIXELS_H

#include "picture.h"
#include "scene_rays.h"

#include <stdbool.h>
#include <stddef.h>

/* Errors are relative to the truth or, where it is darker, to this share of the largest truth of the picture. */
#define TRUTH_DARK 1e-3
/* The same at adaptive resolution. */
#define TRUTH_DARK_INTERPOLATED 0.03
/* Where fog hides even the brightest, this luminance, of which no target shows anything. */
#define TRUTH_INVISIBLE 1e-6

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
    double dark;    /* the share of it that errors are relative to at the least, */
    double darkest; /* and a luminance */
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

/* Where the picture has the pixel, and the luminance there. */
size_t true_pixel_index(const drawn_picture *picture, const true_pixel *pixel);
double true_pixel_luminance(const drawn_picture *picture, const true_pixel *pixel);

/* The relative error there; infinite if the luminance is not finite. */
double true_pixel_error(const true_pixels *truth, const drawn_picture *picture, const true_pixel *pixel);

#endif
