/* State at random. */
#include "scramble.h"

#include "compatibility.h"

#include <stdio.h>
#include <stdlib.h>

#define COUNT(array) ((int)(sizeof(array) / sizeof((array)[0])))

int host_random(test_host *host, int count)
{
    /* Marsaglia, "Xorshift RNGs", with the multiplier of xorshift64*. */
    host->random ^= host->random >> 12;
    host->random ^= host->random << 25;
    host->random ^= host->random >> 27;
    return (int)((host->random * 0x2545F4914F6CDD1DULL >> 33) % (unsigned)count);
}

static bool coin(test_host *host)
{
    return host_random(host, 2);
}

static GLfloat fraction(test_host *host)
{
    return (GLfloat)host_random(host, 65) / 64;
}

#define PICK(host, array) ((array)[host_random(host, COUNT(array))])

/* One of an array of names, or 0. */
static GLuint pick_name(test_host *host, const GLuint *names, int count)
{
    int i = host_random(host, count + 1);
    return i == count ? 0 : names[i];
}

#define PICK_NAME(host, names) pick_name(host, names, COUNT(names))

static GLuint compile(GLenum stage, const char *body)
{
    const char *es =
        gl.version >= 31 ? "#version 310 es\nprecision highp float;\n" : "#version 300 es\nprecision highp float;\n";
    const char *strings[] = {gl.es ? es : "#version 330 core\n", body};
    GLuint shader = gl.CreateShader(stage);
    gl.ShaderSource(shader, 2, strings, NULL);
    gl.CompileShader(shader);
    return shader;
}

GLuint build_program(const char *vertex_shader, const char *fragment_shader, const char *feedback_varying)
{
    GLuint program = gl.CreateProgram();
    GLuint shaders[2] = {compile(GL_VERTEX_SHADER, vertex_shader), compile(GL_FRAGMENT_SHADER, fragment_shader)};
    for (int i = 0; i < 2; i++) {
        gl.AttachShader(program, shaders[i]);
        gl.DeleteShader(shaders[i]);
    }
    if (feedback_varying) gl.TransformFeedbackVaryings(program, 1, &feedback_varying, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) {
        char log[1000] = "";
        gl.GetProgramInfoLog(program, sizeof log, NULL, log);
        fprintf(stderr, "a test's program does not link: %s\n", log);
        abort();
    }
    return program;
}

static const char host_vertex_shader[] = "out vec4 captured;\nvoid main() { captured = vec4(1.0); gl_Position = captured; }\n";
static const char host_fragment_shader[] = "in vec4 captured;\nout vec4 color;\nvoid main() { color = captured; }\n";

GLuint build_host_program(void)
{
    return build_program(host_vertex_shader, host_fragment_shader, NULL);
}

static const struct {
    GLenum target;
    int desktop_version;
    int es_version;
} texture_targets[HOST_TEXTURE_TARGETS] = {
    {GL_TEXTURE_2D, 33, 30},
    {GL_TEXTURE_3D, 33, 30},
    {GL_TEXTURE_2D_ARRAY, 33, 30},
    {GL_TEXTURE_CUBE_MAP, 33, 30},
    {GL_TEXTURE_1D, 33, NEVER},
    {GL_TEXTURE_1D_ARRAY, 33, NEVER},
    {GL_TEXTURE_RECTANGLE, 33, NEVER},
    {GL_TEXTURE_BUFFER, 33, 32},
    {GL_TEXTURE_CUBE_MAP_ARRAY, 40, 32},
    {GL_TEXTURE_2D_MULTISAMPLE, 33, 31},
    {GL_TEXTURE_2D_MULTISAMPLE_ARRAY, 33, 32},
};

bool has_pipelines(void)
{
    return api_has(41, 31, gl.es ? "GL_EXT_separate_shader_objects" : "GL_ARB_separate_shader_objects");
}

static bool has_pausable_feedback(void)
{
    return api_has(40, 30, "GL_ARB_transform_feedback2");
}

