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
    ew_light_sum_destroy(&device->light_sum, gl);
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

static void draw_quad(void *user, GLint surface_rank)
{
    const ew_drawing *drawing = user;
    (void)surface_rank;
    drawing->gl->DrawArrays(GL_TRIANGLE_STRIP, drawing->is_ahead ? EW_QUAD_VERTICES : 0, EW_QUAD_VERTICES);
}

static void draw_every_pixel(const ew_drawing *drawing)
{
    const GLuint program = drawing->programs.names[drawing->plan->pass];
    if (!ew_draws_with(drawing, program)) return;
    drawing->gl->UseProgram(program);
    ew_gl_set_viewport(drawing->gl, &drawing->plan->lit);
    if (drawing->depth->samples > 0)
        ew_draw_samples(drawing->gl, program, drawing->depth->samples, draw_quad, (void *)drawing);
    else
        draw_quad((void *)drawing, 0);
}

static void draw_part(void *user, int part)
{
    const ew_drawing *drawing = user;
    const ew_viewport *lit = &drawing->plan->lit;
    const GLuint program = drawing->parts[part].names[drawing->plan->pass];
    if (!ew_draws_with(drawing, program)) return;
    drawing->gl->UseProgram(program);
    ew_gl_set_viewport(drawing->gl, &(ew_viewport){0, 0, lit->width, lit->height});
    draw_quad((void *)drawing, 0);
}

/* Draws a plan on a grid, or in parts, or both: what needs targets of floats first. Returns false if the context has none of
 * these; then nothing is drawn. */
static bool draw_by_textures(ew_device *device, const ew_drawing *drawing, bool on_grid, ew_gl_state *state)
{
    const ew_gl *gl = drawing->gl;
    const ew_viewport *lit = &drawing->plan->lit;
    const ew_gl_draw_state wanted = draw_state(&drawing->plan->target);
    GLint size[2];
    const bool has_size = wanted.framebuffer && ew_find_target_size(gl, size);
    ew_gl_begin_grid(gl, state);
    bool is_filled = !on_grid || ew_grid_fill(&device->grid, drawing);
    if (drawing->part_count > 0) ew_gl_clip_copy_to(gl, state, lit, has_size ? size : NULL);
    if (is_filled && drawing->part_count > 0)
        is_filled = on_grid ? ew_grid_sum(&device->light_sum, drawing)
                            : ew_light_sum_fill(&device->light_sum, gl, lit->width, lit->height, drawing->part_count, draw_part,
                                                (void *)drawing);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, wanted.framebuffer);
    ew_gl_set_blending(gl, &wanted);
    ew_gl_clip_to(gl, state, lit);
    if (is_filled && on_grid) ew_grid_draw(&device->grid, drawing);
    if (is_filled && !on_grid) draw_every_pixel(drawing);
    return is_filled;
}

/* ---- Plans ---- */

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
    ew_key part_keys[EW_PART_COUNT];
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

/* How far programs are that are prepared. */
typedef struct ahead_progress {
    int steps_left;
    bool has_stepped;  /* in this call */
    ew_pass next_pass; /* of the first program that is ready and has not drawn yet, */
    GLuint next;       /* if there is one; else 0 */
} ahead_progress;

/* Finds one program of many. Where plans are prepared, takes a step towards it if the driver compiles on its own threads, or if
 * it is the first of all that has not drawn. */
static ew_result find_next_program(ew_device *device, const plan_task *task, ew_pass pass, ew_key key, GLuint *name,
                                   ahead_progress *progress, ew_error *error)
{
    const ew_program_cache *cache = &device->programs[pass];
    const ew_key pass_key = ew_permutation_of_pass(pass, key);
    const bool has_drawn = !task->steps_left || ew_program_steps(cache, pass_key) == 0;
    if (has_drawn || !progress->has_stepped || device->gl.parallel_shader_compile) {
        int unused;
        ew_result result = find_program(device, task, pass, key, name, &unused, error);
        if (result != EW_OK || has_drawn) return result;
        progress->has_stepped = true;
    }
    if (*name && !progress->next) {
        progress->next_pass = pass;
        progress->next = *name;
    } else {
        progress->steps_left += ew_program_steps(cache, pass_key);
    }
    return EW_OK;
}

