/* Executes plans: see execute.h. */
#include "host/execute.h"

#include "base/error.h"
#include "host/sample_passes.h"
#include "host/state_guard.h"
#include "host/target_check.h"
#include "host/texture_check.h"

ew_result ew_device_create(ew_device *device, const ew_effect_desc *desc, ew_error *error)
{
    *device = (ew_device){0};
    ew_result result = ew_gl_load(&device->gl, desc->get_proc_address, desc->user, error);
    if (result != EW_OK) return result;
    const ew_gl *gl = &device->gl;
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass)
        device->programs[pass].pass = (ew_pass)pass;
    gl->GenBuffers(1, &device->uniform_buffer);
    gl->GenBuffers(1, &device->list_buffer);
    gl->GenSamplers(1, &device->depth_sampler);
    gl->SamplerParameteri(device->depth_sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->SamplerParameteri(device->depth_sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->SamplerParameteri(device->depth_sampler, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    return EW_OK;
}

void ew_device_destroy(ew_device *device)
{
    const ew_gl *gl = &device->gl;
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass)
        ew_program_cache_destroy(&device->programs[pass], gl);
    ew_grid_destroy(&device->grid, gl);
    ew_source_texture_destroy(&device->source_texture, gl);
    ew_depth_copy_destroy(&device->depth_copy, gl);
    gl->DeleteSamplers(1, &device->depth_sampler);
    gl->DeleteBuffers(1, &device->uniform_buffer);
    gl->DeleteBuffers(1, &device->list_buffer);
}

void ew_device_abandon(ew_device *device, const ew_allocator *allocator)
{
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass)
        ew_program_cache_abandon(&device->programs[pass], allocator);
}

/* ---- Uniforms ---- */

/* Fills the uniform buffer, which it leaves bound. Its storage is orphaned first: the GPU may still be reading what the last
 * frame left there, and waiting for it would stall. Orphaning leaves it to the driver to keep as many copies as frames are
 * under way, which a ring of our own would have to guess, or learn from fences; and the buffer is small enough that a new one
 * costs the driver nothing. */
static void fill_uniform_buffer(const ew_device *device, const ew_plan *plan)
{
    const ew_gl *gl = &device->gl;
    size_t head = sizeof plan->uniforms, capacity = ew_gl_dialect(gl).capacity * sizeof(ew_vec4);
    size_t size = head + capacity;
    gl->BindBuffer(GL_UNIFORM_BUFFER, device->uniform_buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, NULL, GL_STREAM_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)head, &plan->uniforms);
    if (plan->source_data_size > 0 && plan->source_data_size <= capacity)
        gl->BufferSubData(GL_UNIFORM_BUFFER, (GLintptr)head, (GLsizeiptr)plan->source_data_size, plan->source_data);
}

/* Fills the buffer of lists in the same way. */
static void fill_list_buffer(const ew_device *device, const ew_plan *plan)
{
    const ew_gl *gl = &device->gl;
    const ew_tile_lists *lists = plan->lists;
    gl->BindBuffer(GL_UNIFORM_BUFFER, device->list_buffer);
    gl->BufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)(ew_gl_dialect(gl).list_size * sizeof(ew_vec4)), NULL, GL_STREAM_DRAW);
    gl->BufferSubData(GL_UNIFORM_BUFFER, 0, (GLsizeiptr)(lists->word_count * sizeof *lists->words), lists->words);
}

ew_result ew_upload(const ew_device *device, const ew_plan *plan, ew_error *error)
{
    size_t units = plan->source_data_size / sizeof(ew_vec4), capacity = ew_gl_dialect(&device->gl).capacity;
    if (units > capacity)
        return ew_fail(error, EW_ERROR_TOO_MANY_SOURCES,
                       "the sources take %zu units, but a uniform block of this context takes %zu: only ew_draw draws more",
                       units, capacity);
    GLuint bound = ew_gl_uniform_buffer(&device->gl);
    fill_uniform_buffer(device, plan);
    device->gl.BindBuffer(GL_UNIFORM_BUFFER, bound);
    return EW_OK;
}

/* ---- Drawing ---- */

