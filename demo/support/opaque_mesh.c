/* The triangles of opaque shapes: see opaque_mesh.h. */
#include "opaque_mesh.h"
#include "vector.h"

#include <stdlib.h>

/* With these, the silhouette is within 0.0006 radii of the sphere's. */
enum { SPHERE_ROWS = 48, SPHERE_COLUMNS = 96 };

/* A plane is nested squares around the point below the eye, the sides of each a quarter of those of the next. So the vertices
 * near the eye are close together, and rounding them to floats does no harm. */
enum { PLANE_SQUARES = 16 };

typedef struct mesh_size {
    size_t vertices;
    size_t triangles;
} mesh_size;

static mesh_size shape_size(const opaque_shape *opaque)
{
    switch (opaque->kind) {
    case OPAQUE_BOX:
        return (mesh_size){6 * 4, 6 * 2};
    case OPAQUE_PLANE:
        return (mesh_size){PLANE_SQUARES * 4, 2 + (PLANE_SQUARES - 1) * 8};
    case OPAQUE_SPHERE:
        return (mesh_size){2 + (SPHERE_ROWS - 1) * SPHERE_COLUMNS, 2 * (SPHERE_ROWS - 1) * SPHERE_COLUMNS};
    }
    return (mesh_size){0, 0};
}

static unsigned add_vertex(opaque_mesh *mesh, const opaque_shape *opaque, const double position[3], const double normal[3])
{
    opaque_vertex *vertex = &mesh->vertices[mesh->vertex_count];
    vector_copy(position, vertex->position);
    vector_copy(normal, vertex->normal);
    vector_copy(opaque->color, vertex->color);
    return (unsigned)mesh->vertex_count++;
}

