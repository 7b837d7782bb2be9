/* Asking for all GL state. The lists follow the state tables of the specifications: OpenGL 4.6 core and 3.3 compatibility,
 * chapters "State Tables"; OpenGL ES 3.2, chapter 21. */
#include "state.h"

#include "compatibility.h"

#include <stdio.h>
#include <stdlib.h>

static void add(state *taken, const char *name, int index, int component, double value)
{
    if (taken->count == taken->capacity) {
        taken->capacity = taken->capacity ? 2 * taken->capacity : 4096;
        taken->values = realloc(taken->values, taken->capacity * sizeof *taken->values);
        if (taken->values == NULL) abort();
    }
    taken->values[taken->count++] = (state_value){name, index, component, value};
}

/* COMPATIBILITY in place of a desktop version: the compatibility profile only. */
enum { COMPATIBILITY = -1 };

typedef struct availability {
    int desktop_version;
    int es_version;
    const char *extension;
} availability;

static bool available(const availability *what)
{
    if (what->desktop_version == COMPATIBILITY) return gl.compatibility;
    return api_has(what->desktop_version, what->es_version, what->extension);
}

#define ALL                                                                                                                    \
    {                                                                                                                          \
        33, 30, NULL                                                                                                           \
    }
#define DESKTOP                                                                                                                \
    {                                                                                                                          \
        33, NEVER, NULL                                                                                                        \
    }
#define COMPAT                                                                                                                 \
    {                                                                                                                          \
        COMPATIBILITY, NEVER, NULL                                                                                             \
    }

typedef enum value_type { INTEGER, REAL } value_type;

#define Q(name) #name, name

