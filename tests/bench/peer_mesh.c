/* Quads that carry painted light: see peer_mesh.h. */
#include "peer_mesh.h"
#include "message.h"
#include "peer_text.h"
#include "shader.h"
#include "texture.h"

#include <stdlib.h>
#include <string.h>

/* ---- Data --------------------------------------------------------------------------------------------------------------- */

/* Makes room for one more of `size` bytes each. */
static bool grow(void **list, size_t needed, size_t *capacity, size_t size, bool *is_out_of_memory)
{
    if (needed <= *capacity) return true;
    size_t more = needed + *capacity;
    void *grown = realloc(*list, more * size);
    *is_out_of_memory = *is_out_of_memory || !grown;
    if (!grown) return false;
    *list = grown;
    *capacity = more;
    return true;
}

void mesh_data_add_quad(mesh_data *data, const mesh_vertex corners[4])
{
    void *list = data->vertices;
    if (!grow(&list, data->vertex_count + 4, &data->capacity, sizeof *data->vertices, &data->is_out_of_memory)) return;
    data->vertices = list;
    memcpy(data->vertices + data->vertex_count, corners, 4 * sizeof *corners);
    data->vertex_count += 4;
}

float *mesh_data_add_profile(mesh_data *data)
{
    const size_t row = PROFILE_TEXELS * sizeof *data->profiles;
    void *list = data->profiles;
    if (!grow(&list, data->profile_count + 1, &data->profile_capacity, row, &data->is_out_of_memory)) return NULL;
    data->profiles = list;
    return data->profiles + PROFILE_TEXELS * data->profile_count++;
}

static void free_data(mesh_data *data)
{
    free(data->vertices);
    free(data->profiles);
    *data = (mesh_data){0};
}

/* ---- Upload ------------------------------------------------------------------------------------------------------------- */

static bool upload_quads(const gl_functions *gl, const mesh_data *data, peer_mesh *mesh)
{
    static const unsigned pattern[6] = {0, 1, 2, 2, 1, 3};
    static const struct {
        GLint size;
        size_t offset;
    } attributes[] = {
        {4, offsetof(mesh_vertex, position)}, {4, offsetof(mesh_vertex, tangent)}, {3, offsetof(mesh_vertex, offset)}};
    size_t quads = data->vertex_count / 4;
    unsigned *indices = malloc((6 * quads + 1) * sizeof *indices);
    if (!indices) return false;
    for (size_t i = 0; i < 6 * quads; i++)
        indices[i] = (unsigned)(i / 6 * 4) + pattern[i % 6];
    mesh->index_count = (GLsizei)(6 * quads);
    gl->GenVertexArrays(1, &mesh->vertex_array);
    gl->GenBuffers(2, mesh->buffers);
    gl->BindVertexArray(mesh->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, mesh->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(data->vertex_count * sizeof *data->vertices), data->vertices, GL_STATIC_DRAW);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh->buffers[1]);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(6 * quads * sizeof *indices), indices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < sizeof attributes / sizeof *attributes; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribPointer(i, attributes[i].size, GL_FLOAT, GL_FALSE, sizeof(mesh_vertex), (void *)attributes[i].offset);
    }
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    free(indices);
    return true;
}

static void upload_profiles(const gl_functions *gl, const mesh_data *data, peer_mesh *mesh)
{
    gl->GenTextures(1, &mesh->profiles);
    gl->BindTexture(GL_TEXTURE_2D, mesh->profiles);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, PROFILE_TEXELS, (GLsizei)data->profile_count, 0, GL_RED, GL_FLOAT,
                   data->profiles);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

static void set_uniforms(const gl_functions *gl, GLuint program, const ew_frame_desc *frame, size_t profile_count)
{
    float projection[16];
    for (int i = 0; i < 16; i++)
        projection[i] = (float)frame->projection[i];
    gl->UseProgram(program);
    gl->UniformMatrix4fv(gl->GetUniformLocation(program, "projection"), 1, GL_FALSE, projection);
    gl->Uniform1f(gl->GetUniformLocation(program, "profile_count"), (float)profile_count);
    gl->Uniform1i(gl->GetUniformLocation(program, "profiles"), 0);
    gl->Uniform1i(gl->GetUniformLocation(program, "depth"), 1);
    gl->Uniform1i(gl->GetUniformLocation(program, "has_depth"), frame->depth_texture != 0);
    gl->UseProgram(0);
}

static bool make_data(const ew_sources_desc *sources, const ew_frame_desc *frame, const mesh_style *style, int count,
                      mesh_data *data, char *message, size_t size)
{
    for (size_t k = 0; k < SOURCE_KIND_COUNT; k++)
        for (size_t i = 0; i < source_count(source_kinds[k], sources); i++) {
            const void *source = source_at(source_kinds[k], sources, i);
            const outline shape = outline_of(source_kinds[k], source, sources->epsilon, frame->view);
            if (!(shape.light.reach > 0)) {
                message_write(message, size, "--integrators: \"%s\" needs sources that have a reach; leave it out",
                              style->name);
                return false;
            }
            style->add_source(data, &shape, count);
        }
    if (data->is_out_of_memory) message_write(message, size, "%s: does not fit into memory", style->name);
    return !data->is_out_of_memory;
}

bool peer_mesh_create(gl_context *context, const ew_sources_desc *sources, const ew_frame_desc *frame, const mesh_style *style,
                      int count, peer_mesh *mesh, char *message, size_t size)
{
    const gl_functions *gl = context_gl(context);
    mesh_data data = {0};
    *mesh = (peer_mesh){0};
    bool ok = make_data(sources, frame, style, count, &data, message, size);
    if (ok) {
        ok = upload_quads(gl, &data, mesh);
        if (!ok) message_write(message, size, "%s: does not fit into memory", style->name);
    }
    if (ok) {
        upload_profiles(gl, &data, mesh);
        mesh->program = shader_link(gl, style->vertex_shader, peer_glsl_peer_painted_glsl, style->name, message, size);
        ok = mesh->program != 0;
    }
    if (ok)
        set_uniforms(gl, mesh->program, frame, data.profile_count);
    else
        peer_mesh_destroy(gl, mesh);
    free_data(&data);
    return ok;
}

void peer_mesh_destroy(const gl_functions *gl, peer_mesh *mesh)
{
    gl->DeleteVertexArrays(1, &mesh->vertex_array);
    gl->DeleteBuffers(2, mesh->buffers);
    gl->DeleteTextures(1, &mesh->profiles);
    gl->DeleteProgram(mesh->program);
}

/* ---- Drawing ------------------------------------------------------------------------------------------------------------ */

void peer_mesh_draw(const gl_functions *gl, const peer_mesh *mesh, const ew_frame_desc *frame)
{
    const float nothing[4] = {0, 0, 0, 0};
    gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffer);
    gl->Viewport(frame->viewport_x, frame->viewport_y, frame->viewport_width, frame->viewport_height);
    gl->ClearBufferfv(GL_COLOR, 0, nothing);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, frame->depth_texture);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, mesh->profiles);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    gl->UseProgram(mesh->program);
    gl->BindVertexArray(mesh->vertex_array);
    gl->DrawElements(GL_TRIANGLES, mesh->index_count, GL_UNSIGNED_INT, NULL);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->Disable(GL_BLEND);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}
