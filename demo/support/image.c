/* Pictures as files: see image.h. */
#include "image.h"
#include "file_replacement.h"
#include "files.h"
#include "message.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The largest number that RGBE can hold: its exponent is one byte. */
static const float largest_rgbe = 1.69e38f;

/* The largest number in the name of a temporary file. */

image_format image_format_of(const char *path)
{
    const char *ending = strrchr(path, '.');
    if (ending && strcmp(ending, ".png") == 0) return IMAGE_PNG;
    if (ending && strcmp(ending, ".hdr") == 0) return IMAGE_HDR;
    if (ending && strcmp(ending, ".pfm") == 0) return IMAGE_PFM;
    return IMAGE_UNKNOWN;
}

/* The transfer function of sRGB, by IEC 61966-2-1. */
static unsigned char encode_srgb(float linear)
{
    float clipped = fminf(fmaxf(linear, 0), 1);
    float encoded = clipped <= 0.0031308f ? 12.92f * clipped : 1.055f * powf(clipped, 1 / 2.4f) - 0.055f;
    return (unsigned char)(255 * encoded + 0.5f);
}

/* The index of a pixel whose row counts from the top, as in PNG and RGBE. */
static size_t pixel_from_top(const image_pixels *image, int row, int column)
{
    return (size_t)(image->height - 1 - row) * (size_t)image->width + (size_t)column;
}

static const float *color_from_top(const image_pixels *image, int row, int column)
{
    return image->pixels + pixel_from_top(image, row, column) * 4;
}

static void write_bytes(void *file, void *bytes, int count)
{
    fwrite(bytes, 1, (size_t)count, file);
}

static bool write_png(const image_pixels *image, FILE *file)
{
    size_t width = (size_t)image->width;
    unsigned char *bytes = malloc(width * (size_t)image->height * 3), *byte = bytes;
    if (!bytes) return false;
    for (int row = 0; row < image->height; row++)
        for (int column = 0; column < image->width; column++)
            for (int i = 0; i < 3; i++)
                *byte++ = image->srgb ? image->srgb[3 * pixel_from_top(image, row, column) + (size_t)i]
                                      : encode_srgb(color_from_top(image, row, column)[i]);
    bool ok = stbi_write_png_to_func(write_bytes, file, image->width, image->height, 3, bytes, image->width * 3);
    free(bytes);
    return ok;
}

static bool write_hdr(const image_pixels *image, FILE *file)
{
    size_t width = (size_t)image->width;
    float *floats = malloc(width * (size_t)image->height * 3 * sizeof *floats), *next = floats;
    if (!floats) return false;
    for (int row = 0; row < image->height; row++)
        for (int column = 0; column < image->width; column++)
            for (int i = 0; i < 3; i++)
                *next++ = fminf(color_from_top(image, row, column)[i], largest_rgbe);
    bool ok = stbi_write_hdr_to_func(write_bytes, file, image->width, image->height, 3, floats);
    free(floats);
    return ok;
}

static bool write_pfm(const image_pixels *image, FILE *file)
{
    const uint16_t one = 1;
    bool little_endian = *(const unsigned char *)&one == 1;
    size_t count = (size_t)image->width * (size_t)image->height, channels = image->channels == 1 ? 1 : 3;
    fprintf(file, "%s\n%d %d\n%s\n", channels == 1 ? "Pf" : "PF", image->width, image->height, little_endian ? "-1.0" : "1.0");
    for (size_t i = 0; i < count; i++)
        fwrite(image->pixels + i * (size_t)image->channels, sizeof(float), channels, file);
    return true;
}

/* Returns false and sets errno where the picture does not fit on the disk or in memory. */
static bool write_image(image_format format, const image_pixels *image, FILE *file)
{
    bool ok = format == IMAGE_PNG   ? write_png(image, file)
              : format == IMAGE_HDR ? write_hdr(image, file)
                                    : write_pfm(image, file);
    return ok && fflush(file) == 0 && !ferror(file);
}

bool image_print_png(const image_pixels *image, char *message, size_t size)
{
    file_print_bytes();
    if (write_image(IMAGE_PNG, image, stdout)) return true;
    message_write(message, size, "-: standard output cannot be written (%s); lead it to where there is room", strerror(errno));
    return false;
}

bool image_write(const char *path, const image_pixels *image, char *message, size_t size)
{
    file_replacement replacement;
    bool ok = file_replacement_begin(&replacement, path);
    ok = file_replacement_end(&replacement, ok && write_image(image_format_of(path), image, replacement.file));
    if (!ok)
        message_write(message, size, "%s: cannot be written (%s); name a file in a folder that takes it", path,
                      strerror(errno));
    return ok;
}
