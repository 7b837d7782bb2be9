/*
 * Draws every kind of source with every option that a shader knows of, a frame each, by WebGL 2 on the page's canvas. Each
 * frame has an effect of its own, so that its shaders are compiled anew, step by step, before it is drawn. permutations.mjs
 * calls it, and measures.
 */
#include <emscripten.h>
#include <emscripten/html5.h>
#include <energywave.h>
#include <GLES3/gl3.h>

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

/* As many pixels as adaptive resolution asks for. Other frames have few, so that it is compiling that takes their time. */
enum { SIZE = 256, FEW = 16 };

/* ---- Frames ---- */

/* What the sources are. */
enum {
    POINT,
    LINE,
    TORUS,
    CURVE,
    WEIGHTED_CURVE,
    BEAM,
    WEIGHTED_BEAM,
    POLYLINE,
    WEIGHTED_POLYLINE,
    BENT,
    WEIGHTED_BENT,
    ALL,
    SHAPES
};
static const char *const shape_names[SHAPES] = {"point",
                                                "line",
                                                "torus",
                                                "curve",
                                                "weighted curve",
                                                "beam",
                                                "weighted beam",
                                                "polyline",
                                                "weighted polyline",
                                                "bent path",
                                                "weighted bent path",
                                                "all"};

/* What a frame has beside them. */
enum {
    INTERVAL = 1 << 0,
    REACH = 1 << 1,
    SHARP = 1 << 2,
    CORE_PIXELS = 1 << 3,
    FOG = 1 << 4,
    HEIGHT = 1 << 5,
    NO_DEPTH = 1 << 6,
    ADAPTIVE = 1 << 7,
    SIMPSON = 1 << 8,
    SURFACES = 1 << 9,
    SHADOWS = 1 << 10,
    NORMALS = 1 << 11,
    LERP = 1 << 12,
    LUMINANCE = 1 << 13,
    EVALUATIONS = 1 << 14,
    PLAIN = 1 << 15, /* not dithered */
    SRGB = 1 << 16,
    MEDIA = 1 << 17,
    OPTIONS = 18
};
static const char *const option_names[OPTIONS] = {"interval", "reach",     "sharpness",   "core_pixels", "fog",     "height",
                                                  "no depth", "adaptive",  "Simpson",     "surfaces",    "shadows", "normals",
                                                  "lerp",     "luminance", "evaluations", "plain",       "sRGB",    "media"};

typedef struct frame_case {
    int shape;
    unsigned options;
} frame_case;

/* What changes an integrator, with every shape; of all kinds at once, the fullest of each integral. */
static const unsigned integrals[] = {INTERVAL,
                                     REACH | SHARP | CORE_PIXELS,
                                     REACH | FOG | HEIGHT | CORE_PIXELS,
                                     INTERVAL | REACH | SHARP | CORE_PIXELS,
                                     REACH,
                                     REACH | FOG | CORE_PIXELS,
                                     INTERVAL | REACH | FOG};
enum { INTEGRALS = sizeof integrals / sizeof integrals[0], INTEGRALS_OF_ALL = 4 };

/* What does not change an integrator, of a point. */
static const unsigned outputs[] = {
    LERP, LUMINANCE, EVALUATIONS, PLAIN, SRGB, NO_DEPTH, NO_DEPTH | LERP | SRGB, SHARP | LUMINANCE};
enum { OUTPUTS = sizeof outputs / sizeof outputs[0] };

static frame_case cases[SHAPES * (INTEGRALS + 4) + OUTPUTS + 4];
static int case_count;

static void add_case(int shape, unsigned options)
{
    cases[case_count++] = (frame_case){shape, options};
}

static bool has_weights(int shape)
{
    return shape == WEIGHTED_CURVE || shape == WEIGHTED_BEAM || shape == WEIGHTED_POLYLINE || shape == WEIGHTED_BENT ||
           shape == ALL;
}

