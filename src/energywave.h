/*
 * EnergyWave: a drop-in OpenGL effect that draws the glow of a continuous field of energy.
 *
 * Every pixel is the line integral, along its view ray, of a field that is defined everywhere in space. There are two
 * integrals.
 *
 * The world integral is for games. Source i has a core of radius r, inside which its field is constant, and a reach R > r, at
 * which it ends:
 *
 *     psi_i(P) = c_i w_i max(0, 1 / max(r', d_i(P)) - 1 / R_i)
 *     B = sum over the sources of  integral from the eye to the opaque scene of  psi_i  dx
 *
 * c is the coefficient, w the weight, d(P) the distance to the source, x the distance along the ray in world units. A parallel
 * projection integrates from its near plane. B has no unit: a source looks the same in metres and in miles, and from any
 * distance. r' is r, made wider where a pixel is about as wide: see `core_pixels` in ew_frame_desc.
 *
 * The papers' integral is over an interval of view depths, with a decay that dims distant light. A frame with an interval asks
 * for it:
 *
 *     psi_i(P) = c_i w_i / max(r', d_i(P)),  less c_i w_i / R_i and not negative where the source has a reach
 *     B = sum over the sources of  integral from 0 to s_max of  psi_i(L(s)) * alpha / (s + beta)^2  ds
 *
 * L(s) = S + s (E - S) is the ray through the pixel's centre, with S at view depth `interval_start` and E at `interval_end`.
 * s_max is where the ray meets the host's opaque scene, at most 1. The formulas are from Watanabe, Abe, Konno: "Real-Time
 * Rendering Technique for Visual Expression of Arbitrary-Shaped Energy Wave", equations (2), (3), (7), (13), (17), (18), (20)
 * and (21); thesis (3.2) adds the lower limit of the distance. With alpha = beta = 1 and E twice as far away as S, the decay is
 * exactly the inverse square of the distance from the eye, scaled to 1 at S.
 *
 * A fragment shader on a quad over the viewport computes the whole integral, for all sources in one pass; or, of many kinds, in
 * one for each of a few parts.
 *
 *     ew_effect *effect;
 *     ew_create_effect(&(ew_effect_desc){.get_proc_address = my_loader}, &effect, NULL);
 *     ew_point orb = {.position = {0, 1, 0}, .brightness = 1, .color = {0.2, 0.5, 1}, .core = 0.1, .reach = 2};
 *     ew_set_sources(effect, &(ew_sources_desc){.points = &orb, .point_count = 1}, NULL);
 *     ew_frame_desc frame = EW_FRAME_DEFAULTS;                    // every frame, after the opaque scene:
 *     ...                                                         // camera, target, opaque depth
 *     ew_draw(effect, &frame, NULL);
 *     ew_destroy_effect(effect);
 *
 * In C++, from C++11 on, members are set one by one: ew_point orb = {}; orb.core = 0.1; ...
 *
 * Space and units. Sources are given in the host's world space, and lengths in world units, in double precision. The library
 * brings sources into the camera's space before it rounds to float, so distance from the world's origin costs no accuracy.
 * Colours are linear RGB. Matrices are column-major, for column vectors, as in OpenGL. View space looks along -z; *view depth*
 * is -z there.
 *
 * Errors. Every function that can fail returns an `ew_result` and takes an `ew_error`, which may be NULL. On failure the error
 * holds the same code and a sentence that names the field and says how to correct it. A failed call changes nothing: neither
 * the effect, nor GL state, nor the picture. The library never prints and never aborts.
 *
 * Threads. An effect may be used in the context that created it, and in any that shares objects with that one and has the same
 * API, version, profile and loader. A function that takes an effect needs one of these contexts to be current on its thread.
 * Only one call at a time may use an effect. Different effects are independent, on different threads too. The library has no
 * threads, locks or global variables, so the host must keep two calls for one effect apart. When an effect moves from one
 * context to another, the host must also synchronise the two as GL requires: by a glFinish in the first, or by a fence that the
 * second waits for. So a loading thread may create and prepare (ew_prepare) an effect in a context of its own, and another
 * thread may draw it. Contexts do not share framebuffers: a frame's `framebuffer` belongs to the current context. Functions
 * that take no effect are pure.
 *
 * GL. The library creates no context and links no GL. It needs OpenGL 3.3 or OpenGL ES 3.0, or later. Each call leaves all GL
 * state as it found it, unless the frame sets `skip_restore`.
 */
#ifndef ENERGYWAVE_H
#define ENERGYWAVE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(EW_STATIC)
#define EW_API
#elif defined(_WIN32)
#define EW_API __declspec(dllimport)
#else
#define EW_API __attribute__((visibility("default")))
#endif

#define EW_VERSION_MAJOR 0
#define EW_VERSION_MINOR 1
#define EW_VERSION_PATCH 0

/* The memory that sources take is counted in units of 16 bytes. A point takes 2 units, a line or a torus 3, a curve 6. A curve
 * with n weights takes n - 2 units more, and at least one more. Where a source has a reach or a core of its own, each takes one
 * more. All sources of an effect together take at most EW_MAX_SOURCE_UNITS. A uniform block holds about 930 units everywhere,
 * and 4000 on most contexts; ew_draw takes more than that from a texture. */
#define EW_MAX_SOURCE_UNITS 65536
/* The largest count of each kind, in an effect that has no other kind. */
#define EW_MAX_POINTS (EW_MAX_SOURCE_UNITS / 2)
#define EW_MAX_LINES (EW_MAX_SOURCE_UNITS / 3)
#define EW_MAX_TORI (EW_MAX_SOURCE_UNITS / 3)
#define EW_MAX_CURVES (EW_MAX_SOURCE_UNITS / 6)
#define EW_MAX_PATHS (EW_MAX_SOURCE_UNITS / 5)
/* The largest count of weights of one curve. */
#define EW_MAX_WEIGHTS 1024