static const struct {
    const char *name;
    GLenum enumerator;
    value_type type;
    int count;
    availability when;
} queries[] = {
    /* objects bound */
    {Q(GL_CURRENT_PROGRAM), INTEGER, 1, ALL},
    {Q(GL_PROGRAM_PIPELINE_BINDING), INTEGER, 1, {41, 31, NULL}},
    {Q(GL_VERTEX_ARRAY_BINDING), INTEGER, 1, ALL},
    {Q(GL_ARRAY_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_ELEMENT_ARRAY_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_COPY_READ_BUFFER_BINDING), INTEGER, 1, {42, 30, NULL}},
    {Q(GL_COPY_WRITE_BUFFER_BINDING), INTEGER, 1, {42, 30, NULL}},
    {Q(GL_PIXEL_PACK_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_PIXEL_UNPACK_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_UNIFORM_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_TRANSFORM_FEEDBACK_BINDING), INTEGER, 1, {40, 30, NULL}},
    {Q(GL_TRANSFORM_FEEDBACK_ACTIVE), INTEGER, 1, {40, 30, NULL}},
    {Q(GL_TRANSFORM_FEEDBACK_PAUSED), INTEGER, 1, {40, 30, NULL}},
    {Q(GL_TEXTURE_BUFFER_BINDING), INTEGER, 1, {33, 32, NULL}},
    {Q(GL_DRAW_INDIRECT_BUFFER_BINDING), INTEGER, 1, {40, 31, NULL}},
    {Q(GL_DISPATCH_INDIRECT_BUFFER_BINDING), INTEGER, 1, {43, 31, NULL}},
    {Q(GL_SHADER_STORAGE_BUFFER_BINDING), INTEGER, 1, {43, 31, NULL}},
    {Q(GL_ATOMIC_COUNTER_BUFFER_BINDING), INTEGER, 1, {42, 31, NULL}},
    {Q(GL_QUERY_BUFFER_BINDING), INTEGER, 1, {44, NEVER, NULL}},
    {Q(GL_DRAW_FRAMEBUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_READ_FRAMEBUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_RENDERBUFFER_BINDING), INTEGER, 1, ALL},
    {Q(GL_ACTIVE_TEXTURE), INTEGER, 1, ALL},
    /* transformation and rasterization */
    {Q(GL_VIEWPORT), REAL, 4, ALL},
    {Q(GL_DEPTH_RANGE), REAL, 2, ALL},
    {Q(GL_CLIP_ORIGIN), INTEGER, 1, {45, NEVER, "GL_EXT_clip_control"}},
    {Q(GL_CLIP_DEPTH_MODE), INTEGER, 1, {45, NEVER, "GL_EXT_clip_control"}},
    {Q(GL_CULL_FACE_MODE), INTEGER, 1, ALL},
    {Q(GL_FRONT_FACE), INTEGER, 1, ALL},
    {Q(GL_POLYGON_MODE), INTEGER, 2, DESKTOP},
    {Q(GL_POLYGON_OFFSET_FACTOR), REAL, 1, ALL},
    {Q(GL_POLYGON_OFFSET_UNITS), REAL, 1, ALL},
    {Q(GL_POLYGON_OFFSET_CLAMP), REAL, 1, {46, NEVER, "GL_EXT_polygon_offset_clamp"}},
    {Q(GL_LINE_WIDTH), REAL, 1, ALL},
    {Q(GL_POINT_SIZE), REAL, 1, DESKTOP},
    {Q(GL_POINT_FADE_THRESHOLD_SIZE), REAL, 1, DESKTOP},
    {Q(GL_POINT_SPRITE_COORD_ORIGIN), INTEGER, 1, DESKTOP},
    {Q(GL_PROVOKING_VERTEX), INTEGER, 1, DESKTOP},
    {Q(GL_PRIMITIVE_RESTART_INDEX), INTEGER, 1, DESKTOP},
    {Q(GL_PATCH_VERTICES), INTEGER, 1, {40, 32, NULL}},
    {Q(GL_PATCH_DEFAULT_OUTER_LEVEL), REAL, 4, {40, NEVER, NULL}},
    {Q(GL_PATCH_DEFAULT_INNER_LEVEL), REAL, 2, {40, NEVER, NULL}},
    {Q(GL_PRIMITIVE_BOUNDING_BOX_ARB), REAL, 8, {NEVER, 32, NULL}},
    {Q(GL_CLAMP_READ_COLOR), INTEGER, 1, DESKTOP},
    /* fragments */
    {Q(GL_SCISSOR_BOX), INTEGER, 4, ALL},
    {Q(GL_SAMPLE_COVERAGE_VALUE), REAL, 1, ALL},
    {Q(GL_SAMPLE_COVERAGE_INVERT), INTEGER, 1, ALL},
    {Q(GL_MIN_SAMPLE_SHADING_VALUE), REAL, 1, {40, 32, "GL_OES_sample_shading"}},
    {Q(GL_DEPTH_FUNC), INTEGER, 1, ALL},
    {Q(GL_DEPTH_WRITEMASK), INTEGER, 1, ALL},
    {Q(GL_DEPTH_CLEAR_VALUE), REAL, 1, ALL},
    {Q(GL_STENCIL_FUNC), INTEGER, 1, ALL},
    {Q(GL_STENCIL_REF), INTEGER, 1, ALL},
    {Q(GL_STENCIL_VALUE_MASK), INTEGER, 1, ALL},
    {Q(GL_STENCIL_WRITEMASK), INTEGER, 1, ALL},
    {Q(GL_STENCIL_FAIL), INTEGER, 1, ALL},
    {Q(GL_STENCIL_PASS_DEPTH_FAIL), INTEGER, 1, ALL},
    {Q(GL_STENCIL_PASS_DEPTH_PASS), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_FUNC), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_REF), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_VALUE_MASK), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_WRITEMASK), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_FAIL), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_PASS_DEPTH_FAIL), INTEGER, 1, ALL},
    {Q(GL_STENCIL_BACK_PASS_DEPTH_PASS), INTEGER, 1, ALL},
    {Q(GL_STENCIL_CLEAR_VALUE), INTEGER, 1, ALL},
    {Q(GL_BLEND_COLOR), REAL, 4, ALL},
    {Q(GL_BLEND_SRC_RGB), INTEGER, 1, ALL},
    {Q(GL_BLEND_DST_RGB), INTEGER, 1, ALL},
    {Q(GL_BLEND_SRC_ALPHA), INTEGER, 1, ALL},
    {Q(GL_BLEND_DST_ALPHA), INTEGER, 1, ALL},
    {Q(GL_BLEND_EQUATION_RGB), INTEGER, 1, ALL},
    {Q(GL_BLEND_EQUATION_ALPHA), INTEGER, 1, ALL},
    {Q(GL_LOGIC_OP_MODE), INTEGER, 1, DESKTOP},
    {Q(GL_COLOR_WRITEMASK), INTEGER, 4, ALL},
    {Q(GL_COLOR_CLEAR_VALUE), REAL, 4, ALL},
    /* pixels and hints */
    {Q(GL_PACK_ALIGNMENT), INTEGER, 1, ALL},
    {Q(GL_PACK_ROW_LENGTH), INTEGER, 1, ALL},
    {Q(GL_PACK_SKIP_ROWS), INTEGER, 1, ALL},
    {Q(GL_PACK_SKIP_PIXELS), INTEGER, 1, ALL},
    {Q(GL_PACK_IMAGE_HEIGHT), INTEGER, 1, DESKTOP},
    {Q(GL_PACK_SKIP_IMAGES), INTEGER, 1, DESKTOP},
    {Q(GL_PACK_SWAP_BYTES), INTEGER, 1, DESKTOP},
    {Q(GL_PACK_LSB_FIRST), INTEGER, 1, DESKTOP},
    {Q(GL_UNPACK_ALIGNMENT), INTEGER, 1, ALL},
    {Q(GL_UNPACK_ROW_LENGTH), INTEGER, 1, ALL},
    {Q(GL_UNPACK_SKIP_ROWS), INTEGER, 1, ALL},
    {Q(GL_UNPACK_SKIP_PIXELS), INTEGER, 1, ALL},
    {Q(GL_UNPACK_IMAGE_HEIGHT), INTEGER, 1, ALL},
    {Q(GL_UNPACK_SKIP_IMAGES), INTEGER, 1, ALL},
    {Q(GL_UNPACK_SWAP_BYTES), INTEGER, 1, DESKTOP},
    {Q(GL_UNPACK_LSB_FIRST), INTEGER, 1, DESKTOP},
    {Q(GL_LINE_SMOOTH_HINT), INTEGER, 1, DESKTOP},
    {Q(GL_POLYGON_SMOOTH_HINT), INTEGER, 1, DESKTOP},
    {Q(GL_TEXTURE_COMPRESSION_HINT), INTEGER, 1, DESKTOP},
    {Q(GL_FRAGMENT_SHADER_DERIVATIVE_HINT), INTEGER, 1, ALL},
    {Q(GL_GENERATE_MIPMAP_HINT), INTEGER, 1, {NEVER, 30, NULL}},
    {Q(GL_DEBUG_GROUP_STACK_DEPTH), INTEGER, 1, {43, 32, "GL_KHR_debug"}},
    {Q(GL_MAX_SHADER_COMPILER_THREADS_KHR), INTEGER, 1, {NEVER, NEVER, "GL_KHR_parallel_shader_compile"}},
    /* the compatibility profile */
    {Q(GL_ALPHA_TEST_FUNC), INTEGER, 1, COMPAT},
    {Q(GL_ALPHA_TEST_REF), REAL, 1, COMPAT},
    {Q(GL_CLAMP_VERTEX_COLOR), INTEGER, 1, COMPAT},
    {Q(GL_CLAMP_FRAGMENT_COLOR), INTEGER, 1, COMPAT},
    {Q(GL_CLIENT_ACTIVE_TEXTURE), INTEGER, 1, COMPAT},
    {Q(GL_COLOR_MATERIAL_FACE), INTEGER, 1, COMPAT},
    {Q(GL_COLOR_MATERIAL_PARAMETER), INTEGER, 1, COMPAT},
    {Q(GL_CURRENT_COLOR), REAL, 4, COMPAT},
    {Q(GL_CURRENT_SECONDARY_COLOR), REAL, 4, COMPAT},
    {Q(GL_CURRENT_FOG_COORD), REAL, 1, COMPAT},
    {Q(GL_CURRENT_NORMAL), REAL, 3, COMPAT},
    {Q(GL_CURRENT_RASTER_POSITION), REAL, 4, COMPAT},
    {Q(GL_CURRENT_RASTER_COLOR), REAL, 4, COMPAT},
    {Q(GL_ATTRIB_STACK_DEPTH), INTEGER, 1, COMPAT},
    {Q(GL_CLIENT_ATTRIB_STACK_DEPTH), INTEGER, 1, COMPAT},
    {Q(GL_FOG_COLOR), REAL, 4, COMPAT},
    {Q(GL_FOG_DENSITY), REAL, 1, COMPAT},
    {Q(GL_FOG_MODE), INTEGER, 1, COMPAT},
    {Q(GL_LIGHT_MODEL_AMBIENT), REAL, 4, COMPAT},
    {Q(GL_LIGHT_MODEL_TWO_SIDE), INTEGER, 1, COMPAT},
    {Q(GL_LINE_STIPPLE_PATTERN), INTEGER, 1, COMPAT},
    {Q(GL_LINE_STIPPLE_REPEAT), INTEGER, 1, COMPAT},
    {Q(GL_LIST_BASE), INTEGER, 1, COMPAT},
    {Q(GL_MATRIX_MODE), INTEGER, 1, COMPAT},
    {Q(GL_MODELVIEW_MATRIX), REAL, 16, COMPAT},
    {Q(GL_PROJECTION_MATRIX), REAL, 16, COMPAT},
    {Q(GL_MODELVIEW_STACK_DEPTH), INTEGER, 1, COMPAT},
    {Q(GL_PROJECTION_STACK_DEPTH), INTEGER, 1, COMPAT},
    {Q(GL_PERSPECTIVE_CORRECTION_HINT), INTEGER, 1, COMPAT},
    {Q(GL_RED_SCALE), REAL, 1, COMPAT},
    {Q(GL_RENDER_MODE), INTEGER, 1, COMPAT},
    {Q(GL_SHADE_MODEL), INTEGER, 1, COMPAT},
};

