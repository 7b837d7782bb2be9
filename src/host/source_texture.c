/* The texture of sources: see source_texture.h. */
#include "host/source_texture.h"

#include "host/binding_points.h"

/* ---- The host's way to store pixels, which also tells how textures are filled ---- */

/* Of WebGL: whether rows come last to first, and whether colours are multiplied by alpha. */
enum { UNPACK_FLIP_Y_WEBGL = 0x9240, UNPACK_PREMULTIPLY_ALPHA_WEBGL = 0x9241 };

/* Those states that matter to two-dimensional textures, what they must be, and which GL has them. */
static const struct {
    GLenum name;
    GLint value;
    enum { EVERY_GL, DESKTOP_GL, WEB_GL } of;
} unpack_states[] = {{GL_UNPACK_ALIGNMENT, 4, EVERY_GL},         {GL_UNPACK_ROW_LENGTH, 0, EVERY_GL},
                     {GL_UNPACK_SKIP_ROWS, 0, EVERY_GL},         {GL_UNPACK_SKIP_PIXELS, 0, EVERY_GL},
                     {GL_UNPACK_SWAP_BYTES, 0, DESKTOP_GL},      {UNPACK_FLIP_Y_WEBGL, 0, WEB_GL},
                     {UNPACK_PREMULTIPLY_ALPHA_WEBGL, 0, WEB_GL}};

enum { UNPACK_STATE_COUNT = sizeof unpack_states / sizeof unpack_states[0] };

typedef struct unpack {
    GLint values[UNPACK_STATE_COUNT];
    GLint buffer;
} unpack;

static bool has_unpack(const ew_gl *gl, int state)
{
    switch (unpack_states[state].of) {
    case DESKTOP_GL:
        return !gl->es;
    case WEB_GL:
        return gl->web;
    default:
        return true;
    }
}

static void begin_unpack(const ew_gl *gl, unpack *saved)
{
    *saved = (unpack){.buffer = 0};
    for (int i = 0; i < UNPACK_STATE_COUNT; ++i) {
        if (!has_unpack(gl, i)) continue;
        gl->GetIntegerv(unpack_states[i].name, &saved->values[i]);
        gl->PixelStorei(unpack_states[i].name, unpack_states[i].value);
    }
    gl->GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &saved->buffer);
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

static void end_unpack(const ew_gl *gl, const unpack *saved)
{
    for (int i = 0; i < UNPACK_STATE_COUNT; ++i)
        if (has_unpack(gl, i)) gl->PixelStorei(unpack_states[i].name, saved->values[i]);
    if (saved->buffer != 0 && gl->IsBuffer((GLuint)saved->buffer))
        gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)saved->buffer);
}

/* ---- The texture ---- */

/* Fills the bound texture from a row on. */
static void fill(const ew_gl *gl, int first_row, const void *units, size_t count)
{
    const GLsizei rows = (GLsizei)(count / EW_TEXTURE_WIDTH), rest = (GLsizei)(count % EW_TEXTURE_WIDTH);
    const ew_vec4 *last = (const ew_vec4 *)units + (size_t)rows * EW_TEXTURE_WIDTH;
    if (rows > 0) gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row, EW_TEXTURE_WIDTH, rows, GL_RGBA, GL_FLOAT, units);
    if (rest > 0) gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, first_row + rows, rest, 1, GL_RGBA, GL_FLOAT, last);
}

/* Makes the bound texture anew: the GPU may still be reading what the last frame left there. */
static void fill_texture(const ew_gl *gl, const ew_plan *plan)
{
    const int list_row = ew_first_list_row(plan);
    const size_t list_units = plan->lists ? plan->lists->word_count * sizeof(uint32_t) / sizeof(ew_vec4) : 0;
    const GLsizei rows = list_row + (GLsizei)(list_units / EW_TEXTURE_WIDTH) + 1;
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, EW_TEXTURE_WIDTH, rows, 0, GL_RGBA, GL_FLOAT, NULL);
    fill(gl, 0, plan->source_data, plan->source_data_size / sizeof(ew_vec4));
    if (plan->lists) fill(gl, list_row, plan->lists->words, list_units);
}

void ew_source_texture_bind(ew_source_texture *texture, const ew_gl *gl, const ew_plan *plan)
{
    unpack saved;
    if (!texture->name) gl->GenTextures(1, &texture->name);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_SOURCE_TEXTURE_UNIT);
    gl->BindSampler(EW_GL_SOURCE_TEXTURE_UNIT, 0);
    gl->BindTexture(GL_TEXTURE_2D, texture->name);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    begin_unpack(gl, &saved);
    fill_texture(gl, plan);
    end_unpack(gl, &saved);
}

void ew_source_texture_destroy(ew_source_texture *texture, const ew_gl *gl)
{
    gl->DeleteTextures(1, &texture->name);
    *texture = (ew_source_texture){0};
}
