/* Soft billboards: see peer_billboards.h. */
#include "peer_billboards.h"
#include "peer_text.h"

#include <string.h>

static void add_billboard(mesh_data *data, const outline *shape, const outline_place *place, size_t profile, double level)
{
    mesh_vertex corners[4];
    for (int i = 0; i < 4; i++) {
        mesh_vertex *corner = &corners[i];
        *corner = (mesh_vertex){.level = (float)(shape->light.brightness * place->weight * level),
                                .row = (float)profile,
                                .offset = {i & 1 ? 1.0f : -1.0f, i & 2 ? 1.0f : -1.0f},
                                .reach = (float)shape->light.reach};
        memcpy(corner->position, place->position, sizeof corner->position);
    }
    mesh_data_add_quad(data, corners);
}

static void add_orb(mesh_data *data, const outline *shape)
{
    const outline_place place = outline_at(shape, 0);
    float *profile = mesh_data_add_profile(data);
    if (!profile) return;
    profile_of_ribbon(&shape->light, profile);
    add_billboard(data, shape, &place, data->profile_count - 1, 1);
}

/* Each billboard counts by the length that it stands for. */
static void add_source(mesh_data *data, const outline *shape, int count)
{
    if (!(shape->length > 0)) {
        add_orb(data, shape);
        return;
    }
    size_t all = shape->spans * outline_parts(shape, count), along = data->profile_count, end = along + 1;
    double spacing = shape->length / (double)all;
    if (!mesh_data_add_profile(data) || !mesh_data_add_profile(data)) return;
    profiles_of_billboards(&shape->light, spacing, data->profiles + along * PROFILE_TEXELS,
                           data->profiles + end * PROFILE_TEXELS);
    for (size_t i = 0; i < all; i++) {
        const outline_place place = outline_at(shape, ((double)i + 0.5) / (double)all);
        add_billboard(data, shape, &place, along, place.speed / shape->length);
    }
    for (int i = 0; i < 2 && !shape->is_closed; i++) {
        const outline_place place = outline_at(shape, i);
        add_billboard(data, shape, &place, end, 1);
    }
}

const mesh_style peer_billboards_style = {"billboards", peer_glsl_peer_billboards_glsl, add_source};
