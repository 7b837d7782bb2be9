/* A scene whose surfaces are to be lit: see light_stage.h. */
#include "light_stage.h"
#include "camera.h"
#include "message.h"
#include "opaque.h"
#include "peer_text.h"
#include "shader.h"
#include "source_kinds.h"
#include "texture.h"
#include "vector.h"

static const char surface_vertex[] = "#version 330 core\n"
                                     "uniform mat4 projection;\n"
                                     "uniform mat4 view;\n"
                                     "layout(location = 0) in vec3 position;\n"
                                     "layout(location = 1) in vec3 normal;\n"
                                     "out vec3 surface_position;\n"
                                     "out vec3 surface_normal;\n"
                                     "void main()\n{\n"
                                     "vec4 place = view * vec4(position, 1.0);\n"
                                     "surface_position = transpose(mat3(view)) * place.xyz;\n"
                                     "surface_normal = normal;\n"
                                     "gl_Position = projection * place;\n}\n";
static const char surface_fragment[] = "#version 330 core\n"
                                       "in vec3 surface_position;\n"
                                       "in vec3 surface_normal;\n"
                                       "layout(location = 0) out vec4 place;\n"
                                       "layout(location = 1) out vec4 direction;\n"
                                       "void main()\n{\n"
                                       "place = vec4(surface_position, 1.0);\n"
                                       "direction = vec4(normalize(surface_normal), 0.0);\n}\n";

static void set_matrix(const light_stage *stage, const char *name, const double matrix[16])
{
    float rounded[16];
    for (int i = 0; i < 16; i++)
        rounded[i] = (float)matrix[i];
    stage->gl->UniformMatrix4fv(stage->gl->GetUniformLocation(stage->surface_program, name), 1, GL_FALSE, rounded);
}

static bool draw_surfaces(light_stage *stage)
{
    static const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    static const float none[4] = {0}, farthest = 1;
    const gl_functions *gl = stage->gl;
    const scene_camera *camera = &stage->scene->camera;
    double view[16], projection[16];
    opaque_mesh mesh;
    opaque_buffers buffers;
    if (!opaque_make_mesh(stage->scene, &mesh)) return false;
    bool ok = opaque_upload(gl, &mesh, NULL, &buffers);
    opaque_free_mesh(&mesh);
    if (!ok) return false;
    camera_view(camera, view);
    camera_projection(camera, (double)stage->settings.width / stage->settings.height, projection);
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->surface_framebuffer);
    gl->DrawBuffers(2, attachments);
    gl->Viewport(0, 0, stage->settings.width, stage->settings.height);
    for (int i = 0; i < 2; i++)
        gl->ClearBufferfv(GL_COLOR, i, none);
    gl->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl->UseProgram(stage->surface_program);
    set_matrix(stage, "view", view);
    set_matrix(stage, "projection", projection);
    opaque_draw_buffers(gl, &buffers);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    opaque_delete_buffers(gl, &buffers);
    return true;
}

static void make_textures(light_stage *stage)
{
    const gl_functions *gl = stage->gl;
    bool complete = true;
    for (int i = 0; i < 2; i++)
        stage->surfaces[i] = texture_create(gl, stage->settings.width, stage->settings.height, GL_RGBA32F, GL_RGBA);
    stage->surface_framebuffer = texture_framebuffer(gl, stage->surfaces[0], stage->target.depth, &complete);
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->surface_framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, stage->surfaces[1], 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    stage->lights = texture_create(gl, MAX_POINT_LIGHTS, 2, GL_RGBA32F, GL_RGBA);
    gl->GenVertexArrays(1, &stage->vertex_array);
}

bool light_stage_create(gl_context *context, const demo_scene *scene, int width, int height, light_stage *stage, char *message,
                        size_t size)
{
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    ew_error error = {.text = "the stage does not fit into memory"};
    *stage = (light_stage){.context = context, .gl = context_gl(context), .scene = scene};
    stage->settings = (render_settings){.width = width, .height = height};
    if (!render_create_target(stage->gl, &stage->settings, &stage->target, message, size)) return false;
    make_textures(stage);
    stage->surface_program = shader_link(stage->gl, surface_vertex, surface_fragment, "the surfaces'", message, size);
    stage->peer_program =
        shader_link(stage->gl, peer_glsl_peer_quad_glsl, peer_glsl_light_peer_glsl, "the point lights'", message, size);
    bool has_programs = stage->surface_program && stage->peer_program;
    if (has_programs && draw_surfaces(stage) && ew_create_effect(&desc, &stage->effect, &error) == EW_OK &&
        ew_set_sources(stage->effect, &scene->sources, &error) == EW_OK)
        return true;
    if (has_programs) message_write(message, size, "%s", error.text);
    light_stage_destroy(stage);
    return false;
}

void light_stage_destroy(light_stage *stage)
{
    const gl_functions *gl = stage->gl;
    ew_destroy_effect(stage->effect);
    gl->DeleteProgram(stage->surface_program);
    gl->DeleteProgram(stage->peer_program);
    gl->DeleteVertexArrays(1, &stage->vertex_array);
    gl->DeleteFramebuffers(1, &stage->surface_framebuffer);
    gl->DeleteTextures(2, stage->surfaces);
    gl->DeleteTextures(1, &stage->lights);
    render_destroy_target(gl, &stage->target);
}

/* ---- Point lights ------------------------------------------------------------------------------------------------------- */

enum { STEPS_OF_A_SOURCE = 4096 };

static void place_of(const source_kind *kind, const void *source, double u, double place[3])
{
    const source_view view = {{0, 0, 0}, 1}; /* matters for lines alone, which no scene here has */
    kind->place(source, &view, u, place);
}

