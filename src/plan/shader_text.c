/* The text of shaders: see shader_text.h. glsl/README.md tells the files' order and what each needs. */
#include "plan/shader_text.h"

#include "base/printf_format.h"
#include "glsl_text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- Strings ---- */

static void add(ew_shader_text *text, const char *string)
{
    text->strings[text->count++] = string;
    text->ends_in_made = false;
}

/* Adds to the last string if that is made, too. */
EW_PRINTF(2, 3) static void add_made(ew_shader_text *text, const char *format, ...)
{
    if (!text->ends_in_made) {
        add(text, text->made + text->made_used);
        text->made_used++;
        text->ends_in_made = true;
    }
    size_t end = text->made_used - 1;
    va_list arguments;
    va_start(arguments, format);
    text->made_used += (size_t)vsnprintf(text->made + end, EW_SHADER_MAX_MADE - end, format, arguments);
    va_end(arguments);
}

/* A file of glsl/. Where a driver shall name it in its messages, by its place in the shader, lines count from its first. */
static void add_file(ew_shader_text *text, const char *file)
{
    if (text->numbers_lines) add_made(text, "#line 1 %d\n", text->file_count++);
    add(text, file);
}

size_t ew_join_shader_text(const ew_shader_text *text, char *joined)
{
    size_t used = 0;
    for (int i = 0; i < text->count; ++i) {
        size_t length = strlen(text->strings[i]);
        if (joined) memcpy(joined + used, text->strings[i], length + 1);
        used += length;
    }
    return used;
}

/* ---- The head of a shader ---- */

/* Multisampled textures came to OpenGL with GLSL 1.50, and to OpenGL ES with 3.10; gl_SampleMask came with 4.00 and 3.20. */
static void add_version(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    bool multisample = key & EW_PERMUTATION_DEPTH_MULTISAMPLE;
    bool masks_samples = multisample && dialect->sample_mask;
    if (!dialect->es) {
        add(text, masks_samples ? "#version 400 core\n" : "#version 330 core\n");
        return;
    }
    add(text, masks_samples ? "#version 320 es\n" : multisample ? "#version 310 es\n" : "#version 300 es\n");
    add(text, "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n");
    if (multisample) add(text, "precision highp sampler2DMS;\n");
}

/* How many vec4 a source of the kind takes in the shader of `key`. */
static size_t units_of(int kind, ew_key key)
{
    return ew_kind_units(ew_kinds[kind], key & EW_PERMUTATION_REACH);
}

/* How many vec4 the sources take as varyings; 0 where their number is not known, or too large. */
static size_t source_varyings(const ew_dialect *dialect, ew_key key)
{
    size_t units = 0;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (ew_permutation_count(key, kind) == EW_ANY_COUNT) return 0;
        units += ew_permutation_count(key, kind) * units_of(kind, key);
    }
    size_t head = sizeof(struct ew_frame_block) / sizeof(ew_vec4);
    if (key & EW_PERMUTATION_FOG) head += sizeof(struct ew_fog_block) / sizeof(ew_vec4);
    return head + units <= (size_t)dialect->max_varying_vectors ? units : 0;
}

static void add_defines(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    static const char *const flags[EW_PERMUTATION_FLAG_COUNT] = {
        "WEIGHTS",        "DEPTH",      "SIMPSON",     "LUMINANCE", "EVALUATIONS", "DEPTH_MULTISAMPLE", "DITHER", "DITHER_SRGB",
        "WORLD",          "REACH",      "CORE_PIXELS", "SHARPNESS", "SOFT",        "POLYLINES",         "BENDS",  "LISTS",
        "SOURCE_TEXTURE", "IRRADIANCE", "SHADOWS",     "NORMALS",   "FOG",         "FOG_HEIGHT",        "MEDIA",  "PART",
        "SUMMED",         "BEAMS"};
    add_made(text, "#define EW_SOURCE_DATA_SIZE %zu\n", dialect->capacity);
    if (key & EW_PERMUTATION_LISTS) add_made(text, "#define EW_LIST_SIZE %zu\n", dialect->list_size);
    for (int i = 0; i < EW_PERMUTATION_FLAG_COUNT; ++i)
        if (key & (ew_key)1 << i) add_made(text, "#define EW_%s\n", flags[i]);
    if (key & (EW_PERMUTATION_POLYLINES | EW_PERMUTATION_BENDS)) add(text, "#define EW_PIECES\n");
}