/* The largest number of divisions that EW_INTEGRATOR_SIMPSON takes. */
#define EW_MAX_SIMPSON_DIVISIONS 4096

/* All results: EW_RESULTS(X) expands X(name, text) for each. ew_result_text returns the text. */
#define EW_RESULTS(X)                                                                                                          \
    X(EW_OK, "success")                                                                                                        \
    X(EW_ERROR_INVALID_ARGUMENT, "a parameter is outside its range")                                                           \
    X(EW_ERROR_TOO_MANY_SOURCES, "more sources than there is room for")                                                        \
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

/* What went wrong: the code that the call returned, and one sentence without a newline. A successful call does not touch it. */
typedef struct ew_error {
    ew_result code;
    char text[240];
} ew_error;

/* Returns what `result` means in general: a static string, never NULL. */
EW_API const char *ew_result_text(ew_result result);

/* ---- Sources ------------------------------------------------------------------------------------------------------------
 * A source of any kind ends with the same members. All may be left at 0 that do not matter to it.
 *
 * coefficient  c of the field, equation (18): finite and >= 0. Or else
 * brightness   of a source with a reach: the luminance B through the middle of an orb, or of a long straight beam that is seen
 * from the side, whatever the unit of length. It stands for the coefficient brightness / (2 ln(reach / core)). Finite and
 *              >= 0; not together with a coefficient.
 * color        the colour of the light where B = 1: linear RGB, each component in [0, 65504].
 * core         the radius r of the core, in world units. 0: the `epsilon` of ew_sources_desc.
 * reach        the distance R at which the light ends, in world units, > core. 0: none, which only the papers' integral allows.
 * sharpness    of a source with a reach, >= 1; 0 stands for 1. Above 1 the glow falls off faster, like neon, at the same
 *              brightness b in the middle: the source's B becomes b g(B / b), with g(x) = x^sharpness for x <= 1 and
 *              1 + sharpness (x - 1) beyond.
 *
 * Positions are finite. */

