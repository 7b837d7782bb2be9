/* The checks of a frame: see frame.h. */
#include "plan/frame.h"

#include "base/error.h"
#include "model/limits.h"
#include "model/media.h"
#include "model/rays.h"
#include "model/vector.h"

#include <math.h>

/* An enumeration, or a choice between 0 and 1, that a host may have left unset. */
typedef struct choice {
    int value;
    int last;
    const char *text;
} choice;

static ew_result check_choices(const choice *choices, size_t count, ew_error *error)
{
    for (size_t i = 0; i < count; ++i)
        if (choices[i].value < 0 || choices[i].value > choices[i].last)
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s", choices[i].text);
    return EW_OK;
}

static ew_result check_integrator(const ew_frame_desc *frame, ew_error *error)
{
    const choice choices[] = {
        {(int)frame->integrator, EW_INTEGRATOR_SIMPSON, "integrator must be one of ew_integrator"},
        {(int)frame->quality, EW_QUALITY_ERROR_1E_4, "quality must be one of ew_quality"},
    };
    ew_result result = check_choices(choices, sizeof choices / sizeof choices[0], error);
    if (result != EW_OK || frame->integrator != EW_INTEGRATOR_SIMPSON) return result;
    int n = frame->simpson_divisions;
    if (n >= 2 && n % 2 == 0 && n <= EW_MAX_SIMPSON_DIVISIONS) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "simpson_divisions must be even, from 2 to %d", EW_MAX_SIMPSON_DIVISIONS);
}

bool ew_is_world_frame(const ew_frame_desc *frame)
{
    return frame->interval_start == 0 && frame->interval_end == 0;
}

bool ew_draws_surfaces(const ew_frame_desc *frame)
{
    return frame->output == EW_OUTPUT_SURFACES;
}

double ew_core_pixels_of(const ew_frame_desc *frame)
{
    if (frame->core_pixels != EW_CORE_PIXELS_DEFAULT) return frame->core_pixels;
    return ew_is_world_frame(frame) ? 1.5 : 0;
}

static ew_result check_decay(const ew_frame_desc *frame, ew_error *error)
{
    if (ew_is_world_frame(frame)) {
        if (frame->decay_alpha == 1 && frame->decay_beta == 1) return EW_OK;
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "decay_alpha and decay_beta must be 1 without an interval: set interval_start and interval_end, too");
    }
    if (!(frame->decay_alpha >= 0 && frame->decay_alpha <= EW_MAX_COEFFICIENT))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "decay_alpha must be in [0, %g]", EW_MAX_COEFFICIENT);
    if (!(frame->decay_beta >= EW_MIN_BETA && frame->decay_beta <= EW_MAX_BETA))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "decay_beta must be in [%g, %g]", EW_MIN_BETA, EW_MAX_BETA);
    return EW_OK;
}

static ew_result check_look(const ew_frame_desc *frame, ew_error *error)
{
    double core_pixels = ew_core_pixels_of(frame);
    if (!(core_pixels >= 0 && core_pixels <= EW_MAX_CORE_PIXELS))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "core_pixels must be in [0, %g], or EW_CORE_PIXELS_DEFAULT",
                       EW_MAX_CORE_PIXELS);
    if (!(frame->light_gain >= 0 && frame->light_gain <= EW_MAX_LIGHT_GAIN))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "light_gain must be in [0, %g]", EW_MAX_LIGHT_GAIN);
    if (!(frame->light_reach >= 0 && isfinite(frame->light_reach)))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "light_reach must be finite and >= 0");
    if (!(frame->shadow_thickness >= 0 && isfinite(frame->shadow_thickness)))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "shadow_thickness must be finite and >= 0");
    if (!(frame->exposure >= 0 && frame->exposure <= EW_MAX_EXPOSURE))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "exposure must be in [0, %g]", EW_MAX_EXPOSURE);
    return EW_OK;
}