/* The published method is a baseline, and reads its sources from the uniform block as it was published. */
static void add_software_defines(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    if (key & EW_PERMUTATION_SIMPSON || !dialect->software) return;
    add(text, "#define EW_SOFTWARE\n");
    size_t varyings = source_varyings(dialect, key);
    if (varyings > 0) add_made(text, "#define EW_SOURCE_VARYINGS %zu\n", varyings);
}

/* ---- Sources ---- */

/* How many sources of a kind there are, as the block says. */
#define EW_COUNT_FORMAT "ew_source_counts[%d].%c"
#define EW_COUNT_PLACE(kind) (kind) / 4, "xyzw"[(kind) % 4]

/* Where the sources of a kind start in the block, as an expression: all of the kinds before it. EW_KIND_COUNT asks for the end
 * of the last. */
static void add_start(ew_shader_text *text, int kind, ew_key key)
{
    size_t known = 0;
    for (int before = 0; before < kind; ++before) {
        unsigned count = ew_permutation_count(key, before);
        /* A part does not know how many there are of the kinds that it leaves out. */
        if (count == EW_ANY_COUNT || key & EW_PERMUTATION_PART)
            add_made(text, EW_COUNT_FORMAT " * %zu + ", EW_COUNT_PLACE(before), units_of(before, key));
        else
            known += count * units_of(before, key);
    }
    add_made(text, "%zu", known);
}

/* The body of a function that reads a source unit by unit. Where places differ from pixel to pixel, some compilers put a dozen
 * branches into the shader for every read: so one read stands in a loop, which hands the units on until each has its place. */
static void add_reading_loop(ew_shader_text *text, const ew_kind *kind, size_t units)
{
    add_made(text, "{\n    vec4 unit0 = vec4(0.0)");
    for (size_t unit = 1; unit < units; ++unit)
        add_made(text, ", unit%zu = unit0", unit);
    add_made(text, ";\n    for (int unit = 0; unit < %zu; ++unit) {\n", units);
    for (size_t unit = 0; unit + 1 < units; ++unit)
        add_made(text, "        unit%zu = unit%zu;\n", unit, unit + 1);
    add_made(text, "        unit%zu = ew_source(EW_%s_START + unit, %zu, i);\n    }\n    return ew_%s_block(", units - 1,
             kind->upper_name, units, kind->name);
    for (size_t unit = 0; unit < units; ++unit)
        add_made(text, "%sunit%zu", unit > 0 ? ", " : "", unit);
}

/* The same for the only source of a kind, whose place is constant. */
static void add_reading(ew_shader_text *text, const ew_kind *kind, size_t units)
{
    add_made(text, "{\n    return ew_%s_block(", kind->name);
    for (size_t unit = 0; unit < units; ++unit)
        add_made(text, "%sew_source(EW_%s_START + %zu, %zu, i)", unit > 0 ? ", " : "", kind->upper_name, unit, units);
}

/* EW_..._COUNT, and the function that reads source i of the kind: its block consists of vec4 and nothing else. */
static void add_reader(ew_shader_text *text, int index, ew_key key)
{
    const ew_kind *kind = ew_kinds[index];
    unsigned count = ew_permutation_count(key, index);
    if (count == 0) return;
    if (count == EW_ANY_COUNT)
        add_made(text, "#define EW_%s_COUNT " EW_COUNT_FORMAT "\n", kind->upper_name, EW_COUNT_PLACE(index));
    else
        add_made(text, "#define EW_%s_COUNT %u\n", kind->upper_name, count);
    add_made(text, "#define EW_%s_START (", kind->upper_name);
    add_start(text, index, key);
    add_made(text, ")\new_%s_block ew_%s(int i)\n", kind->name, kind->name);
    if (count == EW_ANY_COUNT)
        add_reading_loop(text, kind, units_of(index, key));
    else
        add_reading(text, kind, units_of(index, key));
    add_made(text, "%s);\n}\n", key & EW_PERMUTATION_REACH ? "" : ", ew_plain_glow()");
}

