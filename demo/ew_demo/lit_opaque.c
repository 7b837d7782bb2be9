/* Opaque shapes in the energy's light: see lit_opaque.h. */
#include "lit_opaque.h"
#include "camera.h"
#include "court.h"
#include "energy_lights.h"
#include "message.h"
#include "opaque.h"
#include "shader.h"
#include "shader_text.h"
#include "vector.h"

#include <stdlib.h>

enum { FLOATS_PER_VERTEX = 9 };

static const double to_moon[3] = {-0.46, 0.76, 0.46};

struct lit_opaque {
    const gl_functions *gl;
    GLuint program;
    GLuint vertex_array;
    GLuint buffers[2];
    GLsizei index_count;
    GLsizei shape_count;
    float centers[COURT_MAX_SHAPES][4]; /* and a rounding radius */
    float extents[COURT_MAX_SHAPES][4];
};

static void describe_shape(const opaque_shape *shape, float center[4], float extent[4])
{
    bool is_box = shape->kind == OPAQUE_BOX;
    for (int i = 0; i < 3; i++) {
        double min = shape->shape.box.min[i], max = shape->shape.box.max[i];
        center[i] = (float)(is_box ? (min + max) / 2 : shape->shape.sphere.center[i]);
        extent[i] = (float)(is_box ? (max - min) / 2 : 0);
    }
    center[3] = (float)(is_box ? 0 : shape->shape.sphere.radius);
    extent[3] = 0;
}

static void upload_mesh(lit_opaque *lit, const opaque_mesh *mesh, const float *vertices)
{
    const gl_functions *gl = lit->gl;
    const GLsizei stride = FLOATS_PER_VERTEX * sizeof *vertices;
    lit->index_count = (GLsizei)(3 * mesh->triangle_count);
    gl->GenVertexArrays(1, &lit->vertex_array);
    gl->GenBuffers(2, lit->buffers);
    gl->BindVertexArray(lit->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, lit->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)mesh->vertex_count * stride, vertices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, lit->buffers[1]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangle_count * sizeof *mesh->triangles), mesh->triangles,
                   GL_STATIC_DRAW);
    for (GLuint i = 0; i < 3; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, stride, (const void *)(i * 3 * sizeof *vertices));
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
}

static bool make_mesh(lit_opaque *lit, const demo_scene *scene)
{
    opaque_mesh mesh;
    if (!opaque_make_mesh(scene, &mesh)) return false;
    float *vertices = malloc(mesh.vertex_count * FLOATS_PER_VERTEX * sizeof *vertices);
    for (size_t i = 0; vertices && i < mesh.vertex_count; i++)
        for (int j = 0; j < 3; j++) {
            float *vertex = vertices + i * FLOATS_PER_VERTEX;
            vertex[j] = (float)mesh.vertices[i].position[j];
            vertex[3 + j] = (float)mesh.vertices[i].normal[j];
            vertex[6 + j] = (float)mesh.vertices[i].color[j];
        }
    bool ok = vertices != NULL;
    if (ok) upload_mesh(lit, &mesh, vertices);
    free(vertices);
    opaque_free_mesh(&mesh);
    return ok;
}

lit_opaque *lit_opaque_create(const gl_functions *gl, const demo_scene *scene, char *message, size_t size)
{
    lit_opaque *lit = calloc(1, sizeof *lit);
    if (lit) {
        lit->gl = gl;
        lit->shape_count = (GLsizei)scene->opaque_count;
        for (size_t i = 0; i < scene->opaque_count; i++)
            describe_shape(&scene->opaque[i], lit->centers[i], lit->extents[i]);
    }
    if (!lit || !make_mesh(lit, scene)) {
        message_write(message, size, "the court does not fit into memory; close other programs");
        lit_opaque_destroy(lit);
        return NULL;
    }
    lit->program = shader_link(gl, shader_text_lit_opaque_vert, shader_text_lit_opaque_frag, "the court's", message, size);
    if (lit->program) return lit;
    lit_opaque_destroy(lit);
    return NULL;
}

