/* The layers of the court: see court_layers.h. */
#include "court_layers.h"
#include "texture.h"

enum { LAYER_COUNT = 3 };

void court_layers_fit(const gl_functions *gl, court_layers *layers, int width, int height, GLuint depth)
{
    if (layers->width == width && layers->height == height && layers->depth == depth) return;
    court_layers_destroy(gl, layers);
    GLuint *const textures[LAYER_COUNT] = {&layers->albedo, &layers->own_light, &layers->normal};
    const GLenum attachments[LAYER_COUNT] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
    bool complete = true;
    for (int i = 0; i < LAYER_COUNT; i++)
        *textures[i] = texture_create(gl, width, height, GL_RGBA16F, GL_RGBA);
    layers->albedo_framebuffer = texture_framebuffer(gl, layers->albedo, 0, &complete);
    layers->framebuffer = texture_framebuffer(gl, layers->albedo, depth, &complete);
    gl->BindFramebuffer(GL_FRAMEBUFFER, layers->framebuffer);
    for (int i = 1; i < LAYER_COUNT; i++)
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, attachments[i], GL_TEXTURE_2D, *textures[i], 0);
    gl->DrawBuffers(LAYER_COUNT, attachments);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    layers->width = width;
    layers->height = height;
    layers->depth = depth;
}

void court_layers_begin(const gl_functions *gl, const court_layers *layers)
{
    static const float dark[LAYER_COUNT][4] = {{0, 0, 0, 1}};
    const float farthest = 1;
    gl->BindFramebuffer(GL_FRAMEBUFFER, layers->framebuffer);
    gl->Viewport(0, 0, layers->width, layers->height);
    for (int i = 0; i < LAYER_COUNT; i++)
        gl->ClearBufferfv(GL_COLOR, i, dark[i]);
    gl->ClearBufferfv(GL_DEPTH, 0, &farthest);
}

void court_layers_destroy(const gl_functions *gl, court_layers *layers)
{
    const GLuint framebuffers[] = {layers->framebuffer, layers->albedo_framebuffer};
    const GLuint textures[] = {layers->albedo, layers->own_light, layers->normal};
    gl->DeleteFramebuffers(2, framebuffers);
    gl->DeleteTextures(3, textures);
    *layers = (court_layers){0};
}
