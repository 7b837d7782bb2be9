/* A scene becomes a picture: see stage.h. */
#include "stage.h"
#include "lit_opaque.h"
#include "message.h"
#include "opaque.h"
#include "shader.h"
#include "shader_text.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

/* The light meter's picture: small, yet fine enough that a core on one of its pixels does not count. */
enum { METER_WIDTH = 32, METER_HEIGHT = 18 };

struct demo_stage {
    const gl_functions *gl;
    ew_effect *effect;
    lit_opaque *lit;
    GLuint film;
    GLuint no_vertices;
    GLuint meter;
    GLuint meter_framebuffer;

    int width; /* of the picture; 0 while there is none */
    int height;
    int samples_per_axis;
    GLuint opaque, depth, energy, picture;
    GLuint opaque_framebuffer, energy_framebuffer, picture_framebuffer;
};

static void delete_targets(demo_stage *stage)
{
    const GLuint textures[] = {stage->opaque, stage->depth, stage->energy, stage->picture};
    const GLuint framebuffers[] = {stage->opaque_framebuffer, stage->energy_framebuffer, stage->picture_framebuffer};
    stage->gl->DeleteFramebuffers(3, framebuffers);
    stage->gl->DeleteTextures(4, textures);
    stage->width = 0;
}

static bool make_targets(demo_stage *stage, const stage_view *view, char *message, size_t size)
{
    const gl_functions *gl = stage->gl;
    int width = view->settings.width, height = view->settings.height, samples = view->samples_per_axis;
    if (stage->width == width && stage->height == height && stage->samples_per_axis == samples) return true;
    if (stage->width) delete_targets(stage);
    GLint limit = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width * samples > limit || height * samples > limit) {
        message_write(message, size, "--size: this GL draws pictures of %d x %d at most; ask for a smaller one",
                      limit / samples, limit / samples);
        return false;
    }
    bool complete = true;
    stage->opaque = texture_create(gl, width * samples, height * samples, GL_RGBA16F, GL_RGBA);
    stage->depth = texture_create(gl, width * samples, height * samples, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT);
    stage->energy = texture_create(gl, width * samples, height * samples, GL_RGBA16F, GL_RGBA);
    stage->picture = texture_create(gl, width, height, GL_RGBA8, GL_RGBA);
    stage->opaque_framebuffer = texture_framebuffer(gl, stage->opaque, stage->depth, &complete);
    stage->energy_framebuffer = texture_framebuffer(gl, stage->energy, 0, &complete);
    stage->picture_framebuffer = texture_framebuffer(gl, stage->picture, 0, &complete);
    stage->width = width;
    stage->height = height;
    stage->samples_per_axis = samples;
    if (complete && gl->GetError() == GL_NO_ERROR) return true;
    delete_targets(stage);
    message_write(message, size, "--size: GL cannot make targets of %d x %d; ask for a smaller one", width * samples,
                  height * samples);
    return false;
}

demo_stage *stage_create(const gl_functions *gl, const ew_effect_desc *desc, char *message, size_t size)
{
    demo_stage *stage = calloc(1, sizeof *stage);
    ew_error error = {.text = "memory is exhausted"};
    if (!stage || ew_create_effect(desc, &stage->effect, &error)) {
        message_write(message, size, "%s", error.text);
        free(stage);
        return NULL;
    }
    stage->gl = gl;
    gl->GenVertexArrays(1, &stage->no_vertices);
    bool complete = true;
    stage->meter = texture_create(gl, METER_WIDTH, METER_HEIGHT, GL_R32F, GL_RED);
    stage->meter_framebuffer = texture_framebuffer(gl, stage->meter, 0, &complete);
    stage->film = shader_link(gl, shader_text_screen_vert, shader_text_film_frag, "the film's", message, size);
    if (stage->film && complete) return stage;
    if (stage->film) message_write(message, size, "GL cannot make a float target; update the GL driver");
    stage_destroy(stage);
    return NULL;
}

static bool draw_opaque(demo_stage *stage, const stage_view *view, int width, int height, char *message, size_t size)
{
    if (view->lit && !stage->lit) stage->lit = lit_opaque_create(stage->gl, view->scene, message, size);
    if (view->lit && !stage->lit) return false;
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, stage->opaque_framebuffer);
    bool ok = true;
    if (view->lit)
        lit_opaque_draw(stage->lit, view->scene, width, height);
    else
        ok = opaque_draw(stage->gl, view->scene, width, height, message, size);
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

/* Makes of a frame the columns from `first` up to `end`: their part of the NDC square becomes the whole of it. */
static void crop(ew_frame_desc *frame, int first, int end)
{
    double left = 2.0 * first / frame->viewport_width - 1, right = 2.0 * end / frame->viewport_width - 1;
    for (int column = 0; column < 4; column++) {
        double *x = &frame->projection[4 * column], w = frame->projection[4 * column + 3];
        *x = (2 * *x - (right + left) * w) / (right - left);
    }
    frame->viewport_x += first;
    frame->viewport_width = end - first;
}

