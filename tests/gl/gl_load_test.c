/* Loading GL functions: what is missing or too old is named. The contexts here are pretended. */
#include "host/gl.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

static struct fake_context {
    const char *version; /* NULL: no context is current */
    const char *renderer;
    const char *extensions[4];
    GLint profile;
    const char *absent[4]; /* what the loader does not know */
    bool knows_nothing;
    bool has_small_points;
} fake;

static const GLubyte *fake_get_string(GLenum name)
{
    return name == GL_VERSION ? (const GLubyte *)fake.version : name == GL_RENDERER ? (const GLubyte *)fake.renderer : NULL;
}

static const GLubyte *fake_get_string_i(GLenum name, GLuint index)
{
    return name == GL_EXTENSIONS ? (const GLubyte *)fake.extensions[index] : NULL;
}

static void fake_get_integer(GLenum name, GLint *value)
{
    switch (name) {
    case GL_NUM_EXTENSIONS:
        for (*value = 0; fake.extensions[*value]; ++*value)
            ;
        return;
    case GL_CONTEXT_PROFILE_MASK:
        *value = fake.profile;
        return;
    case GL_MAX_UNIFORM_BLOCK_SIZE:
        *value = 12345;
        return;
    case GL_MAX_VERTEX_OUTPUT_COMPONENTS:
        *value = 128;
        return;
    case GL_MAX_FRAGMENT_INPUT_COMPONENTS:
        *value = 60;
        return;
    case GL_MAX_VIEWPORT_DIMS:
        value[0] = value[1] = 16384;
        return;
    case GL_MAX_CLIP_DISTANCES:
    case GL_MAX_DRAW_BUFFERS:
        *value = 8;
        return;
    default:
        fail_msg("unexpected query of 0x%x", name);
    }
}

static void fake_get_float(GLenum name, GLfloat *value)
{
    enum { ES_ALIASED_POINT_SIZE_RANGE = 0x846D };
    assert_int_equal(name, strncmp(fake.version, "OpenGL ES", 9) == 0 ? ES_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE);
    value[0] = 1;
    value[1] = fake.has_small_points ? 31 : 255;
}

static void fake_function(void)
{
    fail_msg("%s", "a function was called that loading has no need of");
}

static ew_gl_function fake_loader(void *user, const char *name)
{
    assert_ptr_equal(user, &fake);
    if (fake.knows_nothing) return NULL;
    for (int i = 0; i < 4 && fake.absent[i]; i++)
        if (strcmp(name, fake.absent[i]) == 0) return NULL;
    if (strcmp(name, "glGetString") == 0) return (ew_gl_function)fake_get_string;
    if (strcmp(name, "glGetStringi") == 0) return (ew_gl_function)fake_get_string_i;
    if (strcmp(name, "glGetFloatv") == 0) return (ew_gl_function)fake_get_float;
    if (strcmp(name, "glGetIntegerv") == 0) return (ew_gl_function)fake_get_integer;
    return fake_function;
}

static ew_gl gl;
static ew_error error;

static ew_result load(void)
{
    error = (ew_error){EW_OK, ""};
    return ew_gl_load(&gl, fake_loader, &fake, &error);
}

static void no_current_context_is_an_error(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = NULL};
    assert_int_equal(load(), EW_ERROR_UNSUPPORTED_CONTEXT);
    assert_int_equal(error.code, EW_ERROR_UNSUPPORTED_CONTEXT);
    assert_non_null(strstr(error.text, "no GL context is current"));
}

static void old_versions_are_named(void **state)
{
    (void)state;
    static const char *const versions[] = {"2.1 Mesa 22.3.6", "3.2.0 NVIDIA 535.1", "OpenGL ES 2.0 build 1.0",
                                           "OpenGL ES-CM 1.1", "what is this"};
    for (size_t i = 0; i < sizeof versions / sizeof versions[0]; i++) {
        fake = (struct fake_context){.version = versions[i], .profile = GL_CONTEXT_CORE_PROFILE_BIT};
        assert_int_equal(load(), EW_ERROR_UNSUPPORTED_CONTEXT);
        assert_non_null(strstr(error.text, versions[i]));
    }
}