static void draw_quad(void *user, GLint surface_rank)
{
    const ew_drawing *drawing = user;
    (void)surface_rank;
    drawing->gl->DrawArrays(GL_TRIANGLE_STRIP, drawing->is_ahead ? EW_QUAD_VERTICES : 0, EW_QUAD_VERTICES);
}

static void draw_every_pixel(ew_drawing *drawing)
{
    const GLuint program = drawing->programs.names[drawing->plan->pass];
    drawing->gl->UseProgram(program);
    ew_gl_set_viewport(drawing->gl, &drawing->plan->lit);
    if (drawing->depth->samples > 0)
        ew_draw_samples(drawing->gl, program, drawing->depth->samples, draw_quad, drawing);
    else
        draw_quad(drawing, 0);
}

/* Draws the plan on a grid. Returns false if the context has no grids; then nothing is drawn. */
static bool draw_on_grid(ew_grid *grid, const ew_drawing *drawing, ew_gl_state *state)
{
    const ew_gl *gl = drawing->gl;
    const ew_target *target = &drawing->plan->target;
    ew_gl_begin_grid(gl, state);
    bool is_filled = ew_grid_fill(grid, drawing);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target->framebuffer);
    ew_gl_set_blend(gl, target->blend != EW_BLEND_REPLACE);
    ew_gl_clip_to(gl, state, &drawing->plan->lit);
    if (is_filled) ew_grid_draw(grid, drawing);
    return is_filled;
}

/* ---- Plans ---- */

/* The state in which the plan is drawn. Its shader's alpha is min(1, B). */
static ew_gl_draw_state draw_state(const ew_target *target)
{
    static const struct {
        GLenum source_rgb, destination_rgb, source_alpha, destination_alpha;
    } factors[] = {[EW_BLEND_REPLACE] = {GL_ONE, GL_ONE, GL_ZERO, GL_ONE},
                   [EW_BLEND_OVER] = {GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA},
                   [EW_BLEND_DIM] = {GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE},
                   [EW_BLEND_ADD] = {GL_ONE, GL_ONE, GL_ZERO, GL_ONE},
                   [EW_BLEND_SOFT] = {GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_ZERO, GL_ONE},
                   [EW_BLEND_LIGHT] = {GL_DST_COLOR, GL_ONE, GL_ZERO, GL_ONE}};
    const ew_viewport *viewport = &target->viewport;
    return (ew_gl_draw_state){
        .framebuffer = target->framebuffer,
        .viewport = {viewport->x, viewport->y, viewport->width, viewport->height},
        .blend = target->blend != EW_BLEND_REPLACE,
        .source_rgb = factors[target->blend].source_rgb,
        .destination_rgb = factors[target->blend].destination_rgb,
        .source_alpha = factors[target->blend].source_alpha,
        .destination_alpha = factors[target->blend].destination_alpha,
        .framebuffer_srgb = target->encodes_srgb,
        .keep_stencil_test = target->keeps_stencil_test,
    };
}

/* What the context can tell of a plan's names before any state is touched. */
static ew_result check_names(const ew_gl *gl, const ew_plan *plan, ew_error *error)
{
    unsigned framebuffer = plan->target.framebuffer;
    const ew_depth_request *depth = &plan->depth;
    if (framebuffer && !gl->IsFramebuffer(framebuffer))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "framebuffer %u is none of this context's", framebuffer);
    if (depth->source == EW_DEPTH_TEXTURE_MULTISAMPLE && !gl->SampleMaski)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "depth_source is EW_DEPTH_TEXTURE_MULTISAMPLE, but OpenGL ES has multisampled textures from 3.1 on, and "
                       "this context is older");
    if (depth->source != EW_DEPTH_FRAMEBUFFER && depth->texture && !gl->IsTexture(depth->texture))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is no texture", depth->texture);
    if (plan->normal_texture && !gl->IsTexture(plan->normal_texture))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "normal_texture %u is no texture", plan->normal_texture);
    return EW_OK;
}

