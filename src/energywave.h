/*
 * EnergyWave: light that glows out of a continuous field of energy, as a drop-in effect for OpenGL.
 *
 * The field at a point P is
 *
 *     psi(P) = sum over the sources of  coefficient * weight / max(epsilon, distance(P, source))
 *
 * and every pixel is its line integral along the view ray, with a decay that dims what is far:
 *
 *     B = integral from 0 to s_max of  psi(L(s)) * alpha / (s + beta)^2  ds
 *
 * L(s) = S + s (E - S), where S lies at view depth `interval_start` and E at `interval_end` on the ray through the pixel's
 * centre; s_max is where the ray meets the host's opaque scene, at most 1. (Watanabe, Abe, Konno: "Real-Time Rendering
 * Technique for Visual Expression of Arbitrary-Shaped Energy Wave", equations (2), (3), (7), (13), (17), (18), (20), (21);
 * the floor `epsilon` is ours.) With alpha = beta = 1 and E twice as far away as S, the decay is exactly the inverse square
 * of the distance from the eye, scaled to 1 at S.
 *
 * The whole integral is computed in the fragment shader of one screen-covering quad, for any number of sources in one pass.
 *
 *     ew_effect *effect;
 *     ew_create_effect(&(ew_effect_desc){.get_proc_address = my_loader}, &effect, NULL);
 *     ew_set_sources(effect, &(ew_sources_desc){.points = &orb, .point_count = 1, .epsilon = 1e-3}, NULL);
 *     ew_frame_desc frame = EW_FRAME_DEFAULTS;                    // every frame, after the opaque scene:
 *     ...                                                         // camera, interval, target, opaque depth
 *     ew_draw(effect, &frame, NULL);
 *     ew_destroy_effect(effect);
 *
 * Space and units. Sources live in the host's world space. Lengths are world units, in double precision: sources and camera
 * are brought together before anything becomes a float, so a world far from its origin costs no accuracy. Colours are linear
 * RGB. Matrices are column-major, for column vectors, as in OpenGL. View space looks along -z; *view depth* is -z there.
 *
 * Errors. Every function that can fail returns an `ew_result` and takes an `ew_error` that may be NULL; on failure the error
 * holds the same code and a sentence that names the field and says what to mend. A failed call changes nothing: neither the
 * effect, nor GL state, nor the picture. The library never prints and never aborts.
 *
 * Threads. An effect belongs to the context in which it was created, and as well to all that share objects with it and were
 * created alike: the same API, version, profile and loader. A function that takes an effect must be called on a thread on which
 * one of these contexts is current, one call at a time; different effects are independent, on different threads too. The
 * library has no threads, locks or variables of its own, so keeping two calls for one effect apart is the host's part; and when
 * an effect goes from one context to another, so is what GL asks for there: a glFinish in the first, or a fence that the second
 * waits for. So a loader's thread may create and prepare (ew_prepare) an effect on a context of its own, for another thread to
 * draw. What contexts do not share is the host's to name in each: a frame's `framebuffer` is one of the current context. The
 * functions without an effect are pure.
 *
 * GL. The library creates no context and links no GL. It needs OpenGL 3.3 core or OpenGL ES 3.0. Each call leaves all GL state
 * as it found it, unless the frame says `skip_restore`.
 */
#ifndef ENERGYWAVE_H
#define ENERGYWAVE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(EW_STATIC)
#define EW_API
#elif defined(_WIN32) && defined(EW_BUILD)
#define EW_API __declspec(dllexport)
#elif defined(_WIN32)
#define EW_API __declspec(dllimport)
#else
#define EW_API __attribute__((visibility("default")))
#endif

#define EW_VERSION_MAJOR 0
#define EW_VERSION_MINOR 1
#define EW_VERSION_PATCH 0

/* The sources of an effect share one uniform block, of which a point takes 2 units of 16 bytes, a line and a torus 3, a curve
 * 6, and a curve with n weights n - 2 more, at least one. Together they take at most EW_MAX_SOURCE_UNITS; a context whose
 * uniform blocks are smaller than 64 KiB (the least that GL and GLES promise is 16 KiB) takes fewer, in proportion, and the
 * error says how many. */