static void an_old_context_is_blamed_before_the_functions_that_it_lacks(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "2.1 Mesa 22.3.6", .absent = {"glGetStringi", "glBindSampler"}};
    assert_int_equal(load(), EW_ERROR_UNSUPPORTED_CONTEXT);
}

static void versions_and_profiles_are_told_apart(void **state)
{
    (void)state;
    static const struct {
        const char *version;
        GLint profile;
        int number;
        bool es;
        bool compatibility;
    } cases[] = {
        {"3.3 (Core Profile) Mesa 22.3.6", GL_CONTEXT_CORE_PROFILE_BIT, 33, false, false},
        {"4.6.0 NVIDIA 535.129.03", GL_CONTEXT_COMPATIBILITY_PROFILE_BIT, 46, false, true},
        {"4.1 ATI-4.8.101", GL_CONTEXT_CORE_PROFILE_BIT, 41, false, false},
        {"OpenGL ES 3.2 Mesa 22.3.6", 0, 32, true, false},
        {"OpenGL ES 3.0 (WebGL 2.0 (OpenGL ES 3.0 Chromium))", 0, 30, true, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fake = (struct fake_context){.version = cases[i].version, .profile = cases[i].profile};
        assert_int_equal(load(), EW_OK);
        assert_int_equal(gl.version, cases[i].number);
        assert_int_equal(gl.es, cases[i].es);
        assert_int_equal(gl.compatibility, cases[i].compatibility);
        assert_int_equal(gl.max_uniform_block_size, 12345);
        assert_int_equal(gl.max_varying_vectors, 14); /* the lesser of both, without the position */
        assert_int_equal(gl.max_draw_buffers, 8);
        assert_int_equal(error.code, EW_OK);
    }
}

static void software_is_told_from_hardware(void **state)
{
    (void)state;
    static const struct {
        const char *renderer;
        bool software;
    } cases[] = {
        {"llvmpipe (LLVM 15.0.6, 256 bits)", true},
        {"softpipe", true},
        {"Google SwiftShader", true},
        {"ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero) (0x0000C0DE)), SwiftShader driver)", true},
        {"Mesa DRI Intel(R) HD Graphics 4000 (IVB GT2)", false},
        {"AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.6, DRM 3.49)", false},
        {"NVIDIA H200/PCIe/SSE2", false},
        {NULL, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        fake = (struct fake_context){
            .version = "4.5 (Core Profile)", .profile = GL_CONTEXT_CORE_PROFILE_BIT, .renderer = cases[i].renderer};
        assert_int_equal(load(), EW_OK);
        assert_int_equal(gl.software, cases[i].software);
    }
}

static void missing_functions_are_named(void **state)
{
    (void)state;
    fake = (struct fake_context){
        .version = "4.5 (Core Profile)", .profile = GL_CONTEXT_CORE_PROFILE_BIT, .absent = {"glBindSampler", "glViewport"}};
    assert_int_equal(load(), EW_ERROR_MISSING_FUNCTION);
    assert_string_equal(error.text, "desc.get_proc_address returned NULL for 2 functions: glBindSampler, glViewport");

    fake.absent[0] = "glGetString";
    fake.absent[1] = NULL;
    assert_int_equal(load(), EW_ERROR_MISSING_FUNCTION);
    assert_string_equal(error.text, "desc.get_proc_address returned NULL for 1 function: glGetString");
}

static void a_loader_that_knows_nothing_is_an_error(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "4.5", .knows_nothing = true};
    assert_int_equal(load(), EW_ERROR_MISSING_FUNCTION);
    assert_non_null(strstr(error.text, "glActiveTexture"));
    assert_non_null(strstr(error.text, ", ..."));
    assert_int_equal(ew_gl_load(&gl, fake_loader, &fake, NULL), EW_ERROR_MISSING_FUNCTION);
}

static void functions_that_the_version_promises_are_needed(void **state)
{
    (void)state;
    fake = (struct fake_context){
        .version = "4.1 (Core Profile)", .profile = GL_CONTEXT_CORE_PROFILE_BIT, .absent = {"glViewportIndexedf"}};
    assert_int_equal(load(), EW_ERROR_MISSING_FUNCTION);
    assert_non_null(strstr(error.text, "glViewportIndexedf"));
    fake.version = "4.0 (Core Profile)";
    assert_int_equal(load(), EW_OK);
    assert_null(gl.ViewportIndexedf);
}

static void optional_functions_come_with_versions_and_extensions_only(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "3.3", .profile = GL_CONTEXT_CORE_PROFILE_BIT};
    assert_int_equal(load(), EW_OK);
    assert_non_null(gl.Enablei);
    assert_non_null(gl.PolygonMode);
    assert_null(gl.BlendFuncSeparatei);
    assert_null(gl.ViewportIndexedf);
    assert_null(gl.GenProgramPipelines);
    assert_null(gl.PauseTransformFeedback);
    assert_null(gl.ClampColor);

    fake.extensions[0] = "GL_ARB_draw_buffers_blend";
    fake.absent[0] = "glBlendFuncSeparatei"; /* the extension's own names end in ARB */
    assert_int_equal(load(), EW_OK);
    assert_non_null(gl.BlendFuncSeparatei);

    fake = (struct fake_context){.version = "3.3", .profile = GL_CONTEXT_COMPATIBILITY_PROFILE_BIT};
    assert_int_equal(load(), EW_OK);
    assert_non_null(gl.ClampColor);

    fake = (struct fake_context){.version = "OpenGL ES 3.0"};
    assert_int_equal(load(), EW_OK);
    assert_null(gl.Enablei);
    assert_null(gl.PolygonMode);
    assert_non_null(gl.PauseTransformFeedback);

    static const char *const extensions[] = {"GL_OES_draw_buffers_indexed", "GL_EXT_draw_buffers_indexed"};
    for (int i = 0; i < 2; i++) {
        fake.extensions[0] = extensions[i];
        fake.absent[0] = "glEnablei"; /* these extensions' names end in OES and EXT */
        assert_int_equal(load(), EW_OK);
        assert_non_null(gl.Enablei);
        assert_non_null(gl.BlendEquationi);
    }

    /* What the version brings is not taken from the extension. */
    fake = (struct fake_context){.version = "OpenGL ES 3.2",
                                 .extensions = {"GL_OES_draw_buffers_indexed"},
                                 .absent = {"glEnableiOES", "glBlendEquationiOES"}};
    assert_int_equal(load(), EW_OK);
    assert_non_null(gl.Enablei);
    assert_non_null(gl.BlendEquationi);
    assert_non_null(gl.GenProgramPipelines);
    assert_null(gl.ViewportIndexedf);
}

