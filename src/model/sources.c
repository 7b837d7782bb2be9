/* The host's sources: see sources.h. */
#include "model/sources.h"

#include "base/error.h"
#include "model/limits.h"
#include "model/vector.h"
#include "model/weights.h"

#include <string.h>

/* Drivers of desktop GL have it. */
enum { MAX_BLOCK_SIZE = 65536 };

size_t ew_largest_block(size_t block_size)
{
    return block_size < MAX_BLOCK_SIZE ? block_size : MAX_BLOCK_SIZE;
}

size_t ew_sources_capacity(size_t block_size)
{
    return (ew_largest_block(block_size) - sizeof(struct ew_uniform_head)) / sizeof(ew_vec4);
}

/* ---- The host's description ---- */

static size_t count_in(const ew_sources_desc *desc, const ew_kind *kind)
{
    size_t count;
    memcpy(&count, (const char *)desc + kind->count_offset, sizeof count);
    return count;
}

static const char *list_in(const ew_sources_desc *desc, const ew_kind *kind)
{
    const char *list;
    memcpy(&list, (const char *)desc + kind->list_offset, sizeof list);
    return list;
}

static ew_weight_list weights_of(const ew_kind *kind, const void *source)
{
    return kind->weights ? kind->weights(source) : (ew_weight_list){NULL, 0};
}

static size_t count_weight_pieces(const ew_sources_desc *desc)
{
    size_t pieces = 0;
    for (int k = 0; k < EW_KIND_COUNT; ++k)
        for (size_t i = 0; ew_kinds[k]->weights && i < count_in(desc, ew_kinds[k]); ++i)
            pieces += ew_weight_piece_count(weights_of(ew_kinds[k], list_in(desc, ew_kinds[k]) + i * ew_kinds[k]->size).count);
    return pieces;
}

static double core_of(const ew_emission *emission, double epsilon)
{
    return emission->core > 0 ? emission->core : epsilon;
}

/* Whether a source has a reach or a core of its own. */
static bool needs_glow(const ew_sources_desc *desc)
{
    for (int k = 0; k < EW_KIND_COUNT; ++k)
        for (size_t i = 0; i < count_in(desc, ew_kinds[k]); ++i) {
            const ew_emission *emission = ew_source_emission(ew_kinds[k], list_in(desc, ew_kinds[k]) + i * ew_kinds[k]->size);
            if (emission->reach > 0 || emission->core > 0) return true;
        }
    return false;
}

/* Counts the pieces of all chains, and the bytes and units that they take. On failure says which source has too many. */
typedef struct piece_total {
    size_t bytes, units, chains;
} piece_total;

static ew_result count_pieces(const ew_sources_desc *desc, piece_total *total, ew_error *error)
{
    *total = (piece_total){0};
    for (int k = 0; k < EW_KIND_COUNT; ++k) {
        const ew_kind *kind = ew_kinds[k];
        for (size_t i = 0; kind->chain && i < count_in(desc, kind); ++i) {
            const char *source = list_in(desc, kind) + i * kind->size;
            const ew_source_name name = {kind->list_name, i};
            size_t count;
            ew_result result =
                kind->chain->count(source, core_of(ew_source_emission(kind, source), desc->epsilon), &name, &count, error);
            if (result != EW_OK) return result;
            total->bytes += count * kind->chain->piece_size;
            total->units += count * kind->chain->most_piece_units(source);
            total->chains++;
        }
    }
    return EW_OK;
}

static size_t count_all(const ew_sources_desc *desc)
{
    size_t count = 0;
    for (int k = 0; k < EW_KIND_COUNT; ++k)
        count += count_in(desc, ew_kinds[k]);
    return count;
}

/* ---- Checks ---- */

static ew_result check_list(const ew_sources_desc *desc, const ew_kind *kind, ew_error *error)
{
    size_t count = count_in(desc, kind);
    if (list_in(desc, kind) || count == 0) return EW_OK;
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s must not be NULL with a count of %zu", kind->list_name, count);
}