static const struct {
    const char *name;
    GLenum enumerator;
    availability when;
} capabilities[] = {
    {Q(GL_BLEND), ALL},
    {Q(GL_COLOR_LOGIC_OP), DESKTOP},
    {Q(GL_CULL_FACE), ALL},
    {Q(GL_DEBUG_OUTPUT), {43, 32, "GL_KHR_debug"}},
    {Q(GL_DEBUG_OUTPUT_SYNCHRONOUS), {43, 32, "GL_KHR_debug"}},
    {Q(GL_DEPTH_CLAMP), {33, NEVER, "GL_EXT_depth_clamp"}},
    {Q(GL_DEPTH_TEST), ALL},
    {Q(GL_DITHER), ALL},
    {Q(GL_FRAMEBUFFER_SRGB), {33, NEVER, "GL_EXT_sRGB_write_control"}},
    {Q(GL_LINE_SMOOTH), DESKTOP},
    {Q(GL_MULTISAMPLE), DESKTOP},
    {Q(GL_POLYGON_OFFSET_FILL), ALL},
    {Q(GL_POLYGON_OFFSET_LINE), DESKTOP},
    {Q(GL_POLYGON_OFFSET_POINT), DESKTOP},
    {Q(GL_POLYGON_SMOOTH), DESKTOP},
    {Q(GL_PRIMITIVE_RESTART), DESKTOP},
    {Q(GL_PRIMITIVE_RESTART_FIXED_INDEX), {43, 30, NULL}},
    {Q(GL_PROGRAM_POINT_SIZE), DESKTOP},
    {Q(GL_RASTERIZER_DISCARD), ALL},
    {Q(GL_SAMPLE_ALPHA_TO_COVERAGE), ALL},
    {Q(GL_SAMPLE_ALPHA_TO_ONE), DESKTOP},
    {Q(GL_SAMPLE_COVERAGE), ALL},
    {Q(GL_SAMPLE_MASK), {33, 31, NULL}},
    {Q(GL_SAMPLE_SHADING), {40, 32, "GL_OES_sample_shading"}},
    {Q(GL_SCISSOR_TEST), ALL},
    {Q(GL_STENCIL_TEST), ALL},
    {Q(GL_TEXTURE_CUBE_MAP_SEAMLESS), DESKTOP},
    {Q(GL_BLEND_ADVANCED_COHERENT_KHR), {NEVER, NEVER, "GL_KHR_blend_equation_advanced_coherent"}},
    {Q(GL_CLIP_DISTANCE0), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE1), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE2), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE3), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE4), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE5), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE6), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_CLIP_DISTANCE7), {33, NEVER, "GL_EXT_clip_cull_distance"}},
    {Q(GL_DEPTH_BOUNDS_TEST_EXT), {NEVER, NEVER, "GL_EXT_depth_bounds_test"}},
    {Q(GL_ALPHA_TEST), COMPAT},
    {Q(GL_AUTO_NORMAL), COMPAT},
    {Q(GL_COLOR_MATERIAL), COMPAT},
    {Q(GL_COLOR_SUM), COMPAT},
    {Q(GL_FOG), COMPAT},
    {Q(GL_INDEX_LOGIC_OP), COMPAT},
    {Q(GL_LIGHTING), COMPAT},
    {Q(GL_LIGHT0), COMPAT},
    {Q(GL_LINE_STIPPLE), COMPAT},
    {Q(GL_NORMALIZE), COMPAT},
    {Q(GL_POINT_SMOOTH), COMPAT},
    {Q(GL_POINT_SPRITE), COMPAT},
    {Q(GL_POLYGON_STIPPLE), COMPAT},
    {Q(GL_RESCALE_NORMAL), COMPAT},
    {Q(GL_VERTEX_PROGRAM_TWO_SIDE), COMPAT},
    {Q(GL_COLOR_ARRAY), COMPAT},
    {Q(GL_NORMAL_ARRAY), COMPAT},
    {Q(GL_VERTEX_ARRAY), COMPAT},
    {Q(GL_TEXTURE_COORD_ARRAY), COMPAT},
};

