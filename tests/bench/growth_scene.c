/* A frame to be timed: see growth_scene.h. */
#include "growth_scene.h"
#include "message.h"
#include "opaque.h"
#include "random_numbers.h"
#include "sort.h"
#include "stopwatch.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

/* How far the beams are from the eye, half the height that is seen there, and how deep they are strewn. */
#define DISTANCE 10.0
#define HALF_HEIGHT 4.5
#define DEPTH 4.0

bool strewn_beams_create(size_t count, double reach, strewn_beams *beams)
{
    uint64_t random = 0;
    *beams = (strewn_beams){.paths = calloc(count, sizeof *beams->paths), .ends = calloc(count, sizeof *beams->ends)};
    if (!beams->paths || !beams->ends) {
        strewn_beams_free(beams);
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const double half[3] = {HALF_HEIGHT * 16 / 9, HALF_HEIGHT, 0.5 * DEPTH};
        double angle = 2 * M_PI * random_unit(&random);
        for (int k = 0; k < 3; k++) {
            double middle = half[k] * (2 * random_unit(&random) - 1), along = k == 0 ? cos(angle) : k == 1 ? sin(angle) : 0.3;
            beams->ends[i][0][k] = middle - 0.5 * along;
            beams->ends[i][1][k] = middle + 0.5 * along;
        }
        beams->paths[i] = (ew_path){.points = (const double(*)[3])beams->ends[i],
                                    .point_count = 2,
                                    .brightness = 1,
                                    .color = {1, 1, 1},
                                    .core = 0.01,
                                    .reach = reach};
    }
    beams->scene = (demo_scene){
        .camera = {.eye = {0, 0, DISTANCE},
                   .up = {0, 1, 0},
                   .fov_y_degrees = 360 / M_PI * atan(HALF_HEIGHT / DISTANCE),
                   .near_depth = 0.1,
                   .far_depth = 100},
        .decay_alpha = 1,
        .decay_beta = 1,
        .core_pixels = 1.5,
        .exposure = 1,
        .sources = {.paths = beams->paths, .path_count = count},
    };
    return true;
}

void strewn_beams_free(strewn_beams *beams)
{
    free(beams->paths);
    free(beams->ends);
    *beams = (strewn_beams){0};
}

/* ---- Targets ------------------------------------------------------------------------------------------------------------ */

static GLuint create_texture(gl_context *context, int width, int height, int samples, GLenum internal_format, GLenum format)
{
    const gl_functions *gl = context_gl(context);
    GLuint texture;
    if (samples == 1) return texture_create(gl, width, height, (GLint)internal_format, format);
    PFNGLTEXIMAGE2DMULTISAMPLEPROC TexImage2DMultisample =
        (PFNGLTEXIMAGE2DMULTISAMPLEPROC)context_get_proc_address(context, "glTexImage2DMultisample");
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, internal_format, width, height, GL_TRUE);
    gl->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    return texture;
}

static bool create_targets(gl_context *context, int width, int height, int samples, growth_frame *frame)
{
    const gl_functions *gl = frame->gl;
    GLenum target = samples == 1 ? GL_TEXTURE_2D : GL_TEXTURE_2D_MULTISAMPLE;
    bool complete = true;
    frame->color = create_texture(context, width, height, samples, GL_RGBA16F, GL_RGBA);
    frame->depth = create_texture(context, width, height, samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    gl->GenFramebuffers(2, frame->framebuffers);
    for (int i = 0; i < 2; i++) {
        gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffers[i]);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, frame->color, 0);
        if (i == 0) gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, frame->depth, 0);
        complete = complete && gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return complete && gl->GetError() == GL_NO_ERROR;
}

static bool draw_opaque(const growth_frame *frame, const demo_scene *scene, int width, int height, char *message, size_t size)
{
    frame->gl->BindFramebuffer(GL_FRAMEBUFFER, frame->framebuffers[0]);
    bool ok = opaque_draw(frame->gl, scene, width, height, message, size);
    frame->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

ew_result growth_frame_create(gl_context *context, const demo_scene *scene, int width, int height, int samples,
                              ew_gl_function (*loader)(void *user, const char *name), growth_frame *frame, char *message,
                              size_t size)
{
    const render_settings settings = {.width = width, .height = height};
    const ew_effect_desc desc = {.get_proc_address = loader, .user = context};
    ew_error error = {.code = EW_ERROR_OPENGL};
    *frame = (growth_frame){.gl = context_gl(context)};
    ew_result result = EW_ERROR_OPENGL;
    message_write(message, size, "GL cannot make a float target of %d x %d with %d samples", width, height, samples);
    if (create_targets(context, width, height, samples, frame) && draw_opaque(frame, scene, width, height, message, size)) {
        result = ew_create_effect(&desc, &frame->effect, &error);
        if (result == EW_OK) result = ew_set_sources(frame->effect, &scene->sources, &error);
        if (result != EW_OK) message_write(message, size, "%s", error.text);
    }
    const render_target target = {.depth = frame->depth, .effect_framebuffer = frame->framebuffers[1]};
    frame->desc = render_frame(scene, &settings, &target);
    frame->desc.output = EW_OUTPUT_ADD;
    frame->desc.depth_source = samples == 1 ? EW_DEPTH_TEXTURE : EW_DEPTH_TEXTURE_MULTISAMPLE;
    if (scene->opaque_count == 0) frame->desc.depth_texture = 0;
    if (result != EW_OK) growth_frame_destroy(frame);
    return result;
}

void growth_frame_destroy(growth_frame *frame)
{
    const GLuint textures[] = {frame->color, frame->depth};
    ew_destroy_effect(frame->effect);
    frame->gl->DeleteFramebuffers(2, frame->framebuffers);
    frame->gl->DeleteTextures(2, textures);
}

/* ---- Time --------------------------------------------------------------------------------------------------------------- */

double growth_frame_time(gl_context *context, growth_frame *frame, ew_resolution resolution, char *message, size_t size)
{
    enum { MOST_FRAMES = 15 };
    const double budget = 1000;
    double times[MOST_FRAMES], total = 0;
    int count = 0;
    ew_error error;
    frame->desc.resolution = resolution;
    bench_stopwatch stopwatch = stopwatch_create(context);
    /* The first compiles, and is not counted unless it is all that there is time for. */
    for (int i = 0; i == 0 || (count < MOST_FRAMES && (total < budget || i == 1)); i++) {
        texture_clear(frame->gl, frame->framebuffers[1]);
        stopwatch_start(&stopwatch);
        bool ok = ew_draw(frame->effect, &frame->desc, &error) == EW_OK;
        double ms = stopwatch_stop(&stopwatch);
        if (!ok) {
            message_write(message, size, "%s", error.text);
            stopwatch_destroy(&stopwatch);
            return -1;
        }
        if (i == 0) continue;
        times[count++] = ms;
        total += ms;
    }
    stopwatch_destroy(&stopwatch);
    sort_numbers(times, (size_t)count);
    return times[count / 2];
}

double growth_frame_lit_share(const growth_frame *frame)
{
    const pixel_rectangle whole = {0, 0, frame->desc.viewport_width, frame->desc.viewport_height};
    size_t count = (size_t)whole.width * (size_t)whole.height, lit = 0;
    float *pixels = malloc(count * sizeof *pixels);
    if (!pixels) return -1;
    texture_read(frame->gl, frame->framebuffers[1], whole, GL_RED, GL_FLOAT, pixels);
    for (size_t i = 0; i < count; i++)
        lit += pixels[i] > 0;
    free(pixels);
    return (double)lit / (double)count;
}
