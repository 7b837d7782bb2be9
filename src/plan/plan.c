/* Plans: see plan.h. */
#include "plan/plan.h"

#include "base/error.h"
#include "model/limits.h"
#include "plan/frame.h"

/* How much the four values of a panel may bend, relative to the integral, for the whole to keep the quality's error: measured,
 * not derived (docs/method.md). */
static double panel_tolerance(ew_quality quality)
{
    static const double tolerances[] = {
        [EW_QUALITY_ERROR_1E_2] = 1e-2, [EW_QUALITY_ERROR_1E_3] = 1e-3, [EW_QUALITY_ERROR_1E_4] = 1e-4};
    return tolerances[quality];
}

static ew_viewport viewport_of(const ew_frame_desc *frame)
{
    return (ew_viewport){frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height};
}

/* Fills the plan's uniforms for a checked frame, but for the rays of the viewport's pixels. */
static ew_result pack(ew_plan *plan, ew_sources *sources, const ew_frame_desc *frame, ew_error *error)
{
    const ew_view view = ew_view_of(frame);
    const ew_interval interval = {frame->interval_start, frame->interval_end};
    const ew_ray_space space = {frame->view, interval.start, interval.end - interval.start};
    double epsilon = sources->epsilon / space.length;
    if (!(epsilon >= EW_MIN_EPSILON && epsilon <= EW_MAX_COORDINATE))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "epsilon over the interval's length must be in [%g, %g]",
                       EW_MIN_EPSILON, EW_MAX_COORDINATE);
    ew_result result = ew_check_rays(&view, &interval, error);
    if (result == EW_OK) result = ew_sources_pack(sources, &space, frame->decay_alpha, error);
    if (result != EW_OK) return result;

    struct ew_frame_block *block = &plan->uniforms.frame;
    ew_pack_ray_space(&space, block);
    block->decay = (ew_vec4){(float)frame->decay_beta, (float)epsilon, (float)panel_tolerance(frame->quality), 0};
    block->simpson.x = frame->simpson_divisions;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        plan->uniforms.source_counts[kind] = (int)sources->counts[kind];
    plan->source_data = sources->data;
    plan->source_data_size = sources->data_size;
    return EW_OK;
}

ew_result ew_plan_uniforms(ew_plan *plan, ew_sources *sources, const ew_frame_desc *frame, ew_error *error)
{
    *plan = (ew_plan){0};
    ew_result result = ew_check_integral(frame, error);
    return result == EW_OK ? pack(plan, sources, frame, error) : result;
}

static ew_blend blend_of(ew_output output)
{
    switch (output) {
    case EW_OUTPUT_LERP:
        return EW_BLEND_OVER;
    case EW_OUTPUT_ADD:
        return EW_BLEND_ADD;
    default:
        return EW_BLEND_REPLACE;
    }
}

ew_result ew_plan_frame(ew_plan *plan, ew_sources *sources, const ew_mix *mix, const ew_frame_desc *frame, ew_error *error)
{
    *plan = (ew_plan){0};
    ew_result result = ew_check_integral(frame, error);
    if (result == EW_OK) result = ew_check_target(frame, error);
    if (result == EW_OK) result = pack(plan, sources, frame, error);
    if (result != EW_OK) return result;

    const ew_view view = ew_view_of(frame);
    const ew_interval interval = {frame->interval_start, frame->interval_end};
    const ew_viewport viewport = viewport_of(frame);
    const ew_mix current = ew_sources_mix(sources);
    ew_pack_rays(&view, &interval, &viewport, &plan->uniforms.frame);
    plan->permutation = ew_permutation_of(mix ? mix : &current, frame);
    plan->target = (ew_target){frame->framebuffer, viewport, blend_of(frame->output), frame->encoding == EW_ENCODING_SRGB_8BIT};
    plan->depth = (ew_depth_request){frame->depth_source, frame->depth_texture};
    plan->skips_restore = frame->skip_restore;
    return EW_OK;
}
