/*
 * Pictures as files. The file's name decides the format:
 *
 *     .png    8 bits a channel: clipped to 0 .. 1 and encoded as sRGB
 *     .hdr    Radiance RGBE, linear
 *     .pfm    32-bit floats as they are
 *
 * A file is written under a temporary name in the same folder and then renamed, so no half-written picture is ever seen.
 */
#ifndef IMAGE_H
#define IMAGE_H

#include <stdbool.h>
#include <stddef.h>

typedef enum image_format { IMAGE_UNKNOWN, IMAGE_PNG, IMAGE_HDR, IMAGE_PFM } image_format;

/* The format of a file's name, which must end in lower case. */
image_format image_format_of(const char *path);

/* Pixels in rows from the bottom up. */
typedef struct image_pixels {
    int width;
    int height;
    int channels; /* 4: linear RGB, and opacity, which is not written; 1: luminance, for .pfm only ("Pf") */
    const float *pixels;
    const unsigned char *srgb; /* 3 channels of 8-bit sRGB, for .png only; `pixels` is not used then */
} image_pixels;

/* Writes `image` to standard output as PNG. On failure returns false, with one line "-: what to mend" in `message`. */
bool image_print_png(const image_pixels *image, char *message, size_t size);

/* Writes `image` to `path`. On failure returns false, with one line "PATH: what to mend" in `message`, and leaves
 * an earlier file at `path` as it is. */
bool image_write(const char *path, const image_pixels *image, char *message, size_t size);

#endif
