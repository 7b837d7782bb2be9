/* Automatic exposure: see light_meter.h. */
#include "light_meter.h"
#include "message.h"
#include "texture.h"

#include <math.h>

/* The mean luminance at which a picture looks right as it is. */
static const double usual_mean = 0.5;

/* Exposure follows the mean luminance only in part, so that a brighter scene still looks brighter: 0 not at all, 1 entirely. */
static const double adaptation = 0.8;

/* Darker pixels count as this, because the logarithm of 0 is infinite. */
static const double darkest = 1e-3;

/* The size of the measured picture. It is small, but has enough pixels that one on a core does not decide the mean. */
enum { WIDTH = 32, HEIGHT = 18 };

bool light_meter_create(const gl_functions *gl, light_meter *meter, char *message, size_t size)
{
    bool complete = true;
    meter->texture = texture_create(gl, WIDTH, HEIGHT, GL_R32F, GL_RED);
    meter->framebuffer = texture_framebuffer(gl, meter->texture, 0, &complete);
    if (!complete) message_write(message, size, "GL cannot make a float target; update the GL driver");
    return complete;
}

void light_meter_destroy(const gl_functions *gl, light_meter *meter)
{
    gl->DeleteFramebuffers(1, &meter->framebuffer);
    gl->DeleteTextures(1, &meter->texture);
}

/* The mean of the logarithm, because the eye's response is closer to logarithmic than to linear. */
static double mean_luminance(const float *luminances, int count)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += log(fmax((double)luminances[i], darkest));
    return exp(sum / count);
}

ew_result light_meter_read(const gl_functions *gl, const light_meter *meter, ew_effect *effect, const demo_scene *scene,
                           const render_settings *settings, double *sensitivity, ew_error *error)
{
    const pixel_rectangle whole = {0, 0, WIDTH, HEIGHT};
    float luminances[WIDTH * HEIGHT];
    render_target target = {.effect_framebuffer = meter->framebuffer};
    ew_frame_desc frame = render_frame(scene, settings, &target);
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.output = EW_OUTPUT_LUMINANCE;
    frame.integrator = EW_INTEGRATOR_ADAPTIVE;
    frame.quality = EW_QUALITY_ERROR_1E_2;
    ew_result result = ew_draw(effect, &frame, error);
    if (result) return result;
    texture_read(gl, meter->framebuffer, whole, GL_RED, GL_FLOAT, luminances);
    *sensitivity = pow(mean_luminance(luminances, WIDTH * HEIGHT) / usual_mean, -adaptation) / usual_mean;
    return EW_OK;
}
