/* Plans: see plan.h. */
#include "plan/plan.h"

#include "base/error.h"
#include "model/bounds.h"
#include "model/limits.h"
#include "model/lit_space.h"
#include "model/media.h"
#include "plan/frame.h"

#include <string.h>

/* How much the four values of a panel may bend, relative to the integral, for the whole to keep the quality's error: measured,
 * not derived (docs/method.md). */
static double panel_tolerance(ew_quality quality)
{
    static const double tolerances[] = {
        [EW_QUALITY_ERROR_1E_2] = 1e-2, [EW_QUALITY_ERROR_1E_3] = 1e-3, [EW_QUALITY_ERROR_1E_4] = 1e-4};
    return tolerances[quality];
}

/* How much interpolation may add to that, relative to the light; a third of what the quality is named by. */
static double interpolation_tolerance(ew_quality quality)
{
    return 0.35 * panel_tolerance(quality);
}

static ew_viewport viewport_of(const ew_frame_desc *frame)
{
    return (ew_viewport){frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height};
}

/* How much the least radius of a core grows with view depth; of a parallel projection, that radius. 0 without a viewport. */
static double core_growth_of(const ew_frame_desc *frame)
{
    const ew_view view = ew_view_of(frame);
    const ew_viewport viewport = viewport_of(frame);
    if (viewport.width <= 0 || viewport.height <= 0) return 0;
    return 0.5 * ew_core_pixels_of(frame) * ew_pixel_height(&view, &viewport);
}

/* Fills the steps between the values that the target stores: see ew_target_step. R11F_G11F_B10F has 6 bits behind a float's
 * leading one. */
static void pack_target_steps(ew_encoding encoding, struct ew_frame_block *block)
{
    static const struct {
        float fixed, relative;
    } steps[] = {[EW_ENCODING_LINEAR_8BIT] = {1.0f / 255, 0},
                 [EW_ENCODING_LINEAR_10BIT] = {1.0f / 1023, 0},
                 [EW_ENCODING_FLOAT_11BIT] = {0, 1.0f / 64}};
    block->pixel_center.z = steps[encoding].fixed;
    block->pixel_center.w = steps[encoding].relative;
}

/* Says what of the viewport is drawn. */
static void set_lit(ew_plan *plan, const ew_viewport *lit)
{
    plan->lit = *lit;
    plan->uniforms.grid.viewport = (ew_ivec4){lit->x, lit->y, lit->width, lit->height};
}

/* Fills what depends on the viewport: the rays of its pixels, and how wide cores are at the least. */
static void pack_viewport(ew_plan *plan, const ew_frame_desc *frame, const ew_lit_space *space)
{
    const ew_view view = ew_view_of(frame);
    const ew_viewport viewport = viewport_of(frame);
    struct ew_frame_block *block = &plan->uniforms.frame;
    ew_pack_rays(&view, &space->interval, space->unit, &viewport, block);
    if (frame->depth_source == EW_DEPTH_TEXTURE_LINEAR) ew_pack_linear_depth(&space->interval, block);
    double growth = core_growth_of(frame), unit = space->unit;
    block->core_floor.x = ew_is_parallel(&view) ? 0 : (float)(growth * growth);
    set_lit(plan, &viewport);
    block->light.z = 0.5f * (float)viewport.width;
    block->light.w = 0.5f * (float)viewport.height;
    plan->uniforms.grid.tolerance = (ew_vec4){(float)interpolation_tolerance(frame->quality), 0.03f, 0, 0};
    block->core_floor.z = ew_is_parallel(&view) ? (float)(growth * growth / (unit * unit)) : 0;
}

/* The interval and the unit of length of a checked frame: its own, or in the world integral the sources'. */
static ew_lit_space space_of(const ew_frame_desc *frame, const ew_sources *sources)
{
    const ew_view view = ew_view_of(frame);
    if (ew_draws_surfaces(frame)) return ew_find_lit_space(sources, frame->light_reach, &view, 0);
    if (ew_is_world_frame(frame)) return ew_find_lit_space(sources, 0, &view, core_growth_of(frame));
    return (ew_lit_space){{frame->interval_start, frame->interval_end}, frame->interval_end - frame->interval_start};
}

