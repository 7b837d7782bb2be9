/* A scene becomes a picture: see stage.h. */
#include "stage.h"
#include "false_color.h"
#include "gpu_timer.h"
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
    gl->GenVertexArrays(1, &stage->no_vertices);
    for (int half = 0; half < 2; half++)
        gpu_timer_create(gl, &stage->timers[half]);
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

static void read_measured(const demo_stage *stage, int first, int end, float *values)
{
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, stage->measured_framebuffer);
    stage->gl->ReadPixels(first, 0, end - first, stage->height * stage->samples_per_axis, GL_RED, GL_FLOAT, values);
    stage->gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
}

/* One number for each sample of a half of the picture. */
static ew_result measure(demo_stage *stage, const stage_view *view, int half, ew_output output, float *values, ew_error *error)
{
    ew_frame_desc frame = half_frame(stage, view, half, stage->measured_framebuffer);
    frame.output = output;
    ew_result result = ew_draw(stage->effect, &frame, error);
    if (!result) read_measured(stage, frame.viewport_x, frame.viewport_x + frame.viewport_width, values);
    return result;
}

/* The luminance of a half by the reference. On a part of the interval, from s0 to s1 of it, with s = s0 + (s1 - s0) s', the
 * decay alpha / (s + beta)^2 ds is alpha' / (s' + beta')^2 ds', where alpha' = alpha / (s1 - s0), beta' = (s0 + beta) / (s1 -
 * s0). */
static ew_result measure_reference(demo_stage *stage, const stage_view *view, int half, float *scratch, double *sum,
                                   size_t count, ew_error *error)
{
    const double parts = STAGE_REFERENCE_PARTS;
    ew_frame_desc whole = half_frame(stage, view, half, stage->measured_framebuffer);
    for (size_t i = 0; i < count; i++)
        sum[i] = 0;
    for (int part = 0; part < STAGE_REFERENCE_PARTS; part++) {
        ew_frame_desc frame = whole;
        double length = (whole.interval_end - whole.interval_start) / parts;
        frame.interval_start = whole.interval_start + part * length;
        frame.interval_end = frame.interval_start + length;
        frame.decay_alpha = whole.decay_alpha * parts;
        frame.decay_beta = part + whole.decay_beta * parts;
        frame.integrator = EW_INTEGRATOR_SIMPSON;
        frame.simpson_divisions = EW_MAX_SIMPSON_DIVISIONS;
        frame.output = EW_OUTPUT_LUMINANCE;
        ew_result result = ew_draw(stage->effect, &frame, error);
        if (result) return result;
        read_measured(stage, frame.viewport_x, frame.viewport_x + frame.viewport_width, scratch);
        for (size_t i = 0; i < count; i++)
            sum[i] += (double)scratch[i];
    }
    return EW_OK;
}

static double mean_of(const float *values, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)values[i];
    return sum / (double)count;
}