EMSCRIPTEN_KEEPALIVE int count_frames(void)
{
    case_count = 0;
    for (int shape = 0; shape < SHAPES; ++shape) {
        for (int i = 0; i < (shape == ALL ? INTEGRALS_OF_ALL : INTEGRALS); ++i)
            add_case(shape, integrals[i]);
        add_case(shape, INTERVAL | SIMPSON);
        add_case(shape, REACH | SURFACES | (shape % 2 ? SHADOWS : SHADOWS | NORMALS));
        if (shape == POINT || shape == ALL) add_case(shape, REACH | SURFACES);
        if (has_weights(shape)) add_case(shape, REACH | ADAPTIVE | CORE_PIXELS);
    }
    for (int i = 0; i < OUTPUTS; ++i)
        add_case(POINT, REACH | outputs[i]);
    add_case(POINT, REACH | MEDIA);
    add_case(POINT, INTERVAL | MEDIA | FOG | HEIGHT);
    add_case(BENT, REACH | MEDIA | CORE_PIXELS);
    add_case(WEIGHTED_CURVE, REACH | MEDIA | ADAPTIVE);
    return case_count;
}

EMSCRIPTEN_KEEPALIVE const char *name_frame(int i)
{
    static char name[160];
    int length = snprintf(name, sizeof name, "%s", shape_names[cases[i].shape]);
    for (int option = 0; option < OPTIONS; ++option)
        if (cases[i].options & 1u << option)
            length += snprintf(name + length, sizeof name - (size_t)length, ", %s", option_names[option]);
    return name;
}

/* ---- Drawing ---- */

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return (ew_gl_function)(uintptr_t)emscripten_webgl_get_proc_address(name);
}

/* The light is in front of the depth of 4 that the depth texture has everywhere. */
static ew_result set_sources(ew_effect *effect, const frame_case *which, ew_error *error)
{
    static const double weights[] = {1, 0.2, 0.8, 0.1, 1};
    static const double corners[][3] = {{-1, -0.6, -2}, {-0.3, 0.5, -2.5}, {0.3, -0.4, -2}, {1, 0.6, -2.6}};
    const double reach = which->options & REACH ? 0.9 : 0, sharpness = which->options & SHARP ? 2 : 0;
    const size_t weight_count = has_weights(which->shape) ? sizeof weights / sizeof weights[0] : 0;
    ew_point point = {
        .position = {0, 0, -2}, .coefficient = 0.2, .color = {1, 1, 1}, .core = 0.05, .reach = reach, .sharpness = sharpness};
    ew_line line = {.position = {0, 0.2, -2},
                    .direction = {1, 0.3, 0.2},
                    .coefficient = 0.2,
                    .color = {1, 1, 1},
                    .core = 0.05,
                    .reach = reach,
                    .sharpness = sharpness};
    ew_torus torus = {.center = {0, 0, -2.5},
                      .axis = {0.2, 1, 0.6},
                      .radius = 0.7,
                      .coefficient = 0.2,
                      .color = {1, 1, 1},
                      .core = 0.05,
                      .reach = reach,
                      .sharpness = sharpness};
    ew_curve curve = {.domain = {0, 1},
                      .coefficient = 0.2,
                      .color = {1, 1, 1},
                      .core = 0.05,
                      .reach = reach,
                      .sharpness = sharpness,
                      .weights = weight_count > 0 ? weights : NULL,
                      .weight_count = weight_count};
    ew_bezier_polynomial(corners[0], corners[1], corners[3], curve.polynomial);
    const bool is_beam = which->shape == BEAM || which->shape == WEIGHTED_BEAM;
    const bool is_bent = which->shape == BENT || which->shape == WEIGHTED_BENT || which->shape == ALL;
    ew_path path = {.kind = is_bent ? EW_PATH_BSPLINE : EW_PATH_POLYLINE,
                    .points = corners,
                    .point_count = is_beam ? 2 : 4,
                    .weights = curve.weights,
                    .weight_count = weight_count,
                    .coefficient = 0.2,
                    .color = {1, 1, 1},
                    .core = 0.05,
                    .reach = reach,
                    .sharpness = sharpness};
    const bool all = which->shape == ALL;
    return ew_set_sources(effect,
                          &(ew_sources_desc){.points = &point,
                                             .point_count = all || which->shape == POINT,
                                             .lines = &line,
                                             .line_count = all || which->shape == LINE,
                                             .tori = &torus,
                                             .torus_count = all || which->shape == TORUS,
                                             .curves = &curve,
                                             .curve_count = all || which->shape == CURVE || which->shape == WEIGHTED_CURVE,
                                             .paths = &path,
                                             .path_count = all || which->shape >= BEAM},
                          error);
}

static GLuint framebuffer, target, depth, normals;

static GLuint make_texture(GLenum format)
{
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, SIZE, SIZE);
    return texture;
}