static ew_packing packing_of(const ew_frame_desc *frame, const ew_lit_space *space)
{
    bool is_world = ew_is_world_frame(frame) || ew_draws_surfaces(frame);
    /* d ds = (length d') (ds): over the interval's length, B is what it is in world units. The world integral is over the way
     * itself, which is as long in the unit of d. */
    return (ew_packing){.space = {frame->view, space->interval.start, space->unit},
                        .coefficient_scale = is_world ? 1 : frame->decay_alpha / space->unit,
                        .exposure = frame->exposure,
                        .least_core = is_world ? EW_MIN_CORE : EW_MIN_EPSILON};
}

/* An integral over a source's length is as many times smaller in ray space as its unit is longer. */
static void pack_light(const ew_frame_desc *frame, const ew_packing *packing, struct ew_frame_block *block)
{
    double scale = packing->coefficient_scale * packing->space.length;
    block->light.x = scale > 0 ? (float)(frame->light_gain / scale) : 0;
    /* Where it is less than a pixel by far, powers of it would be no numbers. */
    block->light.y = (float)fmax(frame->light_reach / packing->space.length, 1e-6);
    block->core_floor.w = (float)(frame->shadow_thickness / packing->space.length);
}

/* What no product in the shader overflows with; e to such powers is 0 or means that nothing is seen. */
static double clamp_exponent(double x)
{
    return fmax(-1e12, fmin(1e12, x));
}

static void pack_fog(const ew_fog *fog, const ew_view *view, const ew_ray_space *space, struct ew_fog_block *block)
{
    block->density.x = (float)(fog->extinction * space->length);
    block->density.y = (float)((ew_first_depth(view) - space->start) / space->length);
    double up[3], unit[3], growth[3];
    if (fog->scale == 0 || !ew_normalize(fog->up, unit)) return;
    ew_ray_space_turn(space, unit, up);
    double at_anchor = -up[2] * space->start;
    for (int i = 0; i < 3; ++i) {
        growth[i] = clamp_exponent(up[i] * space->length / fog->scale);
        at_anchor -= up[i] * ew_element(view->view, i, 3);
    }
    double at_height_0 = log(fog->extinction * space->length);
    block->height = ew_pack(growth, clamp_exponent((at_anchor - fog->base) / fog->scale - at_height_0));
}

/* Fills what dims light on its way. */
static ew_result pack_air(const ew_frame_desc *frame, const ew_view *view, const ew_ray_space *space,
                          struct ew_uniform_head *head, ew_error *error)
{
    pack_fog(&frame->fog, view, space, &head->fog);
    return ew_pack_media(frame->media, frame->medium_count, space, frame->exposure, head, error);
}

/* Fills the plan's uniforms for a checked frame, but for what depends on the viewport. */
static ew_result pack(ew_plan *plan, ew_sources *sources, const ew_frame_desc *frame, const ew_lit_space *space,
                      ew_error *error)
{
    const ew_view view = ew_view_of(frame);
    const ew_packing packing = packing_of(frame, space);
    const ew_interval *interval = &space->interval;
    bool needs_reach = ew_is_world_frame(frame) && !ew_draws_surfaces(frame);
    ew_result result = needs_reach ? ew_sources_check_reach(sources, error) : EW_OK;
    if (result == EW_OK) result = ew_check_rays(&view, interval, error);
    if (result == EW_OK) result = ew_sources_pack(sources, &packing, error);
    if (result == EW_OK) result = pack_air(frame, &view, &packing.space, &plan->uniforms, error);
    if (result != EW_OK) return result;

    struct ew_frame_block *block = &plan->uniforms.frame;
    ew_pack_ray_space(&packing.space, block);
    block->decay =
        (ew_vec4){(float)frame->decay_beta, (float)(sources->epsilon / packing.space.length),
                  (float)panel_tolerance(frame->quality), (float)((interval->end - interval->start) / packing.space.length)};
    block->core_floor.y = (float)(interval->start / packing.space.length);
    pack_light(frame, &packing, block);
    block->choices = (ew_ivec4){frame->simpson_divisions, frame->normal_encoding, !ew_is_parallel(&view), 0};
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        plan->uniforms.source_counts[kind] = (int)sources->counts[kind];
    plan->source_data = sources->data;
    plan->source_data_size = sources->data_size;
    plan->depths = space->interval;
    return EW_OK;
}