/* Whether lists may say which pieces of the kind's sources light a tile. */
static bool may_have_ranges(ew_key key, int kind)
{
    return key & EW_PERMUTATION_LISTS && ew_kinds[kind]->chain;
}

static void add_readers(ew_shader_text *text, ew_key key)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        add_reader(text, kind, key);
    add_made(text, "#define EW_WEIGHT_START (");
    add_start(text, EW_KIND_COUNT, key);
    add_made(text, ")\n");
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (ew_permutation_count(key, kind) > 0 && !may_have_ranges(key, kind))
            add_made(text, "#define ew_listed_%s(i) ew_%s(EW_PLACE(i))\n#define EW_%s_STEP(i) 1\n", ew_kinds[kind]->name,
                     ew_kinds[kind]->name, ew_kinds[kind]->upper_name);
    add_made(text, "#define EW_ADD_KINDS");
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (ew_permutation_count(key, kind) == 0) continue;
        const ew_list_range lists = ew_permutation_lists_of(key, kind);
        add_made(text, " EW_ADD_KIND(ew_%s_block, ew_listed_%s, EW_%s_STEP, %d, %d, EW_%s_COUNT)", ew_kinds[kind]->name,
                 ew_kinds[kind]->name, ew_kinds[kind]->upper_name, lists.first, lists.last, ew_kinds[kind]->upper_name);
    }
    add_made(text, "\n");
}

/* Adds a file of a kind that no other kind has added. */
static void add_file_once(ew_shader_text *text, const char *file)
{
    for (int i = 0; i < text->count; ++i)
        if (text->strings[i] == file) return;
    add_file(text, file);
}

static void add_files_once(ew_shader_text *text, const char *const files[EW_KIND_MAX_FILES])
{
    for (int i = 0; i < EW_KIND_MAX_FILES && files[i]; ++i)
        add_file_once(text, files[i]);
}

static void add_bend_files(ew_shader_text *text, const ew_kind *kind, bool is_sampling)
{
    const char *const *files = is_sampling ? kind->chain->sampled_bend_files : kind->chain->bend_files;
    for (int i = 0; files[i]; ++i)
        add_file_once(text, files[i]);
}

static void add_kinds(ew_shader_text *text, ew_key key, const ew_integrator_text *integrator)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (ew_permutation_count(key, kind) == 0) continue;
        const char *const *files = integrator->is_sampling ? ew_kinds[kind]->sampling_files : ew_kinds[kind]->adaptive_files;
        if (ew_kinds[kind]->chain && key & EW_PERMUTATION_BENDS) add_bend_files(text, ew_kinds[kind], integrator->is_sampling);
        if (ew_kinds[kind]->chord_file) add_file_once(text, ew_kinds[kind]->chord_file);
        add_files_once(text, files);
        if (!integrator->each_kind) continue;
        add_made(text, "#define EW_SOURCE ew_%s_block\n", ew_kinds[kind]->name);
        if (!ew_kinds[kind]->chain) add_file(text, ew_glsl_sample_source_glsl);
        add_file(text, integrator->each_kind);
        add(text, "#undef EW_SOURCE\n");
    }
}

/* ---- Whole shaders ---- */

static const char *const nothing_before[] = {NULL};

static const ew_integrator_text *integrator_of(ew_key key)
{
    static const char *const adaptive_before[] = {ew_glsl_quadrature_glsl, NULL};
    static const char *const fogged_before[] = {ew_glsl_fogged_glsl, ew_glsl_quadrature_glsl, ew_glsl_fog_moments_glsl, NULL};
    static const ew_integrator_text adaptive = {adaptive_before, NULL, false};
    static const ew_integrator_text fogged = {fogged_before, NULL, false};
    static const ew_integrator_text simpson = {nothing_before, ew_glsl_simpson_glsl, true};
    if (key & EW_PERMUTATION_SIMPSON) return &simpson;
    return key & EW_PERMUTATION_FOG ? &fogged : &adaptive;
}