/* Finds the programs of a pass: of one that integrates parts, one for each, and one for their sum where that is seen. */
static ew_result find_programs_of(ew_device *device, const plan_task *task, prepared_plan *prepared, ew_pass pass,
                                  ahead_progress *progress, ew_error *error)
{
    ew_drawing *drawing = &prepared->drawing;
    const bool is_seen = pass == drawing->plan->pass || pass == EW_PASS_CELLS;
    const bool has_parts = drawing->part_count > 0 && (is_seen || pass == EW_PASS_NODES);
    ew_result result = EW_OK;
    for (int part = 0; has_parts && part < drawing->part_count && result == EW_OK; ++part)
        result = find_next_program(device, task, pass, prepared->part_keys[part], &drawing->parts[part].names[pass], progress,
                                   error);
    if (result != EW_OK || (has_parts && !is_seen)) return result;
    const ew_key key = has_parts ? ew_permutation_summed(prepared->key) : prepared->key;
    result = find_next_program(device, task, pass, key, &drawing->programs.names[pass], progress, error);
    if (result != EW_OK || !has_parts || !(prepared->key & EW_PERMUTATION_DEPTH_MULTISAMPLE)) return result;
    return find_next_program(device, task, pass, prepared->key, &drawing->torn, progress, error);
}

/* Finds the programs of all passes of a plan. */
static ew_result find_programs(ew_device *device, const plan_task *task, prepared_plan *prepared, ahead_progress *progress,
                               ew_error *error)
{
    for (int pass = 0; pass < EW_PASS_COUNT; ++pass) {
        if (prepared->on_grid ? !ew_pass_is_of_grid((ew_pass)pass) : (ew_pass)pass != prepared->drawing.plan->pass) continue;
        ew_result result = find_programs_of(device, task, prepared, (ew_pass)pass, progress, error);
        if (result != EW_OK) return result;
    }
    return EW_OK;
}

