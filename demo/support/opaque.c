/* The opaque shapes of a scene in GL: see opaque.h. */
#include "opaque.h"
#include "camera.h"
#include "message.h"
#include "shader.h"
#include "vector.h"

#include <stdlib.h>

/* ---- Buffers ------------------------------------------------------------------------------------------------------------- */

typedef struct packed_vertex {
    float position[3];
    float normal[3];
    float color[3];
} packed_vertex;

enum { ATTRIBUTE_COUNT = 3 };

static void pack_vertex(const opaque_vertex *vertex, const scene_camera *camera, packed_vertex *packed)
{
    double position[3], normal[3];
    vector_copy(vertex->position, position);
    vector_copy(vertex->normal, normal);
    if (camera) {
        camera_to_view(camera, vertex->position, position);
        camera_turn_to_view(camera, vertex->normal, normal);
    }
    for (int i = 0; i < 3; i++) {
        packed->position[i] = (float)position[i];
        packed->normal[i] = (float)normal[i];
        packed->color[i] = (float)vertex->color[i];
    }
}

bool opaque_upload(const gl_functions *gl, const opaque_mesh *mesh, const scene_camera *camera, opaque_buffers *buffers)
{
    packed_vertex *vertices = malloc(mesh->vertex_count * sizeof *vertices);
    if (!vertices) return false;
    for (size_t i = 0; i < mesh->vertex_count; i++)
        pack_vertex(&mesh->vertices[i], camera, &vertices[i]);
    buffers->index_count = (GLsizei)(3 * mesh->triangle_count);
    gl->GenVertexArrays(1, &buffers->vertex_array);
    gl->GenBuffers(2, buffers->buffers);
    gl->BindVertexArray(buffers->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffers->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->vertex_count * sizeof *vertices), vertices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers->buffers[1]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangle_count * sizeof *mesh->triangles), mesh->triangles,
                   GL_STATIC_DRAW);
    for (GLuint i = 0; i < ATTRIBUTE_COUNT; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, sizeof *vertices, (const void *)(i * sizeof vertices->position));
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(vertices);
    return true;
}

void opaque_draw_buffers(const gl_functions *gl, const opaque_buffers *buffers)
{
    gl->BindVertexArray(buffers->vertex_array);
    gl->Enable(GL_DEPTH_TEST);
    gl->DrawElements(GL_TRIANGLES, buffers->index_count, GL_UNSIGNED_INT, NULL);
    gl->Disable(GL_DEPTH_TEST);
    gl->BindVertexArray(0);
}

void opaque_delete_buffers(const gl_functions *gl, opaque_buffers *buffers)
{
    gl->DeleteVertexArrays(1, &buffers->vertex_array);
    gl->DeleteBuffers(2, buffers->buffers);
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------- */

void opaque_clear(const gl_functions *gl, const demo_scene *scene)
{
    const float background[4] = {(float)scene->background[0], (float)scene->background[1], (float)scene->background[2], 1};
    const float farthest = 1;
    gl->ClearBufferfv(GL_COLOR, 0, background);
    gl->ClearBufferfv(GL_DEPTH, 0, &farthest);
}

/* Vertices arrive in view space: they are transformed in double precision on the CPU. */
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

/* A key light over the camera's left shoulder, and a dim sky over a darker ground. Haze of the background's colour hides
 * everything at the far plane, so that shapes do not end there visibly. */
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

static bool draw_mesh(const gl_functions *gl, const demo_scene *scene, const opaque_mesh *mesh, double aspect, char *message,
                      size_t size)
{
    opaque_buffers buffers;
    if (!opaque_upload(gl, mesh, &scene->camera, &buffers)) {
        message_write(message, size, "opaque: does not fit into memory; use fewer shapes");
        return false;
    }
    GLuint program = shader_link(gl, vertex_shader, fragment_shader, "the opaque shapes'", message, size);
    if (program) {
        gl->UseProgram(program);
        set_uniforms(gl, program, scene, aspect);
        opaque_draw_buffers(gl, &buffers);
        gl->UseProgram(0);
        gl->DeleteProgram(program);
    }
    opaque_delete_buffers(gl, &buffers);
    return program != 0;
}

bool opaque_draw(const gl_functions *gl, const demo_scene *scene, int width, int height, char *message, size_t size)
{
    gl->Viewport(0, 0, width, height);
    opaque_clear(gl, scene);
    opaque_mesh mesh;
    if (!opaque_make_mesh(scene, &mesh)) {
        message_write(message, size, "opaque: does not fit into memory; use fewer shapes");
        return false;
    }
    bool ok = mesh.triangle_count == 0 || draw_mesh(gl, scene, &mesh, (double)width / height, message, size);
    opaque_free_mesh(&mesh);
    return ok;
}