/* What the light along rays and that on surfaces share. */
static void add_sources(ew_shader_text *text, ew_key key, bool has_grid)
{
    add_file(text, ew_glsl_layout_glsl);
    add_file(text, ew_glsl_blocks_glsl);
    if (has_grid) add_file(text, ew_glsl_grid_glsl);
    add_readers(text, key);
    add_file(text, ew_glsl_segment_glsl);
    add_file(text, ew_glsl_core_glsl);
    if (key & EW_PERMUTATION_FOG) add_file(text, ew_glsl_fog_glsl);
    if (key & EW_PERMUTATION_MEDIA) add_file(text, ew_glsl_media_glsl);
    add_file(text, ew_glsl_components_glsl);
    if (key & EW_PERMUTATION_WEIGHTS) add_file(text, ew_glsl_weight_glsl);
    if (key & EW_PERMUTATION_LISTS) add_file(text, ew_glsl_list_glsl);
    add_file(text, ew_glsl_each_glsl);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (ew_permutation_count(key, kind) > 0 && may_have_ranges(key, kind)) add_file(text, ew_kinds[kind]->chain->list_file);
}

/* The light along a segment of a ray. */
static void add_light(ew_shader_text *text, ew_key key, const ew_integrator_text *integrator, bool has_grid)
{
    add_sources(text, key, has_grid);
    if (integrator->is_sampling) {
        add(text, "#define EW_SAMPLING\n");
        add_file(text, ew_glsl_sample_glsl);
    }
    for (int i = 0; integrator->before[i]; ++i)
        add_file(text, integrator->before[i]);
    /* Of the grid's passes, the one that finds the field of the nodes is the one that samples. */
    if (key & EW_PERMUTATION_MEDIA && has_grid && integrator->is_sampling) add_file(text, ew_glsl_media_edge_glsl);
    add_kinds(text, key, integrator);
    add_file(text, ew_glsl_light_glsl);
}

/* The light on surfaces. */
static void add_irradiance(ew_shader_text *text, ew_key key)
{
    add_file(text, ew_glsl_emitter_glsl);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (ew_permutation_count(key, kind) > 0) add_files_once(text, ew_kinds[kind]->irradiance_files);
    add_file(text, ew_glsl_irradiance_glsl);
}

/* What glossy surfaces mirror of that. */
static void add_gloss(ew_shader_text *text, ew_key key)
{
    add_file_once(text, ew_glsl_straight_emitter_glsl);
    add_file(text, ew_glsl_gloss_glsl);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (ew_permutation_count(key, kind) > 0) add_files_once(text, ew_kinds[kind]->gloss_files);
    add_file(text, ew_glsl_gloss_of_all_glsl);
}

/* The light of media themselves. */
static void add_media_light(ew_shader_text *text, ew_key key)
{
    if (key & EW_PERMUTATION_FOG_HEIGHT) add_file_once(text, ew_glsl_product_rule_glsl);
    add_file(text, ew_glsl_media_light_glsl);
}

static void start(ew_shader_text *text, bool numbers_lines)
{
    text->count = text->file_count = 0;
    text->made_used = 0;
    text->ends_in_made = false;
    text->numbers_lines = numbers_lines;
}

static bool integrates(ew_pass pass)
{
    return pass == EW_PASS_WAVE || pass == EW_PASS_NODES || pass == EW_PASS_FIELD || pass == EW_PASS_CELLS ||
           pass == EW_PASS_SURFACES || pass == EW_PASS_MEDIA;
}

static bool draws_patches(ew_pass pass)
{
    return pass == EW_PASS_CELLS || pass == EW_PASS_INTERPOLATION;
}