ew_result ew_plan_uniforms(ew_plan *plan, ew_sources *sources, const ew_frame_desc *frame, ew_error *error)
{
    *plan = (ew_plan){0};
    ew_result result = ew_check_integral(frame, error);
    if (result != EW_OK) return result;
    const ew_lit_space space = space_of(frame, sources);
    result = pack(plan, sources, frame, &space, error);
    if (result == EW_OK && frame->viewport_width > 0 && frame->viewport_height > 0) pack_viewport(plan, frame, &space);
    return result;
}

static ew_blend blend_of(ew_output output)
{
    switch (output) {
    case EW_OUTPUT_LERP:
        return EW_BLEND_OVER;
    case EW_OUTPUT_ADD:
        return EW_BLEND_ADD;
    case EW_OUTPUT_SOFT:
        return EW_BLEND_SOFT;
    case EW_OUTPUT_SURFACES:
        return EW_BLEND_LIGHT;
    default:
        return EW_BLEND_REPLACE;
    }
}

/* Below these, the passes of a grid cost more than they save: pixels, and what one of them costs (see ew_mix_cost). */
enum { MIN_ADAPTIVE_PIXELS = 256 * 256, MIN_ADAPTIVE_COST = 3 };

static bool is_adaptive(const ew_frame_desc *frame, const ew_mix *mix)
{
    return frame->resolution == EW_RESOLUTION_ADAPTIVE && frame->integrator == EW_INTEGRATOR_ADAPTIVE &&
           frame->output != EW_OUTPUT_EVALUATIONS && !ew_draws_surfaces(frame) && ew_mix_cost(mix) >= MIN_ADAPTIVE_COST &&
           (double)frame->viewport_width * frame->viewport_height >= MIN_ADAPTIVE_PIXELS;
}

/* Says where and how the frame is drawn. */
static void set_target(ew_plan *plan, const ew_frame_desc *frame, ew_blend blend)
{
    plan->target = (ew_target){frame->framebuffer, viewport_of(frame), blend, frame->encoding == EW_ENCODING_SRGB_8BIT,
                               frame->keep_stencil_test};
    plan->depth = (ew_depth_request){frame->depth_source, frame->depth_texture};
    plan->skips_restore = frame->skip_restore;
}

ew_result ew_plan_frame(ew_plan *plan, ew_sources *sources, const ew_mix *mix, const ew_frame_desc *frame, ew_error *error)
{
    *plan = (ew_plan){0};
    ew_result result = ew_check_integral(frame, error);
    if (result == EW_OK) result = ew_check_target(frame, error);
    if (result != EW_OK) return result;
    const ew_lit_space space = space_of(frame, sources);
    result = pack(plan, sources, frame, &space, error);
    if (result != EW_OK) return result;

    const ew_mix current = ew_sources_mix(sources);
    pack_viewport(plan, frame, &space);
    pack_target_steps(frame->encoding, &plan->uniforms.frame);
    plan->pass = ew_draws_surfaces(frame) ? EW_PASS_SURFACES : EW_PASS_WAVE;
    plan->permutation = ew_permutation_of(mix ? mix : &current, frame);
    if (!mix) plan->permutation = ew_permutation_with_forms(plan->permutation, sources->has_list);
    plan->source_units = mix ? (mix->has_many ? EW_MAX_SOURCE_UNITS : 0) : sources->data_size / sizeof(ew_vec4);
    set_target(plan, frame, blend_of(frame->output));
    plan->light_reach = ew_draws_surfaces(frame) ? frame->light_reach : 0;
    plan->normal_texture = ew_draws_surfaces(frame) ? frame->normal_texture : 0;
    plan->is_adaptive = is_adaptive(frame, mix ? mix : &current);
    return EW_OK;
}

