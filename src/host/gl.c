/* Loading the host's GL functions. */
#include "host/gl.h"

#include "base/error.h"
#include "model/layout.h"

#include <stdio.h>
#include <string.h>

typedef struct function_loader {
    ew_gl_function (*get_proc_address)(void *user, const char *name);
    void *user;
    char missing[128]; /* the names of functions that were not found, as many as fit */
    int missing_count;
    bool missing_unnamed; /* some names did not fit */
} function_loader;

static ew_gl_function load_function(function_loader *loader, const char *name, const char *suffix)
{
    char full_name[64];
    snprintf(full_name, sizeof full_name, "gl%s%s", name, suffix);
    ew_gl_function function = loader->get_proc_address(loader->user, full_name);
    if (function == NULL) {
        size_t length = strlen(loader->missing), space = sizeof loader->missing - length;
        const char *separator = length == 0 ? "" : ", ";
        if (strlen(separator) + strlen(full_name) < space)
            snprintf(loader->missing + length, space, "%s%s", separator, full_name);
        else
            loader->missing_unnamed = true;
        loader->missing_count++;
    }
    return function;
}

#define LOAD(type, name) gl->name = (type)load_function(loader, #name, suffix);
#define DEFINE_LOAD(group, FUNCTIONS)                                                                                          \
    static void load_##group(ew_gl *gl, function_loader *loader, const char *suffix)                                           \
    {                                                                                                                          \
        FUNCTIONS(LOAD)                                                                                                        \
    }
DEFINE_LOAD(common, EW_GL_FUNCTIONS)
DEFINE_LOAD(indexed_mask, EW_GL_INDEXED_MASK_FUNCTIONS)
DEFINE_LOAD(indexed_blend, EW_GL_INDEXED_BLEND_FUNCTIONS)
DEFINE_LOAD(multisample, EW_GL_MULTISAMPLE_FUNCTIONS)
DEFINE_LOAD(texture_query, EW_GL_TEXTURE_QUERY_FUNCTIONS)
DEFINE_LOAD(viewport_array, EW_GL_VIEWPORT_ARRAY_FUNCTIONS)
DEFINE_LOAD(clip_control, EW_GL_CLIP_CONTROL_FUNCTIONS)
DEFINE_LOAD(pipeline, EW_GL_PIPELINE_FUNCTIONS)
DEFINE_LOAD(transform_feedback, EW_GL_TRANSFORM_FEEDBACK_FUNCTIONS)
DEFINE_LOAD(desktop, EW_GL_DESKTOP_FUNCTIONS)
DEFINE_LOAD(compatibility, EW_GL_COMPATIBILITY_FUNCTIONS)
#undef DEFINE_LOAD
#undef LOAD

static bool has_extension(const ew_gl *gl, const char *name)
{
    GLint count = 0;
    gl->GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; i++) {
        const char *extension = (const char *)gl->GetStringi(GL_EXTENSIONS, (GLuint)i);
        if (extension && strcmp(extension, name) == 0) return true;
    }
    return false;
}

/* A limit that the core profile dropped. */
enum { ES_ALIASED_POINT_SIZE_RANGE = 0x846D };

/* In place of a version: no version has the functions, only an extension. */
enum { NEVER = 1000 };

/* A version that has a group of functions, or an extension that has them under names that end in `suffix`. */
typedef struct group_source {
    bool es;
    int version;
    const char *extension;
    const char *suffix;
} group_source;

static const struct group {
    void (*load)(ew_gl *gl, function_loader *loader, const char *suffix);
    group_source sources[4];
} groups[] = {
    {load_indexed_mask,
     {{false, 30, NULL, ""},
      {true, 32, NULL, ""},
      {true, NEVER, "GL_OES_draw_buffers_indexed", "OES"},
      {true, NEVER, "GL_EXT_draw_buffers_indexed", "EXT"}}},
    {load_indexed_blend,
     {{false, 40, "GL_ARB_draw_buffers_blend", "ARB"},
      {true, 32, NULL, ""},
      {true, NEVER, "GL_OES_draw_buffers_indexed", "OES"},
      {true, NEVER, "GL_EXT_draw_buffers_indexed", "EXT"}}},
    {load_multisample, {{false, 32, NULL, ""}, {true, 31, NULL, ""}}},
    {load_texture_query, {{false, 45, "GL_ARB_direct_state_access", ""}}},
    {load_viewport_array, {{false, 41, "GL_ARB_viewport_array", ""}, {true, NEVER, "GL_OES_viewport_array", "OES"}}},
    {load_pipeline, {{false, 41, "GL_ARB_separate_shader_objects", ""}, {true, 31, "GL_EXT_separate_shader_objects", "EXT"}}},
    {load_transform_feedback, {{false, 40, "GL_ARB_transform_feedback2", ""}, {true, 30, NULL, ""}}},
    {load_desktop, {{false, 30, NULL, ""}}},
};