/* Column-major: result = a b. */
static void multiply(const double a[16], const double b[16], float result[16])
{
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            double sum = 0;
            for (int i = 0; i < 4; i++)
                sum += a[4 * i + row] * b[4 * column + i];
            result[4 * column + row] = (float)sum;
        }
}

static void set_vector(const lit_opaque *lit, const char *name, const double vector[3])
{
    const gl_functions *gl = lit->gl;
    gl->Uniform3f(gl->GetUniformLocation(lit->program, name), (float)vector[0], (float)vector[1], (float)vector[2]);
}

static void set_uniforms(const lit_opaque *lit, const lit_opaque_view *how)
{
    const demo_scene *scene = how->scene;
    const gl_functions *gl = lit->gl;
    double view[16], projection[16], moon[3], eye[3];
    float view_projection[16];
    camera_view(&scene->camera, view);
    camera_projection(&scene->camera, (double)how->width / how->height, projection);
    vector_copy(scene->camera.eye, eye);
    if (how->is_mirrored) {
        for (int row = 0; row < 4; row++)
            view[4 + row] = -view[4 + row];
        eye[1] = -eye[1];
    }
    multiply(projection, view, view_projection);
    gl->UniformMatrix4fv(gl->GetUniformLocation(lit->program, "view_projection"), 1, GL_FALSE, view_projection);
    vector_normalize(to_moon, moon);
    set_vector(lit, "to_moon", moon);
    set_vector(lit, "eye", eye);
    set_vector(lit, "background", scene->background);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "shape_count"), lit->shape_count);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_center"), lit->shape_count, lit->centers[0]);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_extent"), lit->shape_count, lit->extents[0]);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "is_mirrored"), how->is_mirrored);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "reflects"), how->reflection != 0);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "reflection"), 0);
    gl->Uniform2f(gl->GetUniformLocation(lit->program, "pixel"), 1.0f / (float)how->width, 1.0f / (float)how->height);
    energy_light lights[ENERGY_MAX_LIGHTS];
    GLsizei count = (GLsizei)energy_make_lights(&scene->sources, lights);
    float positions[ENERGY_MAX_LIGHTS][4], colors[ENERGY_MAX_LIGHTS][4];
    for (GLsizei i = 0; i < count; i++)
        for (int j = 0; j < 4; j++) {
            positions[i][j] = (float)(j < 3 ? lights[i].position[j] : lights[i].radius);
            colors[i][j] = (float)(j < 3 ? lights[i].color[j] : 0);
        }
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "light_count"), count);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "light_position"), count, positions[0]);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "light_color"), count, colors[0]);
}

void lit_opaque_draw(const lit_opaque *lit, const lit_opaque_view *view)
{
    const gl_functions *gl = lit->gl;
    const double *background = view->scene->background;
    const float color[4] = {(float)background[0], (float)background[1], (float)background[2], 1}, farthest = 1;
    gl->Viewport(0, 0, view->width, view->height);
    gl->ClearBufferfv(GL_COLOR, 0, color);
    gl->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl->UseProgram(lit->program);
    set_uniforms(lit, view);
    gl->BindTexture(GL_TEXTURE_2D, view->reflection);
    gl->BindVertexArray(lit->vertex_array);
    gl->Enable(GL_DEPTH_TEST);
    /* A mirror turns the triangles round. */
    if (!view->is_mirrored) gl->Enable(GL_CULL_FACE);
    gl->DrawElements(GL_TRIANGLES, lit->index_count, GL_UNSIGNED_INT, NULL);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_DEPTH_TEST);
    gl->BindVertexArray(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->UseProgram(0);
}

void lit_opaque_destroy(lit_opaque *lit)
{
    if (!lit) return;
    lit->gl->DeleteProgram(lit->program);
    lit->gl->DeleteVertexArrays(1, &lit->vertex_array);
    lit->gl->DeleteBuffers(2, lit->buffers);
    free(lit);
}
