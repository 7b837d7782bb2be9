/* See stage.h. */
#include "stage.h"

#include "program_context.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

static gl_context *context;
static canvas target;
static ew_effect *effect;

bool stage_open(const char *context_name)
{
    context = open_context(context_name, NULL);
    if (!context) return false;
    target = canvas_create(STAGE_WIDTH, STAGE_HEIGHT, GL_RGBA32F, 0, 0);
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = context};
    return ew_create_effect(&desc, &effect, NULL) == EW_OK;
}

void stage_close(void)
{
    ew_destroy_effect(effect);
    canvas_destroy(&target);
    close_context(context);
}

ew_effect *stage_effect(void)
{
    return effect;
}

double stage_slope(void)
{
    return tan(22.5 * acos(-1) / 180);
}

double stage_pixel(double depth)
{
    return 2 * stage_slope() * depth / STAGE_HEIGHT;
}

ew_frame_desc stage_frame(double distance)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    double near_depth = distance / 100, far_depth = 100 * distance, *p = frame.projection;
    frame.view[14] = -distance;
    memset(p, 0, 16 * sizeof *p);
    p[0] = STAGE_HEIGHT / (stage_slope() * STAGE_WIDTH);
    p[5] = 1 / stage_slope();
    p[10] = -(far_depth + near_depth) / (far_depth - near_depth);
    p[11] = -1;
    p[14] = -2 * far_depth * near_depth / (far_depth - near_depth);
    frame.framebuffer = target.framebuffer;
    frame.encoding = EW_ENCODING_FLOAT;
    frame.viewport_width = STAGE_WIDTH;
    frame.viewport_height = STAGE_HEIGHT;
    frame.encoding = EW_ENCODING_FLOAT;
    return frame;
}

void stage_set(const ew_sources_desc *sources)
{
    ew_error error = {.text = ""};
    if (ew_set_sources(effect, sources, &error) != EW_OK) fail_msg("%s", error.text);
}

void stage_draw(const ew_frame_desc *frame, const GLfloat background[4], stage_picture drawn)
{
    ew_error error = {.text = ""};
    canvas_clear(&target, background);
    if (ew_draw(effect, frame, &error) != EW_OK) fail_msg("%s", error.text);
    canvas_read(&target, &drawn[0][0][0]);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

void stage_measure(const ew_frame_desc *frame, stage_picture measured)
{
    static const GLfloat black[4] = {0, 0, 0, 1};
    ew_frame_desc measuring = *frame;
    measuring.output = EW_OUTPUT_LUMINANCE;
    stage_draw(&measuring, black, measured);
}

double stage_peak(stage_picture measured)
{
    double peak = 0;
    for (int i = 0; i < STAGE_WIDTH * STAGE_HEIGHT; i++)
        peak = fmax(peak, (double)measured[i / STAGE_WIDTH][i % STAGE_WIDTH][0]);
    return peak;
}

double stage_difference(stage_picture measured, stage_picture expected)
{
    double largest = 0, peak = stage_peak(expected);
    for (int i = 0; i < STAGE_WIDTH * STAGE_HEIGHT; i++) {
        double is = (double)measured[i / STAGE_WIDTH][i % STAGE_WIDTH][0];
        double should = (double)expected[i / STAGE_WIDTH][i % STAGE_WIDTH][0];
        if (!isfinite(is)) return (double)INFINITY;
        largest = fmax(largest, fabs(is - should) / fmax(should, 1e-3 * peak));
    }
    return largest;
}

double stage_ray_distance(double distance, int column, int row)
{
    double x = (2 * column + 1 - STAGE_WIDTH) * stage_slope() / STAGE_HEIGHT;
    double y = (2 * row + 1 - STAGE_HEIGHT) * stage_slope() / STAGE_HEIGHT;
    return distance * sqrt((x * x + y * y) / (1 + x * x + y * y));
}

static double orb_field(double core, double reach, double miss, double along)
{
    return fmax(0, 1 / fmax(core, hypot(miss, along)) - 1 / reach);
}

static double simpson(double core, double reach, double miss, double from, double to)
{
    enum { DIVISIONS = 4000 };
    double sum = 0;
    if (!(from < to)) return 0;
    for (int i = 0; i <= DIVISIONS; i++) {
        /* Finer towards both ends of the part. */
        double u = (double)i / DIVISIONS, place = u * u * (3 - 2 * u), slope = 6 * u * (1 - u);
        double factor = i == 0 || i == DIVISIONS ? 1 : i % 2 ? 4 : 2;
        sum += factor * slope * orb_field(core, reach, miss, from + (to - from) * place);
    }
    return sum * (to - from) / (3 * DIVISIONS);
}

double stage_orb(double brightness, double core, double reach, double miss, double end)
{
    double half_chord = sqrt(fmax(0, reach * reach - miss * miss)), half_core = sqrt(fmax(0, core * core - miss * miss));
    double last = fmin(end, half_chord);
    double sum = simpson(core, reach, miss, -half_chord, fmin(last, -half_core)) +
                 simpson(core, reach, miss, -half_core, fmin(last, half_core)) + simpson(core, reach, miss, half_core, last);
    return brightness / (2 * log(reach / core)) * sum;
}

GLuint stage_make_depth(double depth)
{
    static GLfloat depths[STAGE_HEIGHT][STAGE_WIDTH];
    for (int i = 0; i < STAGE_WIDTH * STAGE_HEIGHT; i++)
        depths[i / STAGE_WIDTH][i % STAGE_WIDTH] = (GLfloat)depth;
    GLuint texture;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, STAGE_WIDTH, STAGE_HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return texture;
}