static void add_triangle(opaque_mesh *mesh, unsigned a, unsigned b, unsigned c)
{
    unsigned *triangle = mesh->triangles[mesh->triangle_count++];
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

static void add_quad(opaque_mesh *mesh, unsigned a, unsigned b, unsigned c, unsigned d)
{
    add_triangle(mesh, a, b, c);
    add_triangle(mesh, a, c, d);
}

static void add_box(opaque_mesh *mesh, const opaque_shape *box)
{
    const double *ends[2] = {box->shape.box.min, box->shape.box.max};
    for (int axis = 0; axis < 3; axis++)
        for (int end = 0; end < 2; end++) {
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            double normal[3] = {0, 0, 0};
            normal[axis] = end ? 1 : -1;
            unsigned corners[4];
            for (int corner = 0; corner < 4; corner++) {
                bool right = corner == 1 || corner == 2, top = corner >= 2;
                double position[3];
                position[axis] = ends[end][axis];
                /* The face at the lower end is seen from the other side, so u and v are swapped. */
                position[end ? u : v] = ends[right][end ? u : v];
                position[end ? v : u] = ends[top][end ? v : u];
                corners[corner] = add_vertex(mesh, box, position, normal);
            }
            add_quad(mesh, corners[0], corners[1], corners[2], corners[3]);
        }
}

static void add_sphere(opaque_mesh *mesh, const opaque_shape *sphere)
{
    unsigned first = (unsigned)mesh->vertex_count, bottom = first + (SPHERE_ROWS - 1) * SPHERE_COLUMNS, top = bottom + 1;
    for (int row = 1; row <= SPHERE_ROWS; row++)
        for (int column = 0; column < (row < SPHERE_ROWS ? SPHERE_COLUMNS : 2); column++) {
            double latitude = (row * 1.0 / SPHERE_ROWS - 0.5) * M_PI, longitude = column * 2.0 / SPHERE_COLUMNS * M_PI;
            double normal[3] = {cos(latitude) * sin(longitude), sin(latitude), cos(latitude) * cos(longitude)}, position[3];
            if (row == SPHERE_ROWS) vector_copy((double[3]){0, column ? 1 : -1, 0}, normal);
            vector_add_scaled(sphere->shape.sphere.center, sphere->shape.sphere.radius, normal, position);
            add_vertex(mesh, sphere, position, normal);
        }
    for (unsigned column = 0; column < SPHERE_COLUMNS; column++) {
        unsigned next = (column + 1) % SPHERE_COLUMNS, last = bottom - SPHERE_COLUMNS;
        add_triangle(mesh, bottom, first + next, first + column);
        for (unsigned row = first; row < last; row += SPHERE_COLUMNS)
            add_quad(mesh, row + column, row + next, row + SPHERE_COLUMNS + next, row + SPHERE_COLUMNS + column);
        add_triangle(mesh, last + column, last + next, top);
    }
}

/* The largest distance from the eye at which something is visible. */
static double sight(const scene_camera *camera)
{
    const double aspect = 4;
    double half_height =
        camera->orthographic ? camera->height / 2 : camera->far_depth * tan(camera->fov_y_degrees * M_PI / 360);
    double depth = fmax(fabs(camera->near_depth), fabs(camera->far_depth));
    return sqrt(depth * depth + half_height * half_height * (1 + aspect * aspect));
}

static void add_plane(opaque_mesh *mesh, const opaque_shape *plane, const scene_camera *camera)
{
    double normal[3], u[3], v[3], from_plane[3], foot[3];
    vector_normalize(plane->shape.plane.normal, normal);
    vector_subtract(camera->eye, plane->shape.plane.point, from_plane);
    double height = vector_dot(from_plane, normal), reach = sight(camera);
    if (fabs(height) >= reach) return;
    vector_add_scaled(camera->eye, -height, normal, foot);
    vector_across(normal, u, v);

    double half_side = sqrt((reach - height) * (reach + height));
    double smallest = fmax(fabs(height), fabs(camera->near_depth));
    for (int square = 0; square < PLANE_SQUARES; square++) {
        unsigned corners = (unsigned)mesh->vertex_count;
        for (int corner = 0; corner < 4; corner++) {
            double position[3];
            vector_add_scaled(foot, corner == 1 || corner == 2 ? half_side : -half_side, u, position);
            vector_add_scaled(position, corner >= 2 ? half_side : -half_side, v, position);
            add_vertex(mesh, plane, position, normal);
        }
        for (unsigned i = 0; square > 0 && i < 4; i++)
            add_quad(mesh, corners - 4 + i, corners - 4 + (i + 1) % 4, corners + (i + 1) % 4, corners + i);
        if (half_side <= smallest || square == PLANE_SQUARES - 1) {
            add_quad(mesh, corners, corners + 1, corners + 2, corners + 3);
            break;
        }
        half_side /= 4;
    }
}

bool opaque_make_mesh(const demo_scene *scene, opaque_mesh *mesh)
{
    mesh_size total = {0, 0};
    for (size_t i = 0; i < scene->opaque_count; i++) {
        mesh_size size = shape_size(&scene->opaque[i]);
        total.vertices += size.vertices;
        total.triangles += size.triangles;
    }
    *mesh = (opaque_mesh){0};
    if (total.vertices == 0) return true;
    mesh->vertices = malloc(total.vertices * sizeof *mesh->vertices);
    mesh->triangles = malloc(total.triangles * sizeof *mesh->triangles);
    if (!mesh->vertices || !mesh->triangles) {
        opaque_free_mesh(mesh);
        return false;
    }
    for (size_t i = 0; i < scene->opaque_count; i++) {
        const opaque_shape *opaque = &scene->opaque[i];
        switch (opaque->kind) {
        case OPAQUE_BOX:
            add_box(mesh, opaque);
            break;
        case OPAQUE_PLANE:
            add_plane(mesh, opaque, &scene->camera);
            break;
        case OPAQUE_SPHERE:
            add_sphere(mesh, opaque);
            break;
        }
    }
    return true;
}

void opaque_free_mesh(opaque_mesh *mesh)
{
    free(mesh->vertices);
    free(mesh->triangles);
    *mesh = (opaque_mesh){0};
}