void host_create(test_host *host)
{
    *host = (test_host){.random = 1};
    for (int i = 0; i < 2; i++)
        host->programs[i] = build_host_program();
    host->programs[2] = build_program(host_vertex_shader, host_fragment_shader, "captured");
    if (has_pipelines()) gl.GenProgramPipelines(1, &host->pipeline);
    gl.GenVertexArrays(COUNT(host->vertex_arrays), host->vertex_arrays);
    gl.GenBuffers(COUNT(host->buffers), host->buffers);
    for (int i = 0; i < COUNT(host->buffers); i++) {
        gl.BindBuffer(GL_ARRAY_BUFFER, host->buffers[i]);
        gl.BufferData(GL_ARRAY_BUFFER, 65536, NULL, GL_STATIC_DRAW);
    }
    for (int i = 0; i < COUNT(texture_targets); i++) {
        if (!api_has(texture_targets[i].desktop_version, texture_targets[i].es_version, NULL)) continue;
        gl.GenTextures(2, host->textures[i]);
        for (int j = 0; j < 2; j++)
            gl.BindTexture(texture_targets[i].target, host->textures[i][j]);
    }
    gl.GenSamplers(COUNT(host->samplers), host->samplers);
    gl.GenFramebuffers(COUNT(host->framebuffers), host->framebuffers);
    gl.GenRenderbuffers(1, &host->renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, host->renderbuffer);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
    for (int i = 0; i < COUNT(host->framebuffers); i++) {
        gl.BindFramebuffer(GL_FRAMEBUFFER, host->framebuffers[i]);
        for (GLenum j = 0; j < 4; j++)
            gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + j, GL_RENDERBUFFER, host->renderbuffer);
    }
    if (has_pausable_feedback()) gl.GenTransformFeedbacks(1, &host->transform_feedback);
    gl.GenQueries(COUNT(host->queries), host->queries);
}

static void scramble_buffers(test_host *host)
{
    static const struct {
        GLenum target;
        int desktop_version;
        int es_version;
    } targets[] = {
        {GL_ARRAY_BUFFER, 33, 30},          {GL_COPY_READ_BUFFER, 33, 30},      {GL_COPY_WRITE_BUFFER, 33, 30},
        {GL_PIXEL_PACK_BUFFER, 33, 30},     {GL_PIXEL_UNPACK_BUFFER, 33, 30},   {GL_UNIFORM_BUFFER, 33, 30},
        {GL_TEXTURE_BUFFER, 33, 32},        {GL_DRAW_INDIRECT_BUFFER, 40, 31},  {GL_DISPATCH_INDIRECT_BUFFER, 43, 31},
        {GL_SHADER_STORAGE_BUFFER, 43, 31}, {GL_ATOMIC_COUNTER_BUFFER, 42, 31}, {GL_QUERY_BUFFER, 44, NEVER},
    };
    GLint count = 0;
    gl.GetIntegerv(GL_MAX_UNIFORM_BUFFER_BINDINGS, &count);
    for (GLuint i = 0; i < (GLuint)count; i++) {
        GLuint buffer = PICK_NAME(host, host->buffers);
        if (buffer && coin(host))
            gl.BindBufferRange(GL_UNIFORM_BUFFER, i, buffer, 256 * host_random(host, 16), 16 * (1 + host_random(host, 64)));
        else
            gl.BindBufferBase(GL_UNIFORM_BUFFER, i, buffer);
    }
    for (int i = 0; i < COUNT(targets); i++)
        if (api_has(targets[i].desktop_version, targets[i].es_version, NULL))
            gl.BindBuffer(targets[i].target, PICK_NAME(host, host->buffers));
}

static void scramble_textures(test_host *host)
{
    GLint count = 0;
    gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &count);
    for (GLint unit = 0; unit < count; unit++) {
        gl.ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
        for (int i = 0; i < COUNT(texture_targets); i++)
            if (host->textures[i][0]) gl.BindTexture(texture_targets[i].target, PICK_NAME(host, host->textures[i]));
        gl.BindSampler((GLuint)unit, PICK_NAME(host, host->samplers));
    }
    gl.ActiveTexture(GL_TEXTURE0 + (GLenum)host_random(host, count));
}

