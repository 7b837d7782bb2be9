/* Opaque shapes in the energy's light: see lit_opaque.h. */
#include "lit_opaque.h"
#include "camera.h"
#include "court.h"
#include "demo_shaders.h"
#include "energy_lights.h"
#include "message.h"
#include "opaque.h"
#include "shader.h"
#include "vector.h"

#include <stdlib.h>

static const double to_moon[3] = {-0.46, 0.76, 0.46};

struct lit_opaque {
    const gl_functions *gl;
    GLuint program;
    opaque_buffers buffers;
    GLsizei shape_count;
    float centers[COURT_MAX_SHAPES][4]; /* w: the rounding radius */
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

static bool make_buffers(lit_opaque *lit, const demo_scene *scene)
{
    opaque_mesh mesh;
    if (!opaque_make_mesh(scene, &mesh)) return false;
    bool ok = opaque_upload(lit->gl, &mesh, NULL, &lit->buffers);
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
    if (!lit || !make_buffers(lit, scene)) {
        message_write(message, size, "the court does not fit into memory; close other programs");
        lit_opaque_destroy(lit);
        return NULL;
    }
    lit->program = shader_link(gl, demo_shader_lit_opaque_vert, demo_shader_lit_opaque_frag, "the court's", message, size);
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

static void set_lights(const lit_opaque *lit, const ew_sources_desc *sources)
{
    const gl_functions *gl = lit->gl;
    energy_light lights[ENERGY_MAX_LIGHTS];
    GLsizei count = (GLsizei)energy_make_lights(sources, lights);
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

static void set_camera(const lit_opaque *lit, const lit_opaque_view *how)
{
    const scene_camera *camera = &how->scene->camera;
    const gl_functions *gl = lit->gl;
    double view[16], projection[16], eye[3];
    float view_projection[16];
    camera_view(camera, view);
    camera_projection(camera, (double)how->width / how->height, projection);
    vector_copy(camera->eye, eye);
    if (how->is_mirrored) {
        for (int row = 0; row < 4; row++)
            view[4 + row] = -view[4 + row];
        eye[1] = -eye[1];
    }
    multiply(projection, view, view_projection);
    gl->UniformMatrix4fv(gl->GetUniformLocation(lit->program, "view_projection"), 1, GL_FALSE, view_projection);
    set_vector(lit, "eye", eye);
}

static void set_uniforms(const lit_opaque *lit, const lit_opaque_view *how)
{
    const demo_scene *scene = how->scene;
    const gl_functions *gl = lit->gl;
    double moon[3];
    set_camera(lit, how);
    vector_normalize(to_moon, moon);
    set_vector(lit, "to_moon", moon);
    set_vector(lit, "background", scene->background);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "shape_count"), lit->shape_count);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_center"), lit->shape_count, lit->centers[0]);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_extent"), lit->shape_count, lit->extents[0]);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "is_mirrored"), how->is_mirrored);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "reflects"), how->reflection != 0);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "reflection"), 0);
    gl->Uniform2f(gl->GetUniformLocation(lit->program, "pixel"), 1.0f / (float)how->width, 1.0f / (float)how->height);
    set_lights(lit, &scene->sources);
}

void lit_opaque_draw(const lit_opaque *lit, const lit_opaque_view *view)
{
    const gl_functions *gl = lit->gl;
    gl->Viewport(0, 0, view->width, view->height);
    opaque_clear(gl, view->scene);
    gl->UseProgram(lit->program);
    set_uniforms(lit, view);
    gl->BindTexture(GL_TEXTURE_2D, view->reflection);
    /* A mirror image turns the triangles the other way round. */
    if (!view->is_mirrored) gl->Enable(GL_CULL_FACE);
    opaque_draw_buffers(gl, &lit->buffers);
    gl->Disable(GL_CULL_FACE);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->UseProgram(0);
}

void lit_opaque_destroy(lit_opaque *lit)
{
    if (!lit) return;
    lit->gl->DeleteProgram(lit->program);
    opaque_delete_buffers(lit->gl, &lit->buffers);
    free(lit);
}