/* Takes what `count` elements need from the units that are left. */
static ew_result take_units(const char *elements, size_t count, size_t units, size_t *left, ew_error *error)
{
    if (count > *left / units)
        return ew_fail(error, EW_ERROR_TOO_MANY_SOURCES,
                       "%zu %s of %zu units each are too many: an effect takes %d units of sources, of which %zu are left",
                       count, elements, units, EW_MAX_SOURCE_UNITS, *left);
    *left -= count * units;
    return EW_OK;
}

static ew_result refuse(const ew_source_name *name, const char *text, ew_error *error)
{
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].%s", name->list, name->index, text);
}

static bool is_positive_or_0(double value)
{
    return isfinite(value) && value >= 0;
}

static ew_result check_light(const ew_emission *emission, const ew_source_name *name, ew_error *error)
{
    if (!is_positive_or_0(emission->coefficient)) return refuse(name, "coefficient must be finite and >= 0", error);
    if (!is_positive_or_0(emission->brightness)) return refuse(name, "brightness must be finite and >= 0", error);
    if (emission->coefficient > 0 && emission->brightness > 0)
        return refuse(name, "brightness must not be given together with a coefficient", error);
    for (int i = 0; i < 3; ++i)
        if (!(emission->color[i] >= 0 && emission->color[i] <= EW_MAX_COLOR))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].color must be in [0, %g]", name->list, name->index,
                           EW_MAX_COLOR);
    return EW_OK;
}

static ew_result check_extent(const ew_emission *emission, double epsilon, const ew_source_name *name, ew_error *error)
{
    if (!is_positive_or_0(emission->core)) return refuse(name, "core must be finite and >= 0", error);
    if (!(core_of(emission, epsilon) > 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "epsilon must be > 0, or else %s[%zu].core", name->list, name->index);
    if (!is_positive_or_0(emission->reach)) return refuse(name, "reach must be finite and >= 0", error);
    if (emission->reach > 0 && !(emission->reach > core_of(emission, epsilon)))
        return refuse(name, "reach must be larger than the core", error);
    if (emission->brightness > 0 && emission->reach == 0) return refuse(name, "brightness needs a reach", error);
    if (emission->sharpness == 0) return EW_OK;
    if (!(isfinite(emission->sharpness) && emission->sharpness >= 1))
        return refuse(name, "sharpness must be finite and >= 1, or 0", error);
    if (emission->reach == 0) return refuse(name, "sharpness needs a reach", error);
    return EW_OK;
}

static ew_result check_sources_of(const ew_sources_desc *desc, const ew_kind *kind, ew_error *error)
{
    for (size_t i = 0; i < count_in(desc, kind); ++i) {
        const char *source = list_in(desc, kind) + i * kind->size;
        ew_source_name name = {kind->list_name, i};
        ew_result result = kind->check(source, &name, error);
        if (result == EW_OK) result = check_light(ew_source_emission(kind, source), &name, error);
        if (result == EW_OK) result = check_extent(ew_source_emission(kind, source), desc->epsilon, &name, error);
        if (result != EW_OK) return result;
    }
    return EW_OK;
}

/* Counts come first: no source is looked at before all of them are known to fit. */
static ew_result check(const ew_sources_desc *desc, piece_total *total, ew_error *error)
{
    if (!desc) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "sources must not be NULL");
    if (!is_positive_or_0(desc->epsilon)) return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "epsilon must be finite and >= 0");
    ew_result result = EW_OK;
    size_t left = EW_MAX_SOURCE_UNITS;
    for (int k = 0; k < EW_KIND_COUNT && result == EW_OK; ++k)
        result = check_list(desc, ew_kinds[k], error);
    for (int k = 0; k < EW_KIND_COUNT && result == EW_OK; ++k)
        result =
            take_units(ew_kinds[k]->list_name, count_in(desc, ew_kinds[k]), ew_kind_units(ew_kinds[k], false), &left, error);
    for (int k = 0; k < EW_KIND_COUNT && result == EW_OK; ++k)
        result = check_sources_of(desc, ew_kinds[k], error);
    if (result != EW_OK) return result;
    if (needs_glow(desc)) result = take_units("reaches or cores", count_all(desc), 1, &left, error);
    if (result != EW_OK) return result;
    result = take_units("pieces of weights", count_weight_pieces(desc), sizeof(struct ew_weight_block) / sizeof(ew_vec4), &left,
                        error);
    if (result == EW_OK) result = count_pieces(desc, total, error);
    return result == EW_OK ? take_units("units of paths' pieces", total->units, 1, &left, error) : result;
}