static void scramble_vertex_arrays(test_host *host)
{
    for (int i = 0; i < COUNT(host->vertex_arrays); i++) {
        gl.BindVertexArray(host->vertex_arrays[i]);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, PICK_NAME(host, host->buffers));
        gl.BindBuffer(GL_ARRAY_BUFFER, PICK(host, host->buffers));
        for (GLuint attribute = 0; attribute < 8; attribute++) {
            gl.VertexAttribPointer(attribute, 1 + host_random(host, 4), coin(host) ? GL_FLOAT : GL_SHORT, (GLboolean)coin(host),
                                   4 * host_random(host, 8), NULL);
            (coin(host) ? gl.EnableVertexAttribArray : gl.DisableVertexAttribArray)(attribute);
            gl.VertexAttribDivisor(attribute, (GLuint)host_random(host, 3));
        }
    }
    for (GLuint attribute = 0; attribute < 8; attribute++) {
        GLfloat value[4] = {fraction(host), fraction(host), fraction(host), fraction(host)};
        gl.VertexAttrib4fv(attribute, value);
    }
    gl.BindVertexArray(PICK_NAME(host, host->vertex_arrays));
    gl.BindBuffer(GL_ARRAY_BUFFER, PICK_NAME(host, host->buffers));
}

static void scramble_framebuffers(test_host *host)
{
    for (int i = 0; i < COUNT(host->framebuffers); i++) {
        GLenum draw_buffers[4];
        for (GLenum j = 0; j < 4; j++)
            draw_buffers[j] = coin(host) ? GL_COLOR_ATTACHMENT0 + j : GL_NONE;
        gl.BindFramebuffer(GL_FRAMEBUFFER, host->framebuffers[i]);
        gl.DrawBuffers(1 + host_random(host, 4), draw_buffers);
        gl.ReadBuffer(coin(host) ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    }
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, PICK_NAME(host, host->framebuffers));
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, PICK_NAME(host, host->framebuffers));
    gl.BindRenderbuffer(GL_RENDERBUFFER, coin(host) ? host->renderbuffer : 0);
}