ew_key ew_permutation_of_pass(ew_pass pass, ew_key key)
{
    switch (pass) {
    case EW_PASS_NODES:
        return key & ~EW_PERMUTATION_OF_TARGET;
    case EW_PASS_FIELD:
        return key & ~(EW_PERMUTATION_OF_TARGET | EW_PERMUTATION_SHARPNESS);
    case EW_PASS_PEAK:
        return 0;
    case EW_PASS_CLASSES:
        return key & (EW_PERMUTATION_DEPTH | EW_PERMUTATION_DEPTH_MULTISAMPLE | EW_PERMUTATION_WORLD | EW_PERMUTATION_LISTS |
                      EW_PERMUTATION_SOURCE_TEXTURE | EW_PERMUTATION_LUMINANCE);
    case EW_PASS_INTERPOLATION:
        return key & EW_PERMUTATION_OF_TARGET;
    default:
        return key & EW_PERMUTATION_PART ? key & ~EW_PERMUTATION_OF_TARGET : key;
    }
}

static void start_stage(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key)
{
    start(text, true);
    add_version(text, dialect, key);
    add_defines(text, dialect, key);
    if (draws_patches(pass)) add(text, "#define EW_PATCHES\n");
    if (integrates(pass)) add_software_defines(text, dialect, key);
}

void ew_write_vertex_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key)
{
    start_stage(text, dialect, pass, key);
    add(text, "#define EW_VERTEX_STAGE\n");
    if (key & EW_PERMUTATION_PART) {
        const ew_list_range lists = ew_permutation_lists(key);
        add_made(text, "#define EW_FIRST_LIST %d\n#define EW_LAST_LIST %d\n", lists.first, lists.last);
    }
    if (pass == EW_PASS_INTERPOLATION) add(text, "#define EW_INTERPOLATED\n");
    add_file(text, ew_glsl_layout_glsl);
    add_file(text, ew_glsl_blocks_glsl);
    if (draws_patches(pass)) add_file(text, ew_glsl_grid_glsl);
    if (pass == EW_PASS_CELLS && key & EW_PERMUTATION_LISTS) add_file(text, ew_glsl_list_glsl);
    if (pass == EW_PASS_INTERPOLATION) {
        add_file(text, ew_glsl_patch_glsl);
        add_file(text, ew_glsl_edge_glsl);
        add_file(text, ew_glsl_fit_glsl);
    }
    add_file(text, draws_patches(pass) ? ew_glsl_patch_vert : ew_glsl_quad_vert);
}

static void add_dither(ew_shader_text *text, ew_key key)
{
    if (!(key & EW_PERMUTATION_DITHER)) return;
    add_file(text, ew_glsl_noise_glsl);
    add_file(text, ew_glsl_dither_glsl);
}

static void add_target_files(ew_shader_text *text, ew_key key)
{
    add_file(text, ew_glsl_composite_glsl);
    add_dither(text, key);
}

static void add_depth(ew_shader_text *text, ew_key key)
{
    if (key & EW_PERMUTATION_DEPTH) add_file(text, ew_glsl_depth_glsl);
}

/* The depth, and which samples are shaded, of a pass that draws to the target. */
static void add_depth_of_samples(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    add_depth(text, key);
    if (!(key & EW_PERMUTATION_DEPTH_MULTISAMPLE)) return;
    /* A part is drawn to a texture without samples, where all those of a pixel see one surface. */
    if (dialect->sample_mask && !(key & EW_PERMUTATION_PART)) add(text, "#define EW_SAMPLE_MASK\n");
    add_file(text, ew_glsl_samples_glsl);
}

static void write_integrating_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key,
                                     const ew_integrator_text *integrator)
{
    const bool is_of_nodes = pass == EW_PASS_NODES || pass == EW_PASS_FIELD;
    start_stage(text, dialect, pass, key);
    if (is_of_nodes) add(text, "#define EW_NODE_STAGE\n");
    if (pass == EW_PASS_FIELD) add(text, "#define EW_FIELD\n");
    add_light(text, key, integrator, is_of_nodes);
    if (is_of_nodes) {
        add_depth(text, key);
        add_file(text, ew_glsl_ray_glsl);
        add_file(text, ew_glsl_node_frag);
        return;
    }
    add_depth_of_samples(text, dialect, key);
    add_file(text, ew_glsl_ray_glsl);
    if (key & EW_PERMUTATION_PART) {
        add_file(text, ew_glsl_part_frag);
        return;
    }
    add_target_files(text, key);
    add_file(text, ew_glsl_wave_frag);
}