/* d(P) = |P - position|: equation (2). */
typedef struct ew_point {
    double position[3];
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_point;

/* d(P) = distance to the infinite line through `position` along `direction`: equation (3). `direction` may have any length but
 * zero. */
typedef struct ew_line {
    double position[3];
    double direction[3];
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_line;

/* d(P) = distance to the circle of `radius` >= 0 about `center`, in the plane perpendicular to `axis`: equation (7). `axis` may
 * have any length but zero. */
typedef struct ew_torus {
    double center[3];
    double axis[3];
    double radius;
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_torus;

/* d(P) = distance to the nearest point of the arc C(t) = polynomial[2] t^2 + polynomial[1] t + polynomial[0] with t in
 * [domain[0], domain[1]], the ends included: equations (8) to (13). domain[0] < domain[1]. The arc may be straight, folded
 * back on itself, or a single point.
 *
 * `weights` varies the brightness along the arc: equations (14) to (17). NULL with a count of 0 means the same brightness
 * everywhere. One weight is a constant factor, two are a linear ramp. Three or more are the control values of a clamped uniform
 * quadratic B-spline, evaluated at the nearest point's t. Each weight is in [0, 1e12]. Weight i is centred at its Greville
 * abscissa, the mean of the knots i + 1 and i + 2 of (16), not at i / (n - 1) as in the paper. The array is copied. */
typedef struct ew_curve {
    double polynomial[3][3];
    double domain[2];
    const double *weights;
    size_t weight_count;
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_curve;

/* The points of a path, and what is between them. */
typedef enum ew_path_kind {
    /* Straight pieces from point to point; two points are a straight beam. */
    EW_PATH_POLYLINE,
    /* A uniform quadratic B-spline. The points in between are the middle control points of the pieces, which join half way
     * between them. It begins at the first point and ends at the last, unless it is closed. */
    EW_PATH_BSPLINE,
    /* Cubic Bezier curves: 3 n + 1 points, each curve starting at the last point of the one before. Cannot be closed. */
    EW_PATH_BEZIER,
    /* A uniform Catmull-Rom spline through all points. At an open end the missing neighbour is the mirrored one. */
    EW_PATH_CATMULL_ROM,
} ew_path_kind;

/* A chain of pieces that shines as one: its joints are no brighter than the rest. The field is the sum of the pieces' fields,
 * each by the distance to its nearest point, less a point's field at each joint, with the weight there. Each cubic piece
 * becomes the fewest equal parts that are quadratic within 3e-4 of the core's radius.
 *
 * points:      as many as the kind needs: 2 or more; a closed path and EW_PATH_BSPLINE 3 or more; EW_PATH_BEZIER 3 n + 1. The
 *              array is copied.
 * is_closed:   1: the path goes on from its last point to its first. 0: it does not.
 * weights:     as for curves, over the whole path. Each span between control points has an equal share of the parameter. If the
 *              first and the last differ, the weight jumps where a path closes.
 *
 * A path has at most EW_MAX_PATH_PIECES pieces. Of the effect's capacity it takes 5 units, or 6 with a reach or a core of its
 * own; for each piece 2, or 7 if any is bent; and, with n weights, n - 2 more, at least one. */
#define EW_MAX_PATH_PIECES 600

typedef struct ew_path {
    ew_path_kind kind;
    const double (*points)[3];
    size_t point_count;
    int is_closed;
    const double *weights;
    size_t weight_count;
    double coefficient;
    double color[3];
    double brightness;
    double core;
    double reach;
    double sharpness;
} ew_path;

/* Computes the polynomial, on the domain [0, 1], of the quadratic Bezier curve with three control points: equation (10). */
EW_API void ew_bezier_polynomial(const double start[3], const double middle[3], const double end[3], double polynomial[3][3]);

/* Fills `weights[0..count)` with a pulse that travels along a curve as `frame`, a frame number, grows: thesis (5.1). Weight i
 * rises from frame 7 i, reaches its peak of 1 at 7 i + 25 and is back at 0 at 7 i + 50. Before and after that it is 0: theta' =
 * 0 makes (5.1) negative, and its clamp makes that 0. `frame` may be fractional. Does nothing if `weights` is NULL. */
EW_API void ew_fill_pulse_weights(double frame, double *weights, size_t count);

/* The field. A list of sources may be NULL with a count of 0; a field without any source draws nothing. `epsilon` is the core's
 * radius of the sources that have no `core` of their own: > 0, or 0 if there are none. */
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
    const ew_path *paths;
    size_t path_count;
} ew_sources_desc;

/* ---- Effect ------------------------------------------------------------------------------------------------------------- */

typedef struct ew_effect ew_effect;

typedef void (*ew_gl_function)(void);

/* Where an effect's memory comes from. The library calls both functions on the thread that called the library. */
typedef struct ew_allocator {
    /* Returns `size` > 0 bytes, aligned as by malloc, or NULL if there is no memory. The call that needed it then fails with
     * EW_ERROR_OUT_OF_MEMORY. */
    void *(*allocate)(void *user, size_t size);
    /* Frees memory that `allocate` returned. `memory` is never NULL. */
    void (*deallocate)(void *user, void *memory);
    void *user; /* passed to both functions */
} ew_allocator;

typedef struct ew_effect_desc {
    /* Returns the current context's GL function of this name, or NULL if there is none. It wraps eglGetProcAddress,
     * glfwGetProcAddress, SDL_GL_GetProcAddress or OSMesaGetProcAddress in one line. Only ew_create_effect calls it. */
    ew_gl_function (*get_proc_address)(void *user, const char *name);
    void *user; /* passed to get_proc_address */
    /* Allocates all memory of the effect. The structure is copied. NULL means malloc and free. */
    const ew_allocator *allocator;
} ew_effect_desc;

/* Creates an effect without sources, for the current context.
 *
 * desc:   not NULL. Its get_proc_address, and both functions of its allocator, if it has one, must not be NULL either.
 * effect: receives the effect, which the host must pass to ew_destroy_effect. Unchanged on failure.
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, MISSING_FUNCTION, UNSUPPORTED_CONTEXT, OPENGL.
 * GL:     the context must be current. Leaves all state as it was. */
EW_API ew_result ew_create_effect(const ew_effect_desc *desc, ew_effect **effect, ew_error *error);

/* Replaces the effect's sources by a copy of these. May be called every frame: it allocates memory only when there are more
 * sources than ever before.
 *
 * Errors: INVALID_ARGUMENT (the text names the field, such as "curves[2].domain"), TOO_MANY_SOURCES, OUT_OF_MEMORY. On failure
 *         the effect keeps its old sources.
 * GL:     calls none. */
EW_API ew_result ew_set_sources(ew_effect *effect, const ew_sources_desc *sources, ew_error *error);

/* Destroys the effect and its GL objects. `effect` may be NULL.
 * GL:     a context of the effect must be current; leaves all state as it was. If there is none any more, call
 *         ew_abandon_effect. */
EW_API void ew_destroy_effect(ew_effect *effect);

/* Lets go of an effect whose context is lost, or gone: frees its memory and leaves its GL objects to the context that had them.
 * Their names may be those of other objects in a new context, where ew_destroy_effect would delete these. `effect` may be NULL.
 * GL:     calls none, and needs no context. */
EW_API void ew_abandon_effect(ew_effect *effect);

/* ---- Frame -------------------------------------------------------------------------------------------------------------- */

/* The range of NDC depth: [-1, 1], OpenGL's default, or [0, 1], as set by glClipControl(..., GL_ZERO_TO_ONE). */
typedef enum ew_clip_depth {
    EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE,
    EW_CLIP_DEPTH_ZERO_TO_ONE,
} ew_clip_depth;

typedef enum ew_integrator {
    EW_INTEGRATOR_ADAPTIVE, /* ours: aims for the relative error that `quality` says */
    EW_INTEGRATOR_SIMPSON,  /* the papers' Simpson's rule, (23): `simpson_divisions` n takes n + 1 samples */
} ew_integrator;

/* The error of B that EW_INTEGRATOR_ADAPTIVE aims for, relative to max(B, 1e-3 of the image's largest B). It is estimated, not
 * bounded. With the default, 1E_3, all but a few of the tests' scenes stay within 1e-3 everywhere and within 1e-4 on 99 % of
 * the pixels. Three stay within 1e-2: their rays pass through the middle of cores of a ten-millionth of the interval, or their
 * tori are larger than the interval. Of random scenes of the world integral without fog and media, one and a half pixels in
 * a thousand of tori are beyond 1e-3, by rounding, and of the others one in a thousand. Points and lines are exact except for
 * rounding. */
typedef enum ew_quality {
    EW_QUALITY_ERROR_1E_2,
    EW_QUALITY_ERROR_1E_3,
    EW_QUALITY_ERROR_1E_4,
} ew_quality;

/* At how many pixels the light is integrated. */
typedef enum ew_resolution {
    EW_RESOLUTION_FULL, /* at every pixel */
    /* At every eighth pixel of every eighth row, and at every pixel where that is not enough: at cores, at silhouettes of the
     * opaque scene, at the edges of reaches, where the light of curves has a crease, and near sources that reach less than
     * 12 pixels. The other pixels are interpolated. That adds at most 1e-3 of max(B, 0.03 of the picture's largest B), or
     * what another `quality` is named by.
     *
     * It is for EW_INTEGRATOR_ADAPTIVE. The picture is as with FULL if it has fewer than 65,536 pixels, or no more to
     * integrate than two points or lines or one straight beam without a reach, if its output is EW_OUTPUT_EVALUATIONS, or if
     * the context cannot draw to float textures (OpenGL ES before 3.2 without EXT_color_buffer_float). Takes 0.58 bytes of GL
     * memory for each pixel of the largest viewport, allocated when a viewport is larger than any before. */
    EW_RESOLUTION_ADAPTIVE,
} ew_resolution;

/* What ew_draw writes. Cb is the colour that the target had, and B_i is source i's share of B. */
typedef enum ew_output {
    /* C = max(0, 1 - B) Cb + sum B_i color_i: thesis (4.8), with the background's weight clamped at 0. The target's alpha A
     * becomes max(0, 1 - B) A + min(1, B), which is premultiplied "over". So a target cleared to 0 becomes a layer that the
     * host may composite later, with the blend factors (1, 1 - source alpha) or in a compositor that expects premultiplied
     * colours. An 8-bit target clips, which is the papers' white-out; a float target stays HDR. */
    EW_OUTPUT_LERP,
    /* C = Cb + sum B_i color_i. The target's alpha stays as it is. */
    EW_OUTPUT_ADD,
    /* C = 1 - (1 - Cb) exp(-sum B_i color_i), for each channel: it never clips, and runs from the colour to white without
     * contours. For targets that show what they hold, with colours in [0, 1]. The target's alpha stays as it is. */
    EW_OUTPUT_SOFT,
    /* The light that falls on the opaque scene: C = (1 + E) Cb for each channel, with the irradiance E of ew_irradiance (see
     * ew_get_shader_text) and the target's colour as the albedo. Draw it first, and the glow itself over it. It needs a
     * light_reach and an opaque depth, from which it takes places and, without a normal_texture, normals. The exposure counts;
     * integrator, quality, resolution, interval, fog and dither do not matter, nor do the sources' reaches and sharpness. The
     * target's alpha stays as it is. A target of 8 or 10 bits takes E only up to 1. */
    EW_OUTPUT_SURFACES,
    /* B itself, in the red channel, without blending. For tone mapping by the host, and for tests. */
    EW_OUTPUT_LUMINANCE,
    /* How many times the shader evaluated the distance to a source for this pixel, in the red channel. For profiling. */
    EW_OUTPUT_EVALUATIONS,
} ew_output;

/* How the target encodes colours. The library's colours are linear, and its shaders never convert them: GL encodes for an sRGB
 * target, once, after blending in linear light. For the draw, the library sets GL_FRAMEBUFFER_SRGB to match, whatever the host
 * had set. OpenGL ES without EXT_sRGB_write_control has no such switch: there GL encodes exactly if the format is sRGB, and the
 * encoding given here only decides the form of `dither`. */
typedef enum ew_encoding {
    EW_ENCODING_LINEAR_8BIT,  /* 8 bits a channel, stored without conversion, even in an sRGB format */
    EW_ENCODING_SRGB_8BIT,    /* an sRGB format, or an sRGB capable window: GL encodes */
    EW_ENCODING_FLOAT,        /* a float format, or one of more than 8 bits a channel, stored without conversion */
    EW_ENCODING_LINEAR_10BIT, /* 10 bits a channel (RGB10_A2), stored without conversion; `dither` fits its steps */
    EW_ENCODING_FLOAT_11BIT,  /* small floats (R11F_G11F_B10F), stored without conversion; `dither` fits their steps */
} ew_encoding;

/* Where to read the depth of the opaque scene, which hides the light behind it. Its pixels must be those of the target; the
 * viewport and the target may be smaller, and only pixels that are on both need a depth. Depth in the form of a depth buffer
 * must have been written with the frame's `projection` and GL's default depth range, and must be the far plane's where there is
 * no surface. */
typedef enum ew_depth_source {
    /* Level 0 of `depth_texture`, a 2D texture of a depth or depth-stencil format, or of a float format with the depth in its
     * red channel. Its swizzle, base level, compare mode, filters and depth-stencil mode do not matter. 0 means that nothing is
     * opaque. */
    EW_DEPTH_TEXTURE,
    /* `depth_texture`, a multisampled 2D texture of such a format. Needs OpenGL, or OpenGL ES 3.1. If the target has as many
     * samples, each sample gets the light up to the surface that it sees, so the host resolves finished samples. As a
     * rasteriser does, the library shades a surface once a pixel, at the pixel's centre, for all samples that see it; contexts
     * before OpenGL 4.0 and OpenGL ES 3.2 shade each sample of a silhouette. Any other target gets each pixel's light averaged
     * over the depth samples, drawn over a background that no longer has samples of its own. */
    EW_DEPTH_TEXTURE_MULTISAMPLE,
    /* The depth of `framebuffer` itself, which may be 0. The library copies the part under the viewport (and the scissor) to a
     * texture of its own. Nothing else works if the host draws to a window's framebuffer or to a depth renderbuffer, or keeps
     * its depth texture attached. The copy grows to the largest viewport. When the format changes or the copy grows, it is
     * allocated anew and GL's error flag is cleared. Of a multisampled framebuffer, OpenGL copies every sample, and they
     * are drawn as above. OpenGL ES reduces the samples to one depth a pixel, in a way of its own choice, so
     * edges may be a pixel off. */
    EW_DEPTH_FRAMEBUFFER,
    /* Level 0 of `depth_texture`, a 2D texture of a float format, with the view depth in world units in its red channel,
     * whatever the projection: of a deferred renderer, or of one whose depth buffer is logarithmic. Where there is no surface
     * it must be infinite, or beyond all light. 0 means that nothing is opaque. */
    EW_DEPTH_TEXTURE_LINEAR,
} ew_depth_source;

/* How a texture has unit normals n. */
typedef enum ew_normal_encoding {
    EW_NORMAL_WORLD,        /* n along the axes of the world, of a signed format */
    EW_NORMAL_VIEW,         /* n along the axes of the view */
    EW_NORMAL_WORLD_BIASED, /* (n + 1) / 2, of an unsigned format */
    EW_NORMAL_VIEW_BIASED,
} ew_normal_encoding;

/* Fog, which pales the light on its way to the eye as it pales the opaque scene, which is the host's to fog: what a source
 * sheds at a place of a ray counts exp(-integral of the extinction), over the way from the eye to that place (in a parallel
 * projection, from the near plane). The extinction is the same everywhere or, with a `scale`, falls with height as
 *
 *     extinction exp(-(height - base) / scale),        height: along `up`, in world units
 *
 * Light behind more than 40 optical depths, 4e-18 of itself, does not count. A source's `sharpness` shapes what is left of its
 * luminance, so it makes fog thicker. The fog scatters no light: a halo is the host's. */
typedef struct ew_fog {
    double extinction; /* per world unit, in [0, 1e12]; at `base`, if there is a scale. 0: no fog */
    double up[3];      /* of any length but zero; ignored without a scale */
    double base;       /* a height: where the extinction is as above; ignored without a scale */
    double scale;      /* in world units: how far up the extinction falls to 1 / e; 0: it is the same everywhere */
} ew_fog;

/* What a medium fills, of the places center + x half_axes[0] + y half_axes[1] + z half_axes[2]. */
typedef enum ew_medium_shape {
    EW_MEDIUM_BOX,       /* |x|, |y| and |z| at most 1 */
    EW_MEDIUM_ELLIPSOID, /* x^2 + y^2 + z^2 at most 1; with three axes of one length, at right angles, a sphere */
} ew_medium_shape;

/* A body of a homogeneous medium: smoke, the inside of a force field, tinted glass. With the extinction tau, the albedo a and
 * the ambient light L^a, a piece of a ray of length l in it
 *
 *     lets exp(-tau l) of what is behind it through, be that light of the sources or the opaque scene, and
 *     shines with a L^a (1 - exp(-tau l)):
 *
 * equations (3) to (5) of Zsolnai and Szirmay-Kalos, "Order Independent Transparency with Per-Pixel Linked Lists". Where bodies
 * overlap, their extinctions add up, and so do the products tau a L^a. Fog dims a body's own light, too; but what the host has
 * made of fog before the body is dimmed as part of the opaque scene. */
typedef struct ew_medium {
    ew_medium_shape shape;
    double center[3];
    double half_axes[3][3]; /* need not be at right angles, but must span a space */
    double extinction;      /* per world unit, in [0, 1e12] */
    double albedo;          /* what part of the light that it stops it scatters, in [0, 1] */
    double ambient[3];      /* the light that comes from all around: linear RGB, each component in [0, 65504] */
} ew_medium;

/* How many media a frame may have. */
#define EW_MAX_MEDIA 16

/* One frame. Start from EW_FRAME_DEFAULTS and set the camera and the target. The defaults suit a window of 8 bits a channel: a
 * composite that does not clip, with dither. For a float target set `encoding`, and an output that keeps what is above 1. */
typedef struct ew_frame_desc {
    /* World to view: a rotation or a reflection, and a translation; no scale, no shear. Where rounding in floats has made it
     * drift, by up to 1e-3 in each entry of R^T R and 1e-6 in the last row, the rotation next to it is taken, with the same
     * eye. A source may be neither larger, nor farther from the camera, than 1e6 times the interval's length. */
    double view[16];
    /* View to clip: any perspective or parallel projection, including off-axis, jittered, oblique, reversed and infinite ones.
     * The view may extend to at most 1e6 times the interval's length on either side of the axis. Where the host has set
     * glClipControl(GL_UPPER_LEFT, ...), the light is turned over as the host's own drawing is: the matrix stays the same. */
    double projection[16];
    ew_clip_depth clip_depth;

    /* 0 and 0: the world integral. Else the papers': view depths of S and E, start < end, both finite; for a perspective
     * projection, start > 0 and end <= 1e12 start. */
    double interval_start;
    double interval_end;
    /* (21), of the papers' integral: alpha in [0, 1e12], beta in [1e-6, 1e6]. Without an interval, both must be 1. */
    double decay_alpha;
    double decay_beta;
    /* How many pixels wide a core is at the least, in [0, 64]: at view depth z the core's radius is r' = sqrt(r^2 +
     * (core_pixels / 2 * p)^2), with p the height of a pixel at z in world units. So thin beams neither crawl nor flicker, and
     * fade with distance as antialiasing would. 0: cores are as they are, for figures. EW_CORE_PIXELS_DEFAULT: 1.5 in the world
     * integral, 0 in the papers'. */
    double core_pixels;
    /* A factor on all colours, in [0, 1e6]. */
    double exposure;
    /* Of the light that sources shed on surfaces: the factor g on it, in [0, 1e6], and the distance from a source at which it
     * ends, in world units; 0: there is no such light. See ew_irradiance at ew_get_shader_text. */
    double light_gain;
    double light_reach;
    /* Of EW_OUTPUT_SURFACES: 0: without shadows. Else how thick, in world units, opaque things are taken to be, of which depth
     * tells the front alone; what passes deeper behind that is lit. */
    double shadow_thickness;
    ew_fog fog;
    /* Bodies that dim the light, at most EW_MAX_MEDIA; NULL with a count of 0. The outputs that are pictures, LERP, ADD and
     * SOFT, draw the bodies first, over the target: Cb becomes T Cb + L, where T is what they let through and L their own
     * light, times the exposure. With LERP the target's alpha A becomes T A + 1 - T. So of several effects in one scene, one
     * alone may draw a picture with the bodies that are seen. EW_OUTPUT_SURFACES knows of no media. Each call reads the array
     * and does not keep it. */
    const ew_medium *media;
    size_t medium_count;

    ew_integrator integrator;
    ew_quality quality;
    int simpson_divisions; /* even, 2 .. EW_MAX_SIMPSON_DIVISIONS */
    ew_resolution resolution;

    ew_output output;
    /* Where to draw: a framebuffer of the current context (0 is the window's). Its draw buffer 0 must have an image that is not
     * of integers, and a single layer: of an array, a cube map or a target of several views, attach one layer at a time. */
    unsigned framebuffer;
    /* The rectangle in it, in pixels, that the projection's NDC square covers. x and y are its lower left corner; width and
     * height must be > 0, and at most what the context says at GL_MAX_VIEWPORT_DIMS. */
    int viewport_x;
    int viewport_y;
    int viewport_width;
    int viewport_height;
    ew_encoding encoding;
    /* 1 adds noise of at most half a step of the target, so that faint glow does not band; 0 adds none. The noise stays with
     * its pixel from frame to frame and does not change the mean. Alpha, pixels without light, EW_ENCODING_FLOAT and the
     * outputs that are measurements get none. Where light of less than half a step darkens a brighter background, bands
     * remain. */
    int dither;

    ew_depth_source depth_source;
    /* The texture, if `depth_source` is one of the textures; ignored otherwise. It must not be attached to `framebuffer`:
     * reading a texture while drawing to it is undefined in GL. */
    unsigned depth_texture;
    /* Of EW_OUTPUT_SURFACES: level 0 of a 2D texture with the unit normals of opaque surfaces in its red, green and blue
     * channels, pixel by pixel as depth_texture, and what `normal_encoding` says of it. Its filters do not matter, its swizzle
     * and base level do. It must not be attached to `framebuffer`. 0: normals are found from depth. */
    unsigned normal_texture;
    ew_normal_encoding normal_encoding;

    /* 1: the host's stencil test stays as it is, on or off, so that light is drawn only where a portal or a mirror is, say. Its
     * operations apply, too, wherever the effect draws, which leaves out much of what no source can light; the host sets the
     * same for front and back faces. 0: the test is off. */
    int keep_stencil_test;

    /* 0: ew_draw leaves all state as it was. 1: it saves and restores nothing. That is for hosts that keep their own cache of
     * GL's state; whether the call succeeds or fails, they must then set the following anew:
     *
     *   - the program in use, the vertex array, GL_UNIFORM_BUFFER and its indexed bindings 0 and 1
     *   - the active texture unit, the 2D textures of the units 0 to 6, unit 0's multisampled 2D texture, and these units'
     *     samplers: there are none bound afterwards, so that a host which knows no samplers need not mind
     *   - the draw framebuffer and the read framebuffer
     *   - viewport 0's rectangle; draw buffer 0's blend enable, blend factors, blend equations and colour mask
     *   - glPolygonMode; in the compatibility profile glClampColor for fragments; before OpenGL 4.0 and OpenGL ES 3.2 word 0 of
     *     the sample mask
     *   - glEnable and glDisable of GL_CULL_FACE, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD, GL_FRAMEBUFFER_SRGB,
     *     GL_MULTISAMPLE, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,
     *     GL_SAMPLE_SHADING, GL_POLYGON_SMOOTH, GL_POINT_SMOOTH, GL_POINT_SPRITE, GL_PROGRAM_POINT_SIZE, GL_COLOR_LOGIC_OP,
     *     GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCEi, GL_ALPHA_TEST, GL_POLYGON_STIPPLE, GL_DEPTH_BOUNDS_TEST_EXT
     *
     * Where a context lacks the indexed form of a call, the state of all viewports or draw buffers is changed. None of the
     * host's objects is left changed. Transform feedback must be inactive or paused. */
    int skip_restore;
} ew_frame_desc;

#define EW_CORE_PIXELS_DEFAULT -1.0

/* By position, because C++ knows no designators before C++20: in the order of the members, and none left out. */
#define EW_FRAME_DEFAULTS                                                                                                      \
    {                                                                                                                          \
        {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},          /* view */                                                  \
            {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0}, /* projection */                                            \
            EW_CLIP_DEPTH_NEGATIVE_ONE_TO_ONE,                     /* clip_depth */                                            \
            0, 0,                                                  /* interval_start, interval_end */                          \
            1, 1,                                                  /* decay_alpha, decay_beta */                               \
            EW_CORE_PIXELS_DEFAULT,                                /* core_pixels */                                           \
            1,                                                     /* exposure */                                              \
            1, 0, 0,                                               /* light_gain, light_reach, shadow_thickness */             \
            {0, {0, 1, 0}, 0, 0},                                  /* fog: extinction, up, base, scale */                      \
            0, 0,                                                  /* media, medium_count */                                   \
            EW_INTEGRATOR_ADAPTIVE, EW_QUALITY_ERROR_1E_3, 200,    /* integrator, quality, simpson_divisions */                \
            EW_RESOLUTION_ADAPTIVE,                                /* resolution */                                            \
            EW_OUTPUT_SOFT,                                        /* output */                                                \
            0, 0, 0, 0, 0,                                         /* framebuffer, viewport_x, _y, _width, _height */          \
            EW_ENCODING_LINEAR_8BIT, 1,                            /* encoding, dither */                                      \
            EW_DEPTH_TEXTURE, 0,                                   /* depth_source, depth_texture */                           \
            0, EW_NORMAL_WORLD,                                    /* normal_texture, normal_encoding */                       \
            0, 0                                                   /* keep_stencil_test, skip_restore */                       \
    }

/* Draws the effect over what the framebuffer holds. The host's scissor (that of viewport 0), conditional rendering and
 * GL_DITHER stay in force.
 *
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY, SHADER, OPENGL (for example, the framebuffer is incomplete). If depth_texture is not
 *         the kind of texture that depth_source says, GL records an error of its own; ew_draw clears it, together with any that
 *         the host may have left in GL's error flag.
 * GL:     the context must be current. The first draw with a new combination of what ew_prepare names compiles a shader,
 *         unless ew_prepare already has. Leaves all state as it was (but see skip_restore), and changes only the colour of the
 *         framebuffer's first draw buffer. */
EW_API ew_result ew_draw(ew_effect *effect, const ew_frame_desc *frame, ew_error *error);

/* What the sources can light of a frame: a rectangle of the viewport, in pixels of the target, and view depths. */
typedef struct ew_bounds {
    int x, y, width, height; /* width or height 0: nothing is lit */
    double depth_start;      /* view depths, in world units; 0 or less: the eye is in the light */
    double depth_end;        /* HUGE_VAL: without end, as infinite lines */
} ew_bounds;

/* Says what the sources can light at the most (with EW_OUTPUT_SURFACES, on surfaces within the light_reach), and where a
 * picture's media are seen, so that the host can skip the draw, set a scissor, or sort. In the papers' integral a source
 * without a reach lights everything in the interval.
 *
 * frame:  as ew_draw would take it.
 * bounds: receives the bounds; unchanged on failure.
 * Errors: INVALID_ARGUMENT, as ew_draw would; but it is not checked whether sources are too far away.
 * GL:     the context must be current: its clip origin is asked for. Changes nothing. */
EW_API ew_result ew_get_bounds(ew_effect *effect, const ew_frame_desc *frame, ew_bounds *bounds, ew_error *error);

/* ---- Compiling ahead ---------------------------------------------------------------------------------------------------- */

/* Which sources a shader can draw. A count of 0 or 1 is exact. A larger one, such as EW_ANY_COUNT, stands for any number of
 * sources, including none. With has_reach, and but for EW_INTEGRATOR_SIMPSON, ew_draw takes the shader for any number from one
 * source on. */
typedef struct ew_mix {
    size_t point_count;
    size_t line_count;
    size_t torus_count;
    size_t curve_count;
    int has_weights; /* 1: curves and paths with or without weights; 0: only without */
    size_t path_count;
    int has_reach;     /* 1: a source has a reach or a core of its own; 0: none has. Always 1 in the world integral */
    int has_sharpness; /* 1: sources with or without sharpness; 0: only without */
    int has_joints;    /* 1: paths of any number of pieces; 0: straight beams only */
    int has_bends;     /* 1: paths with or without bent pieces; 0: polylines only */
    int has_many; /* 1: more sources than a uniform block takes (see EW_MAX_SOURCE_UNITS); 0: no more than that. Shaders for
                   * one of both draw nothing of the other. ew_get_shader_text has no shader for more. */
} ew_mix;

#define EW_ANY_COUNT 2

/* Compiles ahead of time, so that ew_draw need not wait: starts to compile the shader that draws `mix` as `frame` says, or the
 * few that do, and reports whether it is ready. Call it again, every frame or so, until it is.
 *
 * One shader for all kinds would take long to compile. So where curves or bent paths come together with other kinds, and in
 * fog and with shadows, what is straight (points, lines, beams), polylines, bent paths, tori and curves have a shader each,
 * which many mixes share; and so they do on software rasterisers at adaptive resolution, which then draw each only where it
 * shines. Their light is summed up before it is composited, in a texture of 16 bytes for each pixel of the largest viewport,
 * allocated when one is larger than any before. There is one shader for all where the context cannot blend in float textures
 * (OpenGL ES without EXT_float_blend), for EW_INTEGRATOR_SIMPSON, and for what sees several surfaces in a pixel of a
 * multisampled depth.
 *
 * A shader depends on the mix, on the frame's integrator, output, depth and dither, and on whether it has an interval,
 * core_pixels, fog, even or by height, and media. The driver may also finish it only for the context and the framebuffer format
 * of its first draw. Everything else in `frame` and in the sources may change freely.
 *
 * If the shader for exactly the effect's sources is ready, ew_draw uses it; or else a more general one that is ready. Only if
 * there is neither does it wait for the compiler. So a host whose sources come and go prepares a general mix while it loads,
 * with EW_ANY_COUNT for each kind that may come, and once more with has_many if there may be so many; no draw of these then
 * waits. It may also prepare the current sources whenever they change, to draw with their faster shader once that is ready. A
 * shader that was prepared on a loading thread must be prepared once more in the context that will draw, which is quicker.
 *
 * A call takes one step of three at the most: it compiles a shader, or links it, or makes its first draw, in which some drivers
 * finish it; that is outside of the viewport. If the driver has GL_KHR_parallel_shader_compile and compiles on threads of its
 * own, no call waits for these, and a call takes a step with each shader, but draws with one. Others compile, link or draw
 * while they are called, so a call takes as long as its step.
 *
 * mix:      NULL means the effect's current sources.
 * frame:    as for ew_draw.
 * is_ready: becomes 1 if the shader is ready, or else 0. Unchanged on failure.
 * Errors:   as for ew_draw.
 * GL:       as for ew_draw, but the picture does not change. */
EW_API ew_result ew_prepare(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *is_ready, ew_error *error);

/* The same, for a host that shows how far it has come: steps_left receives how many steps are left, 0 if the shader is ready.
 * While the driver is at work on its threads, a call leaves the count as it was. */
EW_API ew_result ew_prepare_step(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, int *steps_left,
                                 ew_error *error);

/* ---- The light in the host's own shaders -------------------------------------------------------------------------------- */

/* Returns GLSL that computes the light of the sources along any ray, in any shader stage: for a forward or a deferred pass, or
 * a ray marcher. The text goes after the line `#version 330` or `#version 300 es`, or a later version, and before the first use
 * of
 *
 *     float ew_luminance(vec3 origin, vec3 direction, float opaque);    // B
 *     vec4 ew_light(vec3 origin, vec3 direction, float opaque);         // sum B_i color_i, and B
 *
 * of the world integral, from x = 0 to x = opaque; or, of the papers' integral,
 *
 *     float ew_luminance(vec3 origin, vec3 direction, vec2 interval, float opaque);
 *     vec4 ew_light(vec3 origin, vec3 direction, vec2 interval, float opaque);
 *
 * The ray is origin + x direction. `origin` is relative to the eye of the frame's view, along the world's axes: zero for view
 * rays; for others, the host subtracts the eye in double precision. S is at x = interval.x and E at x = interval.y, which is
 * larger. Whatever is opaque is at x = opaque, and hides the rest of the ray. If `direction` has unit view depth, x is the view
 * depth, and the result is what ew_draw computes for a pixel; `direction` may also be a unit vector, and x the distance. The
 * interval may differ from the frame's and from ray to ray; it may be 1e-2 to 1e3 times as long as the frame's. The light of a
 * part of the ray, with the same decay, is a difference: the light up to the part's end minus the light up to its start, each
 * given as `opaque`.
 *
 * With a light_reach in the frame there is also
 *
 *     vec3 ew_irradiance(vec3 position, vec3 normal);
 *
 * the light that a surface at `position`, relative to the eye along the world's axes, receives from all sources as thin
 * emitters along their shapes. l is the unit vector from the surface to a place C of the source, d its distance, r the core's
 * radius, L the light_reach, g the light_gain, and the normal n a unit vector:
 *
 *     E = g sum of color_i c_i  integral along the source of  w max(0, n . l) (1 / m - m / L^2)^2 |dC|,    m = max(r, d) < L
 *
 * and of a point, r in the place of the integral of w |dC|. A diffuse surface shines with its albedo times E. In the papers'
 * integral, coefficients count as they are, without alpha. Error 1e-2 of the picture's largest.
 *
 *     vec3 ew_specular(vec3 position, vec3 normal, vec3 to_eye, float roughness);
 *
 * what a glossy surface there mirrors of them towards the eye, where it reflects all light: multiply it by the surface's
 * reflectance, such as Schlick's approximation of Fresnel's. `to_eye` is a vector of any length, the roughness in [0.1, 1]. In
 * the place of max(0, n . l) stands Phong's lobe about the mirrored view R, (p + 1) / (2 pi) max(0, R . l)^p where n . l > 0,
 * with p = 2 / roughness^4 - 2, at least 1, which matches the peak of GGX without its long tails and its stretch at grazing
 * angles. Outside of cores it is off by 3 % of all light at most, on bent sources at a low roughness.
 *
 * With media in the frame there is also
 *
 *     vec4 ew_media_light(vec3 origin, vec3 direction, float opaque);
 *
 * what the media do to what is opaque at x = opaque, from x = 0 on: rgb is their own light, to be added to the opaque colour
 * times a, the share that they let through. The light of the sources comes over that.
 *
 * All names in the text start with ew_ or EW_. In OpenGL ES, floats and ints are highp from there on. The text has no samplers,
 * reads no built-in variables, and has one uniform block, `ew_uniforms`:
 *
 *     glUniformBlockBinding(program, glGetUniformBlockIndex(program, "ew_uniforms"), binding);
 *     ew_update_uniform_buffer(effect, &frame, &buffer, NULL);    // every frame
 *     glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer);
 *
 * mix:        the sources that the shader can draw; NULL means the effect's current ones. The sources in the buffer must match
 *             it: exactly as many of a kind where the mix has an exact count, no weights where has_weights is 0, and has_reach
 *             as they need it, because the block's layout depends on it.
 * frame:      which integral the text computes, and by which integrator; core_pixels, if they are 0; whether there is fog,
 *             even or by height, or a light_reach, or are media. All else comes from the buffer.
 * text:       receives a string that belongs to the effect and is valid until the next call of this function. Unchanged on
 *             failure.
 *
 * Errors: INVALID_ARGUMENT, OUT_OF_MEMORY.
 * GL:     calls none. The text suits any context whose uniform blocks are as large. */
EW_API ew_result ew_get_shader_text(ew_effect *effect, const ew_mix *mix, const ew_frame_desc *frame, const char **text,
                                    ew_error *error);

/* Fills the buffer of the block `ew_uniforms` with the frame and the current sources.
 *
 * frame:  as for ew_draw, whichever output it has: a frame of EW_OUTPUT_SURFACES will do, too. What it says of the target, of
 *         depth and of shadows does not matter, but for the viewport, by whose pixels core_pixels counts. Sources must be
 *         within 1e6 times the interval's length.
 * buffer: receives the buffer's name. Unchanged on failure. The buffer belongs to the effect, is always the same one, and keeps
 *         its contents until the next call of ew_draw, ew_prepare or this function.
 * Errors: INVALID_ARGUMENT, TOO_MANY_SOURCES if the context's uniform blocks are too small for the sources.
 * GL:     the context must be current. Leaves all state as it was. */
EW_API ew_result ew_update_uniform_buffer(ew_effect *effect, const ew_frame_desc *frame, unsigned *buffer, ew_error *error);

#ifdef __cplusplus
}
#endif

#endif
