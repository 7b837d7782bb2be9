/* Opaque shapes in the energy's light: see lit_opaque.h. */
#include "lit_opaque.h"
#include "camera.h"
#include "camera_ray.h"
#include "court.h"
#include "court_layers.h"
#include "demo_shaders.h"
#include "message.h"
#include "opaque.h"
#include "shader.h"
#include "vector.h"

#include <stdlib.h>

static const double to_moon[3] = {-0.46, 0.76, 0.46};

struct lit_opaque {
    const gl_functions *gl;
    GLuint program, compose_program;
    GLuint no_vertices;
    court_layers layers[2]; /* of the picture, and of its reflection */
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
    gl->GenVertexArrays(1, &lit->no_vertices);
    lit->program = shader_link(gl, demo_shader_lit_opaque_vert, demo_shader_lit_opaque_frag, "the court's", message, size);
    if (lit->program)
        lit->compose_program = shader_link(gl, demo_shader_screen_vert, demo_shader_compose_frag, "the court's", message, size);
    if (lit->compose_program) return lit;
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

static void set_vector(const gl_functions *gl, GLuint program, const char *name, const double vector[3])
{
    gl->Uniform3f(gl->GetUniformLocation(program, name), (float)vector[0], (float)vector[1], (float)vector[2]);
}

void lit_opaque_mirror(double view[16])
{
    for (int row = 0; row < 4; row++)
        view[4 + row] = -view[4 + row];
}

static void set_camera(const lit_opaque *lit, const lit_opaque_view *how)
{
    const scene_camera *camera = &how->scene->camera;
    const gl_functions *gl = lit->gl;
    double view[16], projection[16], eye[3];
    float view_projection[16];
    camera_view(camera, view);
    camera_projection(camera, (double)how->settings->width / how->settings->height, projection);
    vector_copy(camera->eye, eye);
    if (how->is_mirrored) {
        lit_opaque_mirror(view);
        eye[1] = -eye[1];
    }
    multiply(projection, view, view_projection);
    gl->UniformMatrix4fv(gl->GetUniformLocation(lit->program, "view_projection"), 1, GL_FALSE, view_projection);
    set_vector(gl, lit->program, "eye", eye);
}

static void set_uniforms(const lit_opaque *lit, const lit_opaque_view *how)
{
    const gl_functions *gl = lit->gl;
    double moon[3];
    set_camera(lit, how);
    vector_normalize(to_moon, moon);
    set_vector(lit->gl, lit->program, "to_moon", moon);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "shape_count"), lit->shape_count);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_center"), lit->shape_count, lit->centers[0]);
    gl->Uniform4fv(gl->GetUniformLocation(lit->program, "shape_extent"), lit->shape_count, lit->extents[0]);
    gl->Uniform1i(gl->GetUniformLocation(lit->program, "is_mirrored"), how->is_mirrored);
}