static const struct {
    const char *name;
    GLenum binding;
    availability when;
} texture_bindings[] = {
    {Q(GL_TEXTURE_BINDING_2D), ALL},
    {Q(GL_TEXTURE_BINDING_3D), ALL},
    {Q(GL_TEXTURE_BINDING_2D_ARRAY), ALL},
    {Q(GL_TEXTURE_BINDING_CUBE_MAP), ALL},
    {Q(GL_TEXTURE_BINDING_1D), DESKTOP},
    {Q(GL_TEXTURE_BINDING_1D_ARRAY), DESKTOP},
    {Q(GL_TEXTURE_BINDING_RECTANGLE), DESKTOP},
    {Q(GL_TEXTURE_BINDING_BUFFER), {33, 32, NULL}},
    {Q(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY), {40, 32, NULL}},
    {Q(GL_TEXTURE_BINDING_2D_MULTISAMPLE), {33, 31, NULL}},
    {Q(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY), {33, 32, NULL}},
    {Q(GL_SAMPLER_BINDING), ALL},
};

/* Buffer bindings with an index: the maximum, the name, and the 64-bit start and size. */
static const struct {
    const char *name;
    GLenum maximum, binding, start, size;
    availability when;
} indexed_buffers[] = {
    {"GL_UNIFORM_BUFFER", GL_MAX_UNIFORM_BUFFER_BINDINGS, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START,
     GL_UNIFORM_BUFFER_SIZE, ALL},
    {"GL_TRANSFORM_FEEDBACK_BUFFER", GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
     GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, ALL},
    {"GL_SHADER_STORAGE_BUFFER",
     GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
     GL_SHADER_STORAGE_BUFFER_BINDING,
     GL_SHADER_STORAGE_BUFFER_START,
     GL_SHADER_STORAGE_BUFFER_SIZE,
     {43, 31, NULL}},
    {"GL_ATOMIC_COUNTER_BUFFER",
     GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS,
     GL_ATOMIC_COUNTER_BUFFER_BINDING,
     GL_ATOMIC_COUNTER_BUFFER_START,
     GL_ATOMIC_COUNTER_BUFFER_SIZE,
     {42, 31, NULL}},
};