/* ---- Memory ---- */

/* Hands out the next `size` bytes of an allocation, or only counts them while there is none yet. */
static void *carve(char *memory, size_t *used, size_t size)
{
    void *part = memory ? memory + *used : NULL;
    *used += size;
    return part;
}

/* Lays the arrays out in `memory`; with NULL, only returns how much is needed. Doubles and pointers come first, so that all is
 * aligned. */
static size_t lay_out(const ew_sources_desc *desc, const piece_total *total, char *memory, ew_sources *sources)
{
    size_t used = 0, with_weights = 0, units = 0;
    sources->has_glow = needs_glow(desc);
    for (int k = 0; k < EW_KIND_COUNT; ++k) {
        const ew_kind *kind = ew_kinds[k];
        size_t count = count_in(desc, kind);
        sources->counts[k] = count;
        sources->lists[k] = carve(memory, &used, count * kind->size);
        if (kind->weights) with_weights += count;
        units += count * ew_kind_units(kind, sources->has_glow);
    }
    sources->lit_count = count_all(desc);
    sources->lit = carve(memory, &used, sources->lit_count * sizeof *sources->lit);
    sources->weights = carve(memory, &used, with_weights * sizeof *sources->weights);
    sources->piece_ranges = carve(memory, &used, total->chains * sizeof *sources->piece_ranges);
    sources->pieces = carve(memory, &used, total->bytes);
    sources->weight_piece_count = count_weight_pieces(desc);
    sources->weight_units = units;
    sources->data_size = (units + sources->weight_piece_count + total->units) * sizeof(ew_vec4);
    sources->data = carve(memory, &used, sources->data_size);
    return used;
}

/* Copies the sources, and makes their weight pieces, which no frame changes. */
static void copy_sources(const ew_sources_desc *desc, ew_sources *sources)
{
    struct ew_weight_block *pieces = NULL;
    if (sources->weight_piece_count > 0) pieces = (void *)((ew_vec4 *)sources->data + sources->weight_units);
    ew_weight_range *range = sources->weights;
    size_t first_piece = 0;
    for (int k = 0; k < EW_KIND_COUNT; ++k) {
        const ew_kind *kind = ew_kinds[k];
        if (sources->counts[k] > 0) memcpy(sources->lists[k], list_in(desc, kind), sources->counts[k] * kind->size);
        for (size_t i = 0; kind->weights && i < sources->counts[k]; ++i) {
            ew_weight_list list = weights_of(kind, list_in(desc, kind) + i * kind->size);
            *range = (ew_weight_range){first_piece, ew_weight_piece_count(list.count), ew_mean_of_weights(list)};
            if (list.count > 0) ew_make_weight_pieces(list, pieces + first_piece);
            first_piece += range->piece_count;
            ++range;
        }
    }
}

