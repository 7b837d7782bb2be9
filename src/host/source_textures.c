/* Textures of lists and sources: see source_textures.h. */
#include "host/source_textures.h"

#include "host/binding_points.h"

/* ---- The host's way to store pixels, which also tells how textures are filled ---- */

/* Those states that matter to two-dimensional textures, and what they must be. */
static const struct {
    GLenum name;
    GLint value;
    bool is_desktop;
} unpack_states[] = {{GL_UNPACK_ALIGNMENT, 4, false},
                     {GL_UNPACK_ROW_LENGTH, 0, false},
                     {GL_UNPACK_SKIP_ROWS, 0, false},
                     {GL_UNPACK_SKIP_PIXELS, 0, false},
                     {GL_UNPACK_SWAP_BYTES, 0, true}};

enum { UNPACK_STATE_COUNT = sizeof unpack_states / sizeof unpack_states[0] };

typedef struct unpack {
    GLint values[UNPACK_STATE_COUNT];
    GLint buffer;
} unpack;

static void set_unpack(const ew_gl *gl, int state, GLint value)
{
    if (!(gl->es && unpack_states[state].is_desktop)) gl->PixelStorei(unpack_states[state].name, value);
}

static void begin_unpack(const ew_gl *gl, unpack *saved)
{
    *saved = (unpack){.buffer = 0};
    for (int i = 0; i < UNPACK_STATE_COUNT; ++i) {
        if (!(gl->es && unpack_states[i].is_desktop)) gl->GetIntegerv(unpack_states[i].name, &saved->values[i]);
        set_unpack(gl, i, unpack_states[i].value);
    }
    gl->GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &saved->buffer);
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

static void end_unpack(const ew_gl *gl, const unpack *saved)
{
    for (int i = 0; i < UNPACK_STATE_COUNT; ++i)
        set_unpack(gl, i, saved->values[i]);
    if (saved->buffer != 0 && gl->IsBuffer((GLuint)saved->buffer))
        gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)saved->buffer);
}

/* ---- Textures ---- */

/* How texels are stored, as a texture and in memory. */
typedef struct texel_format {
    GLint internal;
    GLenum format, type;
    size_t size;
} texel_format;

/* Fills the bound texture with `count` texels, row by row. It is made anew: the GPU may still be reading what the last frame
 * left there. */
static void fill(const ew_gl *gl, const texel_format *texel, const void *data, size_t count)
{
    const GLsizei rows = (GLsizei)(count / EW_TEXTURE_WIDTH), rest = (GLsizei)(count % EW_TEXTURE_WIDTH);
    gl->TexImage2D(GL_TEXTURE_2D, 0, texel->internal, EW_TEXTURE_WIDTH, rows + 1, 0, texel->format, texel->type, NULL);
    if (rows > 0) gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, EW_TEXTURE_WIDTH, rows, texel->format, texel->type, data);
    const char *last = (const char *)data + (size_t)rows * EW_TEXTURE_WIDTH * texel->size;
    if (rest > 0) gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, rows, rest, 1, texel->format, texel->type, last);
}

static void bind(const ew_gl *gl, int unit, GLuint *texture)
{
    const bool is_new = !*texture;
    if (is_new) gl->GenTextures(1, texture);
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindSampler((GLuint)unit, 0);
    gl->BindTexture(GL_TEXTURE_2D, *texture);
    if (!is_new) return;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void ew_source_textures_bind(ew_source_textures *textures, const ew_gl *gl, const ew_plan *plan, unsigned key)
{
    static const texel_format place = {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, sizeof(uint32_t)};
    static const texel_format unit = {GL_RGBA32F, GL_RGBA, GL_FLOAT, sizeof(ew_vec4)};
    unpack saved;
    if (!(key & (EW_PERMUTATION_LISTS | EW_PERMUTATION_SOURCE_TEXTURE))) return;
    begin_unpack(gl, &saved);
    if (key & EW_PERMUTATION_LISTS) {
        bind(gl, EW_GL_LIST_TEXTURE_UNIT, &textures->lists);
        fill(gl, &place, plan->lists->entries, plan->lists->entry_count);
    }
    if (key & EW_PERMUTATION_SOURCE_TEXTURE) {
        bind(gl, EW_GL_SOURCE_TEXTURE_UNIT, &textures->sources);
        fill(gl, &unit, plan->source_data, plan->source_data_size / sizeof(ew_vec4));
    }
    end_unpack(gl, &saved);
}

void ew_source_textures_destroy(ew_source_textures *textures, const ew_gl *gl)
{
    gl->DeleteTextures(1, &textures->lists);
    gl->DeleteTextures(1, &textures->sources);
    *textures = (ew_source_textures){0};
}
