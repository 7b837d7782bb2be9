/*
 * Renders a scene to pixels in memory: the opaque shapes, and the effect over them, as a game would draw it. Programs that draw
 * the effect more than once call the steps.
 */
#ifndef RENDER_H
#define RENDER_H

#include "context.h"
#include "scene.h"

#include <stdbool.h>
#include <stddef.h>

/* The largest width and height of a picture. */
#define RENDER_MAX_SIDE 8192

typedef struct render_settings {
    int width; /* 1 .. RENDER_MAX_SIDE */
    int height;
    ew_integrator integrator;
    ew_quality quality;    /* for EW_INTEGRATOR_ADAPTIVE */
    int simpson_divisions; /* for EW_INTEGRATOR_SIMPSON */
    ew_resolution resolution;
} render_settings;

/* What a picture is drawn to. The effect reads the depth texture, so its framebuffers do not have it attached. */
typedef struct render_target {
    GLuint color;                 /* RGBA32F, linear */
    GLuint depth;                 /* DEPTH_COMPONENT32F */
    GLuint luminance;             /* R32F */
    GLuint opaque_framebuffer;    /* colour and depth */
    GLuint effect_framebuffer;    /* colour */
    GLuint luminance_framebuffer; /* luminance */
} render_target;

/* Creates a target of the settings' size. On failure returns false, with a message and nothing to destroy. */
bool render_create_target(const gl_functions *gl, const render_settings *settings, render_target *target, char *message,
                          size_t size);

void render_destroy_target(const gl_functions *gl, render_target *target);

/* Draws the scene's opaque shapes into the target's colour and depth. On failure returns false, with a message. */
bool render_opaque(const gl_functions *gl, const demo_scene *scene, const render_settings *settings,
                   const render_target *target, char *message, size_t size);

/* The frame that draws the scene's effect onto the target's colour. */
ew_frame_desc render_frame(const demo_scene *scene, const render_settings *settings, const render_target *target);

/* The frame that lights the opaque shapes there, for scenes that have a light_reach. */
ew_frame_desc render_light_frame(const demo_scene *scene, const render_settings *settings, const render_target *target);

/* Draws the scene on `context`. `color` receives 4 floats a pixel: linear RGB and opacity. `luminance` receives 1 float a
 * pixel: B. Rows go from the bottom up. Either may be NULL. On failure returns false, with a message: "place: what to mend". */
bool render_scene(gl_context *context, const demo_scene *scene, const render_settings *settings, float *color, float *luminance,
                  char *message, size_t size);

#endif
