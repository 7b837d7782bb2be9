/* Shader permutations: see permutation.h. */
#include "plan/permutation.h"

#include "plan/frame.h"

#include <string.h>

_Static_assert(EW_PERMUTATION_FLAG_COUNT + EW_KIND_COUNT * EW_PERMUTATION_COUNT_BITS <= 64, "a key has too few bits");
_Static_assert(EW_ANY_COUNT < 1 << EW_PERMUTATION_COUNT_BITS, "a count has too few bits");

static int count_shift(int kind)
{
    return EW_PERMUTATION_FLAG_COUNT + kind * EW_PERMUTATION_COUNT_BITS;
}

unsigned ew_permutation_count(ew_key key, int kind)
{
    return (unsigned)(key >> count_shift(kind)) & ((1u << EW_PERMUTATION_COUNT_BITS) - 1);
}

ew_key ew_permutation_with_count(ew_key key, int kind, size_t count)
{
    return key | (ew_key)(count < EW_ANY_COUNT ? count : EW_ANY_COUNT) << count_shift(kind);
}

static ew_key dither_of(const ew_frame_desc *frame)
{
    if (!frame->dither || !ew_draws_picture(frame) || frame->encoding == EW_ENCODING_FLOAT) return 0;
    return EW_PERMUTATION_DITHER | (frame->encoding == EW_ENCODING_SRGB_8BIT ? (ew_key)EW_PERMUTATION_DITHER_SRGB : 0);
}

static ew_key emitters_of(const ew_mix *mix, const ew_frame_desc *frame)
{
    ew_key key = EW_PERMUTATION_IRRADIANCE | EW_PERMUTATION_WORLD;
    if (frame->shadow_thickness > 0) key |= EW_PERMUTATION_SHADOWS;
    if (frame->normal_texture != 0) key |= EW_PERMUTATION_NORMALS;
    if (mix->has_reach) key |= EW_PERMUTATION_REACH;
    return key;
}

/* What dims light on its way. */
static ew_key air_of(const ew_frame_desc *frame)
{
    ew_key key = 0;
    if (ew_has_fog(frame) || frame->medium_count > 0) key |= EW_PERMUTATION_FOG;
    if (ew_has_height_fog(frame)) key |= EW_PERMUTATION_FOG_HEIGHT;
    if (frame->medium_count > 0) key |= EW_PERMUTATION_MEDIA;
    return key;
}

static ew_key field_of(const ew_mix *mix, const ew_frame_desc *frame)
{
    ew_key key = ew_is_world_frame(frame) ? EW_PERMUTATION_WORLD | EW_PERMUTATION_REACH : 0;
    if (mix->has_reach) key |= EW_PERMUTATION_REACH;
    if (mix->has_sharpness) key |= EW_PERMUTATION_SHARPNESS | EW_PERMUTATION_REACH;
    if (ew_core_pixels_of(frame) > 0) key |= EW_PERMUTATION_CORE_PIXELS;
    return key | air_of(frame);
}

static size_t count_in(const ew_mix *mix, int kind)
{
    size_t count;
    memcpy(&count, (const char *)mix + ew_kinds[kind]->mix_offset, sizeof count);
    return count;
}

/* About how many times as long a source takes where sources have reaches. */
enum { COST_OF_REACHES = 3 };

double ew_mix_cost(const ew_mix *mix)
{
    double cost = 0;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        cost += (double)count_in(mix, kind) * ew_kinds[kind]->cost_in_points;
    return mix->has_reach ? COST_OF_REACHES * cost : cost;
}

ew_key ew_permutation_of(const ew_mix *mix, const ew_frame_desc *frame)
{
    ew_key key = dither_of(frame) | (ew_draws_surfaces(frame) ? emitters_of(mix, frame) : field_of(mix, frame));
    if (mix->path_count > 0) key |= EW_PERMUTATION_BEAMS;
    if ((mix->has_joints || mix->has_bends) && mix->path_count > 0) key |= EW_PERMUTATION_POLYLINES;
    if (mix->has_bends && mix->path_count > 0) key |= EW_PERMUTATION_BENDS;
    bool takes_weights = false;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        size_t count = count_in(mix, kind);
        key = ew_permutation_with_count(key, kind, count);
        takes_weights = takes_weights || (ew_kinds[kind]->weights && count > 0);
    }
    if (mix->has_weights && takes_weights) key |= EW_PERMUTATION_WEIGHTS;
    if (frame->integrator == EW_INTEGRATOR_SIMPSON && !ew_draws_surfaces(frame)) key |= EW_PERMUTATION_SIMPSON;
    if (frame->output == EW_OUTPUT_SOFT) key |= EW_PERMUTATION_SOFT;
    if (frame->output == EW_OUTPUT_LUMINANCE) key |= EW_PERMUTATION_LUMINANCE;
    if (frame->output == EW_OUTPUT_EVALUATIONS) key |= EW_PERMUTATION_EVALUATIONS;
    return key;
}

ew_key ew_permutation_of_media(const ew_frame_desc *frame)
{
    return EW_PERMUTATION_WORLD | dither_of(frame) | air_of(frame);
}

ew_key ew_permutation_with_depth(ew_key key, ew_depth_kind depth)
{
    static const ew_key flags[] = {[EW_DEPTH_KIND_NONE] = 0,
                                   [EW_DEPTH_KIND_SINGLE] = EW_PERMUTATION_DEPTH,
                                   [EW_DEPTH_KIND_MULTISAMPLE] = EW_PERMUTATION_DEPTH | EW_PERMUTATION_DEPTH_MULTISAMPLE};
    return key | flags[depth];
}

