/* Random descriptors: see random_desc.h. */
#include "random_desc.h"
#include "random_numbers.h"
#include "vector.h"

#include <stdlib.h>
#include <string.h>

size_t shader_mix_count(const shader_mix *mix, int kind)
{
    return mix->count_of_each + mix->counts[kind];
}

/* A random turn, by the axes of a random orthogonal frame; now and then mirrored. Rows of the view's rotation. */
static void random_axes(uint64_t *random, double axes[3][3])
{
    double seed[2][3];
    for (int i = 0; i < 6; i++)
        seed[i / 3][i % 3] = random_between(random, -1, 1);
    vector_normalize(seed[0], axes[0]);
    vector_cross(axes[0], seed[1], axes[1]);
    vector_normalize(axes[1], axes[1]);
    vector_cross(axes[0], axes[1], axes[2]);
    if (random_chance(random, 0.1))
        for (int i = 0; i < 3; i++)
            axes[2][i] = -axes[2][i];
}

/* A core, a reach, a brightness or a sharpness of the source's own. The world integral asks for a reach, the papers' does not.
 */
static void random_glow(const shader_mix *mix, const random_place *place, double epsilon, source_light *light)
{
    uint64_t *random = place->random;
    double length = place->end - place->start;
    if (mix->field == FIELD_PLAIN) return;
    if (random_chance(random, 0.7))
        light->core = length * (place->extreme ? random_power_of_ten(random, -9, 0) : random_power_of_ten(random, -4, -1));
    if (mix->field == FIELD_REACH && random_chance(random, 0.3)) return;
    double core = light->core > 0 ? light->core : epsilon;
    light->reach = core * (1 + (place->extreme ? random_power_of_ten(random, -9, 9) : random_power_of_ten(random, -2, 3)));
    if (random_chance(random, 0.5)) {
        light->brightness = light->coefficient;
        light->coefficient = 0;
    }
    if (mix->sharp && random_chance(random, 0.8))
        light->sharpness = place->extreme ? 1 + random_power_of_ten(random, -6, 6) : random_between(random, 1, 8);
}

static void random_source(random_desc *desc, const shader_mix *mix, const random_place *place, int k, size_t i)
{
    const source_kind *kind = source_kinds[k];
    char *source = (char *)desc->lists[k] + i * kind->size;
    source_light light;
    kind->make(place, source, mix->weighted ? desc->weights[k][i] : NULL, desc->points[k][i]);
    memcpy(&light, source + kind->light_offset, sizeof light);
    random_glow(mix, place, desc->sources.epsilon, &light);
    memcpy(source + kind->light_offset, &light, sizeof light);
}

static bool random_sources(random_desc *desc, const shader_mix *mix, const random_place *place)
{
    uint64_t *random = place->random;
    double length = place->end - place->start;
    desc->sources = (ew_sources_desc){
        .epsilon = length * (place->extreme ? random_power_of_ten(random, -9, 1) : random_power_of_ten(random, -4, -1)),
    };
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        size_t count = shader_mix_count(mix, k);
        if (!(desc->lists[k] = calloc(MAX_KIND, kind->size))) return false;
        set_source_list(kind, &desc->sources, desc->lists[k]);
        set_source_count(kind, &desc->sources, count);
        for (size_t i = 0; i < count; i++)
            random_source(desc, mix, place, k, i);
    }
    return true;
}

static void random_view(random_place *at, double distance_from_the_origin, double view[16])
{
    random_axes(at->random, at->axes);
    for (int i = 0; i < 3; i++)
        at->eye[i] = distance_from_the_origin * random_between(at->random, -1, 1);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++)
            view[4 * column + row] = at->axes[row][column];
        view[12 + row] = -vector_dot(at->axes[row], at->eye);
        view[4 * row + 3] = 0;
    }
    view[15] = 1;
}

static void random_projection(random_place *at, ew_frame_desc *frame, double aspect)
{
    uint64_t *random = at->random;
    double near = at->start * random_between(random, 0.5, 1), far = at->end * random_between(random, 1, 2),
           *p = frame->projection;
    bool parallel = random_chance(random, 0.2), infinite = !parallel && random_chance(random, 0.3);
    double half = parallel ? (at->end - at->start) * random_between(random, 0.1, 2)
                           : tan(random_between(random, 0.5, at->extreme ? 89 : 60) * 3.14159265358979 / 180);
    memset(p, 0, 16 * sizeof *p);
    p[0] = 1 / (half * aspect);
    p[5] = 1 / half;
    frame->clip_depth = random_chance(random, 0.5) ? EW_CLIP_DEPTH_ZERO_TO_ONE : EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE;
    if (random_chance(random, 0.3)) { /* off-axis */
        p[parallel ? 12 : 8] = random_between(random, -1, 1);
        p[parallel ? 13 : 9] = random_between(random, -1, 1);
    }
    /* Window depth is `nearest` at near and `farthest` at far, reversed or not. */
    double nearest = frame->clip_depth == EW_CLIP_DEPTH_ZERO_TO_ONE ? 0 : -1, farthest = 1;
    if (random_chance(random, 0.5)) {
        farthest = nearest;
        nearest = 1;
    }
    if (parallel) {
        p[10] = (nearest - farthest) / (far - near);
        p[14] = nearest + near * p[10];
        p[15] = 1;
    } else {
        p[11] = -1;
        p[10] = infinite ? -farthest : (nearest * near - farthest * far) / (far - near);
        p[14] = infinite ? near * (nearest - farthest) : near * far * (nearest - farthest) / (far - near);
    }
    at->slope[0] = parallel ? 0 : half * aspect;
    at->slope[1] = parallel ? 0 : half;
    at->size[0] = parallel ? half * aspect : 0;
    at->size[1] = parallel ? half : 0;
}

