/*
 * What a picture file holds, for shell scripts:
 *
 *     ew-probe-image size FILE             prints "WIDTH HEIGHT CHANNELS"
 *     ew-probe-image pixel FILE X Y        prints the pixel's channels; rows from the top
 *     ew-probe-image difference A B        prints the largest difference of a channel and the share of pixels that differ by
 *                                          more than 1, in percent
 *
 * for .png (values 0 .. 255), .hdr and .pfm.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

typedef struct picture {
    int width;
    int height;
    int channels;
    float *values; /* rows from the top */
} picture;

_Noreturn static void fail(const char *path, const char *what)
{
    fprintf(stderr, "ew-probe-image: %s: %s\n", path, what);
    exit(EXIT_FAILURE);
}

static picture load_pfm(const char *path)
{
    picture result = {0};
    char kind;
    float scale;
    FILE *file = fopen(path, "rb");
    if (!file || fscanf(file, "P%c %d %d %f", &kind, &result.width, &result.height, &scale) != 4 || fgetc(file) != '\n')
        fail(path, "is no PFM");
    if (scale != -1) fail(path, "is not little-endian");
    result.channels = kind == 'F' ? 3 : 1;
    size_t row_length = (size_t)result.width * (size_t)result.channels;
    result.values = malloc(row_length * (size_t)result.height * sizeof(float));
    if (!result.values) fail(path, "does not fit into memory");
    for (int row = result.height - 1; row >= 0; row--)
        if (fread(result.values + (size_t)row * row_length, sizeof(float), row_length, file) != row_length)
            fail(path, "is too short");
    if (fgetc(file) != EOF) fail(path, "is too long");
    fclose(file);
    return result;
}

static picture load_png(const char *path)
{
    picture result = {0};
    unsigned char *bytes = stbi_load(path, &result.width, &result.height, &result.channels, 0);
    if (!bytes) fail(path, "is no picture");
    size_t count = (size_t)result.width * (size_t)result.height * (size_t)result.channels;
    result.values = malloc(count * sizeof(float));
    if (!result.values) fail(path, "does not fit into memory");
    for (size_t i = 0; i < count; i++)
        result.values[i] = bytes[i];
    free(bytes);
    return result;
}

static picture load(const char *path)
{
    const char *ending = strrchr(path, '.');
    picture result = {0};
    if (ending && strcmp(ending, ".pfm") == 0) return load_pfm(path);
    if (!stbi_is_hdr(path)) return load_png(path);
    result.values = stbi_loadf(path, &result.width, &result.height, &result.channels, 0);
    if (!result.values) fail(path, "is no picture");
    return result;
}

static void print_difference(const char *path_a, const char *path_b)
{
    picture a = load(path_a), b = load(path_b);
    if (a.width != b.width || a.height != b.height || a.channels != b.channels) fail(path_b, "is of another size");
    double largest = 0, above = 0, pixels = (double)a.width * a.height;
    for (size_t i = 0; i < (size_t)pixels; i++) {
        double difference = 0;
        for (size_t k = 0; k < (size_t)a.channels; k++) {
            size_t at = i * (size_t)a.channels + k;
            difference = fmax(difference, fabs((double)a.values[at] - (double)b.values[at]));
        }
        largest = fmax(largest, difference);
        above += difference > 1;
    }
    printf("%g %g\n", largest, 100 * above / pixels);
    free(a.values);
    free(b.values);
}

static void print_pixel(const char *path, int x, int y)
{
    picture image = load(path);
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) fail(path, "has no such pixel");
    for (int k = 0; k < image.channels; k++)
        printf("%s%.9g", k ? " " : "",
               (double)image.values[((size_t)y * (size_t)image.width + (size_t)x) * (size_t)image.channels + (size_t)k]);
    printf("\n");
    free(image.values);
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "size") == 0) {
        picture image = load(argv[2]);
        printf("%d %d %d\n", image.width, image.height, image.channels);
        free(image.values);
    } else if (argc == 5 && strcmp(argv[1], "pixel") == 0) {
        print_pixel(argv[2], atoi(argv[3]), atoi(argv[4]));
    } else if (argc == 4 && strcmp(argv[1], "difference") == 0) {
        print_difference(argv[2], argv[3]);
    } else {
        fail("usage", "size FILE, pixel FILE X Y or difference A B");
    }
    return EXIT_SUCCESS;
}
