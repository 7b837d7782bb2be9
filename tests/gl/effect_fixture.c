/* Contexts, targets, frames and sources for the tests of an effect's life. */
#include "effect_fixture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

GLuint make_framebuffer_of(GLuint renderbuffer)
{
    GLuint framebuffer;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) abort();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return framebuffer;
}

GLuint make_target(GLuint *attachment)
{
    GLuint renderbuffer;
    gl.GenRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, PICTURE_WIDTH, PICTURE_HEIGHT);
    gl.BindRenderbuffer(GL_RENDERBUFFER, 0);
    if (attachment) *attachment = renderbuffer;
    return make_framebuffer_of(renderbuffer);
}

void clear_target(GLuint framebuffer)
{
    static const GLfloat nothing[4] = {0, 0, 0, 0};
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.ClearBufferfv(GL_COLOR, 0, nothing);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void read_target(GLuint framebuffer, picture *read)
{
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.ReadPixels(0, 0, PICTURE_WIDTH, PICTURE_HEIGHT, GL_RGBA, GL_FLOAT, read->pixels);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

ew_frame_desc make_frame(GLuint framebuffer, ew_output output)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.view[14] = -6; /* the eye at z = 6 */
    frame.interval_start = 2;
    frame.interval_end = 10;
    frame.output = output;
    frame.framebuffer = framebuffer;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.viewport_width = PICTURE_WIDTH;
    frame.viewport_height = PICTURE_HEIGHT;
    return frame;
}

void make_field(field *f, size_t points, size_t lines, size_t tori, size_t curves, bool weighted)
{
    *f = (field){.weights = {1, 0.2, 0.6, 1}};
    for (int i = 0; i < FIELD_SIZE; i++) {
        double place = (i - 3.5) / 2, next = place + 0.6;
        f->points[i] = (ew_point){.position = {place, 0.3 - place, 0.2 * i}, .coefficient = 0.1, .color = {1, 0.1 * i, 0.2}};
        f->lines[i] = (ew_line){
            .position = {place, 1, 0}, .direction = {0.3 * i, 1, 0.5}, .coefficient = 0.1, .color = {0.2, 1, 0.1 * i}};
        f->tori[i] = (ew_torus){
            .center = {0, place, 0.1}, .axis = {1, 0.2 * i, 1}, .radius = 0.9, .coefficient = 0.1, .color = {0.1 * i, 0.3, 1}};
        f->curves[i] = (ew_curve){.polynomial = {{place, -1, 0}, {next, 2, 0.3}, {-1, 0.2 * place, 1}},
                                  .domain = {0, 1},
                                  .weights = weighted ? f->weights : NULL,
                                  .weight_count = weighted ? 4 : 0,
                                  .coefficient = 0.1,
                                  .color = {1, 1, 0.1 * i}};
    }
    f->desc = (ew_sources_desc){.points = f->points,
                                .point_count = points,
                                .lines = f->lines,
                                .line_count = lines,
                                .tori = f->tori,
                                .torus_count = tori,
                                .curves = f->curves,
                                .curve_count = curves,
                                .epsilon = 0.02};
}

double picture_difference(const picture *actual, const picture *expected)
{
    const GLfloat *a = &actual->pixels[0][0][0], *b = &expected->pixels[0][0][0];
    double largest = 0, difference = 0;
    for (int i = 0; i < 4 * PICTURE_WIDTH * PICTURE_HEIGHT; i++) {
        if (!isfinite(a[i])) return 1e30;
        largest = fmax(largest, fabs((double)b[i]));
        difference = fmax(difference, fabs((double)a[i] - (double)b[i]));
    }
    return difference / largest;
}