bool ew_draws_picture(const ew_frame_desc *frame)
{
    return frame->output == EW_OUTPUT_LERP || frame->output == EW_OUTPUT_ADD || frame->output == EW_OUTPUT_SOFT;
}

bool ew_has_fog(const ew_frame_desc *frame)
{
    return frame->fog.extinction > 0;
}

bool ew_has_height_fog(const ew_frame_desc *frame)
{
    return ew_has_fog(frame) && frame->fog.scale > 0;
}

static ew_result check_fog(const ew_frame_desc *frame, ew_error *error)
{
    const ew_fog *fog = &frame->fog;
    double unit[3];
    if (!(fog->extinction >= 0 && fog->extinction <= EW_MAX_EXTINCTION))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "fog.extinction must be in [0, %g]", EW_MAX_EXTINCTION);
    if (!(fog->scale >= 0 && isfinite(fog->scale)))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "fog.scale must be finite and >= 0");
    if (!isfinite(fog->base)) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "fog.base must be finite");
    if (!ew_all_finite(fog->up, 3)) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "fog.up must be finite");
    if (ew_has_height_fog(frame) && !ew_normalize(fog->up, unit))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "fog.up must not be zero");
    return EW_OK;
}

ew_frame_desc ew_settle_frame(const ew_frame_desc *frame, bool is_upside_down)
{
    ew_frame_desc settled = *frame;
    ew_settle_view(frame->view, settled.view);
    for (int column = 0; column < 4 && is_upside_down; ++column)
        settled.projection[4 * column + 1] = -settled.projection[4 * column + 1];
    return settled;
}

ew_result ew_check_integral(const ew_frame_desc *frame, ew_error *error)
{
    if (!frame) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "frame must not be NULL");
    const ew_view view = ew_view_of(frame);
    const ew_interval interval = {frame->interval_start, frame->interval_end};
    ew_result result = ew_check_view(&view, error);
    if (result == EW_OK && !ew_is_world_frame(frame)) result = ew_check_interval(&interval, &view, error);
    if (result == EW_OK) result = check_decay(frame, error);
    if (result == EW_OK) result = check_look(frame, error);
    if (result == EW_OK) result = check_fog(frame, error);
    if (result == EW_OK) result = ew_check_media(frame->media, frame->medium_count, error);
    return result == EW_OK ? check_integrator(frame, error) : result;
}

static ew_result check_surfaces(const ew_frame_desc *frame, ew_error *error)
{
    if (frame->light_reach == 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "light_reach must be > 0 for the output EW_OUTPUT_SURFACES");
    if (frame->depth_source != EW_DEPTH_FRAMEBUFFER && frame->depth_texture == 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "depth_texture must not be 0 for the output EW_OUTPUT_SURFACES: surfaces are found from their depth");
    return EW_OK;
}

ew_result ew_check_target(const ew_frame_desc *frame, ew_error *error)
{
    if (frame->viewport_width <= 0 || frame->viewport_height <= 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "viewport_width and viewport_height must be > 0");
    const choice choices[] = {
        {(int)frame->output, EW_OUTPUT_EVALUATIONS, "output must be one of ew_output"},
        {(int)frame->encoding, EW_ENCODING_FLOAT_11BIT, "encoding must be one of ew_encoding"},
        {(int)frame->depth_source, EW_DEPTH_TEXTURE_LINEAR, "depth_source must be one of ew_depth_source"},
        {(int)frame->resolution, EW_RESOLUTION_ADAPTIVE, "resolution must be one of ew_resolution"},
        {frame->dither, 1, "dither must be 0 or 1"},
        {(int)frame->normal_encoding, EW_NORMAL_VIEW_BIASED, "normal_encoding must be an ew_normal_encoding"},
        {frame->keep_stencil_test, 1, "keep_stencil_test must be 0 or 1"},
        {frame->skip_restore, 1, "skip_restore must be 0 or 1"},
    };
    ew_result result = check_choices(choices, sizeof choices / sizeof choices[0], error);
    return result == EW_OK && ew_draws_surfaces(frame) ? check_surfaces(frame, error) : result;
}