/* Loads a group if the source has it. What a version promises must be there. An extension may be listed without its functions:
 * a browser knows more of them than the loader of a program that was compiled for it. It then counts as absent. */
static bool load_from(const struct group *group, const group_source *source, ew_gl *gl, function_loader *loader)
{
    if (source->es != gl->es || source->version == 0) return false;
    if (gl->version >= source->version) {
        group->load(gl, loader, "");
        return true;
    }
    if (!source->extension || !has_extension(gl, source->extension)) return false;
    ew_gl with_extension = *gl;
    function_loader tried = *loader;
    group->load(&with_extension, &tried, source->suffix);
    if (tried.missing_count > loader->missing_count) return false;
    *gl = with_extension;
    return true;
}

static void load_groups(ew_gl *gl, function_loader *loader)
{
    for (size_t i = 0; i < sizeof groups / sizeof groups[0]; i++) {
        size_t source = 0, count = sizeof groups[i].sources / sizeof groups[i].sources[0];
        while (source < count && !load_from(&groups[i], &groups[i].sources[source], gl, loader))
            source++;
    }
    if (gl->compatibility) load_compatibility(gl, loader, "");
}

static void find_unwanted_capabilities(ew_gl *gl)
{
    enum {
        COMPATIBILITY_ALPHA_TEST = 0x0BC0,
        COMPATIBILITY_POLYGON_STIPPLE = 0x0B42,
        COMPATIBILITY_POINT_SMOOTH = 0x0B10,
        DEPTH_BOUNDS_TEST_EXT = 0x8890,
    };
    const struct {
        GLenum capability;
        bool known;
    } candidates[] = {
        {GL_CULL_FACE, true},
        {GL_DEPTH_TEST, true},
        {GL_STENCIL_TEST, true},
        {GL_SAMPLE_ALPHA_TO_COVERAGE, true},
        {GL_SAMPLE_COVERAGE, true},
        {GL_RASTERIZER_DISCARD, true},
        {GL_SAMPLE_MASK, gl->version >= (gl->es ? 31 : 32)},
        {GL_SAMPLE_SHADING, gl->es ? gl->version >= 32 || has_extension(gl, "GL_OES_sample_shading")
                                   : gl->version >= 40 || has_extension(gl, "GL_ARB_sample_shading")},
        {GL_SAMPLE_ALPHA_TO_ONE, !gl->es},
        {GL_POLYGON_SMOOTH, !gl->es},
        {GL_COLOR_LOGIC_OP, !gl->es},
        {GL_PRIMITIVE_RESTART, !gl->es},
        {COMPATIBILITY_ALPHA_TEST, gl->compatibility},
        {COMPATIBILITY_POLYGON_STIPPLE, gl->compatibility},
        {COMPATIBILITY_POINT_SMOOTH, gl->compatibility},
        {DEPTH_BOUNDS_TEST_EXT, !gl->es && has_extension(gl, "GL_EXT_depth_bounds_test")},
    };
    for (size_t i = 0; i < sizeof candidates / sizeof candidates[0]; i++)
        if (candidates[i].known) gl->unwanted_capabilities[gl->unwanted_capability_count++] = candidates[i].capability;

    GLint clip_distances = 0;
    if (!gl->es || has_extension(gl, "GL_EXT_clip_cull_distance")) gl->GetIntegerv(GL_MAX_CLIP_DISTANCES, &clip_distances);
    for (GLint i = 0; i < clip_distances && gl->unwanted_capability_count < EW_GL_MAX_CAPABILITIES; i++)
        gl->unwanted_capabilities[gl->unwanted_capability_count++] = GL_CLIP_DISTANCE0 + (GLenum)i;
}

bool ew_gl_is_software(const char *renderer)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast", "Software", "SwiftShader", "Microsoft Basic Render"};
    for (size_t i = 0; renderer && i < sizeof names / sizeof names[0]; i++)
        if (strstr(renderer, names[i])) return true;
    return false;
}

/* Browsers list extensions that are not switched on. There, the loader has no function for them, and a query is an error. */
static bool has_clip_control(const ew_gl *gl, const function_loader *loader)
{
    if (gl->es)
        return has_extension(gl, "GL_EXT_clip_control") && loader->get_proc_address(loader->user, "glClipControlEXT") != NULL;
    return gl->version >= 45 || has_extension(gl, "GL_ARB_clip_control");
}

void ew_gl_allocate(const ew_gl *gl, GLenum target, GLint internal_format, GLsizei width, GLsizei height, GLenum format,
                    GLenum type)
{
    GLint unpack_buffer = 0;
    gl->GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpack_buffer);
    gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl->TexImage2D(target, 0, internal_format, width, height, 0, format, type, NULL);
    if (unpack_buffer != 0 && gl->IsBuffer((GLuint)unpack_buffer))
        gl->BindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)unpack_buffer);
}