/* Binds the host's normals, if the plan has any. */
static ew_result bind_normals(const ew_device *device, const ew_plan *plan, ew_error *error)
{
    const ew_gl *gl = &device->gl;
    GLint bound = 0;
    if (plan->normal_texture == 0) return EW_OK;
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_NORMAL_TEXTURE_UNIT);
    gl->BindSampler(EW_GL_NORMAL_TEXTURE_UNIT, device->depth_sampler);
    gl->BindTexture(GL_TEXTURE_2D, plan->normal_texture);
    gl->GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    if ((GLuint)bound == plan->normal_texture) return ew_normal_check(gl, plan, error);
    gl->GetError();
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "normal_texture %u is no GL_TEXTURE_2D", plan->normal_texture);
}

/* What is done with plans within the guard: ew_execute's part, or ew_execute_ahead's. */
typedef struct plan_task {
    const ew_plan *const *plans;
    int plan_count;
    const ew_allocator *allocator;
    int *steps_left; /* NULL: draw; else prepare */
} plan_task;

/* A plan, with what the context makes of it. */
typedef struct prepared_plan {
    ew_drawing drawing;
    ew_key key;
    ew_depth_kind depth;
    bool on_grid;
} prepared_plan;

/* Finds the program of a pass; where plans are prepared, takes a step towards it. */
static ew_result find_program(ew_device *device, const plan_task *task, ew_pass pass, ew_key key, GLuint *name, int *steps_left,
                              ew_error *error)
{
    ew_program_cache *cache = &device->programs[pass];
    ew_key pass_key = ew_permutation_of_pass(pass, key);
    *steps_left = 0;
    if (!task->steps_left) return ew_program_get(cache, &device->gl, task->allocator, pass_key, name, error);
    return ew_program_prepare(cache, &device->gl, task->allocator, pass_key, name, steps_left, error);
}

/* Finds the programs of all passes of a plan, and adds to `steps_left`. Where plans are prepared, takes a step towards each of
 * them if the driver compiles on its own threads, and else towards the first of all that is not ready. */
static ew_result find_programs(ew_device *device, const plan_task *task, prepared_plan *prepared, int *steps_left,
                               ew_error *error)
{
    const ew_key key = prepared->key;
    ew_drawing *drawing = &prepared->drawing;
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass) {
        if (prepared->on_grid ? !ew_pass_is_of_grid((ew_pass)pass) : (ew_pass)pass != drawing->plan->pass) continue;
        if (*steps_left > 0 && !device->gl.parallel_shader_compile) {
            *steps_left += ew_program_steps(&device->programs[pass], ew_permutation_of_pass((ew_pass)pass, key));
            continue;
        }
        int steps;
        ew_result result = find_program(device, task, (ew_pass)pass, key, &drawing->programs.names[pass], &steps, error);
        if (result != EW_OK) return result;
        *steps_left += steps;
    }
    return EW_OK;
}

/* Draws with uniforms and depth bound. */
static ew_result draw_bound(ew_device *device, const plan_task *task, prepared_plan *prepared, ew_gl_state *state,
                            ew_error *error)
{
    ew_drawing *drawing = &prepared->drawing;
    if (prepared->on_grid && draw_on_grid(&device->grid, drawing, state)) return EW_OK;
    if (prepared->on_grid) {
        GLuint *name = &drawing->programs.names[EW_PASS_WAVE];
        int steps_left;
        ew_result result = find_program(device, task, EW_PASS_WAVE, prepared->key, name, &steps_left, error);
        if (result != EW_OK || steps_left > 0) return result;
    }
    draw_every_pixel(drawing);
    return EW_OK;
}

