/* The public calls: an effect is its sources and its GL objects. */
#include "energywave.h"

#include "base/allocator.h"
#include "base/error.h"
#include "host/execute.h"
#include "model/sources.h"
#include "plan/frame.h"
#include "plan/plan.h"
#include "plan/shader_text.h"

struct ew_effect {
    ew_allocator allocator;
    ew_device device;
    ew_sources sources;
    ew_tile_lists lists;
    char *shader_text; /* what ew_get_shader_text returned last */
};

ew_result ew_create_effect(const ew_effect_desc *desc, ew_effect **effect, ew_error *error)
{
    if (!desc || !desc->get_proc_address)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "desc and its get_proc_address must not be NULL");
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");

    const ew_allocator *allocator = desc->allocator ? desc->allocator : &ew_default_allocator;
    if (!allocator->allocate || !allocator->deallocate)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "desc->allocator's allocate and deallocate must not be NULL");

    ew_effect *made = allocator->allocate(allocator->user, sizeof *made);
    if (!made) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for an effect of %zu bytes", sizeof *made);
    *made = (ew_effect){.allocator = *allocator, .sources.epsilon = 1};
    ew_result result = ew_device_create(&made->device, desc, error);
    if (result == EW_OK)
        *effect = made;
    else
        allocator->deallocate(allocator->user, made);
    return result;
}

void ew_destroy_effect(ew_effect *effect)
{
    if (effect) ew_device_destroy(&effect->device);
    ew_abandon_effect(effect);
}

void ew_abandon_effect(ew_effect *effect)
{
    if (!effect) return;
    const ew_allocator allocator = effect->allocator;
    ew_device_abandon(&effect->device, &allocator);
    ew_sources_destroy(&effect->sources, &allocator);
    ew_destroy_tile_lists(&effect->lists, &allocator);
    if (effect->shader_text) allocator.deallocate(allocator.user, effect->shader_text);
    allocator.deallocate(allocator.user, effect);
}

ew_result ew_set_sources(ew_effect *effect, const ew_sources_desc *sources, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    return ew_sources_set(&effect->sources, sources, &effect->allocator, error);
}

/* The frame as it is planned, in `settled`. NULL for none. */
static const ew_frame_desc *settle(const ew_effect *effect, const ew_frame_desc *frame, ew_frame_desc *settled)
{
    if (!frame) return NULL;
    *settled = ew_settle_frame(frame, ew_gl_is_upside_down(&effect->device.gl));
    return settled;
}

/* The plans of a frame, in the order in which they are drawn. */
typedef struct frame_plans {
    ew_plan media, light;
    const ew_plan *all[EW_MAX_PLANS];
    int count;
} frame_plans;

/* Plans the drawing of the effect's sources, with the shader for `mix` or, with NULL, for them. */
static ew_result plan_light(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, ew_plan *plan, ew_error *error)
{
    ew_result result = ew_plan_frame(plan, &effect->sources, mix, frame, error);
    if (result != EW_OK) return result;
    const ew_dialect dialect = ew_gl_dialect(&effect->device.gl);
    const ew_list_room room =
        plan->source_units > dialect.capacity ? ew_list_room_of_texture() : ew_list_room_of_block(dialect.list_size);
    return ew_plan_lists(plan, &effect->lists, &effect->sources, frame, room, &effect->allocator, error);
}

static ew_result plan_frame(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, frame_plans *plans,
                            ew_error *error)
{
    ew_frame_desc settled;
    bool draws_media = false;
    frame = settle(effect, frame, &settled);
    ew_result result = plan_light(effect, mix, frame, &plans->light, error);
    if (result == EW_OK) result = ew_plan_media(&plans->media, frame, &draws_media, error);
    plans->count = 0;
    if (draws_media) plans->all[plans->count++] = &plans->media;
    plans->all[plans->count++] = &plans->light;
    return result;
}

ew_result ew_draw(ew_effect *effect, const ew_frame_desc *frame, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    frame_plans plans;
    ew_result result = plan_frame(effect, NULL, frame, &plans, error);
    if (result != EW_OK) return result;
    return ew_execute(&effect->device, plans.all, plans.count, &effect->allocator, error);
}

ew_result ew_get_bounds(ew_effect *effect, const ew_frame_desc *frame, ew_bounds *bounds, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    if (!bounds) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "bounds must not be NULL");
    ew_frame_desc settled;
    return ew_plan_bounds(&effect->sources, settle(effect, frame, &settled), bounds, error);
}

ew_result ew_prepare(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *is_ready, ew_error *error)
{
    if (!is_ready) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "is_ready must not be NULL");
    int steps_left;
    ew_result result = ew_prepare_step(effect, mix, frame, &steps_left, error);
    if (result == EW_OK) *is_ready = steps_left == 0;
    return result;
}

ew_result ew_prepare_step(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *steps_left, ew_error *error)
{
    if (!steps_left) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "steps_left must not be NULL");
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    frame_plans plans;
    ew_result result = plan_frame(effect, mix, frame, &plans, error);
    if (result != EW_OK) return result;
    return ew_execute_ahead(&effect->device, plans.all, plans.count, &effect->allocator, steps_left, error);
}

ew_result ew_get_shader_text(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, const char **text,
                             ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    if (!text) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "text must not be NULL");
    ew_result result = ew_check_integral(frame, error);
    if (result != EW_OK) return result;
    const ew_allocator *allocator = &effect->allocator;
    const ew_mix current = ew_sources_mix(&effect->sources);
    const ew_dialect dialect = ew_gl_dialect(&effect->device.gl);
    ew_frame_desc integral = *frame;
    integral.output = EW_OUTPUT_LERP;
    integral.dither = 0;
    ew_shader_text parts;
    ew_key key = ew_permutation_of(mix ? mix : &current, &integral);
    if (frame->light_reach > 0) key |= EW_PERMUTATION_IRRADIANCE;
    ew_write_include(&parts, &dialect, key);
    size_t length = ew_join_shader_text(&parts, NULL);
    char *made = allocator->allocate(allocator->user, length + 1);
    if (!made) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for a shader of %zu characters", length);
    ew_join_shader_text(&parts, made);
    if (effect->shader_text) allocator->deallocate(allocator->user, effect->shader_text);
    *text = effect->shader_text = made;
    return EW_OK;
}

ew_result ew_update_uniform_buffer(ew_effect *effect, const ew_frame_desc *frame, unsigned *buffer, ew_error *error)
{
    if (!effect) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "effect must not be NULL");
    if (!buffer) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "buffer must not be NULL");
    ew_frame_desc settled;
    ew_plan plan;
    const ew_frame_desc *integral = settle(effect, frame, &settled);
    /* As ew_get_shader_text: that of surfaces would be packed in a space of its own, which knows no interval. */
    settled.output = EW_OUTPUT_LERP;
    ew_result result = ew_plan_uniforms(&plan, &effect->sources, integral, error);
    if (result != EW_OK) return result;
    result = ew_upload(&effect->device, &plan, error);
    if (result == EW_OK) *buffer = effect->device.uniform_buffer;
    return result;
}