/* Makes what the sources light, and the pieces of chains. */
static ew_result make_shapes(const ew_sources_desc *desc, ew_sources *sources, ew_error *error)
{
    ew_lit_source *lit = sources->lit;
    ew_piece_range *range = sources->piece_ranges;
    char *pieces = sources->pieces;
    size_t unit = sources->weight_units + sources->weight_piece_count;
    for (int k = 0; k < EW_KIND_COUNT; ++k) {
        const ew_kind *kind = ew_kinds[k];
        for (size_t i = 0; i < sources->counts[k]; ++i, ++lit) {
            const char *source = (const char *)sources->lists[k] + i * kind->size;
            const ew_emission *emission = ew_source_emission(kind, source);
            *lit = (ew_lit_source){kind, source, i, NULL, kind->bound(source), emission->reach};
            sources->has_sharpness = sources->has_sharpness || emission->sharpness > 1;
            if (!kind->chain) {
                sources->has_list[kind->list] = true;
                continue;
            }
            lit->pieces = range;
            const ew_source_name name = {kind->list_name, i};
            double core = core_of(emission, desc->epsilon);
            *range = (ew_piece_range){.first_unit = unit, .ball = lit->ball};
            ew_result result = kind->chain->count(source, core, &name, &range->piece_count, error);
            if (result != EW_OK) return result;
            kind->chain->make(source, core, pieces);
            range->pieces = pieces;
            range->piece_units = kind->chain->piece_units(source, pieces, range->piece_count);
            sources->has_list[ew_list_of(lit)] = true;
            pieces += range->piece_count * kind->chain->piece_size;
            unit += range->piece_count * range->piece_units;
            ++range;
        }
    }
    sources->data_size = unit * sizeof(ew_vec4);
    return EW_OK;
}

ew_result ew_sources_set(ew_sources *sources, const ew_sources_desc *desc, const ew_allocator *allocator, ew_error *error)
{
    piece_total total;
    ew_result result = check(desc, &total, error);
    if (result != EW_OK) return result;
    ew_sources made = {.memory = sources->memory, .memory_size = sources->memory_size, .epsilon = desc->epsilon};
    size_t size = lay_out(desc, &total, NULL, &made);
    if (size > made.memory_size) {
        made.memory = allocator->allocate(allocator->user, size);
        if (!made.memory) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for %zu bytes of sources", size);
        made.memory_size = size;
        ew_sources_destroy(sources, allocator);
    }
    lay_out(desc, &total, made.memory, &made);
    copy_sources(desc, &made);
    result = make_shapes(desc, &made, error);
    *sources = made;
    return result;
}

void ew_sources_destroy(ew_sources *sources, const ew_allocator *allocator)
{
    if (sources->memory) allocator->deallocate(allocator->user, sources->memory);
    *sources = (ew_sources){0};
}

/* ---- What a frame asks ---- */

size_t ew_count_hulls(const ew_lit_source *lit)
{
    return lit->pieces ? lit->pieces->piece_count : 1;
}

ew_hull ew_hull_of_source(const ew_lit_source *lit, size_t index)
{
    const ew_chain_kind *chain = lit->kind->chain;
    return chain ? chain->hull((const char *)lit->pieces->pieces + index * chain->piece_size) : lit->kind->hull(lit->source);
}

ew_list ew_list_of(const ew_lit_source *lit)
{
    const int list = lit->kind->list;
    if (!lit->pieces || lit->pieces->piece_units == 0) return (ew_list)list;
    return (ew_list)(lit->pieces->piece_units == EW_BENT_UNITS ? list + 2 : list + 1);
}

ew_mix ew_sources_mix(const ew_sources *sources)
{
    ew_mix mix = {.has_weights = sources->weight_piece_count > 0,
                  .has_reach = sources->has_glow,
                  .has_sharpness = sources->has_sharpness,
                  .has_joints = sources->has_list[EW_LIST_POLYLINES] || sources->has_list[EW_LIST_BENDS],
                  .has_bends = sources->has_list[EW_LIST_BENDS]};
    for (int k = 0; k < EW_KIND_COUNT; ++k)
        memcpy((char *)&mix + ew_kinds[k]->mix_offset, &sources->counts[k], sizeof sources->counts[k]);
    return mix;
}