static const struct {
    const char *name;
    GLenum target;
    availability when;
} active_queries[] = {
    {Q(GL_ANY_SAMPLES_PASSED), ALL},
    {Q(GL_ANY_SAMPLES_PASSED_CONSERVATIVE), {43, 30, NULL}},
    {Q(GL_SAMPLES_PASSED), DESKTOP},
    {Q(GL_TIME_ELAPSED), DESKTOP},
    {Q(GL_PRIMITIVES_GENERATED), {33, 32, NULL}},
    {Q(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN), ALL},
};

static GLint integer(GLenum enumerator)
{
    GLint value = 0;
    gl.GetIntegerv(enumerator, &value);
    return value;
}

static void take_simple(state *taken)
{
    for (size_t i = 0; i < sizeof queries / sizeof queries[0]; i++) {
        if (!available(&queries[i].when)) continue;
        GLint integers[16] = {0};
        GLfloat floats[16] = {0};
        if (queries[i].type == INTEGER)
            gl.GetIntegerv(queries[i].enumerator, integers);
        else
            gl.GetFloatv(queries[i].enumerator, floats);
        for (int j = 0; j < queries[i].count; j++)
            add(taken, queries[i].name, 0, j, queries[i].type == INTEGER ? integers[j] : (double)floats[j]);
    }
    for (size_t i = 0; i < sizeof capabilities / sizeof capabilities[0]; i++)
        if (available(&capabilities[i].when)) add(taken, capabilities[i].name, 0, 0, gl.IsEnabled(capabilities[i].enumerator));
    for (size_t i = 0; i < sizeof active_queries / sizeof active_queries[0]; i++) {
        if (!available(&active_queries[i].when)) continue;
        GLint query = 0;
        gl.GetQueryiv(active_queries[i].target, GL_CURRENT_QUERY, &query);
        add(taken, active_queries[i].name, 0, 0, query);
    }
    if (api_has(33, 31, NULL)) {
        GLint mask = 0;
        gl.GetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
        add(taken, "GL_SAMPLE_MASK_VALUE", 0, 0, mask);
    }
}

static void take_indexed_buffers(state *taken)
{
    for (size_t i = 0; i < sizeof indexed_buffers / sizeof indexed_buffers[0]; i++) {
        if (!available(&indexed_buffers[i].when)) continue;
        GLint count = integer(indexed_buffers[i].maximum);
        for (GLint j = 0; j < count; j++) {
            GLint buffer = 0;
            GLint64 start = 0, size = 0;
            gl.GetIntegeri_v(indexed_buffers[i].binding, (GLuint)j, &buffer);
            gl.GetInteger64i_v(indexed_buffers[i].start, (GLuint)j, &start);
            gl.GetInteger64i_v(indexed_buffers[i].size, (GLuint)j, &size);
            add(taken, indexed_buffers[i].name, j, 0, buffer);
            add(taken, indexed_buffers[i].name, j, 1, (double)start);
            add(taken, indexed_buffers[i].name, j, 2, (double)size);
        }
    }
}

