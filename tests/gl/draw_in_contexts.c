/* A scene file's picture in contexts of all kinds, one after the other in one process: what is opaque and the light over it.
 *
 *     draw_in_contexts SCENE.json WIDTH HEIGHT CONTEXT...    writes CONTEXT.png; names in context.h */
#include "debug_output.h"
#include "image.h"
#include "program_context.h"
#include "render.h"
#include "scene_file.h"

#include <stdio.h>
#include <stdlib.h>

static bool draw(gl_context *context, const demo_scene *scene, const render_settings *settings, float *pixels, ew_error *error)
{
    gl_functions functions;
    render_target target;
    *error = (ew_error){.text = "the loader lacks functions"};
    if (gl_load_functions(&functions, context_get_proc_address, context)) return false;
    if (!render_create_target(&functions, settings, &target, error->text, sizeof error->text)) return false;

    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    const ew_frame_desc frame = render_frame(scene, settings, &target);
    ew_effect *effect = NULL;
    bool drawn = render_opaque(&functions, scene, settings, &target, error->text, sizeof error->text) &&
                 ew_create_effect(&desc, &effect, error) == EW_OK && ew_set_sources(effect, &scene->sources, error) == EW_OK &&
                 ew_draw(effect, &frame, error) == EW_OK;
    ew_destroy_effect(effect);
    gl.BindFramebuffer(GL_FRAMEBUFFER, target.effect_framebuffer);
    gl.ReadPixels(0, 0, settings->width, settings->height, GL_RGBA, GL_FLOAT, pixels);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    render_destroy_target(&functions, &target);
    return drawn && gl.GetError() == GL_NO_ERROR;
}

static bool draw_in(const char *name, const demo_scene *scene, const render_settings *settings, float *pixels)
{
    gl_context *context = open_context(name, NULL);
    if (context == NULL) return false;
    ew_error error;
    char path[100], message[400];
    bool ok = draw(context, scene, settings, pixels, &error);
    if (!ok) fprintf(stderr, "%s: %s\n", name, error.text);
    close_context(context);

    snprintf(path, sizeof path, "%s.png", name);
    const image_pixels picture = {.width = settings->width, .height = settings->height, .channels = 4, .pixels = pixels};
    if (!ok || image_write(path, &picture, message, sizeof message)) return ok;
    fprintf(stderr, "%s\n", message);
    return false;
}

int main(int argc, char **argv)
{
    demo_scene scene;
    char message[400];
    if (argc < 5) return 2;
    render_settings settings = {.width = atoi(argv[2]), .height = atoi(argv[3]), .quality = EW_QUALITY_ERROR_1E_3};
    if (!scene_load(argv[1], &scene, message, sizeof message)) {
        fprintf(stderr, "%s\n", message);
        return 2;
    }
    float *pixels = calloc((size_t)settings.width * (size_t)settings.height, 4 * sizeof *pixels);
    bool ok = pixels != NULL;
    for (int i = 4; i < argc; i++)
        ok = ok && draw_in(argv[i], &scene, &settings, pixels);
    free(pixels);
    scene_free(&scene);
    return ok && debug_output_count() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
