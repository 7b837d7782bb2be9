/* Maps in false colours: see map.h. */
#include "map.h"
#include "false_color.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

static size_t pixel_count(const ew_frame_desc *frame)
{
    return (size_t)frame->viewport_width * (size_t)frame->viewport_height;
}

static void *allocate(size_t bytes, ew_result *result, ew_error *error)
{
    void *memory = *result ? NULL : malloc(bytes);
    if (memory || *result) return memory;
    *result = EW_ERROR_OUT_OF_MEMORY;
    *error = (ew_error){EW_ERROR_OUT_OF_MEMORY, "the map does not fit into memory; make the picture smaller"};
    return NULL;
}

/* Draws another output of the frame, and reads it: one number a pixel. */
static ew_result measure(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, ew_output output, float *values,
                         ew_error *error)
{
    ew_frame_desc measured = *frame;
    measured.output = output;
    ew_result result = ew_draw(effect, &measured, error);
    if (result) return result;
    const pixel_rectangle viewport = {frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height};
    texture_read(gl, frame->framebuffer, viewport, GL_RED, GL_FLOAT, values);
    return EW_OK;
}

/* Reduces a frame of the papers' integral to one part of its interval. On the part from s0 to s1, let s = s0 + (s1 - s0) s'.
 * Then the decay alpha / (s + beta)^2 ds is alpha' / (s' + beta')^2 ds', with alpha' = alpha / (s1 - s0) and
 * beta' = (s0 + beta) / (s1 - s0). */
static void take_part(ew_frame_desc *frame, int part)
{
    const double parts = MAP_REFERENCE_PARTS, length = (frame->interval_end - frame->interval_start) / parts;
    frame->interval_start += part * length;
    frame->interval_end = frame->interval_start + length;
    frame->decay_alpha *= parts;
    frame->decay_beta = part + frame->decay_beta * parts;
}

/* The luminance of the reference is the sum over parts of the interval, if there is one. */
static ew_result measure_reference(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, float *scratch,
                                   double *sum, ew_error *error)
{
    bool is_world = frame->interval_start == 0 && frame->interval_end == 0;
    for (size_t i = 0; i < pixel_count(frame); i++)
        sum[i] = 0;
    for (int i = 0; i < (is_world ? 1 : MAP_REFERENCE_PARTS); i++) {
        ew_frame_desc part = *frame;
        if (!is_world) take_part(&part, i);
        part.integrator = EW_INTEGRATOR_SIMPSON;
        part.simpson_divisions = EW_MAX_SIMPSON_DIVISIONS;
        ew_result result = measure(gl, effect, &part, EW_OUTPUT_LUMINANCE, scratch, error);
        if (result) return result;
        for (size_t j = 0; j < pixel_count(frame); j++)
            sum[j] += (double)scratch[j];
    }
    return EW_OK;
}

/* Errors are relative to the true luminance or, where that is darker, to 1e-3 of the largest, as everywhere in the project. */
static ew_result measure_errors(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, float *errors,
                                ew_error *error)
{
    ew_result result = EW_OK;
    double *reference = allocate(pixel_count(frame) * sizeof *reference, &result, error), largest = 0;
    if (!result) result = measure_reference(gl, effect, frame, errors, reference, error);
    if (!result) result = measure(gl, effect, frame, EW_OUTPUT_LUMINANCE, errors, error);
    for (size_t i = 0; !result && i < pixel_count(frame); i++)
        largest = fmax(largest, reference[i]);
    for (size_t i = 0; !result && i < pixel_count(frame); i++) {
        double scale = fmax(reference[i], 1e-3 * largest);
        errors[i] = scale > 0 ? (float)(fabs((double)errors[i] - reference[i]) / scale) : 0;
    }
    free(reference);
    return result;
}

static double mean_of(const float *values, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum / (double)count;
}

ew_result map_count_evaluations(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, double *mean,
                                ew_error *error)
{
    ew_result result = EW_OK;
    float *values = allocate(pixel_count(frame) * sizeof *values, &result, error);
    if (!result) result = measure(gl, effect, frame, EW_OUTPUT_EVALUATIONS, values, error);
    if (!result) *mean = mean_of(values, pixel_count(frame));
    free(values);
    return result;
}

static ew_result put_colors(const gl_functions *gl, const ew_frame_desc *frame, const float *values, bool is_error,
                            GLuint picture, ew_error *error)
{
    ew_result result = EW_OK;
    unsigned char *srgb = allocate(pixel_count(frame) * 4, &result, error);
    for (size_t i = 0; !result && i < pixel_count(frame); i++) {
        double value = (double)values[i];
        false_color_at(is_error ? false_color_of_error(value) : false_color_of_evaluations(value), srgb + 4 * i);
        srgb[4 * i + 3] = 255; /* OpenGL ES takes the texture's own format, and no other. */
    }
    if (!result) {
        gl->BindTexture(GL_TEXTURE_2D, picture);
        gl->TexSubImage2D(GL_TEXTURE_2D, 0, frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height,
                          GL_RGBA, GL_UNSIGNED_BYTE, srgb);
        gl->BindTexture(GL_TEXTURE_2D, 0);
    }
    free(srgb);
    return result;
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

ew_result map_draw(const gl_functions *gl, ew_effect *effect, const ew_frame_desc *frame, bool is_error, GLuint picture,
                   map_statistics *statistics, ew_error *error)
{
    ew_result result = EW_OK;
    size_t count = pixel_count(frame);
    float *values = allocate(count * sizeof *values, &result, error);
    *statistics = (map_statistics){-1, -1, -1};
    if (!result) result = measure(gl, effect, frame, EW_OUTPUT_EVALUATIONS, values, error);
    if (!result) statistics->mean_evaluations = mean_of(values, count);
    if (!result && is_error) result = measure_errors(gl, effect, frame, values, error);
    if (!result) result = put_colors(gl, frame, values, is_error, picture, error);
    if (!result && is_error) {
        qsort(values, count, sizeof *values, compare_floats);
        statistics->largest_error = (double)values[count - 1];
        statistics->error_of_99_percent = (double)values[(count - 1) * 99 / 100];
    }
    free(values);
    return result;
}
