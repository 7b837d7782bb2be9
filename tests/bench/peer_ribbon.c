/* Ribbons: see peer_ribbon.h. */
#include "peer_ribbon.h"
#include "peer_text.h"
#include "vector.h"

#include <math.h>
#include <string.h>

/* How much wider than straight a corner may be. */
#define LARGEST_MITRE 2.0

/* How near to a bend's centre the inner edge may come, since the next bend may be sharper. */
#define INNER_SHARE 0.8

/* A place where two sections meet. */
typedef struct ribbon_joint {
    outline_place place;
    double width;     /* of the mitre, relative to a straight joint's */
    double offset[2]; /* of the left and the right edge, in reaches: -1 and 1, unless the ribbon would fold */
} ribbon_joint;

/* At a corner, the tangent is the mean of those on both sides. */
static void mitre(const outline *shape, size_t i, size_t all, ribbon_joint *joint)
{
    const double close = 1e-6;
    const outline_place before = outline_at(shape, (double)(i == 0 ? all : i) / (double)all - close / (double)all);
    double mean[3], tangent[3];
    for (int k = 0; k < 3; k++)
        mean[k] = 0.5 * ((double)joint->place.tangent[k] + (double)before.tangent[k]);
    joint->width = fmin(LARGEST_MITRE, 1 / fmax(vector_length(mean), 1e-6));
    vector_normalize(mean, tangent);
    for (int k = 0; k < 3; k++)
        joint->place.tangent[k] = (float)tangent[k];
}

/* The way between two places as the eye sees it: without what goes towards the eye. */
static double seen_way(const outline_place *from, const outline_place *to, const double to_eye[3], double direction[3])
{
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = (double)to->position[k] - (double)from->position[k];
    vector_add_scaled(way, -vector_dot(way, to_eye), to_eye, way);
    vector_normalize(way, direction);
    return vector_length(way);
}

/* Where the ribbon bends, as it is seen, it is no wider on the inside than the bend's radius, or it would fold. */
static void keep_from_folding(const outline *shape, size_t i, size_t all, ribbon_joint *joint)
{
    const outline_place before = outline_at(shape, (double)(i == 0 ? all - 1 : i - 1) / (double)all);
    const outline_place after = outline_at(shape, (double)(i == all ? 1 : i + 1) / (double)all);
    double from_eye[3], to_eye[3], tangent[3], side[3], first[3], second[3], turn[3];
    for (int k = 0; k < 3; k++) {
        from_eye[k] = -(double)joint->place.position[k];
        tangent[k] = (double)joint->place.tangent[k];
    }
    vector_normalize(from_eye, to_eye);
    vector_cross(tangent, to_eye, side);
    vector_normalize(side, side);
    double length = 0.5 * (seen_way(&before, &joint->place, to_eye, first) + seen_way(&joint->place, &after, to_eye, second));
    vector_subtract(second, first, turn);
    double bend = vector_dot(turn, side) / fmax(length, 1e-9), most = INNER_SHARE / fmax(fabs(bend) * shape->light.reach, 1e-9);
    joint->offset[bend > 0] *= fmin(1, most);
}

static ribbon_joint joint_at(const outline *shape, size_t i, size_t all)
{
    bool is_end = (i == 0 || i == all) && !shape->is_closed;
    ribbon_joint joint = {outline_at(shape, i == all && shape->is_closed ? 0 : (double)i / (double)all), 1, {-1, 1}};
    if (is_end) return joint;
    mitre(shape, i, all, &joint);
    keep_from_folding(shape, i, all, &joint);
    return joint;
}

/* Adds the part of the ribbon between two joints, which are at `beyond` along it: 0, or 1 and -1 for the tips of half discs. */
static void add_section(mesh_data *data, const outline *shape, const ribbon_joint *joints, const float beyond[2])
{
    mesh_vertex corners[4];
    for (int i = 0; i < 4; i++) {
        const ribbon_joint *joint = &joints[i >> 1];
        mesh_vertex *corner = &corners[i];
        *corner = (mesh_vertex){.level = (float)(shape->light.brightness * joint->place.weight),
                                .row = (float)(data->profile_count - 1),
                                .offset = {(float)joint->offset[i & 1], beyond[i >> 1]},
                                .reach = (float)(shape->light.reach * joint->width)};
        memcpy(corner->position, joint->place.position, sizeof corner->position);
        memcpy(corner->tangent, joint->place.tangent, sizeof corner->tangent);
    }
    mesh_data_add_quad(data, corners);
}

static void add_source(mesh_data *data, const outline *shape, int count)
{
    static const float along[2] = {0, 0}, before[2] = {-1, 0}, after[2] = {0, 1};
    size_t all = shape->spans * outline_parts(shape, count);
    float *profile = mesh_data_add_profile(data);
    if (!profile) return;
    profile_of_ribbon(&shape->light, profile);
    ribbon_joint joints[2] = {joint_at(shape, 0, all), joint_at(shape, 0, all)};
    if (!shape->is_closed) add_section(data, shape, joints, before);
    for (size_t i = 1; i <= all && !shape->is_point; i++) {
        joints[0] = joints[1];
        joints[1] = joint_at(shape, i, all);
        add_section(data, shape, joints, along);
    }
    joints[0] = joints[1];
    if (!shape->is_closed) add_section(data, shape, joints, after);
}

const mesh_style peer_ribbon_style = {"ribbon", peer_glsl_peer_ribbon_glsl, add_source};