static ew_result draw_energy(demo_stage *stage, const stage_view *view, const render_target *target, ew_error *error)
{
    int samples = view->samples_per_axis;
    const float nothing[4] = {0, 0, 0, 0};
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, target->effect_framebuffer);
    stage->gl->ClearBufferfv(GL_COLOR, 0, nothing);
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    for (int half = 0; half < (view->split ? 2 : 1); half++) {
        render_settings settings = half ? view->right : view->settings;
        settings.width = view->settings.width * samples;
        settings.height = view->settings.height * samples;
        ew_frame_desc frame = render_frame(view->scene, &settings, target);
        int middle = view->settings.width / 2 * samples;
        if (view->split && middle > 0) crop(&frame, half ? middle : 0, half ? settings.width : middle);
        ew_result result = ew_draw(stage->effect, &frame, error);
        if (result) return result;
    }
    return EW_OK;
}

/* The mean luminance of the energy in all directions that are seen, as the eye has it: that of the logarithm. */
static ew_result meter(demo_stage *stage, const stage_view *view, double *mean, ew_error *error)
{
    const gl_functions *gl = stage->gl;
    float luminances[METER_WIDTH * METER_HEIGHT];
    render_target target = {.effect_framebuffer = stage->meter_framebuffer};
    ew_frame_desc frame = render_frame(view->scene, &view->settings, &target);
    frame.viewport_width = METER_WIDTH;
    frame.viewport_height = METER_HEIGHT;
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.integrator = EW_INTEGRATOR_ADAPTIVE;
    frame.quality = EW_QUALITY_ERROR_1E_2;
    ew_result result = ew_draw(stage->effect, &frame, error);
    if (result) return result;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->meter_framebuffer);
    gl->ReadPixels(0, 0, METER_WIDTH, METER_HEIGHT, GL_RED, GL_FLOAT, luminances);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    double sum = 0;
    for (int i = 0; i < METER_WIDTH * METER_HEIGHT; i++)
        sum += log(fmax((double)luminances[i], 1e-3));
    *mean = exp(sum / (METER_WIDTH * METER_HEIGHT));
    return EW_OK;
}

static void develop(const demo_stage *stage, const stage_view *view, double exposure)
{
    const gl_functions *gl = stage->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->picture_framebuffer);
    gl->Viewport(0, 0, stage->width, stage->height);
    gl->UseProgram(stage->film);
    gl->Uniform1i(gl->GetUniformLocation(stage->film, "opaque_scene"), 0);
    gl->Uniform1i(gl->GetUniformLocation(stage->film, "energy"), 1);
    gl->Uniform1i(gl->GetUniformLocation(stage->film, "samples_per_axis"), stage->samples_per_axis);
    gl->Uniform1i(gl->GetUniformLocation(stage->film, "graded"), view->lit);
    gl->Uniform1f(gl->GetUniformLocation(stage->film, "exposure"), (float)exposure);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, stage->energy);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, stage->opaque);
    gl->BindVertexArray(stage->no_vertices);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindVertexArray(0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

bool stage_draw(demo_stage *stage, const stage_view *view, char *message, size_t size)
{
    ew_error error;
    if (!make_targets(stage, view, message, size)) return false;
    int samples = view->samples_per_axis;
    if (!draw_opaque(stage, view, stage->width * samples, stage->height * samples, message, size)) return false;
    render_target target = {.depth = stage->depth, .effect_framebuffer = stage->energy_framebuffer};
    double mean = 1;
    if (ew_set_sources(stage->effect, &view->scene->sources, &error) || draw_energy(stage, view, &target, &error) ||
        (view->lit && meter(stage, view, &mean, &error))) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    develop(stage, view, 1 / mean);
    if (stage->gl->GetError() == GL_NO_ERROR) return true;
    message_write(message, size, "GL reported an error while drawing; update the GL driver");
    return false;
}

GLuint stage_framebuffer(const demo_stage *stage)
{
    return stage->picture_framebuffer;
}

void stage_read(const demo_stage *stage, unsigned char *srgb)
{
    const gl_functions *gl = stage->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->picture_framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, stage->width, stage->height, GL_RGB, GL_UNSIGNED_BYTE, srgb);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void stage_destroy(demo_stage *stage)
{
    if (!stage) return;
    if (stage->width) delete_targets(stage);
    stage->gl->DeleteFramebuffers(1, &stage->meter_framebuffer);
    stage->gl->DeleteTextures(1, &stage->meter);
    lit_opaque_destroy(stage->lit);
    stage->gl->DeleteProgram(stage->film);
    stage->gl->DeleteVertexArrays(1, &stage->no_vertices);
    ew_destroy_effect(stage->effect);
    free(stage);
}