static void take_texture_units(state *taken)
{
    GLint active = integer(GL_ACTIVE_TEXTURE), count = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    for (size_t i = 0; i < sizeof texture_bindings / sizeof texture_bindings[0]; i++) {
        if (!available(&texture_bindings[i].when)) continue;
        for (GLint unit = 0; unit < count; unit++) {
            gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
            add(taken, texture_bindings[i].name, unit, 0, integer(texture_bindings[i].binding));
        }
    }
    for (GLint unit = 0; gl.compatibility && unit < integer(GL_MAX_TEXTURE_UNITS); unit++) {
        static const GLenum names[] = {GL_TEXTURE_1D,    GL_TEXTURE_2D,    GL_TEXTURE_3D,    GL_TEXTURE_CUBE_MAP,
                                       GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q};
        gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        for (int i = 0; i < 8; i++)
            add(taken, "fixed-function texture unit", unit, i, gl.IsEnabled(names[i]));
        GLint mode = 0;
        gl.GetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
        add(taken, "GL_TEXTURE_ENV_MODE", unit, 0, mode);
        GLfloat coordinates[4];
        gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, coordinates);
        for (int i = 0; i < 4; i++)
            add(taken, "GL_CURRENT_TEXTURE_COORDS", unit, i, (double)coordinates[i]);
    }
    gl.ActiveTexture((GLenum)active);
}

static void take_image_units(state *taken)
{
    static const struct {
        const char *name;
        GLenum enumerator;
    } image_queries[] = {{Q(GL_IMAGE_BINDING_NAME)},  {Q(GL_IMAGE_BINDING_LEVEL)},  {Q(GL_IMAGE_BINDING_LAYERED)},
                         {Q(GL_IMAGE_BINDING_LAYER)}, {Q(GL_IMAGE_BINDING_ACCESS)}, {Q(GL_IMAGE_BINDING_FORMAT)}};
    if (!api_has(42, 31, NULL)) return;
    GLint count = integer(GL_MAX_IMAGE_UNITS);
    for (GLint unit = 0; unit < count; unit++)
        for (size_t i = 0; i < sizeof image_queries / sizeof image_queries[0]; i++) {
            GLint value = 0;
            gl.GetIntegeri_v(image_queries[i].enumerator, (GLuint)unit, &value);
            add(taken, image_queries[i].name, unit, 0, value);
        }
}

/* State that each draw buffer has its own of. */
static void take_draw_buffer_state(state *taken)
{
    static const struct {
        const char *name;
        GLenum enumerator;
    } blend_queries[] = {{Q(GL_BLEND_SRC_RGB)},   {Q(GL_BLEND_DST_RGB)},      {Q(GL_BLEND_SRC_ALPHA)},
                         {Q(GL_BLEND_DST_ALPHA)}, {Q(GL_BLEND_EQUATION_RGB)}, {Q(GL_BLEND_EQUATION_ALPHA)}};
    if (!api_has(33, 32, "GL_OES_draw_buffers_indexed")) return;
    GLint count = integer(GL_MAX_DRAW_BUFFERS);
    for (GLint i = 0; i < count; i++) {
        GLint mask[4] = {0};
        gl.GetIntegeri_v(GL_COLOR_WRITEMASK, (GLuint)i, mask);
        for (int j = 0; j < 4; j++)
            add(taken, "GL_COLOR_WRITEMASK of a draw buffer", i, j, mask[j]);
        add(taken, "GL_BLEND of a draw buffer", i, 0, gl.IsEnabledi(GL_BLEND, (GLuint)i));
        for (size_t j = 0; api_has(40, 32, gl.es ? "GL_OES_draw_buffers_indexed" : "GL_ARB_draw_buffers_blend") &&
                           j < sizeof blend_queries / sizeof blend_queries[0];
             j++) {
            GLint value = 0;
            gl.GetIntegeri_v(blend_queries[j].enumerator, (GLuint)i, &value);
            add(taken, blend_queries[j].name, i, 0, value);
        }
    }
}

static void take_viewports(state *taken)
{
    if (!api_has(41, NEVER, gl.es ? "GL_OES_viewport_array" : "GL_ARB_viewport_array")) return;
    GLint count = integer(GL_MAX_VIEWPORTS);
    for (GLint i = 0; i < count; i++) {
        GLfloat viewport[4] = {0};
        GLint scissor[4] = {0};
        gl.GetFloati_v(GL_VIEWPORT, (GLuint)i, viewport);
        gl.GetIntegeri_v(GL_SCISSOR_BOX, (GLuint)i, scissor);
        for (int j = 0; j < 4; j++) {
            add(taken, "GL_VIEWPORT of the array", i, j, (double)viewport[j]);
            add(taken, "GL_SCISSOR_BOX of the array", i, j, scissor[j]);
        }
        GLfloat range[2] = {0};
        gl.GetFloati_v(GL_DEPTH_RANGE, (GLuint)i, range);
        add(taken, "GL_DEPTH_RANGE of the array", i, 0, (double)range[0]);
        add(taken, "GL_DEPTH_RANGE of the array", i, 1, (double)range[1]);
        add(taken, "GL_SCISSOR_TEST of the array", i, 0, gl.IsEnabledi(GL_SCISSOR_TEST, (GLuint)i));
    }
}

