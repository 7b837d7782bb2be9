/* Executes plans with the host's GL. */
#ifndef EW_EXECUTE_H
#define EW_EXECUTE_H

#include "host/depth_input.h"
#include "host/gl.h"
#include "host/grid.h"
#include "host/program_cache.h"
#include "host/source_texture.h"
#include "plan/plan.h"

/* The GL objects of an effect, and the context's functions. */
typedef struct ew_device {
    ew_gl gl;
    ew_program_cache programs[EW_PASS_COUNT];
    ew_depth_copy depth_copy;
    ew_grid grid;
    ew_light_sum light_sum;
    ew_source_texture source_texture;
    GLuint depth_sampler; /* reads depth as it is, whatever the texture's own parameters say */
    GLuint uniform_buffer, list_buffer;
} ew_device;

/* Makes the device of the current context. On failure there is nothing to destroy. */
ew_result ew_device_create(ew_device *device, const ew_effect_desc *desc, ew_error *error);

/* Deletes the device's GL objects. Its memory is left to ew_device_abandon. */
void ew_device_destroy(ew_device *device);

/* Frees the device's memory. Calls no GL. */
void ew_device_abandon(ew_device *device, const ew_allocator *allocator);

/* A frame has so many plans at the most: its media, and its light. */
enum { EW_MAX_PLANS = 2 };

/* Draws plans for one target, one over the other. Waits for a compiler if no program is ready that can. */
ew_result ew_execute(ew_device *device, const ew_plan *const *plans, int plan_count, const ew_allocator *allocator,
                     ew_error *error);

/* Takes one step towards a draw that does not wait, and says how many are left. The last step of each program is a draw outside
 * of the view: some drivers finish shaders only in a first draw. */
ew_result ew_execute_ahead(ew_device *device, const ew_plan *const *plans, int plan_count, const ew_allocator *allocator,
                           int *steps_left, ew_error *error);

/* Fills the uniform buffer as the plan says, and leaves all bindings as they were. Refuses sources that the block is too small
 * for. */
ew_result ew_upload(const ew_device *device, const ew_plan *plan, ew_error *error);

#endif