/* What glEnable takes, and where. */
static const struct {
    GLenum capability;
    int desktop_version; /* NEVER - 1: the compatibility profile */
    int es_version;
    const char *extension;
} capabilities[] = {
    {GL_CULL_FACE, 33, 30, NULL},
    {GL_DEPTH_TEST, 33, 30, NULL},
    {GL_STENCIL_TEST, 33, 30, NULL},
    {GL_SCISSOR_TEST, 33, 30, NULL},
    {GL_DITHER, 33, 30, NULL},
    {GL_POLYGON_OFFSET_FILL, 33, 30, NULL},
    {GL_SAMPLE_ALPHA_TO_COVERAGE, 33, 30, NULL},
    {GL_SAMPLE_COVERAGE, 33, 30, NULL},
    {GL_RASTERIZER_DISCARD, 33, 30, NULL},
    {GL_PRIMITIVE_RESTART_FIXED_INDEX, 43, 30, NULL},
    {GL_SAMPLE_MASK, 33, 31, NULL},
    {GL_SAMPLE_SHADING, 40, 32, "GL_OES_sample_shading"},
    {GL_COLOR_LOGIC_OP, 33, NEVER, NULL},
    {GL_DEPTH_CLAMP, 33, NEVER, "GL_EXT_depth_clamp"},
    {GL_FRAMEBUFFER_SRGB, 33, NEVER, "GL_EXT_sRGB_write_control"},
    {GL_LINE_SMOOTH, 33, NEVER, NULL},
    {GL_MULTISAMPLE, 33, NEVER, NULL},
    {GL_POLYGON_OFFSET_LINE, 33, NEVER, NULL},
    {GL_POLYGON_OFFSET_POINT, 33, NEVER, NULL},
    {GL_POLYGON_SMOOTH, 33, NEVER, NULL},
    {GL_PRIMITIVE_RESTART, 33, NEVER, NULL},
    {GL_PROGRAM_POINT_SIZE, 33, NEVER, NULL},
    {GL_SAMPLE_ALPHA_TO_ONE, 33, NEVER, NULL},
    {GL_TEXTURE_CUBE_MAP_SEAMLESS, 33, NEVER, NULL},
    {GL_BLEND_ADVANCED_COHERENT_KHR, NEVER, NEVER, "GL_KHR_blend_equation_advanced_coherent"},
    {GL_DEPTH_BOUNDS_TEST_EXT, NEVER, NEVER, "GL_EXT_depth_bounds_test"},
    {GL_CLIP_DISTANCE0, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE1, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE2, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE3, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE4, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE5, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE6, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_CLIP_DISTANCE7, 33, NEVER, "GL_EXT_clip_cull_distance"},
    {GL_ALPHA_TEST, NEVER - 1, NEVER, NULL},
    {GL_COLOR_MATERIAL, NEVER - 1, NEVER, NULL},
    {GL_COLOR_SUM, NEVER - 1, NEVER, NULL},
    {GL_FOG, NEVER - 1, NEVER, NULL},
    {GL_LIGHTING, NEVER - 1, NEVER, NULL},
    {GL_LIGHT0, NEVER - 1, NEVER, NULL},
    {GL_LINE_STIPPLE, NEVER - 1, NEVER, NULL},
    {GL_NORMALIZE, NEVER - 1, NEVER, NULL},
    {GL_POINT_SMOOTH, NEVER - 1, NEVER, NULL},
    {GL_POINT_SPRITE, NEVER - 1, NEVER, NULL},
    {GL_POLYGON_STIPPLE, NEVER - 1, NEVER, NULL},
    {GL_VERTEX_PROGRAM_TWO_SIDE, NEVER - 1, NEVER, NULL},
};

static void scramble_capabilities(test_host *host, unsigned long long seed)
{
    /* Every other seed enables one only, each in its turn: what one does, another might hide. */
    bool only_one = seed % 2 == 0;
    int chosen = (int)(seed / 2 % (unsigned)COUNT(capabilities));
    for (int i = 0; i < COUNT(capabilities); i++) {
        bool enable = only_one ? i == chosen : coin(host);
        bool known = capabilities[i].desktop_version == NEVER - 1
                         ? gl.compatibility
                         : api_has(capabilities[i].desktop_version, capabilities[i].es_version, capabilities[i].extension);
        if (known) (enable ? gl.Enable : gl.Disable)(capabilities[i].capability);
    }
}

