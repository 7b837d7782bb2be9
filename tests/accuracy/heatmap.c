/* A picture of where another one is wrong: see heatmap.h. */
#include "heatmap.h"
#include "image.h"
#include "message.h"

#include <math.h>
#include <stdlib.h>

bool heatmap_write(const char *path, const true_pixels *truth, const drawn_picture *picture, char *message, size_t size)
{
    static const float ramp[][3] = {{0, 0, 0}, {0, 0, 0.6f}, {0, 0.5f, 0.2f}, {1, 0.8f, 0}, {1, 0, 0}, {1, 1, 1}};
    enum { LAST = sizeof ramp / sizeof *ramp - 1 };
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    float *colors = malloc(pixel_count * 4 * sizeof *colors);
    if (!colors) {
        message_write(message, size, "%s: does not fit into memory", path);
        return false;
    }
    for (size_t i = 0; i < pixel_count * 4; i++)
        colors[i] = 0.2f;
    for (size_t i = 0; i < truth->count; i++) {
        const true_pixel *pixel = &truth->pixels[i];
        if (!pixel->reliable) continue;
        double position = fmin(LAST, fmax(0, log10(true_pixel_error(truth, picture, pixel)) + 6));
        int step = position < LAST ? (int)position : LAST - 1;
        for (int k = 0; k < 3; k++)
            colors[true_pixel_index(picture, pixel) * 4 + (size_t)k] =
                ramp[step][k] + (float)(position - step) * (ramp[step + 1][k] - ramp[step][k]);
    }
    image_pixels image = {.width = picture->width, .height = picture->height, .channels = 4, .pixels = colors};
    bool ok = image_write(path, &image, message, size);
    free(colors);
    return ok;
}