/* A browser lists more extensions than the loader of a page's program knows. */
static void an_extension_without_its_functions_counts_as_absent(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "OpenGL ES 3.0 (WebGL 2.0 (OpenGL ES 3.0 Chromium))",
                                 .extensions = {"GL_OES_draw_buffers_indexed"},
                                 .absent = {"glIsEnablediOES"}};
    assert_int_equal(load(), EW_OK);
    assert_null(gl.ColorMaski);
    assert_null(gl.Enablei);
    assert_non_null(gl.BlendEquationi); /* a group of its own, which is complete */

    fake.extensions[1] = "GL_EXT_draw_buffers_indexed";
    assert_int_equal(load(), EW_OK);
    assert_non_null(gl.Enablei);
}

static void webgl_is_told_from_opengl_es(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "OpenGL ES 3.0 (WebGL 2.0 (OpenGL ES 3.0 Chromium))"};
    assert_int_equal(load(), EW_OK);
    assert_true(gl.es && gl.web);
    fake.version = "OpenGL ES 3.2 Mesa 22.3.6";
    assert_int_equal(load(), EW_OK);
    assert_true(gl.es && !gl.web);
}

static bool is_unwanted(GLenum capability)
{
    for (int i = 0; i < gl.unwanted_capability_count; i++)
        if (gl.unwanted_capabilities[i] == capability) return true;
    return false;
}