void ew_write_fragment_shader_with(ew_shader_text *text, const ew_dialect *dialect, ew_key key,
                                   const ew_integrator_text *integrator)
{
    write_integrating_shader(text, dialect, EW_PASS_WAVE, key, integrator);
}

static void write_surface_shader(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    start_stage(text, dialect, EW_PASS_SURFACES, key);
    add_sources(text, key, false);
    add_irradiance(text, key);
    add_depth_of_samples(text, dialect, key);
    add_file(text, ew_glsl_ray_glsl);
    add_file(text, ew_glsl_composite_glsl);
    add_file(text, ew_glsl_normal_glsl);
    if (key & EW_PERMUTATION_SHADOWS) {
        add_file(text, ew_glsl_noise_glsl);
        add_file(text, ew_glsl_shadow_glsl);
    }
    add_file(text, ew_glsl_surface_frag);
}

static void write_media_shader(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    start_stage(text, dialect, EW_PASS_MEDIA, key);
    add_sources(text, key, false);
    add_media_light(text, key);
    add_depth_of_samples(text, dialect, key);
    add_file(text, ew_glsl_ray_glsl);
    add_dither(text, key);
    add_file(text, ew_glsl_media_frag);
}

static void write_summed_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key)
{
    start_stage(text, dialect, pass, key);
    add_file(text, ew_glsl_layout_glsl);
    add_file(text, ew_glsl_blocks_glsl);
    add_target_files(text, key);
    add_file(text, ew_glsl_summed_frag);
}

void ew_write_fragment_shader(ew_shader_text *text, const ew_dialect *dialect, ew_pass pass, ew_key key)
{
    if (key & EW_PERMUTATION_SUMMED) {
        write_summed_shader(text, dialect, pass, key);
        return;
    }
    if (pass == EW_PASS_SURFACES) {
        write_surface_shader(text, dialect, key);
        return;
    }
    if (pass == EW_PASS_MEDIA) {
        write_media_shader(text, dialect, key);
        return;
    }
    if (integrates(pass)) {
        static const ew_integrator_text field = {nothing_before, ew_glsl_field_glsl, true};
        write_integrating_shader(text, dialect, pass, key, pass == EW_PASS_FIELD ? &field : integrator_of(key));
        return;
    }
    start_stage(text, dialect, pass, key);
    add_file(text, ew_glsl_layout_glsl);
    if (pass == EW_PASS_PEAK) {
        add_file(text, ew_glsl_peak_frag);
        return;
    }
    add_file(text, ew_glsl_blocks_glsl);
    add_depth(text, key);
    add_file(text, ew_glsl_grid_glsl);
    if (pass == EW_PASS_CLASSES) {
        add_file(text, ew_glsl_edge_glsl);
        if (key & EW_PERMUTATION_LISTS) add_file(text, ew_glsl_list_glsl);
        add_file(text, ew_glsl_classify_frag);
        return;
    }
    add_file(text, ew_glsl_patch_glsl);
    add_target_files(text, key);
    add_file(text, ew_glsl_interpolate_frag);
}

void ew_write_include(ew_shader_text *text, const ew_dialect *dialect, ew_key key)
{
    start(text, false);
    add(text, "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n");
    add_defines(text, dialect, key);
    add_light(text, key, integrator_of(key), false);
    if (key & EW_PERMUTATION_IRRADIANCE) {
        add_irradiance(text, key);
        add_gloss(text, key);
    }
    if (key & EW_PERMUTATION_MEDIA) add_media_light(text, key);
    add_file(text, ew_glsl_include_glsl);
}