/* How long a source is up to each of its steps. */
static double measure_source(const source_kind *kind, const void *source, double lengths[STEPS_OF_A_SOURCE + 1])
{
    double last[3], place[3], way[3];
    place_of(kind, source, 0, last);
    lengths[0] = 0;
    for (int i = 1; i <= STEPS_OF_A_SOURCE; i++) {
        place_of(kind, source, (double)i / STEPS_OF_A_SOURCE, place);
        vector_subtract(place, last, way);
        lengths[i] = lengths[i - 1] + vector_length(way);
        vector_copy(place, last);
    }
    return lengths[STEPS_OF_A_SOURCE];
}

static void add_light(float *lights[2], const double place[3], const double eye[3], const source_light *light, double intensity)
{
    for (int k = 0; k < 3; k++) {
        lights[0][k] = (float)(place[k] - eye[k]);
        lights[1][k] = (float)(intensity * light->color[k]);
    }
    lights[0][3] = (float)light->core;
    lights[0] += 4;
    lights[1] += 4;
}

static void add_lights_along(const light_stage *stage, const source_kind *kind, const void *source, int count, float *lights[2])
{
    static double lengths[STEPS_OF_A_SOURCE + 1];
    const source_light light = source_light_of(kind, source);
    double whole = measure_source(kind, source, lengths), gain = stage->scene->light_gain;
    double coefficient = light.brightness > 0 ? light.brightness / (2 * log(light.reach / light.core)) : light.coefficient;
    bool is_point = whole == 0;
    for (int i = 0, step = 0; i < (is_point ? 1 : count); i++) {
        double place[3], along = whole * (i + 0.5) / count;
        while (step < STEPS_OF_A_SOURCE - 1 && lengths[step + 1] < along)
            step++;
        double between = is_point ? 0 : (along - lengths[step]) / (lengths[step + 1] - lengths[step]);
        place_of(kind, source, (step + between) / STEPS_OF_A_SOURCE, place);
        add_light(lights, place, stage->scene->camera.eye, &light,
                  gain * coefficient * (is_point ? light.core : whole / count));
    }
}

void light_stage_set_lights(light_stage *stage, int count)
{
    static float rows[2][4 * MAX_POINT_LIGHTS];
    const ew_sources_desc *sources = &stage->scene->sources;
    float *lights[2] = {rows[0], rows[1]};
    size_t all = source_count_of_all_kinds(sources);
    for (int k = 0; k < SOURCE_KIND_COUNT; k++)
        for (size_t i = 0; i < source_count(source_kinds[k], sources); i++)
            add_lights_along(stage, source_kinds[k], source_at(source_kinds[k], sources, i), count / (int)all, lights);
    stage->gl->BindTexture(GL_TEXTURE_2D, stage->lights);
    stage->gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, MAX_POINT_LIGHTS, 2, GL_RGBA, GL_FLOAT, rows);
    stage->gl->BindTexture(GL_TEXTURE_2D, 0);
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

void light_stage_clear(light_stage *stage)
{
    static const float albedo[4] = {1, 1, 1, 1};
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, stage->target.effect_framebuffer);
    stage->gl->ClearBufferfv(GL_COLOR, 0, albedo);
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool light_stage_draw(light_stage *stage, bool has_shadows, char *message, size_t size)
{
    ew_error error;
    ew_frame_desc frame = render_light_frame(stage->scene, &stage->settings, &stage->target);
    frame.normal_texture = stage->surfaces[1];
    if (!has_shadows) frame.shadow_thickness = 0;
    if (ew_draw(stage->effect, &frame, &error) == EW_OK) return true;
    message_write(message, size, "%s", error.text);
    return false;
}

void light_stage_draw_lights(light_stage *stage, int count)
{
    static const char *const samplers[] = {"positions", "normals", "lights"};
    const GLuint textures[] = {stage->surfaces[0], stage->surfaces[1], stage->lights};
    const gl_functions *gl = stage->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->target.effect_framebuffer);
    gl->Viewport(0, 0, stage->settings.width, stage->settings.height);
    gl->UseProgram(stage->peer_program);
    for (int i = 2; i >= 0; i--) {
        gl->ActiveTexture(GL_TEXTURE0 + (GLenum)i);
        gl->BindTexture(GL_TEXTURE_2D, textures[i]);
        gl->Uniform1i(gl->GetUniformLocation(stage->peer_program, samplers[i]), i);
    }
    gl->Uniform1i(gl->GetUniformLocation(stage->peer_program, "light_count"), count);
    gl->Uniform1f(gl->GetUniformLocation(stage->peer_program, "light_reach"), (float)stage->scene->light_reach);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_DST_COLOR, GL_ONE);
    gl->BindVertexArray(stage->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->Disable(GL_BLEND);
    gl->UseProgram(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void light_stage_read(light_stage *stage, float *color, float *positions, float *normals)
{
    const pixel_rectangle whole = {0, 0, stage->settings.width, stage->settings.height};
    const gl_functions *gl = stage->gl;
    GLuint framebuffer;
    bool complete = true;
    texture_read(gl, stage->target.effect_framebuffer, whole, GL_RGBA, GL_FLOAT, color);
    if (!positions) return;
    texture_read(gl, stage->surface_framebuffer, whole, GL_RGBA, GL_FLOAT, positions);
    framebuffer = texture_framebuffer(gl, stage->surfaces[1], 0, &complete);
    texture_read(gl, framebuffer, whole, GL_RGBA, GL_FLOAT, normals);
    gl->DeleteFramebuffers(1, &framebuffer);
}
