/* A scene becomes a picture: see stage.h. */
#include "stage.h"
#include "film.h"
#include "gpu_timer.h"
#include "lit_opaque.h"
#include "map.h"
#include "message.h"
#include "opaque.h"
#include "reflection.h"
#include "texture.h"

#include <math.h>
#include <stdlib.h>

/* The film's sensitivity follows the mean luminance not quite: what grows brighter shall look brighter. */
static const double usual_mean = 0.5, adaptation = 0.8;

/* The light meter's picture: small, yet fine enough that a core on one of its pixels does not count. */
enum { METER_WIDTH = 32, METER_HEIGHT = 18 };

struct demo_stage {
    const gl_functions *gl;
    ew_effect *effect;
    lit_opaque *lit;
    demo_film film;
    floor_reflection reflection;
    GLuint meter;
    GLuint meter_framebuffer;

    int width; /* of the picture; 0 while there is none */
    int height;
    int samples_per_axis;
    GLuint opaque, depth, energy, measured, picture;
    GLuint opaque_framebuffer, energy_framebuffer, measured_framebuffer, picture_framebuffer;

    gpu_timer timers[2];
    stage_statistics statistics[2];
};

static void delete_targets(demo_stage *stage)
{
    const GLuint textures[] = {stage->opaque, stage->depth, stage->energy, stage->measured, stage->picture};
    const GLuint framebuffers[] = {stage->opaque_framebuffer, stage->energy_framebuffer, stage->measured_framebuffer,
                                   stage->picture_framebuffer};
    stage->gl->DeleteFramebuffers(4, framebuffers);
    stage->gl->DeleteTextures(5, textures);
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
    stage->measured = texture_create(gl, width * samples, height * samples, GL_R32F, GL_RED);
    stage->picture = texture_create(gl, width, height, GL_RGBA8, GL_RGBA);
    stage->opaque_framebuffer = texture_framebuffer(gl, stage->opaque, stage->depth, &complete);
    stage->energy_framebuffer = texture_framebuffer(gl, stage->energy, 0, &complete);
    stage->measured_framebuffer = texture_framebuffer(gl, stage->measured, 0, &complete);
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
    for (int half = 0; half < 2; half++)
        gpu_timer_create(gl, &stage->timers[half]);
    bool complete = true;
    stage->meter = texture_create(gl, METER_WIDTH, METER_HEIGHT, GL_R32F, GL_RED);
    stage->meter_framebuffer = texture_framebuffer(gl, stage->meter, 0, &complete);
    if (!complete) message_write(message, size, "GL cannot make a float target; update the GL driver");
    if (complete && film_create(gl, &stage->film, message, size)) return stage;
    stage_destroy(stage);
    return NULL;
}

/* The court, with what its floor mirrors. */
static ew_result draw_court(demo_stage *stage, const stage_view *view, double sensitivity, ew_error *error)
{
    render_settings settings = view->settings;
    settings.width *= view->samples_per_axis;
    settings.height *= view->samples_per_axis;
    ew_result result = reflection_draw(stage->gl, &stage->reflection, stage->effect, stage->lit, &stage->film, view->scene,
                                       &settings, sensitivity, error);
    if (result) return result;
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, stage->opaque_framebuffer);
    lit_opaque_draw(stage->lit, &(lit_opaque_view){.scene = view->scene,
                                                   .width = settings.width,
                                                   .height = settings.height,
                                                   .reflection = stage->reflection.picture});
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return EW_OK;
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

/* The columns of a half of the picture, in samples. Both are halves of the same whole where it is one pixel wide. */
static void columns_of(const stage_view *view, int half, int *first, int *end)
{
    int middle = view->settings.width / 2 * view->samples_per_axis, width = view->settings.width * view->samples_per_axis;
    bool is_split = view->split && middle > 0;
    *first = is_split && half ? middle : 0;
    *end = is_split && !half ? middle : width;
}

/* The frame that draws a half of the picture in its own way. */
static ew_frame_desc half_frame(const demo_stage *stage, const stage_view *view, int half, GLuint framebuffer)
{
    render_target target = {.depth = stage->depth, .effect_framebuffer = framebuffer};
    render_settings settings = half ? view->right : view->settings;
    settings.width = view->settings.width * view->samples_per_axis;
    settings.height = view->settings.height * view->samples_per_axis;
    ew_frame_desc frame = render_frame(view->scene, &settings, &target);
    int first, end;
    columns_of(view, half, &first, &end);
    crop(&frame, first, end);
    return frame;
}