bool ew_gl_is_upside_down(const ew_gl *gl)
{
    GLint origin = GL_LOWER_LEFT;
    if (gl->clip_control) gl->GetIntegerv(GL_CLIP_ORIGIN, &origin);
    return origin == GL_UPPER_LEFT;
}

static ew_result fail_missing(const function_loader *loader, ew_error *error)
{
    return ew_fail(error, EW_ERROR_MISSING_FUNCTION, "desc.get_proc_address returned NULL for %d function%s: %s%s",
                   loader->missing_count, loader->missing_count == 1 ? "" : "s", loader->missing,
                   loader->missing_unnamed ? ", ..." : "");
}

ew_result ew_gl_load(ew_gl *gl, ew_gl_function (*get_proc_address)(void *user, const char *name), void *user, ew_error *error)
{
    function_loader loader = {.get_proc_address = get_proc_address, .user = user};
    *gl = (ew_gl){0};

    load_common(gl, &loader, "");
    if (gl->GetString == NULL) return fail_missing(&loader, error);

    /* Contexts older than 3.0 have the version only as a string, not as the integer GL_MAJOR_VERSION. */
    const char *version = (const char *)gl->GetString(GL_VERSION);
    if (version == NULL)
        return ew_fail(error, EW_ERROR_UNSUPPORTED_CONTEXT, "no GL context is current: glGetString(GL_VERSION) returned NULL");
    gl->es = strncmp(version, "OpenGL ES", 9) == 0;
    gl->web = strstr(version, "WebGL") != NULL;
    const char *number = version + strcspn(version, "0123456789");
    int major = 0, minor = 0;
    if (sscanf(number, "%d.%d", &major, &minor) != 2) major = minor = 0;
    gl->version = 10 * major + minor;
    if (gl->version < (gl->es ? 30 : 33))
        return ew_fail(error, EW_ERROR_UNSUPPORTED_CONTEXT,
                       "the current context's version is \"%.60s\"; OpenGL 3.3 or OpenGL ES 3.0 is needed", version);
    if (loader.missing_count > 0) return fail_missing(&loader, error);

    if (!gl->es) {
        GLint profile = 0;
        gl->GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
        gl->compatibility = (profile & GL_CONTEXT_CORE_PROFILE_BIT) == 0;
    }
    load_groups(gl, &loader);
    if (loader.missing_count > 0) return fail_missing(&loader, error);

    gl->parallel_shader_compile =
        has_extension(gl, "GL_KHR_parallel_shader_compile") || has_extension(gl, "GL_ARB_parallel_shader_compile");
    gl->GetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &gl->max_uniform_block_size);
    GLint outputs = 0, inputs = 0;
    gl->GetIntegerv(GL_MAX_VERTEX_OUTPUT_COMPONENTS, &outputs);
    gl->GetIntegerv(GL_MAX_FRAGMENT_INPUT_COMPONENTS, &inputs);
    gl->max_varying_vectors = (outputs < inputs ? outputs : inputs) / 4 - 1;
    gl->GetIntegerv(GL_MAX_DRAW_BUFFERS, &gl->max_draw_buffers);
    gl->GetIntegerv(GL_MAX_VIEWPORT_DIMS, gl->max_viewport);
    gl->software = ew_gl_is_software((const char *)gl->GetString(GL_RENDERER));
    GLfloat point_sizes[2] = {0, 0};
    gl->GetFloatv(gl->es ? ES_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE, point_sizes);
    bool draws_floats = !gl->es || gl->version >= 32 || has_extension(gl, "GL_EXT_color_buffer_float");
    gl->float_targets = point_sizes[1] >= EW_CELL_SIZE * EW_BLOCK_CELLS && draws_floats;
    gl->float_sums = draws_floats && (!gl->es || has_extension(gl, "GL_EXT_float_blend"));
    gl->clip_control = has_clip_control(gl, &loader);
    if (gl->clip_control) load_clip_control(gl, &loader, gl->es ? "EXT" : "");
    if (loader.missing_count > 0) return fail_missing(&loader, error);
    gl->framebuffer_srgb = !gl->es || has_extension(gl, "GL_EXT_sRGB_write_control");
    gl->sample_mask = gl->version >= (gl->es ? 32 : 40);
    gl->multisample = !gl->es || has_extension(gl, "GL_EXT_multisample_compatibility");
    gl->layered_framebuffers = !gl->es || gl->version >= 32 || has_extension(gl, "GL_OES_geometry_shader") ||
                               has_extension(gl, "GL_EXT_geometry_shader");
    gl->multiview = has_extension(gl, "GL_OVR_multiview");
    gl->stencil_texturing = gl->version >= (gl->es ? 31 : 43) || has_extension(gl, "GL_ARB_stencil_texturing");
    find_unwanted_capabilities(gl);
    return EW_OK;
}
