/* The field, and rays through it without matrices. */
#include "glow.h"

#include "reference.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

static const double eye_z = 6;

static const ew_point points[] = {{.position = {0.3, 0.2, 0.4}, .coefficient = 0.5, .color = {1, 0.5, 0.2}}};
static const ew_line lines[] = {
    {.position = {0, -0.5, 0}, .direction = {1, 0.2, 0.3}, .coefficient = 0.3, .color = {0.2, 0.5, 1}}};
static const ew_torus tori[] = {
    {.center = {0, 0, 0}, .axis = {0.2, 1, 0.4}, .radius = 1.1, .coefficient = 0.4, .color = {0.3, 1, 0.4}}};
static const ew_curve curves[] = {{.polynomial = {{-1.2, 0.4, 0.3}, {1, 1.4, 0.2}, {1.3, -1.6, -0.8}},
                                   .domain = {0, 1},
                                   .coefficient = 0.4,
                                   .color = {0.9, 0.2, 0.7}}};

const ew_sources_desc glow_sources = {
    .points = points,
    .point_count = 1,
    .lines = lines,
    .line_count = 1,
    .tori = tori,
    .torus_count = 1,
    .curves = curves,
    .curve_count = 1,
    .epsilon = 2e-2,
};

const glow_lens glow_default_lens = {.left = -0.4, .right = 0.4, .bottom = -0.3, .top = 0.3};

ew_effect *glow_create(gl_context *context)
{
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    ew_effect *effect = NULL;
    ew_error error = {.text = ""};
    if (ew_create_effect(&desc, &effect, &error) != EW_OK) fail_msg("%s", error.text);
    if (ew_set_sources(effect, &glow_sources, &error) != EW_OK) fail_msg("%s", error.text);
    return effect;
}

ew_frame_desc glow_frame(unsigned framebuffer)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.view[14] = -eye_z;
    glow_projection(&glow_default_lens, -1.02, -1.01, frame.projection);
    frame.interval_start = 3;
    frame.interval_end = 10;
    frame.output = EW_OUTPUT_LERP;
    frame.framebuffer = framebuffer;
    frame.dither = 0;
    frame.viewport_width = GLOW_WIDTH;
    frame.viewport_height = GLOW_HEIGHT;
    return frame;
}

void glow_draw(ew_effect *effect, const ew_frame_desc *frame)
{
    ew_error error = {.text = ""};
    if (ew_draw(effect, frame, &error) != EW_OK) fail_msg("%s", error.text);
}

void glow_refuse(ew_effect *effect, const ew_frame_desc *frame, ew_result result, const char *field)
{
    ew_error error = {.text = ""};
    assert_int_equal(ew_draw(effect, frame, &error), result);
    assert_int_equal(error.code, result);
    if (strstr(error.text, field) == NULL) fail_msg("\"%s\" does not name %s", error.text, field);
}

void glow_pixel(const glow_lens *lens, int column, int row, double place[2])
{
    place[0] = lens->left + (lens->right - lens->left) * (column + 0.5) / GLOW_WIDTH;
    place[1] = lens->bottom + (lens->top - lens->bottom) * (row + 0.5) / GLOW_HEIGHT;
}

void glow_projection(const glow_lens *lens, double z_scale, double z_offset, double projection[16])
{
    const double width = lens->right - lens->left, height = lens->top - lens->bottom;
    const double across[2] = {(lens->right + lens->left) / width, (lens->top + lens->bottom) / height};
    memset(projection, 0, 16 * sizeof *projection);
    projection[0] = 2 / width;
    projection[5] = 2 / height;
    for (int i = 0; i < 2; i++)
        projection[(lens->parallel ? 12 : 8) + i] = lens->parallel ? -across[i] : across[i];
    projection[10] = z_scale;
    projection[14] = z_offset;
    projection[lens->parallel ? 15 : 11] = lens->parallel ? 1 : -1;
}

double glow_reference(const glow_lens *lens, const ew_frame_desc *frame, int column, int row, double opaque)
{
    static reference_workspace *workspace;
    if (workspace == NULL) workspace = reference_create_workspace();
    assert_non_null(workspace);
    double place[2];
    glow_pixel(lens, column, row, place);
    const double start = frame->interval_start, end = frame->interval_end;
    const double at_start = lens->parallel ? 1 : start, at_end = lens->parallel ? 1 : end;
    const reference_ray ray = {
        .start = {place[0] * at_start, place[1] * at_start, eye_z - start},
        .end = {place[0] * at_end, place[1] * at_end, eye_z - end},
        .s_max = fmin(1, fmax(0, (opaque - start) / (end - start))),
        .decay_alpha = frame->decay_alpha,
        .decay_beta = frame->decay_beta,
    };
    reference_value value;
    assert_true(reference_luminance(workspace, &glow_sources, &ray, &value, NULL));
    return value.luminance;
}