#define EW_MAX_SOURCE_UNITS 4064
/* The most of a kind, if there is no other. */
#define EW_MAX_POINTS (EW_MAX_SOURCE_UNITS / 2)
#define EW_MAX_LINES (EW_MAX_SOURCE_UNITS / 3)
#define EW_MAX_TORI (EW_MAX_SOURCE_UNITS / 3)
#define EW_MAX_CURVES (EW_MAX_SOURCE_UNITS / 6)
/* The most weights of one curve. */
#define EW_MAX_WEIGHTS 1024

/* The largest number of divisions that EW_INTEGRATOR_SIMPSON takes. */
#define EW_MAX_SIMPSON_DIVISIONS 4096

/* Results and what they mean: EW_RESULTS(X) expands X(name, text) for each; the texts are ew_result_text's. */
#define EW_RESULTS(X)                                                                                                          \
    X(EW_OK, "success")                                                                                                        \
    X(EW_ERROR_INVALID_ARGUMENT, "a parameter is outside its range")                                                           \
    X(EW_ERROR_TOO_MANY_SOURCES, "more sources than the effect can hold")                                                      \
    X(EW_ERROR_OUT_OF_MEMORY, "memory is exhausted")                                                                           \
    X(EW_ERROR_MISSING_FUNCTION, "the loader does not know a GL function that is needed")                                      \
    X(EW_ERROR_UNSUPPORTED_CONTEXT, "the context is older than OpenGL 3.3 or OpenGL ES 3.0, or none is current")               \
    X(EW_ERROR_SHADER, "the driver refused a shader")                                                                          \
    X(EW_ERROR_OPENGL, "OpenGL reported an error")

typedef enum ew_result {
#define EW_RESULT_NAME(name, text) name,
    EW_RESULTS(EW_RESULT_NAME)
#undef EW_RESULT_NAME
} ew_result;

/* What went wrong: the code that the call returned and one sentence, without a newline. Left alone by calls that succeed. */
typedef struct ew_error {
    ew_result code;
    char text[240];
} ew_error;

/* The general meaning of `result`: a static string, never NULL. */
EW_API const char *ew_result_text(ew_result result);

/* ---- Sources ------------------------------------------------------------------------------------------------------------
 * In each: `coefficient` is the energy coefficient of equation (18), finite and >= 0; `color` is what the source's light
 * looks like where B = 1, linear RGB, each in [0, 65504]. Positions are finite. */

/* d(P) = |P - position|: equation (2). */
typedef struct ew_point {
    double position[3];
    double coefficient;
    double color[3];
} ew_point;

/* d(P) = distance to the infinite line through `position` along `direction`: equation (3). `direction` need not be unit, but
 * not zero. */
typedef struct ew_line {
    double position[3];
    double direction[3];
    double coefficient;
    double color[3];
} ew_line;

/* d(P) = distance to the circle of `radius` >= 0 about `center`, in the plane that `axis` is normal to: equation (7). `axis`
 * need not be unit, but not zero. */
typedef struct ew_torus {
    double center[3];
    double axis[3];
    double radius;
    double coefficient;
    double color[3];
} ew_torus;

/* d(P) = distance to the nearest point of the arc C(t) = polynomial[2] t^2 + polynomial[1] t + polynomial[0] with t in
 * [domain[0], domain[1]], the ends included: equations (8) to (13). domain[0] < domain[1]. The arc may be straight, folded
 * back on itself, or a single point.
 *
 * `weights` makes the arc brighter and darker along its length: equations (14) to (17). NULL with a count of 0: the same
 * everywhere. 1 weight is a constant, 2 are a linear ramp; from 3 on they are the control values of the clamped uniform
 * quadratic B-spline, taken at the nearest point's t. Each is in [0, 1e12]. Weight i is centred at its Greville abscissa, the
 * mean of the knots i + 1 and i + 2 of (16), not at i / (n - 1) as the paper has it. The array is copied. */
typedef struct ew_curve {
    double polynomial[3][3];
    double domain[2];
    const double *weights;
    size_t weight_count;
    double coefficient;
    double color[3];
} ew_curve;

/* The polynomial of the quadratic Bezier with the given control points, on the domain [0, 1]: equation (10). */
EW_API void ew_bezier_polynomial(double control_points[3][3], double polynomial[3][3]);

/* Fills `weights[0..count)` with the pulse that travels along a curve as the `frame` number grows: thesis (5.1). Weight i
 * wakes at frame 7 i, peaks at 1 25 frames later and is dark again at 7 i + 50; `frame` may be fractional. Outside of its
 * time, a weight is 0 (theta' = 0 makes (5.1) negative, and its clamp makes that 0). Does nothing if `weights` is NULL. */
