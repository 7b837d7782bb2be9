/* The court: see court.h. */
#include "court.h"
#include "vector.h"

const double court_orb[3] = {0, 3.3, 0};
const double court_emitters[2][3] = {{-6.4, 2.05, 2.2}, {5.8, 2.05, 0.6}};
const double court_target[3] = {-8.12, 2.9, -1.3};
const double court_shield[3] = {-8.6, 3.65, -1.5};
const double court_spiral_base[3] = {7.0, 0.45, 4.9};

static const double stone[3] = {0.26, 0.27, 0.30};
static const double dark_stone[3] = {0.10, 0.105, 0.12};
static const double metal[3] = {0.10, 0.105, 0.12};

typedef struct shape_list {
    opaque_shape *shapes;
    size_t count;
} shape_list;

static opaque_shape *add(shape_list *list, opaque_kind kind, const double color[3])
{
    opaque_shape *shape = &list->shapes[list->count++];
    *shape = (opaque_shape){.kind = kind};
    vector_copy(color, shape->color);
    return shape;
}

/* A box. The middle of its bottom is at (x, bottom, z). */
static void add_block(shape_list *list, double x, double bottom, double z, double half_side, double height,
                      const double color[3])
{
    opaque_shape *box = add(list, OPAQUE_BOX, color);
    vector_copy((double[3]){x - half_side, bottom, z - half_side}, box->shape.box.min);
    vector_copy((double[3]){x + half_side, bottom + height, z + half_side}, box->shape.box.max);
}

static void add_ball(shape_list *list, double x, double y, double z, double radius, const double color[3])
{
    opaque_shape *sphere = add(list, OPAQUE_SPHERE, color);
    vector_copy((double[3]){x, y, z}, sphere->shape.sphere.center);
    sphere->shape.sphere.radius = radius;
}

static void add_pillar(shape_list *list, double x, double z, double height, bool broken)
{
    add_block(list, x, 0, z, 0.75, 0.4, stone);
    add_block(list, x, 0.4, z, 0.48, height - 0.4, stone);
    if (!broken) add_block(list, x, height, z, 0.72, 0.45, stone);
}

size_t court_make_shapes(opaque_shape shapes[COURT_MAX_SHAPES])
{
    static const struct {
        double x, z, height;
        bool broken;
    } pillars[] = {{-8.6, -1.5, 6.4, false}, {-5.6, -7.2, 6.4, false}, {0.4, -9.4, 6.4, false}, {6.3, -6.9, 6.4, false},
                   {9.4, -1.2, 3.1, true},   {-3.4, 4.1, 1.5, true},   {7.0, 4.9, 6.4, false},  {-9.3, 5.2, 4.3, true}};
    static const double far_pillars[][2] = {{-19, -9}, {-14, -17}, {-6.5, -21}, {2, -22}, {10, -19.5}, {17, -14}, {21, -6}};
    static const double balls[][4] = {{2.9, 0.55, 4.2, 0.55}, {-1.3, 0.38, 5.6, 0.38}, {-6.2, 0.7, -3.2, 0.7},
                                      {4.4, 0.9, -3.9, 0.9},  {7.9, 0.45, 4.6, 0.45},  {-9.3, 4.75, 5.2, 0.45},
                                      {-3.4, 1.95, 4.1, 0.45}};
    shape_list list = {shapes, 0};
    add_block(&list, 0, -1, 0, COURT_FLOOR_HALF_SIDE, 1, dark_stone);
    for (int step = 0; step < 4; step++)
        add_block(&list, 0, 0.24 * step, 0, 3.3 - 0.6 * step, 0.24, stone);
    for (size_t i = 0; i < sizeof pillars / sizeof *pillars; i++)
        add_pillar(&list, pillars[i].x, pillars[i].z, pillars[i].height, pillars[i].broken);
    for (size_t i = 0; i < sizeof far_pillars / sizeof *far_pillars; i++)
        add_block(&list, far_pillars[i][0], 0, far_pillars[i][1], 0.85, 9.5, dark_stone);
    for (size_t i = 0; i < sizeof balls / sizeof *balls; i++)
        add_ball(&list, balls[i][0], balls[i][1], balls[i][2], balls[i][3], stone);
    for (int i = 0; i < 2; i++) {
        const double *emitter = court_emitters[i];
        add_block(&list, emitter[0], 0, emitter[2], 0.55, 0.3, metal);
        add_block(&list, emitter[0], 0.3, emitter[2], 0.28, emitter[1] - 0.75, metal);
        add_ball(&list, emitter[0], emitter[1], emitter[2], 0.34, metal);
    }
    return list.count;
}
