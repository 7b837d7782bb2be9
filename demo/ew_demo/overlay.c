/* Text and bars over the picture: see overlay.h. */
#include "overlay.h"
#include "demo_shaders.h"
#include "message.h"
#include "shader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_easy_font.h>

enum { MAX_QUADS = 16000, MAX_TEXT = 4000 };

/* The layout that stb_easy_font writes. */
typedef struct overlay_vertex {
    float position[3];
    unsigned char color[4];
} overlay_vertex;

struct demo_overlay {
    const gl_functions *gl;
    GLuint program;
    GLuint vertex_array;
    GLuint buffers[2];
    int quad_count;
    overlay_vertex vertices[4 * MAX_QUADS];
};

static void create_buffers(demo_overlay *overlay)
{
    const gl_functions *gl = overlay->gl;
    gl->GenVertexArrays(1, &overlay->vertex_array);
    gl->GenBuffers(2, overlay->buffers);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffers[0]);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(overlay_vertex), NULL);
    gl->EnableVertexAttribArray(1);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(overlay_vertex), (const void *)(3 * sizeof(float)));
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, overlay->buffers[1]);
}

/* Each quad becomes two triangles, because core GL has no quads. */
static bool upload_indices(const demo_overlay *overlay)
{
    const gl_functions *gl = overlay->gl;
    const GLuint corners[] = {0, 1, 2, 0, 2, 3};
    const size_t count = (size_t)6 * MAX_QUADS;
    GLuint *indices = malloc(count * sizeof *indices);
    for (size_t i = 0; indices && i < count; i++)
        indices[i] = (GLuint)(i / 6 * 4) + corners[i % 6];
    if (indices) gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *indices), indices, GL_STATIC_DRAW);
    free(indices);
    return indices != NULL;
}

demo_overlay *overlay_create(const gl_functions *gl, char *message, size_t size)
{
    demo_overlay *overlay = calloc(1, sizeof *overlay);
    bool ok = false;
    message_write(message, size, "the text does not fit into memory; close other programs");
    if (overlay) {
        overlay->gl = gl;
        create_buffers(overlay);
        ok = upload_indices(overlay);
        gl->BindVertexArray(0);
    }
    if (ok) overlay->program = shader_link(gl, demo_shader_overlay_vert, demo_shader_overlay_frag, "the text's", message, size);
    if (ok && overlay->program) return overlay;
    overlay_destroy(overlay);
    return NULL;
}

void overlay_begin(demo_overlay *overlay)
{
    overlay->quad_count = 0;
}

static void add_quad(demo_overlay *overlay, const double corners[4][2], const unsigned char color[4])
{
    if (overlay->quad_count == MAX_QUADS) return;
    overlay_vertex *vertices = &overlay->vertices[4 * overlay->quad_count++];
    for (int corner = 0; corner < 4; corner++) {
        vertices[corner].position[0] = (float)corners[corner][0];
        vertices[corner].position[1] = (float)corners[corner][1];
        memcpy(vertices[corner].color, color, 4);
    }
}

void overlay_box(demo_overlay *overlay, double x, double y, double width, double height, const unsigned char color[4])
{
    const double corners[4][2] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    add_quad(overlay, corners, color);
}

void overlay_line(demo_overlay *overlay, const double from[2], const double to[2], double thickness,
                  const unsigned char color[4])
{
    double x = to[0] - from[0], y = to[1] - from[1], length = hypot(x, y);
    if (!(length > 0)) return;
    /* Half of the thickness, to the line's left. */
    double left[2] = {-y * thickness / (2 * length), x * thickness / (2 * length)};
    const double corners[4][2] = {{from[0] + left[0], from[1] + left[1]},
                                  {to[0] + left[0], to[1] + left[1]},
                                  {to[0] - left[0], to[1] - left[1]},
                                  {from[0] - left[0], from[1] - left[1]}};
    add_quad(overlay, corners, color);
}

/* stb_easy_font wants text that is not const. Replaces what its font lacks by question marks. */
static void copy_text(const char *text, char copy[MAX_TEXT])
{
    size_t length = strlen(text);
    if (length >= MAX_TEXT) length = MAX_TEXT - 1;
    for (size_t i = 0; i < length; i++)
        copy[i] = text[i] == '\n' || (text[i] >= ' ' && text[i] <= '~') ? text[i] : '?';
    copy[length] = '\0';
}

void overlay_text(demo_overlay *overlay, double x, double y, double scale, const char *text, const unsigned char color[4])
{
    char copy[MAX_TEXT];
    unsigned char letters[4];
    copy_text(text, copy);
    memcpy(letters, color, 4);
    overlay_vertex *vertices = &overlay->vertices[4 * overlay->quad_count];
    int room = (int)sizeof *vertices * 4 * (MAX_QUADS - overlay->quad_count);
    int quads = stb_easy_font_print(0, 0, copy, letters, vertices, room);
    for (int i = 0; i < 4 * quads; i++) {
        vertices[i].position[0] = (float)(x + scale * (double)vertices[i].position[0]);
        vertices[i].position[1] = (float)(y + scale * (double)vertices[i].position[1]);
    }
    overlay->quad_count += quads;
}

double overlay_text_width(const char *text, double scale)
{
    char copy[MAX_TEXT];
    copy_text(text, copy);
    return scale * stb_easy_font_width(copy);
}

void overlay_draw(demo_overlay *overlay, int width, int height)
{
    const gl_functions *gl = overlay->gl;
    gl->Viewport(0, 0, width, height);
    gl->UseProgram(overlay->program);
    gl->Uniform2f(gl->GetUniformLocation(overlay->program, "pixel"), 2.0f / (float)width, 2.0f / (float)height);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffers[0]);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof(overlay_vertex) * 4 * overlay->quad_count, overlay->vertices,
                   GL_STREAM_DRAW);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawElements(GL_TRIANGLES, 6 * overlay->quad_count, GL_UNSIGNED_INT, NULL);
    gl->Disable(GL_BLEND);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
}

void overlay_destroy(demo_overlay *overlay)
{
    if (!overlay) return;
    overlay->gl->DeleteProgram(overlay->program);
    overlay->gl->DeleteVertexArrays(1, &overlay->vertex_array);
    overlay->gl->DeleteBuffers(2, overlay->buffers);
    free(overlay);
}
