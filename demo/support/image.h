/*
 * Pictures as files. The file's name decides the format:
 *
 *     .png    8 bits a channel: clipped to 0 .. 1 and encoded as sRGB
 *     .hdr    Radiance RGBE, linear
 *     .pfm    32-bit floats as they are
 *
 * A file is written under a temporary name next to its own and then renamed: no half-written picture ever stands there.
 */
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum image_format { IMAGE_UNKNOWN, IMAGE_PNG, IMAGE_HDR, IMAGE_PFM } image_format;

/* By the name's ending, in small letters. */
image_format image_format_of(const char *path);

/* Pixels in rows from the bottom up. */
typedef struct image_pixels {
    int width;
    int height;
    int channels; /* 4: linear RGB and an opacity that no format keeps; 1: a luminance, for .pfm only ("Pf") */
    const float *pixels;
    const unsigned char *srgb; /* instead of `pixels`, for .png only: 8-bit sRGB, 3 channels */
} image_pixels;

/* Writes `image` to `path`. On failure returns false, with one line "PATH: what to mend" in `message`; a file that stood there
 * before stands there still. */
bool image_write(const char *path, const image_pixels *image, char *message, size_t size);

#endif
