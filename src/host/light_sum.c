/* The texture in which light is summed up: see light_sum.h. */
#include "host/light_sum.h"

#include "host/binding_points.h"

/* Gives the bound texture room for that many columns and rows, never less than before. Returns whether GL has textures of that
 * size. */
static bool grow(ew_light_sum *sum, const ew_gl *gl, int width, int height)
{
    if (width <= sum->width && height <= sum->height) return true;
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (width > most || height > most) return false;
    if (width > sum->width) sum->width = width;
    if (height > sum->height) sum->height = height;
    ew_gl_allocate(gl, GL_TEXTURE_2D, GL_RGBA32F, sum->width, sum->height, GL_RGBA, GL_FLOAT);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return true;
}

void ew_light_sum_destroy(ew_light_sum *sum, const ew_gl *gl)
{
    gl->DeleteTextures(1, &sum->texture);
    *sum = (ew_light_sum){0};
}

bool ew_light_sum_fill(ew_light_sum *sum, const ew_gl *gl, int width, int height, int part_count,
                       void (*draw)(void *user, int part), void *user)
{
    GLuint framebuffer;
    if (!sum->texture) gl->GenTextures(1, &sum->texture);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_LIGHT_TEXTURE_UNIT);
    gl->BindSampler(EW_GL_LIGHT_TEXTURE_UNIT, 0);
    gl->BindTexture(GL_TEXTURE_2D, sum->texture);
    sum->is_refused = !grow(sum, gl, width, height);
    if (sum->is_refused) return false;
    gl->BindTexture(GL_TEXTURE_2D, 0);
    /* It serves one frame only, since contexts do not share framebuffers. */
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, sum->texture, 0);
    sum->is_refused = gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE;
    if (!sum->is_refused) gl->ClearBufferfv(GL_COLOR, 0, (const GLfloat[4]){0, 0, 0, 0});
    ew_gl_set_sum(gl, true);
    for (int part = 0; part < part_count && !sum->is_refused; ++part)
        draw(user, part);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_LIGHT_TEXTURE_UNIT);
    gl->BindTexture(GL_TEXTURE_2D, sum->texture);
    return !sum->is_refused;
}