static void scramble_rasterization(test_host *host)
{
    gl.Viewport(host_random(host, 9) - 4, host_random(host, 9) - 4, host_random(host, 40), host_random(host, 40));
    gl.Scissor(host_random(host, 9), host_random(host, 9), 8 + host_random(host, 24), 8 + host_random(host, 24));
    gl.DepthRangef(fraction(host), fraction(host));
    if (api_has(41, NEVER, gl.es ? "GL_OES_viewport_array" : "GL_ARB_viewport_array")) {
        GLint count = 0;
        gl.GetIntegerv(GL_MAX_VIEWPORTS, &count);
        for (GLuint i = 0; i < (GLuint)count; i++) {
            gl.ViewportIndexedf(i, fraction(host), fraction(host), 32 * fraction(host), 32 * fraction(host));
            gl.ScissorIndexed(i, host_random(host, 9), host_random(host, 9), 8 + host_random(host, 24),
                              8 + host_random(host, 24));
            if (!gl.es) gl.DepthRangeIndexed(i, (GLdouble)fraction(host), (GLdouble)fraction(host));
            (coin(host) ? gl.Enablei : gl.Disablei)(GL_SCISSOR_TEST, i);
        }
    }
    static const GLenum faces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
    gl.CullFace(PICK(host, faces));
    gl.FrontFace(coin(host) ? GL_CW : GL_CCW);
    gl.PolygonOffset(fraction(host), fraction(host));
    gl.LineWidth(1);
    if (api_has(45, NEVER, "GL_EXT_clip_control"))
        gl.ClipControl(coin(host) ? GL_LOWER_LEFT : GL_UPPER_LEFT, coin(host) ? GL_NEGATIVE_ONE_TO_ONE : GL_ZERO_TO_ONE);
    if (!gl.es) {
        static const GLenum modes[] = {GL_FILL, GL_LINE, GL_POINT};
        gl.PolygonMode(GL_FRONT_AND_BACK, PICK(host, modes));
        if (gl.compatibility) {
            gl.PolygonMode(GL_FRONT, PICK(host, modes));
            gl.PolygonMode(GL_BACK, PICK(host, modes));
        }
        gl.PointSize(1 + 8 * fraction(host));
        gl.ProvokingVertex(coin(host) ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
        gl.PrimitiveRestartIndex((GLuint)host_random(host, 4));
        gl.ClampColor(GL_CLAMP_READ_COLOR, coin(host) ? GL_TRUE : GL_FALSE);
    }
    if (api_has(40, 32, NULL)) gl.PatchParameteri(GL_PATCH_VERTICES, 1 + host_random(host, 8));
}

static void scramble_blending(test_host *host)
{
    static const GLenum factors[] = {GL_ZERO,           GL_ONE,
                                     GL_SRC_COLOR,      GL_ONE_MINUS_SRC_COLOR,
                                     GL_DST_COLOR,      GL_ONE_MINUS_DST_COLOR,
                                     GL_SRC_ALPHA,      GL_ONE_MINUS_SRC_ALPHA,
                                     GL_DST_ALPHA,      GL_ONE_MINUS_DST_ALPHA,
                                     GL_CONSTANT_COLOR, GL_CONSTANT_ALPHA,
                                     GL_SRC1_COLOR,     GL_ONE_MINUS_SRC1_ALPHA};
    static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    static const GLenum advanced[] = {GL_MULTIPLY_KHR, GL_SCREEN_KHR, GL_HSL_HUE_KHR};
    const int factor_count = COUNT(factors) - (api_has(33, NEVER, "GL_EXT_blend_func_extended") ? 0 : 2);
    bool has_advanced = api_has(NEVER, 32, "GL_KHR_blend_equation_advanced");
    bool indexed_mask = api_has(33, 32, "GL_OES_draw_buffers_indexed");
    bool indexed_blend = api_has(40, 32, gl.es ? "GL_OES_draw_buffers_indexed" : "GL_ARB_draw_buffers_blend");
    (coin(host) ? gl.Enable : gl.Disable)(GL_BLEND);
    gl.BlendColor(fraction(host), fraction(host), fraction(host), fraction(host));
    gl.BlendFuncSeparate(factors[host_random(host, factor_count)], factors[host_random(host, factor_count)],
                         factors[host_random(host, factor_count)], factors[host_random(host, factor_count)]);
    gl.BlendEquationSeparate(PICK(host, equations), PICK(host, equations));
    if (has_advanced && host_random(host, 4) == 0) gl.BlendEquation(PICK(host, advanced));
    gl.ColorMask((GLboolean)coin(host), (GLboolean)coin(host), (GLboolean)coin(host), (GLboolean)coin(host));
    GLint count = 0;
    gl.GetIntegerv(GL_MAX_DRAW_BUFFERS, &count);
    bool indexed = coin(host);
    for (GLuint i = 0; indexed && i < (GLuint)count; i++) {
        if (indexed_mask) {
            (coin(host) ? gl.Enablei : gl.Disablei)(GL_BLEND, i);
            gl.ColorMaski(i, (GLboolean)coin(host), (GLboolean)coin(host), (GLboolean)coin(host), (GLboolean)coin(host));
        }
        if (indexed_blend) {
            gl.BlendFuncSeparatei(i, factors[host_random(host, factor_count)], factors[host_random(host, factor_count)],
                                  factors[host_random(host, factor_count)], factors[host_random(host, factor_count)]);
            gl.BlendEquationSeparatei(i, PICK(host, equations), PICK(host, equations));
            if (has_advanced && host_random(host, 4) == 0) gl.BlendEquationi(i, PICK(host, advanced));
        }
    }
    if (!gl.es) gl.LogicOp(GL_CLEAR + (GLenum)host_random(host, 16));
}

static void scramble_tests(test_host *host)
{
    static const GLenum operations[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR_WRAP, GL_INVERT};
    static const GLenum faces[] = {GL_FRONT, GL_BACK};
    gl.DepthFunc(GL_NEVER + (GLenum)host_random(host, 8));
    gl.DepthMask((GLboolean)coin(host));
    gl.ClearDepthf(fraction(host));
    gl.ClearStencil(host_random(host, 256));
    gl.ClearColor(fraction(host), fraction(host), fraction(host), fraction(host));
    for (int i = 0; i < 2; i++) {
        gl.StencilFuncSeparate(faces[i], GL_NEVER + (GLenum)host_random(host, 8), host_random(host, 256),
                               (GLuint)host_random(host, 256));
        gl.StencilOpSeparate(faces[i], PICK(host, operations), PICK(host, operations), PICK(host, operations));
        gl.StencilMaskSeparate(faces[i], (GLuint)host_random(host, 256));
    }
    gl.SampleCoverage(fraction(host), (GLboolean)coin(host));
    if (api_has(33, 31, NULL)) gl.SampleMaski(0, (GLbitfield)host_random(host, 16));
    if (api_has(40, 32, gl.es ? "GL_OES_sample_shading" : NULL)) gl.MinSampleShading(fraction(host));
}

static void scramble_pixel_store(test_host *host)
{
    static const GLenum names[] = {GL_PACK_ROW_LENGTH,  GL_PACK_SKIP_ROWS,     GL_PACK_SKIP_PIXELS,    GL_UNPACK_ROW_LENGTH,
                                   GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES};
    static const GLenum desktop_names[] = {GL_PACK_IMAGE_HEIGHT, GL_PACK_SKIP_IMAGES,  GL_PACK_SWAP_BYTES,
                                           GL_PACK_LSB_FIRST,    GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST};
    for (int i = 0; i < COUNT(names); i++)
        gl.PixelStorei(names[i], host_random(host, 64));
    for (int i = 0; !gl.es && i < COUNT(desktop_names); i++)
        gl.PixelStorei(desktop_names[i], host_random(host, 2));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1 << host_random(host, 4));
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1 << host_random(host, 4));
    static const GLenum hints[] = {GL_DONT_CARE, GL_FASTEST, GL_NICEST};
    gl.Hint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, PICK(host, hints));
}

