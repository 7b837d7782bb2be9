/* Which pixels to compare: see pixel_choice.h. */
#include "pixel_choice.h"

#include <math.h>
#include <stdlib.h>

void choose_pixel(true_pixels *truth, const drawn_picture *picture, size_t index, bool representative)
{
    if (truth->chosen[index]) return;
    truth->chosen[index] = 1;
    truth->pixels[truth->count++] = (true_pixel){
        .x = (int)(index % (size_t)picture->width),
        .y = (int)(index / (size_t)picture->width),
        .representative = representative,
    };
}

static void choose_evenly(true_pixels *truth, const drawn_picture *picture, size_t count)
{
    int width = picture->width, height = picture->height;
    double side = sqrt((double)width * height / (double)count);
    int columns = (int)ceil(width / side), rows = (int)ceil(height / side);
    uint64_t random = 1;
    for (int row = 0; row < rows; row++)
        for (int column = 0; column < columns; column++) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            int left = width * column / columns, right = width * (column + 1) / columns;
            int bottom = height * row / rows, top = height * (row + 1) / rows;
            if (left == right || bottom == top) continue;
            int x = left + (int)((random >> 33) % (uint64_t)(right - left));
            int y = bottom + (int)((random >> 48) % (uint64_t)(top - bottom));
            choose_pixel(truth, picture, (size_t)y * (size_t)width + (size_t)x, true);
        }
}

static int compare_ranked(const void *a, const void *b)
{
    const ranked_pixel *first = a, *second = b;
    if (first->value != second->value) return first->value < second->value ? -1 : 1;
    return first->index < second->index ? -1 : 1;
}

ranked_pixel *rank_pixels(const drawn_picture *picture, const drawn_picture *other, double dark)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    ranked_pixel *ranking = malloc(pixel_count * sizeof *ranking);
    double largest = 0;
    for (size_t i = 0; i < pixel_count; i++)
        if (isfinite(picture->luminance[i])) largest = fmax(largest, (double)picture->luminance[i]);
    for (size_t i = 0; ranking && i < pixel_count; i++) {
        double value = (double)picture->luminance[i];
        if (other) value = fabs((double)other->luminance[i] - value) / fmax(value, dark * largest + 1e-30);
        ranking[i] = (ranked_pixel){isfinite(value) ? value : HUGE_VAL, i};
    }
    if (ranking) qsort(ranking, pixel_count, sizeof *ranking, compare_ranked);
    return ranking;
}

/* Of the pixels whose right or upper neighbour lies elsewhere in depth, both, for every so many that `count` are chosen. */
static void choose_silhouettes(true_pixels *truth, const drawn_picture *picture, const scene_rays *rays, size_t count)
{
    size_t width = (size_t)picture->width, height = (size_t)picture->height, found = 0, stride = 1;
    if (count == 0) return;
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 1) stride = 1 + 2 * found / count;
        found = 0;
        for (size_t i = 0; i + width < width * height; i++) {
            const size_t neighbours[] = {i + 1, i + width};
            double depth = scene_rays_stored_depth(rays, picture->depth[i]);
            for (int k = 0; k < 2; k++) {
                double other = scene_rays_stored_depth(rays, picture->depth[neighbours[k]]);
                if (fabs(other - depth) < 0.05 * fabs(depth) || found++ % stride != 0 || pass == 0) continue;
                choose_pixel(truth, picture, i, false);
                choose_pixel(truth, picture, neighbours[k], false);
            }
        }
    }
}

bool choose_pixels(const scene_rays *rays, const drawn_picture *picture, size_t count, true_pixels *truth)
{
    size_t pixel_count = (size_t)picture->width * (size_t)picture->height;
    *truth = (true_pixels){.pixels = malloc(pixel_count * sizeof *truth->pixels), .chosen = calloc(pixel_count, 1)};
    ranked_pixel *ranking = rank_pixels(picture, NULL, TRUTH_DARK);
    bool ok = truth->pixels && truth->chosen && ranking;
    if (ok && (count == 0 || count >= pixel_count)) {
        for (size_t i = 0; i < pixel_count; i++)
            choose_pixel(truth, picture, i, true);
    } else if (ok) {
        choose_evenly(truth, picture, count / 2);
        for (size_t i = 0; i < count / 8; i++) {
            choose_pixel(truth, picture, ranking[i].index, false);
            choose_pixel(truth, picture, ranking[pixel_count - 1 - i].index, false);
        }
        choose_silhouettes(truth, picture, rays, count / 4);
    }
    free(ranking);
    truth->first_count = truth->count;
    if (!ok) true_pixels_free(truth);
    return ok;
}