static ew_result draw_energy(demo_stage *stage, const stage_view *view, ew_error *error)
{
    const gl_functions *gl = stage->gl;
    const float nothing[4] = {0, 0, 0, 0};
    ew_result result = EW_OK;
    gl->BindFramebuffer(GL_FRAMEBUFFER, stage->energy_framebuffer);
    gl->ClearBufferfv(GL_COLOR, 0, nothing);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(stage, view, half, stage->energy_framebuffer);
        gpu_timer_begin(gl, &stage->timers[half]);
        result = ew_draw(stage->effect, &frame, error);
        gpu_timer_end(gl, &stage->timers[half]);
    }
    return result;
}

/* Sets the film by the mean luminance of the energy in all directions that are seen: that of its logarithm, as the eye has it.
 */
static ew_result meter(demo_stage *stage, const stage_view *view, double *sensitivity, ew_error *error)
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
    double mean = exp(sum / (METER_WIDTH * METER_HEIGHT));
    *sensitivity = pow(mean / usual_mean, -adaptation) / usual_mean;
    return EW_OK;
}

static ew_result draw_maps(demo_stage *stage, const stage_view *view, ew_error *error)
{
    ew_result result = EW_OK;
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(stage, view, half, stage->measured_framebuffer);
        result = map_draw(stage->gl, stage->effect, &frame, view->mode == STAGE_ERROR, stage->picture,
                          &stage->statistics[half].map, error);
    }
    return result;
}

static ew_result count_evaluations(demo_stage *stage, const stage_view *view, ew_error *error)
{
    ew_result result = EW_OK;
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++) {
        ew_frame_desc frame = half_frame(stage, view, half, stage->measured_framebuffer);
        double *mean = &stage->statistics[half].map.mean_evaluations;
        result = map_count_evaluations(stage->gl, stage->effect, &frame, mean, error);
        if (!result) *mean *= view->samples_per_axis * view->samples_per_axis;
    }
    return result;
}

/* All of the view's mode: the opaque scene, whose depth everything else needs, comes first. */
static ew_result draw_all(demo_stage *stage, const stage_view *view, ew_error *error)
{
    double sensitivity = 1;
    ew_result result = EW_OK;
    if (view->lit) {
        result = meter(stage, view, &sensitivity, error);
        if (!result) result = draw_court(stage, view, sensitivity, error);
    }
    if (result) return result;
    if (view->mode != STAGE_PICTURE) return draw_maps(stage, view, error);
    result = draw_energy(stage, view, error);
    if (!result && view->count_evaluations) result = count_evaluations(stage, view, error);
    film_exposure exposure = {.opaque = stage->opaque,
                              .energy = stage->energy,
                              .samples_per_axis = stage->samples_per_axis,
                              .graded = view->lit,
                              .sensitivity = sensitivity,
                              .encoded = true};
    film_develop(stage->gl, &stage->film, &exposure, stage->picture_framebuffer, stage->width, stage->height);
    return result;
}

static bool draw_file_opaque(const demo_stage *stage, const stage_view *view, char *message, size_t size)
{
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, stage->opaque_framebuffer);
    bool ok = opaque_draw(stage->gl, view->scene, view->settings.width * view->samples_per_axis,
                          view->settings.height * view->samples_per_axis, message, size);
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    return ok;
}

bool stage_draw(demo_stage *stage, const stage_view *asked_view, char *message, size_t size)
{
    stage_view view = *asked_view;
    ew_error error;
    if (view.mode != STAGE_PICTURE) view.samples_per_axis = 1;
    if (!make_targets(stage, &view, message, size)) return false;
    if (view.lit && !stage->lit) stage->lit = lit_opaque_create(stage->gl, view.scene, message, size);
    if (view.lit ? !stage->lit : !draw_file_opaque(stage, &view, message, size)) return false;
    for (int half = 0; half < 2; half++)
        stage->statistics[half] = (stage_statistics){.map = {-1, -1, -1}};
    if (ew_set_sources(stage->effect, &view.scene->sources, &error) || draw_all(stage, &view, &error)) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    if (stage->gl->GetError() == GL_NO_ERROR) return true;
    message_write(message, size, "GL reported an error while drawing; update the GL driver");
    return false;
}

stage_statistics stage_statistics_of(const demo_stage *stage, int half)
{
    stage_statistics statistics = stage->statistics[half];
    statistics.gpu_milliseconds = stage->timers[half].milliseconds;
    return statistics;
}

GLuint stage_framebuffer(const demo_stage *stage)
{
    return stage->picture_framebuffer;
}

void stage_size(const demo_stage *stage, int *width, int *height)
{
    *width = stage->width;
    *height = stage->height;
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
    for (int half = 0; half < 2; half++)
        gpu_timer_destroy(stage->gl, &stage->timers[half]);
    stage->gl->DeleteFramebuffers(1, &stage->meter_framebuffer);
    stage->gl->DeleteTextures(1, &stage->meter);
    lit_opaque_destroy(stage->lit);
    film_destroy(stage->gl, &stage->film);
    reflection_destroy(stage->gl, &stage->reflection);
    ew_destroy_effect(stage->effect);
    free(stage);
}