/* How far the light on surfaces reaches, and what it is multiplied by. */
static void random_surface_light(const random_place *at, bool has_shadows, ew_frame_desc *frame)
{
    uint64_t *random = at->random;
    double length = at->end - at->start;
    frame->light_gain = at->extreme ? random_power_of_ten(random, -6, 6) : random_power_of_ten(random, 0, 2);
    frame->light_reach = length * (at->extreme ? random_power_of_ten(random, -9, 9) : random_power_of_ten(random, -2, 0));
    if (has_shadows) frame->shadow_thickness = frame->light_reach * random_power_of_ten(random, -2, 0);
}

static void random_fog(const random_place *at, ew_fog *fog)
{
    uint64_t *random = at->random;
    double length = at->end - at->start;
    fog->extinction = at->extreme ? random_power_of_ten(random, -9, 12) : random_power_of_ten(random, -2, 1) / length;
    if (random_chance(random, 0.5)) return;
    fog->scale = length * (at->extreme ? random_power_of_ten(random, -9, 9) : random_power_of_ten(random, -1, 1));
    fog->base = at->eye[1] + length * random_between(random, -1, 1);
    for (int i = 0; i < 3; i++)
        fog->up[i] = random_between(random, -1, 1);
}

static void random_medium(const random_place *at, ew_medium *medium)
{
    uint64_t *random = at->random;
    double length = at->end - at->start,
           size = length * (at->extreme ? random_power_of_ten(random, -9, 3) : random_power_of_ten(random, -2, 0));
    medium->shape = random_chance(random, 0.5) ? EW_MEDIUM_BOX : EW_MEDIUM_ELLIPSOID;
    for (int i = 0; i < 3; i++) {
        medium->center[i] = at->eye[i] + length * random_between(random, -1, 1);
        medium->ambient[i] = at->extreme ? random_power_of_ten(random, -6, 4) : random_between(random, 0, 1);
        for (int k = 0; k < 3; k++)
            medium->half_axes[i][k] = size * ((i == k) + random_between(random, -0.2, 0.2));
    }
    medium->extinction = at->extreme ? random_power_of_ten(random, -9, 12) : random_power_of_ten(random, -2, 1) / size;
    medium->albedo = random_between(random, 0, 1);
}

static void random_media(const random_place *at, random_desc *desc)
{
    desc->frame.medium_count = random_index(at->random, EW_MAX_MEDIA + 1);
    desc->frame.media = desc->media;
    for (size_t i = 0; i < desc->frame.medium_count; i++)
        random_medium(at, &desc->media[i]);
}

bool random_desc_make(random_desc *desc, const shader_mix *mix, bool extreme, int width, int height, uint64_t *random)
{
    random_place at = {.random = random, .extreme = extreme};
    ew_frame_desc *frame = &desc->frame;
    *frame = (ew_frame_desc)EW_FRAME_DEFAULTS;
    double scale = extreme ? random_power_of_ten(random, -5, 5) : 1;
    at.start = scale * (extreme ? random_power_of_ten(random, -4, 1) : random_between(random, 0.1, 5));
    at.end = at.start * (1 + (extreme ? random_power_of_ten(random, -3, 4) : random_between(random, 0.5, 10)));
    frame->interval_start = at.start;
    frame->interval_end = at.end;
    random_view(&at, extreme ? scale * random_power_of_ten(random, -2, 5) : 10, frame->view);
    random_projection(&at, frame, (double)width / height);
    frame->decay_alpha = extreme ? random_power_of_ten(random, -3, 3) : 1;
    frame->decay_beta = extreme ? random_power_of_ten(random, -6, 6) : 1;
    if (mix->field == FIELD_WORLD) frame->interval_start = frame->interval_end = 0, frame->decay_alpha = frame->decay_beta = 1;
    frame->core_pixels = !mix->has_core_pixels ? 0 : extreme ? random_between(random, 1e-3, 64) : 1.5;
    frame->exposure = extreme ? random_power_of_ten(random, -6, 6) : 1;
    if (mix->lights_surfaces) random_surface_light(&at, mix->has_shadows, frame);
    if (mix->has_fog) random_fog(&at, &frame->fog);
    if (mix->has_media) random_media(&at, desc);
    frame->integrator = mix->integrator;
    frame->quality = (ew_quality)random_index(random, 3);
    frame->simpson_divisions = 2 * (int)random_power_of_ten(random, 0, 2);
    frame->output = mix->output;
    frame->encoding = mix->encoding;
    frame->dither = mix->dither;
    frame->keep_stencil_test = random_chance(random, 0.2);
    frame->skip_restore = random_chance(random, 0.2);
    frame->viewport_width = width;
    frame->viewport_height = height;
    return random_sources(desc, mix, &at);
}

void random_desc_free(random_desc *desc)
{
    for (int k = 0; k < SOURCE_KIND_COUNT; k++)
        free(desc->lists[k]);
}
