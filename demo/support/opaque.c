/* The opaque shapes of a scene: see opaque.h. */
#include "opaque.h"
#include "camera.h"
#include "message.h"
#include "shader.h"
#include "vector.h"

#include <stdlib.h>

/* ---- Triangles ---------------------------------------------------------------------------------------------------------- */

/* So many that a silhouette is nowhere farther than 0.0006 radii from the sphere. */
enum { SPHERE_ROWS = 48, SPHERE_COLUMNS = 96 };

/* A plane is squares about the point below the eye, each a quarter of the one around it, so that the vertices near the eye
 * are near each other, and rounding to floats does no harm there. */
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
                /* Seen against the axis, u and v change places, and the turn with them. */
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

/* How far from the eye anything can be seen. */
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
    /* Any two directions in the plane, right-handed with its normal. */
    double across[3] = {fabs(normal[0]) < 0.5, fabs(normal[0]) >= 0.5, 0};
    vector_cross(across, normal, u);
    vector_normalize(u, u);
    vector_cross(normal, u, v);

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

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

/* All in view space, to which the vertices are brought in double precision. */
static const char vertex_shader[] = "#version 330 core\n"
                                    "uniform mat4 projection;\n"
                                    "layout(location = 0) in vec3 position;\n"
                                    "layout(location = 1) in vec3 normal;\n"
                                    "layout(location = 2) in vec3 color;\n"
                                    "out vec3 surface_normal;\n"
                                    "out vec3 surface_color;\n"
                                    "out float depth;\n"
                                    "void main() {\n"
                                    "    surface_normal = normal;\n"
                                    "    surface_color = color;\n"
                                    "    depth = -position.z;\n"
                                    "    gl_Position = projection * vec4(position, 1.0);\n"
                                    "}\n";

/* A key light over the camera's left shoulder, a dim sky over a darker ground, and a haze of the background's colour that
 * has swallowed everything where the far plane cuts it off. */
static const char fragment_shader[] = "#version 330 core\n"
                                      "uniform vec3 up;\n"
                                      "uniform vec3 background;\n"
                                      "uniform float near;\n"
                                      "uniform float far;\n"
                                      "in vec3 surface_normal;\n"
                                      "in vec3 surface_color;\n"
                                      "in float depth;\n"
                                      "out vec4 result;\n"
                                      "void main() {\n"
                                      "    vec3 n = normalize(surface_normal) * (gl_FrontFacing ? 1.0 : -1.0);\n"
                                      "    vec3 key = normalize(vec3(-0.5, 0.0, 0.45) + 0.8 * up);\n"
                                      "    float sky = mix(0.05, 0.16, 0.5 + 0.5 * dot(n, up));\n"
                                      "    vec3 lit = surface_color * (sky + 0.45 * max(0.0, dot(n, key)));\n"
                                      "    float haze = clamp((depth - near) / (far - near), 0.0, 1.0);\n"
                                      "    result = vec4(mix(lit, background, haze * (2.0 - haze)), 1.0);\n"
                                      "}\n";

enum { ATTRIBUTE_COUNT = 3, FLOATS_PER_VERTEX = 3 * ATTRIBUTE_COUNT };

/* The mesh's vertices in view space, FLOATS_PER_VERTEX each; NULL where memory is exhausted. */
static float *view_space_vertices(const opaque_mesh *mesh, const scene_camera *camera)
{
    float *result = malloc(mesh->vertex_count * FLOATS_PER_VERTEX * sizeof *result);
    for (size_t i = 0; result && i < mesh->vertex_count; i++) {
        const opaque_vertex *vertex = &mesh->vertices[i];
        double position[3], normal[3];
        camera_to_view(camera, vertex->position, position);
        camera_turn_to_view(camera, vertex->normal, normal);
        for (int k = 0; k < 3; k++) {
            result[i * FLOATS_PER_VERTEX + k] = (float)position[k];
            result[i * FLOATS_PER_VERTEX + 3 + k] = (float)normal[k];
            result[i * FLOATS_PER_VERTEX + 6 + k] = (float)vertex->color[k];
        }
    }
    return result;
}

static void set_uniforms(const gl_functions *gl, GLuint program, const demo_scene *scene, double aspect)
{
    const scene_camera *camera = &scene->camera;
    const double *background = scene->background;
    double projection[16], up[3];
    float projection_floats[16];
    camera_projection(camera, aspect, projection);
    for (int i = 0; i < 16; i++)
        projection_floats[i] = (float)projection[i];
    vector_normalize(camera->up, up);
    camera_turn_to_view(camera, up, up);
    gl->UniformMatrix4fv(gl->GetUniformLocation(program, "projection"), 1, GL_FALSE, projection_floats);
    gl->Uniform3f(gl->GetUniformLocation(program, "up"), (float)up[0], (float)up[1], (float)up[2]);
    gl->Uniform3f(gl->GetUniformLocation(program, "background"), (float)background[0], (float)background[1],
                  (float)background[2]);
    gl->Uniform1f(gl->GetUniformLocation(program, "near"), (float)camera->near_depth);
    gl->Uniform1f(gl->GetUniformLocation(program, "far"), (float)camera->far_depth);
}

static void draw_mesh(const gl_functions *gl, const opaque_mesh *mesh, const float *vertices)
{
    GLuint vertex_array, buffers[2];
    gl->GenVertexArrays(1, &vertex_array);
    gl->GenBuffers(2, buffers);
    gl->BindVertexArray(vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->vertex_count * FLOATS_PER_VERTEX * sizeof *vertices), vertices,
                   GL_STATIC_DRAW);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangle_count * sizeof *mesh->triangles), mesh->triangles,
                   GL_STATIC_DRAW);
    for (GLuint i = 0; i < ATTRIBUTE_COUNT; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, FLOATS_PER_VERTEX * sizeof *vertices,
                                (const void *)(i * 3 * sizeof *vertices));
    }
    gl->Enable(GL_DEPTH_TEST);
    gl->DrawElements(GL_TRIANGLES, (GLsizei)(3 * mesh->triangle_count), GL_UNSIGNED_INT, NULL);
    gl->Disable(GL_DEPTH_TEST);
    gl->BindVertexArray(0);
    gl->DeleteVertexArrays(1, &vertex_array);
    gl->DeleteBuffers(2, buffers);
}

bool opaque_draw(const gl_functions *gl, const demo_scene *scene, int width, int height, char *message, size_t size)
{
    const float background[4] = {(float)scene->background[0], (float)scene->background[1], (float)scene->background[2], 1};
    const float farthest = 1;
    gl->Viewport(0, 0, width, height);
    gl->ClearBufferfv(GL_COLOR, 0, background);
    gl->ClearBufferfv(GL_DEPTH, 0, &farthest);

    opaque_mesh mesh;
    bool ok = opaque_make_mesh(scene, &mesh);
    float *vertices = ok && mesh.triangle_count > 0 ? view_space_vertices(&mesh, &scene->camera) : NULL;
    if (!ok || (mesh.triangle_count > 0 && !vertices)) {
        message_write(message, size, "opaque: does not fit into memory; use fewer shapes");
        ok = false;
    } else if (vertices) {
        GLuint program = shader_link(gl, vertex_shader, fragment_shader, "the opaque shapes'", message, size);
        ok = program != 0;
        if (ok) {
            gl->UseProgram(program);
            set_uniforms(gl, program, scene, (double)width / height);
            draw_mesh(gl, &mesh, vertices);
            gl->UseProgram(0);
            gl->DeleteProgram(program);
        }
    }
    free(vertices);
    opaque_free_mesh(&mesh);
    return ok;
}