EW_API void ew_fill_pulse_weights(double frame, double *weights, size_t count);

/* The field: lists of sources (NULL with a count of 0 for none; none at all is an empty field, and draws nothing) and the
 * floor under all distances, `epsilon` > 0: the radius of the cores inside which the field stays constant. */
typedef struct ew_sources_desc {
    const ew_point *points;
    size_t point_count;
    const ew_line *lines;
    size_t line_count;
    const ew_torus *tori;
    size_t torus_count;
    const ew_curve *curves;
    size_t curve_count;
    double epsilon;
} ew_sources_desc;

/* ---- Effect ------------------------------------------------------------------------------------------------------------- */

typedef struct ew_effect ew_effect;

typedef void (*ew_gl_function)(void);

/* Where an effect's memory comes from. Both functions are called on the threads that call the effect's. */
typedef struct ew_allocator {
    /* Returns `size` > 0 bytes, aligned as malloc aligns them, or NULL if there are none: then the call that needed them fails
     * with EW_ERROR_OUT_OF_MEMORY. */
    void *(*allocate)(void *user, size_t size);
    /* Takes back what `allocate` returned; never NULL. */
    void (*deallocate)(void *user, void *memory);
    void *user; /* handed to both */
} ew_allocator;

typedef struct ew_effect_desc {
    /* Returns the GL function called `name` of the current context, or NULL: eglGetProcAddress, glfwGetProcAddress,
     * SDL_GL_GetProcAddress or OSMesaGetProcAddress in a one-line wrapper. Called during ew_create_effect only. */
    ew_gl_function (*get_proc_address)(void *user, const char *name);
    void *user; /* handed to get_proc_address */
    /* For all memory of the effect; copied. NULL: malloc and free. */
    const ew_allocator *allocator;
} ew_effect_desc;

/* Creates an effect with no sources for the current context.
 *
 * desc:   must not be NULL, nor its get_proc_address, nor one of its allocator's functions.
 * effect: receives the effect, to be given to ew_destroy_effect; left alone on failure.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, MISSING_FUNCTION, UNSUPPORTED_CONTEXT, OPENGL.
 * GL:     the context must be current. Leaves all state as it was. */
EW_API ew_result ew_create_effect(const ew_effect_desc *desc, ew_effect **effect, ew_error *error);

/* Replaces the effect's sources. All is copied. May be called every frame: memory is only allocated for more than there was
 * ever before.
 *
 * Errors: INVALID_ARGUMENT (the text names the field, such as "curves[2].domain"), TOO_MANY_SOURCES, OUT_OF_MEMORY; the old
 *         sources stay.
 * GL:     none is called. */
EW_API ew_result ew_set_sources(ew_effect *effect, const ew_sources_desc *sources, ew_error *error);

/* Destroys the effect and its GL objects. `effect` may be NULL.
 * GL:     the context must be current; leaves all state as it was. */
EW_API void ew_destroy_effect(ew_effect *effect);

/* ---- Frame -------------------------------------------------------------------------------------------------------------- */

/* How NDC depth spans the depth buffer: [-1, 1], OpenGL's own, or [0, 1], as after glClipControl(..., GL_ZERO_TO_ONE). */
typedef enum ew_clip_depth {
    EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE,
    EW_CLIP_DEPTH_ZERO_TO_ONE,
} ew_clip_depth;

typedef enum ew_integrator {
    EW_INTEGRATOR_ADAPTIVE, /* ours: the host chooses the error */
    EW_INTEGRATOR_SIMPSON,  /* the papers': (23), with `simpson_divisions` n and n + 1 samples */
} ew_integrator;

/* The relative error of B that EW_INTEGRATOR_ADAPTIVE works for, relative to max(B, 1e-3 of the image's largest B). It is
 * estimated, not bounded: with the default, 1E_3, all but a few of the tests' scenes keep 1e-3 everywhere and 1e-4 on 99 % of
 * the pixels, and these keep 1e-2: rays through the middle of cores of a ten-millionth of the interval, and rings larger than
 * the interval. Points and lines are exact but for rounding. */
typedef enum ew_quality {
    EW_QUALITY_ERROR_1E_2,
    EW_QUALITY_ERROR_1E_3,
    EW_QUALITY_ERROR_1E_4,
} ew_quality;