/* c of the field, from the brightness b where the host gives that: b / (2 ln(R / r)). */
static double coefficient_of(const ew_emission *emission, double core)
{
    return emission->brightness > 0 ? emission->brightness / (2 * log(emission->reach / core)) : emission->coefficient;
}

/* The luminance through the middle of an orb; any positive number will do of a source that is dark. */
static double brightness_of(const ew_emission *emission, double core)
{
    if (emission->brightness > 0) return emission->brightness;
    return emission->coefficient > 0 && emission->reach > 0 ? emission->coefficient * 2 * log(emission->reach / core) : 1;
}

static ew_result pack_emission(const ew_emission *emission, const ew_source_name *name, const ew_packing *packing,
                               const ew_sources *sources, ew_vec4 *color_and_glow, ew_error *error)
{
    double core = core_of(emission, sources->epsilon), core_in_space = core / packing->space.length;
    double scaled = coefficient_of(emission, core) * packing->coefficient_scale;
    if (!(scaled <= EW_MAX_COEFFICIENT))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "%s[%zu].coefficient times decay_alpha over the interval's length must be at most %g", name->list,
                       name->index, EW_MAX_COEFFICIENT);
    if (!(core_in_space >= packing->least_core && core_in_space <= EW_MAX_COORDINATE))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s, of %s[%zu], over the interval's length must be in [%g, %g]",
                       emission->core > 0 ? "core" : "epsilon", name->list, name->index, packing->least_core,
                       EW_MAX_COORDINATE);
    double color[3];
    for (int i = 0; i < 3; ++i) {
        double exposed = emission->color[i] * packing->exposure;
        color[i] = exposed > EW_MAX_COLOR ? EW_MAX_COLOR : exposed;
    }
    color_and_glow[0] = ew_pack(color, scaled);
    if (!sources->has_glow) return EW_OK;
    double reach = emission->reach / packing->space.length;
    const double glow[3] = {core_in_space, fmin(reach, EW_MAX_COORDINATE), emission->sharpness};
    color_and_glow[1] = ew_pack(glow, brightness_of(emission, core));
    return EW_OK;
}

ew_result ew_sources_pack(ew_sources *sources, const ew_packing *packing, ew_error *error)
{
    char *block = sources->data;
    const ew_weight_range *weights = sources->weights;
    const ew_piece_range *range = sources->piece_ranges;
    for (int k = 0; k < EW_KIND_COUNT; ++k) {
        const ew_kind *kind = ew_kinds[k];
        for (size_t i = 0; i < sources->counts[k]; ++i) {
            const char *source = (const char *)sources->lists[k] + i * kind->size;
            ew_source_name name = {kind->list_name, i};
            ew_result result = kind->pack(source, &name, &packing->space, kind->weights ? weights++ : NULL, block, error);
            if (result == EW_OK)
                result = pack_emission(ew_source_emission(kind, source), &name, packing, sources,
                                       (ew_vec4 *)(void *)(block + kind->color_offset), error);
            if (result == EW_OK && kind->chain) {
                result = kind->chain->pack(&name, &packing->space, range->pieces, range, block,
                                           (ew_vec4 *)sources->data + range->first_unit, error);
                ++range;
            }
            if (result != EW_OK) return result;
            block += ew_kind_units(kind, sources->has_glow) * sizeof(ew_vec4);
        }
    }
    return EW_OK;
}

ew_result ew_sources_check_reach(const ew_sources *sources, ew_error *error)
{
    for (size_t i = 0; i < sources->lit_count; ++i) {
        const ew_lit_source *lit = &sources->lit[i];
        if (lit->reach > 0) continue;
        const ew_source_name name = {lit->kind->list_name, lit->index};
        return refuse(&name, "reach must be given in a frame without an interval", error);
    }
    return EW_OK;
}