static void scramble_compatibility(test_host *host)
{
    static const GLenum clamping[] = {GL_TRUE, GL_FALSE, GL_FIXED_ONLY};
    gl.AlphaFunc(GL_NEVER + (GLenum)host_random(host, 8), fraction(host));
    gl.ClampColor(GL_CLAMP_FRAGMENT_COLOR, PICK(host, clamping));
    gl.ClampColor(GL_CLAMP_VERTEX_COLOR, PICK(host, clamping));
    gl.ClientActiveTexture(GL_TEXTURE0 + (GLenum)host_random(host, 8));
    gl.Color4f(fraction(host), fraction(host), fraction(host), fraction(host));
    gl.ShadeModel(coin(host) ? GL_FLAT : GL_SMOOTH);
    static const GLenum matrices[] = {GL_MODELVIEW, GL_PROJECTION};
    for (int i = 0; i < 2; i++) {
        gl.MatrixMode(matrices[i]);
        gl.Translatef(fraction(host), fraction(host), fraction(host));
    }
    gl.MatrixMode(PICK(host, matrices));
    for (GLenum i = 0; i < 6; i++) {
        GLdouble plane[4] = {(GLdouble)fraction(host), 0, 0, -2};
        gl.ClipPlane(GL_CLIP_DISTANCE0 + i, plane);
    }
    GLubyte stipple[128];
    for (int i = 0; i < 128; i++)
        stipple[i] = (GLubyte)host_random(host, 256);
    GLint unpack_buffer = 0;
    gl.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpack_buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.PolygonStipple(stipple);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, (GLuint)unpack_buffer);
    GLint active = 0;
    gl.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
    gl.ActiveTexture(GL_TEXTURE0 + (GLenum)host_random(host, 2));
    gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, coin(host) ? GL_ADD : GL_MODULATE);
    (coin(host) ? gl.Enable : gl.Disable)(GL_TEXTURE_2D);
    gl.ActiveTexture((GLenum)active);
}