/* What becomes of B and of the target's colour Cb; B_i is the share of source i. */
typedef enum ew_output {
    /* C = max(0, 1 - B) Cb + sum B_i color_i: thesis (4.8), the background's weight kept from going negative. The target's
     * alpha A becomes max(0, 1 - B) A + min(1, B): premultiplied "over". So a target cleared to 0 becomes a layer that the
     * host may lay over its picture later, with the blend factors (1, 1 - source alpha) or a compositor that expects
     * premultiplied colours. An 8-bit target clips, which is the papers' white-out; a float target stays HDR. */
    EW_OUTPUT_LERP,
    /* C = Cb + sum B_i color_i. The target's alpha is left alone. */
    EW_OUTPUT_ADD,
    /* B itself, in the red channel, blended with nothing. For tone mapping of one's own, and for tests. */
    EW_OUTPUT_LUMINANCE,
    /* How often the shader evaluated the distance to a source for this pixel, in the red channel. For profiling. */
    EW_OUTPUT_EVALUATIONS,
} ew_output;

/* What a target's values mean. The library's colours are linear and are never converted by its shaders: sRGB targets are
 * encoded once, by GL, after it has blended in linear light. GL_FRAMEBUFFER_SRGB is set for the draw as this says, whatever the
 * host left there. OpenGL ES without EXT_sRGB_write_control has no such switch: there GL encodes exactly if the format is sRGB,
 * and this says only what `dither` is to be like. */
typedef enum ew_encoding {
    EW_ENCODING_LINEAR_8BIT, /* 8 bits a channel, stored as they are, in an sRGB format too */
    EW_ENCODING_SRGB_8BIT,   /* an sRGB format, or a window's framebuffer that is sRGB capable: GL encodes */
    EW_ENCODING_FLOAT,       /* a float format, or one of more than 8 bits, stored as they are */
} ew_encoding;

/* Where the depth of the opaque scene is, which hides the light behind it. It must have been written with the frame's
 * `projection` and GL's default depth range, pixel for pixel under the target; where there is no surface, it is the far
 * plane's. A viewport or target that is smaller than the depth is fine. */
typedef enum ew_depth_source {
    /* `depth_texture`: a 2D texture, level 0, with a depth or depth-stencil format (or depths in the red channel of a float
     * format). Its swizzle, base level, compare mode, filters and depth-stencil mode do not matter. 0: nothing is opaque. */
    EW_DEPTH_TEXTURE,
    /* `depth_texture`: a multisampled 2D texture with such a format; OpenGL, and OpenGL ES from 3.1 on. A target with as many
     * samples gets, in each sample, what the light does to the background that this sample sees, at the cost of one pass a
     * sample; so what the host resolves is the mean of the samples' pictures. Any other target gets the mean over the
     * samples of a pixel: between their results, too, but over a background that has lost its samples. */
    EW_DEPTH_TEXTURE_MULTISAMPLE,
    /* The depth of `framebuffer` itself, 0 included, which the library copies to a texture of its own under the viewport
     * (and the scissor): the one way where the host draws to a window's framebuffer or to a depth renderbuffer, or keeps its
     * depth texture attached. The texture grows to the largest viewport; it is made anew, and GL's error flag cleared, where
     * the format changes or the size grows. Of a multisampled framebuffer every sample is copied and drawn with its own
     * depth, as above; but OpenGL ES makes one depth a pixel of them, as it sees fit, so that edges may be a pixel off. */
    EW_DEPTH_FRAMEBUFFER,
} ew_depth_source;

