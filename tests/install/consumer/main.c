/* A game of one frame, built against the installed library: draws the README's glow and looks whether light came out, and where
 * it ends. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <energywave.h>
#include <GL/glcorearb.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

ew_result create_glow(ew_error *error);
ew_result draw_glow(const double view[16], const double projection[16], unsigned framebuffer, unsigned depth_texture, int width,
                    int height, ew_error *error);

enum { SIZE = 64 };

static bool make_context(void)
{
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    if (!get_platform_display) return false;
    EGLDisplay display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, (void *)EGL_DEFAULT_DISPLAY, NULL);
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) return false;
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLConfig config;
    EGLint count = 0;
    if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0) return false;
    EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
}

static GLuint make_framebuffer(void)
{
    GLuint framebuffer, color;
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, SIZE, SIZE);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    return framebuffer;
}

static int fail(const char *what)
{
    fprintf(stderr, "%s\n", what);
    return EXIT_FAILURE;
}

int main(void)
{
    /* The eye is at (0, 1, 5), looks along -z and sees 90 degrees. */
    const double view[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, -5, 1};
    const double projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0};
    ew_error error = {EW_OK, ""};
    if (!make_context()) return fail("no EGL context without a surface can be made");
    GLuint framebuffer = make_framebuffer();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (create_glow(&error) != EW_OK || draw_glow(view, projection, framebuffer, 0, SIZE, SIZE, &error) != EW_OK)
        return fail(error.text);

    /* The orb's centre is 4/10 of the way from the picture's middle to its left edge, and 1/25 above the middle. */
    unsigned char orb[4] = {0}, beam[4] = {0}, corner[4] = {0};
    glReadPixels(SIZE * 3 / 10, SIZE * 13 / 25, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, orb);
    glReadPixels(SIZE * 6 / 10, SIZE * 13 / 25, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, beam);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, corner);
    printf("orb %d %d %d, beam %d %d %d, corner %d %d %d\n", orb[0], orb[1], orb[2], beam[0], beam[1], beam[2], corner[0],
           corner[1], corner[2]);
    if (glGetError() != GL_NO_ERROR) return fail("GL reports an error");
    if (!(orb[2] > 128 && beam[2] > 64)) return fail("the orb or its beam does not glow");
    if (!(orb[2] > orb[0])) return fail("the glow is not blue");
    if (corner[0] != 0 || corner[1] != 0 || corner[2] != 0) return fail("there is light beyond the reach");
    return EXIT_SUCCESS;
}