/* The program in use, transform feedback and queries: what GL ties together. */
static void scramble_program(test_host *host, bool allow_deleted_program)
{
    if (host->pipeline) gl.BindProgramPipeline(coin(host) ? host->pipeline : 0);
    int choice = host_random(host, 4);
    if (host->transform_feedback) gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, coin(host) ? host->transform_feedback : 0);
    if (choice == 3 && has_pausable_feedback()) {
        gl.UseProgram(host->programs[2]);
        gl.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, host->buffers[0], 256, 1024);
        gl.BeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, host->queries[2]);
        gl.BeginTransformFeedback(GL_TRIANGLES);
        host->transform_feedback_active = true;
        if (coin(host)) {
            gl.PauseTransformFeedback();
            if (coin(host)) gl.UseProgram(PICK_NAME(host, host->programs));
        }
    } else if (choice == 2 && allow_deleted_program) {
        host->programs[3] = build_host_program();
        gl.UseProgram(host->programs[3]);
        gl.DeleteProgram(host->programs[3]);
    } else {
        gl.UseProgram(pick_name(host, host->programs, 3));
    }
    host->queries_active = coin(host);
    if (host->queries_active) {
        gl.BeginQuery(GL_ANY_SAMPLES_PASSED, host->queries[0]);
        if (api_has(33, 32, NULL)) gl.BeginQuery(GL_PRIMITIVES_GENERATED, host->queries[1]);
    }
}

void host_scramble(test_host *host, unsigned long long seed, bool allow_deleted_program)
{
    host->random = seed * 0x9E3779B97F4A7C15ULL + 1;
    scramble_buffers(host);
    scramble_textures(host);
    scramble_vertex_arrays(host);
    scramble_framebuffers(host);
    scramble_capabilities(host, seed);
    scramble_rasterization(host);
    scramble_blending(host);
    scramble_tests(host);
    if (gl.compatibility) scramble_compatibility(host);
    scramble_pixel_store(host);
    scramble_program(host, allow_deleted_program);
}

state_objects host_objects(const test_host *host)
{
    return (state_objects){
        .vertex_arrays = host->vertex_arrays,
        .vertex_array_count = COUNT(host->vertex_arrays),
        .buffers = host->buffers,
        .buffer_count = COUNT(host->buffers),
        .samplers = host->samplers,
        .sampler_count = COUNT(host->samplers),
        .programs = host->programs,
        .program_count = COUNT(host->programs),
    };
}

GLuint host_settle(test_host *host)
{
    GLuint captured = 0;
    if (host->transform_feedback_active) {
        gl.EndTransformFeedback();
        gl.EndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
        if (api_has(44, NEVER, NULL)) gl.BindBuffer(GL_QUERY_BUFFER, 0);
        gl.GetQueryObjectuiv(host->queries[2], GL_QUERY_RESULT, &captured);
        host->transform_feedback_active = false;
    }
    if (host->queries_active) {
        gl.EndQuery(GL_ANY_SAMPLES_PASSED);
        if (api_has(33, 32, NULL)) gl.EndQuery(GL_PRIMITIVES_GENERATED);
        host->queries_active = false;
    }
    gl.UseProgram(0);
    host->programs[3] = 0;
    return captured;
}