static void take_vertex_arrays(state *taken, const state_objects *objects)
{
    static const struct {
        const char *name;
        GLenum enumerator;
    } attribute_queries[] = {{Q(GL_VERTEX_ATTRIB_ARRAY_ENABLED)},    {Q(GL_VERTEX_ATTRIB_ARRAY_SIZE)},
                             {Q(GL_VERTEX_ATTRIB_ARRAY_STRIDE)},     {Q(GL_VERTEX_ATTRIB_ARRAY_TYPE)},
                             {Q(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED)}, {Q(GL_VERTEX_ATTRIB_ARRAY_INTEGER)},
                             {Q(GL_VERTEX_ATTRIB_ARRAY_DIVISOR)},    {Q(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)}};
    GLint bound = integer(GL_VERTEX_ARRAY_BINDING), count = integer(GL_MAX_VERTEX_ATTRIBS);
    for (int i = 0; i < objects->vertex_array_count; i++) {
        gl.BindVertexArray(objects->vertex_arrays[i]);
        add(taken, "GL_ELEMENT_ARRAY_BUFFER_BINDING of a vertex array", i, 0, integer(GL_ELEMENT_ARRAY_BUFFER_BINDING));
        for (GLint attribute = 0; attribute < count; attribute++)
            for (size_t j = 0; j < sizeof attribute_queries / sizeof attribute_queries[0]; j++) {
                GLint value = 0;
                gl.GetVertexAttribiv((GLuint)attribute, attribute_queries[j].enumerator, &value);
                add(taken, attribute_queries[j].name, 100 * i + attribute, 0, value);
            }
    }
    gl.BindVertexArray((GLuint)bound);
    /* Attribute 0 has no current value in the compatibility profile. */
    for (GLint attribute = gl.compatibility ? 1 : 0; attribute < count; attribute++) {
        GLfloat value[4] = {0};
        gl.GetVertexAttribfv((GLuint)attribute, GL_CURRENT_VERTEX_ATTRIB, value);
        for (int j = 0; j < 4; j++)
            add(taken, "GL_CURRENT_VERTEX_ATTRIB", attribute, j, (double)value[j]);
    }
}

static void take_framebuffers(state *taken, const state_objects *objects)
{
    GLint draw = integer(GL_DRAW_FRAMEBUFFER_BINDING), read = integer(GL_READ_FRAMEBUFFER_BINDING);
    GLint draw_buffers = integer(GL_MAX_DRAW_BUFFERS);
    for (int i = 0; i < objects->framebuffer_count; i++) {
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, objects->framebuffers[i]);
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, objects->framebuffers[i]);
        for (GLint j = 0; j < draw_buffers; j++)
            add(taken, "GL_DRAW_BUFFERi", i, j, integer(GL_DRAW_BUFFER0 + (GLenum)j));
        add(taken, "GL_READ_BUFFER", i, 0, integer(GL_READ_BUFFER));
        static const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1, GL_DEPTH_ATTACHMENT,
                                             GL_STENCIL_ATTACHMENT};
        for (int j = 0; j < 4; j++) {
            GLint type = 0, name = 0;
            gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachments[j], GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE,
                                                   &type);
            if (type != GL_NONE)
                gl.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachments[j],
                                                       GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
            add(taken, "GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME", i, j, name);
        }
    }
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)draw);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, (GLuint)read);
}

static void take_textures(state *taken, const state_objects *objects)
{
    static const struct {
        const char *name;
        GLenum enumerator;
        availability when;
        bool sampled; /* not a parameter of multisampled textures */
    } parameters[] = {
        {Q(GL_TEXTURE_SWIZZLE_R), ALL, false},
        {Q(GL_TEXTURE_SWIZZLE_G), ALL, false},
        {Q(GL_TEXTURE_SWIZZLE_B), ALL, false},
        {Q(GL_TEXTURE_SWIZZLE_A), ALL, false},
        {Q(GL_DEPTH_STENCIL_TEXTURE_MODE), {43, 31, "GL_ARB_stencil_texturing"}, false},
        {Q(GL_TEXTURE_BASE_LEVEL), ALL, true},
        {Q(GL_TEXTURE_MAX_LEVEL), ALL, true},
        {Q(GL_TEXTURE_MIN_FILTER), ALL, true},
        {Q(GL_TEXTURE_MAG_FILTER), ALL, true},
        {Q(GL_TEXTURE_COMPARE_MODE), ALL, true},
        {Q(GL_DEPTH_TEXTURE_MODE), COMPAT, true},
    };
    GLint active = integer(GL_ACTIVE_TEXTURE), bound[2] = {0};
    bool multisampled = api_has(33, 31, NULL);
    gl.ActiveTexture(GL_TEXTURE0);
    bound[0] = integer(GL_TEXTURE_BINDING_2D);
    if (multisampled) bound[1] = integer(GL_TEXTURE_BINDING_2D_MULTISAMPLE);
    for (int i = 0; i < objects->texture_count; i++) {
        GLenum target = objects->textures[i].target;
        gl.BindTexture(target, objects->textures[i].name);
        for (size_t j = 0; j < sizeof parameters / sizeof parameters[0]; j++) {
            if (!available(&parameters[j].when) || (parameters[j].sampled && target != GL_TEXTURE_2D)) continue;
            GLint value = 0;
            gl.GetTexParameteriv(target, parameters[j].enumerator, &value);
            add(taken, parameters[j].name, i, 0, value);
        }
    }
    gl.BindTexture(GL_TEXTURE_2D, (GLuint)bound[0]);
    if (multisampled) gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, (GLuint)bound[1]);
    gl.ActiveTexture((GLenum)active);
}