static ew_result draw(ew_device *device, const plan_task *task, prepared_plan *prepared, ew_gl_state *state, ew_error *error)
{
    const ew_gl *gl = &device->gl;
    const ew_plan *plan = prepared->drawing.plan;
    ew_depth_input depth;
    ew_result result = bind_normals(device, plan, error);
    if (result == EW_OK) result = ew_depth_input_bind(&device->depth_copy, gl, plan, prepared->depth, &depth, error);
    if (result != EW_OK) return result;
    gl->BindSampler(EW_GL_DEPTH_TEXTURE_UNIT, device->depth_sampler);
    fill_uniform_buffer(device, plan);
    gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, device->uniform_buffer);
    if (prepared->key & EW_PERMUTATION_LISTS && !(prepared->key & EW_PERMUTATION_SOURCE_TEXTURE)) {
        fill_list_buffer(device, plan);
        gl->BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_LIST_BINDING, device->list_buffer);
    }
    if (prepared->key & EW_PERMUTATION_SOURCE_TEXTURE) ew_source_texture_bind(&device->source_texture, gl, plan);
    /* Vertex arrays are not shared between contexts, and one without attributes costs nothing to make. */
    GLuint vertex_array;
    gl->GenVertexArrays(1, &vertex_array);
    gl->BindVertexArray(vertex_array);
    prepared->drawing.depth = &depth;
    result = draw_bound(device, task, prepared, state, error);
    gl->DeleteVertexArrays(1, &vertex_array);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    ew_depth_input_release(gl, &depth);
    return result;
}

static prepared_plan prepare(const ew_device *device, const plan_task *task, const ew_plan *plan)
{
    const ew_gl *gl = &device->gl;
    prepared_plan prepared = {.drawing = {.gl = gl, .plan = plan, .is_ahead = task->steps_left != NULL},
                              .depth = ew_depth_input_kind(gl, &plan->depth),
                              .on_grid = plan->is_adaptive && gl->float_targets && !device->grid.is_refused};
    prepared.key = ew_permutation_with_depth(plan->permutation, prepared.depth);
    if (plan->source_units > ew_gl_dialect(gl).capacity) prepared.key |= EW_PERMUTATION_SOURCE_TEXTURE;
    return prepared;
}

/* The programs of all plans come before the first is drawn, so that a shader that fails leaves no half of a picture; but for
 * the one that takes a grid's place where the driver refuses its textures. */
static ew_result draw_in_state(ew_device *device, const plan_task *task, ew_gl_state *state, ew_error *error)
{
    const ew_gl *gl = &device->gl;
    const ew_target *target = &task->plans[0]->target;
    ew_gl_draw_state wanted = draw_state(target);
    ew_gl_set_draw_state(gl, state, &wanted);
    if (gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return ew_fail(error, EW_ERROR_OPENGL, "framebuffer %u is not complete", target->framebuffer);
    ew_result result = ew_target_check(gl, target, error);
    int steps_left = 0;
    prepared_plan prepared[EW_MAX_PLANS];
    for (int i = 0; i < task->plan_count && result == EW_OK; ++i) {
        prepared[i] = prepare(device, task, task->plans[i]);
        result = find_programs(device, task, &prepared[i], &steps_left, error);
    }
    for (int i = 0; i < task->plan_count && result == EW_OK && steps_left == 0; ++i) {
        wanted = draw_state(&task->plans[i]->target);
        ew_gl_set_blending(gl, &wanted);
        result = draw(device, task, &prepared[i], state, error);
    }
    if (result == EW_OK && task->steps_left) *task->steps_left = steps_left;
    return result;
}

static ew_result execute(ew_device *device, const plan_task *task, ew_error *error)
{
    const ew_gl *gl = &device->gl;
    const ew_plan *plan = task->plans[0];
    ew_result result = check_names(gl, plan, error);
    if (result != EW_OK) return result;
    ew_gl_state state;
    if (plan->skips_restore) {
        ew_gl_assume_state(gl, &state);
        result = draw_in_state(device, task, &state, error);
        ew_gl_restore_objects(gl, &state);
        return result;
    }
    result = ew_gl_save_state(gl, &state, error);
    if (result != EW_OK) return result;
    result = draw_in_state(device, task, &state, error);
    ew_gl_restore_state(gl, &state);
    return result;
}

ew_result ew_execute(ew_device *device, const ew_plan *const *plans, int plan_count, const ew_allocator *allocator,
                     ew_error *error)
{
    return execute(device, &(plan_task){plans, plan_count, allocator, NULL}, error);
}

ew_result ew_execute_ahead(ew_device *device, const ew_plan *const *plans, int plan_count, const ew_allocator *allocator,
                           int *steps_left, ew_error *error)
{
    return execute(device, &(plan_task){plans, plan_count, allocator, steps_left}, error);
}