ew_result ew_plan_media(ew_plan *plan, const ew_frame_desc *frame, bool *draws, ew_error *error)
{
    const ew_view view = ew_view_of(frame);
    ew_lit_space space;
    *plan = (ew_plan){.pass = EW_PASS_MEDIA, .permutation = ew_permutation_of_media(frame)};
    *draws = ew_draws_picture(frame) && ew_find_media_space(frame->media, frame->medium_count, &view, &space);
    if (!*draws) return EW_OK;
    const ew_ray_space rays = {frame->view, space.interval.start, space.unit};
    ew_result result = ew_check_rays(&view, &space.interval, error);
    if (result == EW_OK) result = pack_air(frame, &view, &rays, &plan->uniforms, error);
    if (result != EW_OK) return result;
    plan->uniforms.frame.decay.w = (float)((space.interval.end - space.interval.start) / space.unit);
    pack_viewport(plan, frame, &space);
    const ew_bounds seen = ew_find_media_bounds(frame->media, frame->medium_count, &view, &plan->lit);
    set_lit(plan, &(ew_viewport){seen.x, seen.y, seen.width, seen.height});
    *draws = seen.width > 0 && seen.height > 0;
    pack_target_steps(frame->encoding, &plan->uniforms.frame);
    set_target(plan, frame, frame->output == EW_OUTPUT_LERP ? EW_BLEND_OVER : EW_BLEND_DIM);
    return EW_OK;
}

ew_result ew_plan_lists(ew_plan *plan, ew_tile_lists *lists, const ew_sources *sources, const ew_frame_desc *frame,
                        ew_list_room room, const ew_allocator *allocator, ew_error *error)
{
    const ew_view view = ew_view_of(frame);
    /* The published method is a baseline, and looks at every source. */
    if (plan->permutation & EW_PERMUTATION_SIMPSON || !(plan->permutation & EW_PERMUTATION_REACH)) return EW_OK;
    ew_result result = ew_make_tile_lists(lists, sources, plan->light_reach, &view, &plan->depths, &plan->target.viewport, room,
                                          allocator, error);
    if (result != EW_OK || lists->entry_count == 0) return result;
    plan->permutation = ew_permutation_with_lists(plan->permutation);
    plan->lists = lists;
    if (plan->target.blend != EW_BLEND_REPLACE) set_lit(plan, &lists->lit);
    memcpy(plan->uniforms.list_rows, lists->list_rows, sizeof lists->list_rows);
    plan->uniforms.grid.tolerance.w = (float)lists->path_entries;
    plan->uniforms.grid.tolerance.z = (float)ew_first_list_row(plan) * EW_TEXTURE_WIDTH;
    plan->uniforms.grid.tiles =
        (ew_ivec4){lists->columns, lists->size_log2, lists->first_x - plan->lit.x, lists->first_y - plan->lit.y};
    return EW_OK;
}

ew_result ew_plan_bounds(const ew_sources *sources, const ew_frame_desc *frame, ew_bounds *bounds, ew_error *error)
{
    ew_result result = ew_check_integral(frame, error);
    if (result == EW_OK) result = ew_check_target(frame, error);
    bool draws_surfaces = result == EW_OK && ew_draws_surfaces(frame);
    if (result == EW_OK && ew_is_world_frame(frame) && !draws_surfaces) result = ew_sources_check_reach(sources, error);
    if (result != EW_OK) return result;
    const ew_view view = ew_view_of(frame);
    const bool is_everywhere = ew_is_world_frame(frame) || draws_surfaces;
    const ew_interval world = {ew_first_depth(&view), HUGE_VAL}, own = {frame->interval_start, frame->interval_end};
    const ew_viewport viewport = viewport_of(frame);
    *bounds = ew_find_bounds(sources, draws_surfaces ? frame->light_reach : 0, &view, is_everywhere ? &world : &own, &viewport);
    if (!ew_draws_picture(frame)) return EW_OK;
    const ew_bounds media = ew_find_media_bounds(frame->media, frame->medium_count, &view, &viewport);
    *bounds = ew_unite_bounds(bounds, &media);
    return EW_OK;
}