static void take_objects(state *taken, const state_objects *objects)
{
    for (int i = 0; i < objects->buffer_count; i++) {
        GLint bound = integer(GL_ARRAY_BUFFER_BINDING), size = 0;
        gl.BindBuffer(GL_ARRAY_BUFFER, objects->buffers[i]);
        gl.GetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &size);
        gl.BindBuffer(GL_ARRAY_BUFFER, (GLuint)bound);
        add(taken, "GL_BUFFER_SIZE", i, 0, size);
    }
    static const GLenum sampler_parameters[] = {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S,
                                                GL_TEXTURE_COMPARE_MODE};
    for (int i = 0; i < objects->sampler_count; i++)
        for (int j = 0; j < 4; j++) {
            GLint value = 0;
            gl.GetSamplerParameteriv(objects->samplers[i], sampler_parameters[j], &value);
            add(taken, "sampler parameter", i, j, value);
        }
    for (int i = 0; i < objects->program_count; i++) {
        GLint linked = 0, deleted = 0;
        add(taken, "glIsProgram", i, 0, gl.IsProgram(objects->programs[i]));
        if (!gl.IsProgram(objects->programs[i])) continue;
        gl.GetProgramiv(objects->programs[i], GL_LINK_STATUS, &linked);
        gl.GetProgramiv(objects->programs[i], GL_DELETE_STATUS, &deleted);
        add(taken, "GL_LINK_STATUS", i, 0, linked);
        add(taken, "GL_DELETE_STATUS", i, 0, deleted);
    }
}

static void take_compatibility(state *taken)
{
    static const GLenum packing[] = {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS};
    GLint pack_buffer = integer(GL_PIXEL_PACK_BUFFER_BINDING), pack_alignment = integer(GL_PACK_ALIGNMENT), pack[3];
    for (int i = 0; i < 3; i++) {
        pack[i] = integer(packing[i]);
        gl.PixelStorei(packing[i], 0);
    }
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    GLubyte stipple[128] = {0};
    gl.GetPolygonStipple(stipple);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, (GLuint)pack_buffer);
    gl.PixelStorei(GL_PACK_ALIGNMENT, pack_alignment);
    for (int i = 0; i < 3; i++)
        gl.PixelStorei(packing[i], pack[i]);
    for (int i = 0; i < 128; i++)
        add(taken, "polygon stipple", i, 0, stipple[i]);
    for (int i = 0; i < 6; i++) {
        GLdouble plane[4] = {0};
        gl.GetClipPlane(GL_CLIP_DISTANCE0 + (GLenum)i, plane);
        for (int j = 0; j < 4; j++)
            add(taken, "clip plane", i, j, plane[j]);
    }
}

void state_take(state *taken, const state_objects *objects)
{
    taken->count = 0;
    take_simple(taken);
    take_indexed_buffers(taken);
    take_texture_units(taken);
    take_image_units(taken);
    take_draw_buffer_state(taken);
    take_viewports(taken);
    take_vertex_arrays(taken, objects);
    take_framebuffers(taken, objects);
    take_objects(taken, objects);
    take_textures(taken, objects);
    if (gl.compatibility) take_compatibility(taken);
}

int state_count_differences(const state *before, const state *after)
{
    int differences = before->count != after->count;
    if (differences) fprintf(stderr, "%zu values before, %zu after\n", before->count, after->count);
    for (size_t i = 0; i < before->count && i < after->count; i++) {
        const state_value *old = &before->values[i], *new = &after->values[i];
        if (old->value == new->value) continue;
        if (differences++ < 10)
            fprintf(stderr, "%s [%d].%d was %.9g (0x%x), is %.9g (0x%x)\n", old->name, old->index, old->component, old->value,
                    (unsigned)(long long)old->value, new->value, (unsigned)(long long)new->value);
    }
    return differences;
}

void state_free(state *taken)
{
    free(taken->values);
    *taken = (state){0};
}