/* One frame. Start from EW_FRAME_DEFAULTS and set the camera, the interval and the target. */
typedef struct ew_frame_desc {
    /* World to view: a rotation, or a mirroring, and a translation (no scale, no shear). Sources farther from the camera, or
     * larger, than 1e6 times the interval's length are refused. */
    double view[16];
    /* View to clip: any perspective or parallel projection, off-axis, jittered, oblique, reversed or infinite. What is seen
     * must not be wider than 1e6 times the interval's length to either side of the axis. */
    double projection[16];
    ew_clip_depth clip_depth;

    /* View depths of S and E: start < end, both finite; for a perspective projection, start > 0 and end <= 1e12 start. */
    double interval_start;
    double interval_end;
    /* (21): alpha in [0, 1e12], beta in [1e-6, 1e6]. */
    double decay_alpha;
    double decay_beta;

    ew_integrator integrator;
    ew_quality quality;
    int simpson_divisions; /* even, 2 .. EW_MAX_SIMPSON_DIVISIONS */

    ew_output output;
    /* Where to draw: a framebuffer of the current context (0 is the window's) and the rectangle of it, in pixels, that the
     * projection's NDC square covers; its lower left corner and its size, which must be > 0. */
    unsigned framebuffer;
    int viewport_x;
    int viewport_y;
    int viewport_width;
    int viewport_height;
    ew_encoding encoding;
    /* 1: noise of at most half a step of an 8-bit target is added, so that faint glow does not band; 0: none. It is fixed to
     * the pixels, keeps the mean, leaves pixels without light and the alpha alone, and is nothing for EW_ENCODING_FLOAT and for
     * the outputs that are measurements. It cannot smooth where light of less than half a step darkens a brighter background.
     */
    int dither;

    ew_depth_source depth_source;
    /* For the sources that are textures; else it is not looked at. It must not be attached to `framebuffer`: GL leaves reading
     * a texture while drawing to it undefined. */
    unsigned depth_texture;

    /* 0: ew_draw leaves all state as it was. 1: it asks GL for nothing that it would have to put back, for hosts that keep
     * a cache of the state and set anew what this leaves, success or not, other than it was:
     *
     *   - the program in use, the vertex array, GL_UNIFORM_BUFFER and its indexed binding 0
     *   - the active texture unit, and of unit 0 the sampler and the 2D and multisampled 2D textures
     *   - the draw and the read framebuffer
     *   - of viewport 0: its rectangle; of draw buffer 0: blending on or off, its factors and equations, the colour mask
     *   - sample mask word 0, glPolygonMode, and the compatibility profile's glClampColor of fragments
     *   - glEnable and glDisable of GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_FRAMEBUFFER_SRGB,
     *     GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,
     *     GL_SAMPLE_SHADING, GL_POLYGON_SMOOTH, GL_COLOR_LOGIC_OP, GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCEi, GL_ALPHA_TEST,
     *     GL_POLYGON_STIPPLE, GL_DEPTH_BOUNDS_TEST_EXT
     *
     * Contexts without an indexed form of a call have it changed for all viewports or draw buffers. No object of the host's is
     * left changed. Transform feedback must not be active, unless it is paused. */
    int skip_restore;
} ew_frame_desc;

#define EW_FRAME_DEFAULTS                                                                                                      \
    {                                                                                                                          \
        .view = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},                                                              \
        .projection = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0}, .clip_depth = EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE,  \
        .interval_start = 0.1, .interval_end = 100, .decay_alpha = 1, .decay_beta = 1, .integrator = EW_INTEGRATOR_ADAPTIVE,   \
        .quality = EW_QUALITY_ERROR_1E_3, .simpson_divisions = 200, .output = EW_OUTPUT_LERP, .framebuffer = 0,                \
        .viewport_x = 0, .viewport_y = 0, .viewport_width = 0, .viewport_height = 0, .encoding = EW_ENCODING_LINEAR_8BIT,      \
        .dither = 0, .depth_source = EW_DEPTH_TEXTURE, .depth_texture = 0, .skip_restore = 0                                   \
    }

/* Draws the effect over what the framebuffer holds, where the host's scissor (that of viewport 0) and conditional rendering let
 * it: these two, and GL_DITHER, stay as the host has them.
 *
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, SHADER, OPENGL (an incomplete framebuffer, say). GL itself sees an error where
 *         depth_texture is not the kind of texture that depth_source says; ew_draw takes it out of GL's error flag, and with it
 *         what the host may have left there.
 * GL:     the context must be current. The first draw of a new mix of source kinds, integrator, output, depth and dither
 *         compiles a shader, unless ew_prepare did. Leaves all state as it was (see skip_restore), and changes only the colour
 *         of the framebuffer's first draw buffer. */
EW_API ew_result ew_draw(ew_effect *effect, const ew_frame_desc *frame, ew_error *error);

/* ---- Ahead of the draw -------------------------------------------------------------------------------------------------- */

/* Which sources a shader is made for. The numbers from 0 to 4 are exact: with few sources, a shader made for just as many is
 * the fastest. Any larger number stands for any number, also for none: EW_ANY_COUNT. */
typedef struct ew_mix {
    size_t point_count;
    size_t line_count;
    size_t torus_count;
    size_t curve_count;
    int has_weights; /* 1: curves with weights and without; 0: without */
} ew_mix;

#define EW_ANY_COUNT 5