/* Draws with uniforms and depth bound. */
static ew_result draw_bound(ew_device *device, const plan_task *task, prepared_plan *prepared, ew_gl_state *state,
                            ew_error *error)
{
    ew_drawing *drawing = &prepared->drawing;
    const bool by_textures = prepared->on_grid || drawing->part_count > 0;
    if (by_textures && draw_by_textures(device, drawing, prepared->on_grid, state)) return EW_OK;
    if (by_textures) {
        const ew_pass pass = drawing->plan->pass;
        int steps_left;
        ew_result result = find_program(device, task, pass, prepared->key, &drawing->programs.names[pass], &steps_left, error);
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

/* Whether the shaders of parts are ready that draw all of a plan. */
static bool are_parts_ready(const ew_device *device, const prepared_plan *prepared, ew_pass pass, int part_count)
{
    const ew_program_cache *cache = &device->programs[pass];
    bool are_ready = ew_program_is_ready(cache, ew_permutation_of_pass(pass, ew_permutation_summed(prepared->key)));
    for (int part = 0; part < part_count; ++part)
        are_ready = are_ready && ew_program_is_ready(cache, ew_permutation_of_pass(pass, prepared->part_keys[part]));
    return are_ready;
}

/* Divides a plan into parts, if one shader would be long; or on a grid, if the rasteriser computes both sides of every `if`,
 * since a part is drawn only in the cells that its lists may light; or if the plan has no shader yet, but those of the parts
 * are ready: a host may have prepared a mix of which these sources are a few. */
static void divide(const ew_device *device, const plan_task *task, prepared_plan *prepared)
{
    const ew_pass pass = prepared->on_grid ? EW_PASS_CELLS : prepared->drawing.plan->pass;
    const bool is_software = ew_gl_dialect(&device->gl).software;
    int part_count = 0;
    /* Of samples, only where they see one surface. */
    const ew_key key =
        prepared->on_grid && is_software ? prepared->key & ~(ew_key)EW_PERMUTATION_DEPTH_MULTISAMPLE : prepared->key;
    if (pass == EW_PASS_MEDIA || !device->gl.float_sums || device->light_sum.is_refused || !ew_permutation_can_be_split(key))
        return;
    for (int part = 0; part < EW_PART_COUNT; ++part)
        if (ew_permutation_has_part(prepared->key, (ew_part)part))
            prepared->part_keys[part_count++] = ew_permutation_of_part(prepared->key, (ew_part)part);
    if (part_count == 0) prepared->part_keys[part_count++] = ew_permutation_of_part(prepared->key, EW_PART_STRAIGHT);
    const ew_key whole = ew_permutation_of_pass(pass, prepared->key);
    const bool skips_cells = prepared->on_grid && is_software && part_count > 1 && prepared->key & EW_PERMUTATION_LISTS;
    if (ew_permutation_is_split(prepared->key) || skips_cells ||
        (!task->steps_left && !ew_program_is_ready(&device->programs[pass], whole) &&
         are_parts_ready(device, prepared, pass, part_count)))
        prepared->drawing.part_count = part_count;
}

static prepared_plan prepare(const ew_device *device, const plan_task *task, const ew_plan *plan)
{
    const ew_gl *gl = &device->gl;
    prepared_plan prepared = {.drawing = {.gl = gl, .plan = plan, .is_ahead = task->steps_left != NULL},
                              .depth = ew_depth_input_kind(gl, &plan->depth),
                              .on_grid = plan->is_adaptive && gl->float_targets && !device->grid.is_refused};
    prepared.key = ew_permutation_with_depth(plan->permutation, prepared.depth);
    if (plan->source_units > ew_gl_dialect(gl).capacity) prepared.key |= EW_PERMUTATION_SOURCE_TEXTURE;
    divide(device, task, &prepared);
    return prepared;
}

/* Draws the plans; ahead, only with a program that is ready and has not drawn yet. If all have, each draws: it may have been in
 * another context. */
static ew_result draw_plans(ew_device *device, const plan_task *task, prepared_plan *prepared, const ahead_progress *progress,
                            ew_gl_state *state, ew_error *error)
{
    ew_result result = EW_OK;
    const bool draws = progress->next || progress->steps_left == 0;
    for (int i = 0; draws && i < task->plan_count && result == EW_OK; ++i) {
        const ew_gl_draw_state wanted = draw_state(&task->plans[i]->target);
        ew_gl_set_blending(&device->gl, &wanted);
        prepared[i].drawing.only = progress->next;
        result = draw(device, task, &prepared[i], state, error);
    }
    if (result != EW_OK || !task->steps_left) return result;
    if (progress->next) ew_program_set_drawn(&device->programs[progress->next_pass], progress->next);
    *task->steps_left = progress->steps_left;
    return EW_OK;
}

/* The programs of all plans come before the first is drawn, so that a shader that fails leaves no half of a picture; but for
 * the one that takes a grid's place where the driver refuses its textures. */
static ew_result draw_in_state(ew_device *device, const plan_task *task, ew_gl_state *state, ew_error *error)
{
    const ew_gl *gl = &device->gl;
    const ew_target *target = &task->plans[0]->target;
    const ew_gl_draw_state wanted = draw_state(target);
    ew_gl_set_draw_state(gl, state, &wanted);
    if (gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return ew_fail(error, EW_ERROR_OPENGL, "framebuffer %u is not complete", target->framebuffer);
    ew_result result = ew_target_check(gl, target, error);
    ahead_progress progress = {0};
    prepared_plan prepared[EW_MAX_PLANS];
    for (int i = 0; i < task->plan_count && result == EW_OK; ++i) {
        prepared[i] = prepare(device, task, task->plans[i]);
        result = find_programs(device, task, &prepared[i], &progress, error);
    }
    return result == EW_OK ? draw_plans(device, task, prepared, &progress, state, error) : result;
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