/* An opaque plane at a view depth of 4, across the view, and a target. Returns whether there is WebGL 2. */
EMSCRIPTEN_KEEPALIVE int start(void)
{
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#canvas", &attributes);
    if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS) return 0;
    target = make_texture(GL_RGBA8);
    depth = make_texture(GL_DEPTH_COMPONENT24);
    normals = make_texture(GL_RGBA8);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, normals, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    glClearColor(0.5f, 0.5f, 1, 1);
    glClearDepthf(1 - 0.1f / 4);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, 0, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    return 1;
}

static void set_output(ew_frame_desc *frame, unsigned options)
{
    if (options & LERP) frame->output = EW_OUTPUT_LERP;
    if (options & LUMINANCE) frame->output = EW_OUTPUT_LUMINANCE;
    if (options & EVALUATIONS) frame->output = EW_OUTPUT_EVALUATIONS;
    if (options & SURFACES) frame->output = EW_OUTPUT_SURFACES;
    frame->dither = !(options & PLAIN);
    if (options & SRGB) frame->encoding = EW_ENCODING_SRGB_8BIT;
}

static ew_frame_desc frame_of(unsigned options)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    if (options & INTERVAL) {
        frame.interval_start = 1;
        frame.interval_end = 4;
    }
    frame.core_pixels = options & CORE_PIXELS ? 1.5 : 0;
    frame.light_gain = options & SURFACES ? 20 : 1;
    frame.light_reach = options & SURFACES ? 6 : 0;
    frame.shadow_thickness = options & SHADOWS ? 0.5 : 0;
    if (options & FOG) frame.fog.extinction = 0.2;
    if (options & HEIGHT) frame.fog.scale = 1;
    if (options & MEDIA) {
        static const ew_medium ball = {
            .shape = EW_MEDIUM_ELLIPSOID, .half_axes = {{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}, .extinction = 0.5};
        frame.media = &ball;
        frame.medium_count = 1;
    }
    frame.integrator = options & SIMPSON ? EW_INTEGRATOR_SIMPSON : EW_INTEGRATOR_ADAPTIVE;
    frame.resolution = options & ADAPTIVE ? EW_RESOLUTION_ADAPTIVE : EW_RESOLUTION_FULL;
    set_output(&frame, options);
    frame.framebuffer = framebuffer;
    frame.viewport_width = frame.viewport_height = options & ADAPTIVE ? SIZE : FEW;
    frame.depth_texture = options & NO_DEPTH ? 0 : depth;
    if (options & NORMALS) {
        frame.normal_texture = normals;
        frame.normal_encoding = EW_NORMAL_WORLD_BIASED;
    }
    return frame;
}

static unsigned char pixels[SIZE * SIZE * 4];

static ew_effect *effect;
static ew_error error;

/* Makes the effect for a frame. Like the next two, it returns what is wrong, or nothing. */
EMSCRIPTEN_KEEPALIVE const char *begin_frame(int i)
{
    error.text[0] = '\0';
    effect = NULL;
    if (ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK)
        set_sources(effect, &cases[i], &error);
    return error.text;
}

static int steps_left;

/* Takes a step towards the frame's shaders, and waits for what it does. */
EMSCRIPTEN_KEEPALIVE const char *prepare_frame(int i)
{
    const ew_frame_desc frame = frame_of(cases[i].options);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    ew_prepare_step(effect, NULL, &frame, &steps_left, &error);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    return error.text;
}

EMSCRIPTEN_KEEPALIVE int count_steps_left(void)
{
    return steps_left;
}

/* Draws the frame, waits for it, and destroys the effect. */
EMSCRIPTEN_KEEPALIVE const char *draw_frame(int i)
{
    const ew_frame_desc frame = frame_of(cases[i].options);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    const bool lights_surfaces = cases[i].options & SURFACES; /* what is there, times the light */
    glClearColor(lights_surfaces ? 0.25f : 0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (error.text[0] == '\0' && ew_draw(effect, &frame, &error) == EW_OK) {
        glReadPixels(0, 0, SIZE, SIZE, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        size_t lit = 0;
        for (size_t k = 0; k < sizeof pixels; k += 4)
            lit += pixels[k] > (lights_surfaces ? 64 : 0);
        if (lit == 0) strcpy(error.text, "the picture is dark");
    }
    ew_destroy_effect(effect);
    return error.text;
}

/* The pixels of the last frame. */
EMSCRIPTEN_KEEPALIVE const unsigned char *last_pixels(void)
{
    return pixels;
}

EMSCRIPTEN_KEEPALIVE size_t last_pixels_size(void)
{
    return sizeof pixels;
}