ew_key ew_permutation_with_lists(ew_key key)
{
    if (!(key & EW_PERMUTATION_REACH)) return key;
    ew_key general = (key & (((ew_key)1 << EW_PERMUTATION_FLAG_COUNT) - 1)) | EW_PERMUTATION_LISTS;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        general = ew_permutation_with_count(general, kind, ew_permutation_count(key, kind) > 0 ? EW_ANY_COUNT : 0);
    return general;
}

/* The form of the chains of a part; 0 if it has none. */
static ew_key form_of(ew_part part)
{
    static const ew_key forms[EW_PART_COUNT] = {[EW_PART_STRAIGHT] = EW_PERMUTATION_BEAMS,
                                                [EW_PART_POLYLINES] = EW_PERMUTATION_POLYLINES,
                                                [EW_PART_BENDS] = EW_PERMUTATION_BENDS};
    return forms[part];
}

ew_key ew_permutation_with_forms(ew_key key, const bool has_list[EW_LIST_COUNT])
{
    if (!has_list[EW_LIST_BEAMS]) key &= ~(ew_key)EW_PERMUTATION_BEAMS;
    if (!has_list[EW_LIST_POLYLINES]) key &= ~(ew_key)EW_PERMUTATION_POLYLINES;
    if (!has_list[EW_LIST_BENDS]) key &= ~(ew_key)EW_PERMUTATION_BENDS;
    return key;
}

ew_list_range ew_permutation_lists_of(ew_key key, int kind)
{
    static const ew_key forms[] = {EW_PERMUTATION_BEAMS, EW_PERMUTATION_POLYLINES, EW_PERMUTATION_BENDS};
    const int list = ew_kinds[kind]->list;
    if (!ew_kinds[kind]->chain) return (ew_list_range){list, list + 1};
    ew_list_range range = {list + 2, list + 1};
    for (int form = 0; form < 3; ++form) {
        if (!(key & forms[form])) continue;
        if (list + form < range.first) range.first = list + form;
        range.last = list + form + 1;
    }
    return range;
}

ew_list_range ew_permutation_lists(ew_key key)
{
    ew_list_range all = {EW_LIST_COUNT, 0};
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (ew_permutation_count(key, kind) == 0) continue;
        const ew_list_range range = ew_permutation_lists_of(key, kind);
        if (range.first < all.first) all.first = range.first;
        if (range.last > all.last) all.last = range.last;
    }
    return all;
}

/* Whether sources of a kind that `key` knows are of a part. */
static bool is_of_part(ew_key key, int kind, ew_part part)
{
    if (ew_permutation_count(key, kind) == 0) return false;
    return ew_kinds[kind]->chain ? (key & form_of(part)) != 0 : ew_kinds[kind]->part == part;
}

bool ew_permutation_has_part(ew_key key, ew_part part)
{
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (is_of_part(key, kind, part)) return true;
    return false;
}

ew_key ew_permutation_of_part(ew_key key, ew_part part)
{
    const ew_key of_sources = EW_PERMUTATION_WEIGHTS | EW_PERMUTATION_FORMS;
    ew_key of_part = (key & (((ew_key)1 << EW_PERMUTATION_FLAG_COUNT) - 1) & ~of_sources) | EW_PERMUTATION_PART;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind) {
        if (!is_of_part(key, kind, part)) continue;
        of_part = ew_permutation_with_count(of_part, kind, EW_ANY_COUNT);
        if (ew_kinds[kind]->weights) of_part |= key & EW_PERMUTATION_WEIGHTS;
        if (ew_kinds[kind]->chain) of_part |= form_of(part);
    }
    return of_part;
}

ew_key ew_permutation_summed(ew_key key)
{
    return (key & (EW_PERMUTATION_OF_TARGET | EW_PERMUTATION_EVALUATIONS)) | EW_PERMUTATION_SUMMED;
}

bool ew_permutation_can_be_split(ew_key key)
{
    /* Of the samples of a pixel, what they do to the target is averaged, not their light. */
    return !(key & (EW_PERMUTATION_SIMPSON | EW_PERMUTATION_DEPTH_MULTISAMPLE));
}

bool ew_permutation_is_split(ew_key key)
{
    int part_count = 0;
    bool has_other_kinds = false;
    for (int part = 0; part < EW_PART_COUNT; ++part)
        part_count += ew_permutation_has_part(key, (ew_part)part);
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        has_other_kinds = has_other_kinds || (ew_permutation_count(key, kind) > 0 && !ew_kinds[kind]->chain);
    if (!ew_permutation_can_be_split(key) || part_count < 2) return false;
    /* Without fog and shadows, one shader does for tori and all that is straight, and for chains. */
    return key & (EW_PERMUTATION_FOG | EW_PERMUTATION_SHADOWS) || ew_permutation_has_part(key, EW_PART_CURVES) ||
           (ew_permutation_has_part(key, EW_PART_BENDS) && has_other_kinds);
}

bool ew_permutation_covers(ew_key key, ew_key other)
{
    /* What a shader may know without harm to sources that do not need it. Reaches are not among that: blocks are longer with
     * them. */
    const ew_key extras = EW_PERMUTATION_WEIGHTS | EW_PERMUTATION_SHARPNESS | EW_PERMUTATION_FORMS;
    const ew_key flags = (((ew_key)1 << EW_PERMUTATION_FLAG_COUNT) - 1) & ~extras;
    if ((key & flags) != (other & flags) || (other & extras & ~key) != 0) return false;
    for (int kind = 0; kind < EW_KIND_COUNT; ++kind)
        if (ew_permutation_count(key, kind) != ew_permutation_count(other, kind) &&
            ew_permutation_count(key, kind) != EW_ANY_COUNT)
            return false;
    return true;
}