static void capabilities_are_asked_for_only_where_they_are_known(void **state)
{
    (void)state;
    const GLenum depth_bounds_test = 0x8890, alpha_test = 0x0BC0;
    fake = (struct fake_context){.version = "OpenGL ES 3.0"};
    assert_int_equal(load(), EW_OK);
    assert_true(is_unwanted(GL_DEPTH_TEST));
    assert_false(is_unwanted(GL_SAMPLE_MASK));
    assert_false(is_unwanted(GL_SAMPLE_SHADING));
    assert_false(is_unwanted(GL_CLIP_DISTANCE0));
    assert_false(is_unwanted(GL_COLOR_LOGIC_OP));
    fake =
        (struct fake_context){.version = "OpenGL ES 3.0", .extensions = {"GL_EXT_clip_cull_distance", "GL_OES_sample_shading"}};
    assert_int_equal(load(), EW_OK);
    assert_true(is_unwanted(GL_CLIP_DISTANCE0) && is_unwanted(GL_CLIP_DISTANCE7));
    assert_true(is_unwanted(GL_SAMPLE_SHADING));
    fake = (struct fake_context){.version = "OpenGL ES 3.1"};
    assert_int_equal(load(), EW_OK);
    assert_true(is_unwanted(GL_SAMPLE_MASK));

    fake = (struct fake_context){.version = "3.3", .profile = GL_CONTEXT_CORE_PROFILE_BIT};
    assert_int_equal(load(), EW_OK);
    assert_true(is_unwanted(GL_CLIP_DISTANCE7));
    assert_false(is_unwanted(depth_bounds_test));
    assert_false(is_unwanted(alpha_test));
    assert_false(is_unwanted(GL_SAMPLE_SHADING));
    fake = (struct fake_context){.version = "3.3",
                                 .profile = GL_CONTEXT_COMPATIBILITY_PROFILE_BIT,
                                 .extensions = {"GL_EXT_depth_bounds_test", "GL_ARB_sample_shading"}};
    assert_int_equal(load(), EW_OK);
    assert_true(is_unwanted(depth_bounds_test));
    assert_true(is_unwanted(alpha_test));
    assert_true(is_unwanted(GL_SAMPLE_SHADING));
}

/* Browsers list extensions that are not switched on, and a query of such a one is an error. */
static void a_clip_origin_is_asked_for_only_where_it_can_be_set(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "OpenGL ES 3.0"};
    assert_int_equal(load(), EW_OK);
    assert_false(gl.clip_control);
    fake = (struct fake_context){.version = "OpenGL ES 3.0", .extensions = {"GL_EXT_clip_control"}};
    assert_int_equal(load(), EW_OK);
    assert_true(gl.clip_control);
    fake.absent[0] = "glClipControlEXT";
    assert_int_equal(load(), EW_OK);
    assert_false(gl.clip_control);
    fake = (struct fake_context){.version = "4.5", .profile = GL_CONTEXT_CORE_PROFILE_BIT};
    assert_int_equal(load(), EW_OK);
    assert_true(gl.clip_control);
}

static void grids_need_float_targets_and_points_as_large_as_blocks(void **state)
{
    (void)state;
    fake = (struct fake_context){.version = "OpenGL ES 3.0"};
    assert_int_equal(load(), EW_OK);
    assert_false(gl.float_targets);
    fake.extensions[0] = "GL_EXT_color_buffer_float";
    assert_int_equal(load(), EW_OK);
    assert_true(gl.float_targets);
    fake.has_small_points = true;
    assert_int_equal(load(), EW_OK);
    assert_false(gl.float_targets);
    fake = (struct fake_context){.version = "3.3", .profile = GL_CONTEXT_CORE_PROFILE_BIT};
    assert_int_equal(load(), EW_OK);
    assert_true(gl.float_targets);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_current_context_is_an_error),
        cmocka_unit_test(old_versions_are_named),
        cmocka_unit_test(an_old_context_is_blamed_before_the_functions_that_it_lacks),
        cmocka_unit_test(versions_and_profiles_are_told_apart),
        cmocka_unit_test(software_is_told_from_hardware),
        cmocka_unit_test(missing_functions_are_named),
        cmocka_unit_test(a_loader_that_knows_nothing_is_an_error),
        cmocka_unit_test(functions_that_the_version_promises_are_needed),
        cmocka_unit_test(optional_functions_come_with_versions_and_extensions_only),
        cmocka_unit_test(an_extension_without_its_functions_counts_as_absent),
        cmocka_unit_test(webgl_is_told_from_opengl_es),
        cmocka_unit_test(capabilities_are_asked_for_only_where_they_are_known),
        cmocka_unit_test(a_clip_origin_is_asked_for_only_where_it_can_be_set),
        cmocka_unit_test(grids_need_float_targets_and_points_as_large_as_blocks),
    };
    return cmocka_run_group_tests_name("gl load", tests, NULL, NULL);
}