/* Compiles ahead, so that ew_draw need not: starts to make the shader that draws `mix` as `frame` says, and asks whether it is
 * ready. Call it again, every frame or so, until it is.
 *
 * A shader is made for a mix and for the frame's integrator, output, depth and dither, and drivers may finish it only for the
 * context and the framebuffer's format that it draws with; all else in `frame` and in the sources may change freely. ew_draw
 * takes the shader for just the sources that the effect has if it is ready; else, one that is more general; and only if none is
 * ready does it wait for a compiler. So a host whose sources come and go prepares a general mix while it loads, with
 * EW_ANY_COUNT of each kind that may come, and no draw of any of them will ever wait; and, if it likes, prepares the current
 * sources too, whenever they change, to get their faster shader once that is ready. What was prepared on a loader's thread is
 * prepared once more, sooner, in the context that will draw.
 *
 * The driver compiles on threads of its own where it has GL_KHR_parallel_shader_compile; where it has not, the call waits for
 * the compiler. Once compiled, the shader is used for a first draw, all of it outside of the viewport, since some drivers only
 * finish shaders then.
 *
 * mix:      NULL for the effect's current sources.
 * frame:    as ew_draw would take it.
 * is_ready: becomes 1 if the shader is ready, else 0; left alone on failure.
 * Errors:   as ew_draw.
 * GL:       as ew_draw, but the picture is left alone. */
EW_API ew_result ew_prepare(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *is_ready, ew_error *error);

/* ---- In the host's own shaders ------------------------------------------------------------------------------------------ */

/* GLSL that computes the light of the sources along any ray: for a forward pass, a deferred one, a ray marcher, in any stage.
 * The text goes behind `#version 330` or `#version 300 es`, or a later one, and before the first use of
 *
 *     float ew_luminance(vec3 origin, vec3 direction, vec2 interval, float opaque);    // B
 *     vec4 ew_light(vec3 origin, vec3 direction, vec2 interval, float opaque);         // sum B_i color_i, and B
 *
 * `origin` is relative to the eye of the frame's view, along the world's axes: zero for view rays, and else a difference that
 * the host took in double precision. x along the ray is at origin + x direction; S is at x = interval.x and E at x =
 * interval.y, which is larger; what is opaque is at x = opaque, and hides the rest. Where `direction` has unit view depth, x is
 * the view depth, and the result is what ew_draw computes for a pixel; `direction` may as well be a unit vector, and x the
 * distance. The interval may differ from the frame's own and from ray to ray, being 1e-2 to 1e3 times as long. A part of a ray,
 * seen with the same decay, is a difference: of the light up to its end and that up to its start, given as `opaque`.
 *
 * All names of the text start with ew_ or EW_. In OpenGL ES, floats and ints are highp from there on. It has no samplers, reads
 * no built-in variables, and one uniform block, `ew_uniforms`:
 *
 *     glUniformBlockBinding(program, glGetUniformBlockIndex(program, "ew_uniforms"), binding);
 *     ew_update_uniform_buffer(effect, &frame, &buffer, NULL);    // every frame
 *     glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
 *
 * mix:        what the shader must be able to draw; NULL for the effect's current sources. The sources of the buffer must be as
 *             the mix says: just as many of a kind where the mix has an exact number, and no weights where it has none.
 * integrator: of `frame`, the shader takes the quality or the simpson_divisions from the buffer.
 * text:       receives a string that stays the effect's and is valid up to the next call of this function; left alone on
 *             failure.
 *
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY.
 * GL:     none is called. The text is good for any context whose uniform blocks are as large. */
EW_API ew_result ew_get_shader_text(ew_effect *effect, const ew_mix *mix, ew_integrator integrator, const char **text,
                                    ew_error *error);

/* Fills the buffer of the block `ew_uniforms` with the frame and the current sources.
 *
 * frame:  as ew_draw would take it; what counts is the view, the interval (sources must be within 1e6 times its length), the
 *         decay, the quality and the simpson_divisions.
 * buffer: receives the buffer's name; left alone on failure. It stays the effect's, is always the same, and holds what it was
 *         filled with up to the next call of ew_draw, ew_prepare or this function.
 * Errors: INVALID_ARGUMENT.
 * GL:     the context must be current. Leaves all state as it was. */
EW_API ew_result ew_update_uniform_buffer(ew_effect *effect, const ew_frame_desc *frame, unsigned *buffer, ew_error *error);

#ifdef __cplusplus
}
#endif

#endif