static int compare_floats(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Writes the values' colours where the half stands in the picture. */
static void put_map(const demo_stage *stage, const float *values, int first, int end, double (*place_of)(double),
                    unsigned char *srgb)
{
    size_t count = (size_t)(end - first) * (size_t)stage->height;
    for (size_t i = 0; i < count; i++)
        false_color_at(place_of((double)values[i]), srgb + 3 * i);
    const gl_functions *gl = stage->gl;
    gl->BindTexture(GL_TEXTURE_2D, stage->picture);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, first, 0, end - first, stage->height, GL_RGB, GL_UNSIGNED_BYTE, srgb);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

/* Room for one half, or the whole, of a map. */
typedef struct map_memory {
    float *values;
    float *scratch;
    double *reference;
    unsigned char *srgb;
} map_memory;

static ew_result draw_half_map(demo_stage *stage, const stage_view *view, int half, const map_memory *memory, ew_error *error)
{
    stage_statistics *statistics = &stage->statistics[half];
    int first, end;
    columns_of(view, half, &first, &end);
    size_t count = (size_t)(end - first) * (size_t)stage->height;
    bool is_error = view->mode == STAGE_ERROR;
    ew_result result = measure(stage, view, half, EW_OUTPUT_EVALUATIONS, memory->values, error);
    if (!result) statistics->mean_evaluations = mean_of(memory->values, count);
    if (!result && is_error) {
        result = measure_reference(stage, view, half, memory->scratch, memory->reference, count, error);
        if (!result) result = measure(stage, view, half, EW_OUTPUT_LUMINANCE, memory->values, error);
    }
    if (result) return result;
    double largest = 0;
    for (size_t i = 0; is_error && i < count; i++)
        largest = fmax(largest, memory->reference[i]);
    if (is_error) false_color_errors(memory->values, memory->reference, count, largest);
    put_map(stage, memory->values, first, end, is_error ? false_color_of_error : false_color_of_evaluations, memory->srgb);
    if (is_error) {
        qsort(memory->values, count, sizeof *memory->values, compare_floats);
        statistics->largest_error = (double)memory->values[count - 1];
        statistics->error_of_99_percent = (double)memory->values[(count - 1) * 99 / 100];
    }
    return EW_OK;
}

static ew_result draw_map(demo_stage *stage, const stage_view *view, ew_error *error)
{
    size_t count = (size_t)stage->width * (size_t)stage->height;
    map_memory memory = {malloc(count * sizeof(float)), malloc(count * sizeof(float)), malloc(count * sizeof(double)),
                         malloc(count * 3)};
    ew_result result = EW_OK;
    if (!memory.values || !memory.scratch || !memory.reference || !memory.srgb) {
        result = EW_ERROR_OUT_OF_MEMORY;
        *error = (ew_error){result, "the map does not fit into memory; make the picture smaller"};
    }
    for (int half = 0; !result && half < (view->split ? 2 : 1); half++)
        result = draw_half_map(stage, view, half, &memory, error);
    free(memory.values);
    free(memory.scratch);
    free(memory.reference);
    free(memory.srgb);
    return result;
}

static ew_result count_evaluations(demo_stage *stage, const stage_view *view, ew_error *error)
{
    size_t samples = (size_t)view->samples_per_axis;
    float *values = malloc((size_t)stage->width * (size_t)stage->height * samples * samples * sizeof *values);
    ew_result result = EW_OK;
    for (int half = 0; values && !result && half < (view->split ? 2 : 1); half++) {
        int first, end;
        columns_of(view, half, &first, &end);
        result = measure(stage, view, half, EW_OUTPUT_EVALUATIONS, values, error);
        size_t count = (size_t)(end - first) * (size_t)stage->height * samples;
        if (!result) stage->statistics[half].mean_evaluations = mean_of(values, count) * (double)(samples * samples);
    }
    free(values);
    return result;
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

static ew_result draw_picture(demo_stage *stage, const stage_view *view, ew_error *error)
{
    double mean = 1;
    ew_result result = draw_energy(stage, view, error);
    if (!result && view->lit) result = meter(stage, view, &mean, error);
    if (!result && view->count_evaluations) result = count_evaluations(stage, view, error);
    if (!result) develop(stage, view, 1 / mean);
    return result;
}

bool stage_draw(demo_stage *stage, const stage_view *asked_view, char *message, size_t size)
{
    stage_view view = *asked_view;
    ew_error error;
    if (view.mode != STAGE_PICTURE) view.samples_per_axis = 1;
    if (!make_targets(stage, &view, message, size)) return false;
    for (int half = 0; half < 2; half++)
        stage->statistics[half] = (stage_statistics){-1, -1, -1, -1};
    int samples = view.samples_per_axis;
    if (!draw_opaque(stage, &view, stage->width * samples, stage->height * samples, message, size)) return false;
    if (ew_set_sources(stage->effect, &view.scene->sources, &error) ||
        (view.mode == STAGE_PICTURE ? draw_picture : draw_map)(stage, &view, &error)) {
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
    stage->gl->DeleteProgram(stage->film);
    stage->gl->DeleteVertexArrays(1, &stage->no_vertices);
    ew_destroy_effect(stage->effect);
    free(stage);
}