static void draw_layers(const lit_opaque *lit, const court_layers *layers, const lit_opaque_view *view)
{
    const gl_functions *gl = lit->gl;
    court_layers_begin(gl, layers);
    gl->UseProgram(lit->program);
    set_uniforms(lit, view);
    /* A mirror image turns the triangles the other way round. */
    if (!view->is_mirrored) gl->Enable(GL_CULL_FACE);
    opaque_draw_buffers(gl, &lit->buffers);
    gl->Disable(GL_CULL_FACE);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

static void bind_texture(const lit_opaque *lit, const char *sampler, GLint unit, GLuint texture)
{
    const gl_functions *gl = lit->gl;
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->Uniform1i(gl->GetUniformLocation(lit->compose_program, sampler), unit);
}

/* The stone and what it mirrors are fogged together, on the way from the floor to the eye: in the mirror itself there is no
 * fog. */
static void set_fog(const lit_opaque *lit, const lit_opaque_view *view)
{
    const gl_functions *gl = lit->gl;
    const GLuint program = lit->compose_program;
    const scene_camera *camera = &view->scene->camera;
    const ew_fog *fog = &view->scene->fog;
    const double aspect = (double)view->settings->width / view->settings->height;
    double ray[3], right[3], up[3];
    vector_copy(camera_ray_at(camera, aspect, (double[]){0, 0}).direction, ray);
    vector_subtract(camera_ray_at(camera, aspect, (double[]){1, 0}).direction, ray, right);
    vector_subtract(camera_ray_at(camera, aspect, (double[]){0, 1}).direction, ray, up);
    set_vector(gl, program, "ray", ray);
    set_vector(gl, program, "ray_right", right);
    set_vector(gl, program, "ray_up", up);
    set_vector(gl, program, "eye", camera->eye);
    gl->Uniform2f(gl->GetUniformLocation(program, "depth_range"), (float)camera->near_depth, (float)camera->far_depth);
    gl->Uniform1f(gl->GetUniformLocation(program, "fog_extinction"), view->is_mirrored ? 0 : (float)fog->extinction);
    gl->Uniform1f(gl->GetUniformLocation(program, "fog_scale"), (float)fog->scale);
}

static void compose(const lit_opaque *lit, const court_layers *layers, const lit_opaque_view *view)
{
    const gl_functions *gl = lit->gl;
    const GLuint program = lit->compose_program;
    gl->BindFramebuffer(GL_FRAMEBUFFER, view->framebuffer);
    gl->Viewport(0, 0, layers->width, layers->height);
    gl->UseProgram(program);
    set_vector(gl, program, "background", view->scene->background);
    gl->Uniform1i(gl->GetUniformLocation(program, "reflects"), view->reflection != 0);
    gl->Uniform2f(gl->GetUniformLocation(program, "pixel"), 1.0f / (float)layers->width, 1.0f / (float)layers->height);
    set_fog(lit, view);
    bind_texture(lit, "depth", 3, view->depth);
    bind_texture(lit, "reflection", 2, view->reflection);
    bind_texture(lit, "own_light", 1, layers->own_light);
    bind_texture(lit, "lit_albedo", 0, layers->albedo);
    gl->BindVertexArray(lit->no_vertices);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindVertexArray(0);
    for (int unit = 3; unit >= 0; unit--) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        gl->BindTexture(GL_TEXTURE_2D, 0);
    }
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void lit_opaque_fit(lit_opaque *lit, const lit_opaque_view *view)
{
    court_layers *layers = &lit->layers[view->is_mirrored];
    court_layers_fit(lit->gl, layers, view->settings->width, view->settings->height, view->depth);
}

ew_frame_desc lit_opaque_frame(const lit_opaque *lit, const lit_opaque_view *view)
{
    const court_layers *layers = &lit->layers[view->is_mirrored];
    const render_target target = {.depth = view->depth, .effect_framebuffer = layers->albedo_framebuffer};
    ew_frame_desc frame = render_light_frame(view->scene, view->settings, &target);
    frame.normal_texture = layers->normal;
    if (view->is_mirrored) lit_opaque_mirror(frame.view);
    return frame;
}

ew_result lit_opaque_draw(lit_opaque *lit, const lit_opaque_view *view, ew_effect *effect, ew_error *error)
{
    const court_layers *layers = &lit->layers[view->is_mirrored];
    lit_opaque_fit(lit, view);
    draw_layers(lit, layers, view);
    const ew_frame_desc frame = lit_opaque_frame(lit, view);
    ew_result result = ew_draw(effect, &frame, error);
    if (!result) compose(lit, layers, view);
    return result;
}

void lit_opaque_destroy(lit_opaque *lit)
{
    if (!lit) return;
    lit->gl->DeleteProgram(lit->program);
    lit->gl->DeleteProgram(lit->compose_program);
    lit->gl->DeleteVertexArrays(1, &lit->no_vertices);
    for (int i = 0; i < 2; i++)
        court_layers_destroy(lit->gl, &lit->layers[i]);
    opaque_delete_buffers(lit->gl, &lit->buffers);
    free(lit);
}
