/* The guard against hosts in any condition: all GL state is as before, and the picture as from a clean state.
 *
 *     state_guard_test CONTEXT    one of the names in context.h
 *
 * Two contexts share their objects: a clean one, which prepares the targets and reads the pictures, and a scrambled one. */
#include "compatibility.h"
#include "debug_output.h"
#include "host/state_guard.h"
#include "program_context.h"
#include "scramble.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <string.h>

/* Large enough for adaptive resolution. */
enum { WIDTH = 288, HEIGHT = 228, SAMPLES = 4 };

/* As many that every capability is the only one enabled before a draw to every target. The effect takes fewer: its shaders are
 * slow to compile, anew for much of the state that changes. */
enum { GUARD_SEEDS = 400, EFFECT_SEEDS = 16, LIFE_SEEDS = 18, DIRTY_SEEDS = 24 };

/* What is drawn to: a colour attachment that should get the picture, one that should not, depth and stencil. */
typedef struct test_target {
    const char *name;
    GLenum format;
    int samples;
    GLuint images[3]; /* renderbuffers: picture, bystander, depth and stencil; shared */
    GLuint framebuffers[2];
} test_target;

enum { CLEAN, SCRAMBLED };

static test_target targets[] = {
    {.name = "RGBA8", .format = GL_RGBA8},
    {.name = "RGBA32F", .format = GL_RGBA32F},
    {.name = "SRGB8_ALPHA8 with 4 samples", .format = GL_SRGB8_ALPHA8, .samples = SAMPLES},
};
enum { TARGET_COUNT = sizeof targets / sizeof targets[0] };

/* Too large for the stack of some systems. */
typedef struct test_picture {
    GLfloat pixels[HEIGHT][WIDTH][4];
} test_picture;

static gl_context *contexts[2];
static test_host host;
static GLuint resolve_framebuffer; /* of the clean context */
static GLuint incomplete_framebuffers[2];
static GLuint depthless_framebuffers[2];
static GLuint depth_texture;

/* The host's depth textures, set to what no shader of the library's could read, and a cube map. */
enum { ODD_DEPTH, MULTISAMPLED_DEPTH, HOST_DEPTH_COUNT };
static state_texture host_depth[HOST_DEPTH_COUNT] = {{.target = GL_TEXTURE_2D}, {.target = GL_TEXTURE_2D_MULTISAMPLE}};
static GLuint cube_texture;

static unsigned long long current_seed;

static GLuint make_framebuffer(const test_target *target)
{
    GLuint framebuffer;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target->images[0]);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + 1, GL_RENDERBUFFER, target->images[1]);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, target->images[2]);
    assert_int_equal(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
    return framebuffer;
}

static GLuint make_depthless_framebuffer(void)
{
    GLuint framebuffer;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, targets[0].images[0]);
    return framebuffer;
}

static GLuint make_incomplete_framebuffer(void)
{
    GLuint framebuffer;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    return framebuffer;
}

static bool has_multisampled_textures(void)
{
    return api_has(33, 31, NULL);
}

static GLuint make_multisampled_depth(GLfloat depth)
{
    GLuint texture, framebuffer;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
    if (gl.es)
        gl.TexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SAMPLES, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, GL_TRUE);
    else
        gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SAMPLES, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, GL_TRUE);
    gl.TexParameteri(GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_SWIZZLE_R, GL_ONE);
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.DrawBuffers(1, &(GLenum){GL_NONE});
    gl.ReadBuffer(GL_NONE);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
    gl.ClearBufferfv(GL_DEPTH, 0, &depth);
    gl.DeleteFramebuffers(1, &framebuffer);
    gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, 0);
    return texture;
}

static void make_depth_textures(void)
{
    static GLfloat depth[HEIGHT][WIDTH];
    static GLuint packed[HEIGHT][WIDTH];
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            depth[y][x] = 1 - 0.05f * (GLfloat)(x + y) / (WIDTH + HEIGHT);
            packed[y][x] = (GLuint)(depth[y][x] * 16777215) << 8 | 0x5A;
        }
    gl.GenTextures(1, &depth_texture);
    gl.BindTexture(GL_TEXTURE_2D, depth_texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    GLuint odd;
    gl.GenTextures(1, &odd);
    gl.BindTexture(GL_TEXTURE_2D, odd);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, WIDTH, HEIGHT, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, packed);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_R, GL_ZERO);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 2);
    if (api_has(43, 31, "GL_ARB_stencil_texturing"))
        gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_STENCIL_TEXTURE_MODE, GL_STENCIL_INDEX);
    if (gl.compatibility) gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_ALPHA);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    host_depth[ODD_DEPTH].name = odd;
    if (has_multisampled_textures()) host_depth[MULTISAMPLED_DEPTH].name = make_multisampled_depth(0.96f);

    gl.GenTextures(1, &cube_texture);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube_texture);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, 0);
}

static void make_targets(void)
{
    for (int i = 0; i < TARGET_COUNT; i++) {
        test_target *target = &targets[i];
        const GLenum formats[3] = {target->format, target->format, GL_DEPTH24_STENCIL8};
        gl.GenRenderbuffers(3, target->images);
        for (int j = 0; j < 3; j++) {
            gl.BindRenderbuffer(GL_RENDERBUFFER, target->images[j]);
            gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, target->samples, formats[j], WIDTH, HEIGHT);
        }
        target->framebuffers[CLEAN] = make_framebuffer(target);
    }
    GLuint resolved;
    gl.GenRenderbuffers(1, &resolved);
    gl.BindRenderbuffer(GL_RENDERBUFFER, resolved);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, WIDTH, HEIGHT);
    gl.GenFramebuffers(1, &resolve_framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolve_framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved);

    make_depth_textures();
}

static const GLfloat before_color[4] = {0.25f, 0.5f, 0.75f, 0.5f};

/* In the clean context. */
static void clear_target(const test_target *target)
{
    static const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1};
    gl.BindFramebuffer(GL_FRAMEBUFFER, target->framebuffers[CLEAN]);
    gl.DrawBuffers(2, both);
    gl.ClearBufferfv(GL_COLOR, 0, before_color);
    gl.ClearBufferfv(GL_COLOR, 1, before_color);
    gl.ClearBufferfi(GL_DEPTH_STENCIL, 0, 0.95f, 0x5A);
    gl.DrawBuffers(1, both);
}

/* In the clean context: what an attachment holds, its samples resolved. */
static void read_picture(const test_target *target, GLenum attachment, test_picture *picture)
{
    GLuint framebuffer = target->framebuffers[CLEAN];
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    gl.ReadBuffer(attachment);
    if (target->samples > 0) {
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolve_framebuffer);
        gl.BlitFramebuffer(0, 0, WIDTH, HEIGHT, 0, 0, WIDTH, HEIGHT, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, resolve_framebuffer);
    }
    memset(picture, 0, sizeof *picture);
    if (target->format == GL_RGBA32F) {
        gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, picture->pixels);
    } else {
        static GLubyte bytes[HEIGHT][WIDTH][4];
        gl.ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++)
                for (int i = 0; i < 4; i++)
                    picture->pixels[y][x][i] = bytes[y][x][i];
    }
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
}

static int count_different_pixels(const test_picture *a, const test_picture *b)
{
    int different = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            different += memcmp(a->pixels[y][x], b->pixels[y][x], sizeof a->pixels[y][x]) != 0;
    return different;
}

/* Something to draw under the guard, in either context, to its framebuffer for the target. */
typedef struct test_subject {
    void (*draw)(int context, const test_target *target);
    void (*create)(int context);
    void (*destroy)(int context);
} test_subject;

static void make_current(int context)
{
    context_make_current(contexts[context]);
}

/* The state that is the host's wish, and stays in force while the effect draws. */
typedef struct host_wish {
    bool scissor;
    GLint scissor_box[4];
} host_wish;

static host_wish ask_wish(void)
{
    host_wish wish = {.scissor = gl.IsEnabled(GL_SCISSOR_TEST)};
    gl.GetIntegerv(GL_SCISSOR_BOX, wish.scissor_box);
    return wish;
}

static void grant_wish(const host_wish *wish)
{
    gl.Scissor(wish->scissor_box[0], wish->scissor_box[1], wish->scissor_box[2], wish->scissor_box[3]);
    (wish->scissor ? gl.Enable : gl.Disable)(GL_SCISSOR_TEST);
}

static void draw_clean(const test_subject *subject, const test_target *target, const host_wish *wish, test_picture *picture)
{
    make_current(CLEAN);
    clear_target(target);
    grant_wish(wish);
    subject->draw(CLEAN, target);
    gl.Disable(GL_SCISSOR_TEST);
    read_picture(target, GL_COLOR_ATTACHMENT0, picture);
}

/* What one draw from a scrambled state did wrong. */
typedef struct test_outcome {
    GLenum error;
    int debug_messages;
    int differences;
    GLuint captured;
} test_outcome;

/* Lets a target have one draw buffer or two. */
static void scramble_draw_buffers(const test_target *target)
{
    const GLenum choices[2][2] = {{GL_COLOR_ATTACHMENT0, GL_NONE}, {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT0 + 1}};
    GLint bound = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target->framebuffers[SCRAMBLED]);
    gl.DrawBuffers(2, choices[host_random(&host, 2)]);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)bound);
}

static test_outcome draw_scrambled(const test_subject *subject, const test_target *target, unsigned long long seed,
                                   host_wish *wish)
{
    static state before, after;
    make_current(CLEAN);
    clear_target(target);
    gl.Finish();

    make_current(SCRAMBLED);
    host_scramble(&host, seed, has_pipelines());
    /* llvmpipe lets single samples of multisampled pixels out of the scissor's rectangle, now more of them, now fewer. */
    if (target->samples > 0) gl.Disable(GL_SCISSOR_TEST);
    scramble_draw_buffers(target);
    state_objects objects = host_objects(&host);
    objects.framebuffers = &target->framebuffers[SCRAMBLED];
    objects.framebuffer_count = 1;
    objects.textures = host_depth;
    objects.texture_count = has_multisampled_textures() ? HOST_DEPTH_COUNT : 1;
    state_take(&before, &objects);
    *wish = ask_wish();
    assert_int_equal(gl.GetError(), GL_NO_ERROR);

    const int messages_before = debug_output_count();
    debug_output_resume();
    subject->draw(SCRAMBLED, target);
    debug_output_pause();

    test_outcome outcome = {.error = gl.GetError(), .debug_messages = debug_output_count() - messages_before};
    state_take(&after, &objects);
    outcome.differences = state_count_differences(&before, &after);
    outcome.captured = host_settle(&host);
    gl.Finish();
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    state_free(&before);
    state_free(&after);
    return outcome;
}

/* Draws from scrambled states. All must be as before, and the picture as from the clean state. */
static void check_neutrality(const test_subject *subject, int seeds)
{
    static test_picture cleared, expected, found, bystander;
    int failures = 0;
    make_current(CLEAN);
    subject->create(CLEAN);
    make_current(SCRAMBLED);
    subject->create(SCRAMBLED);

    for (unsigned long long seed = 1; seed <= (unsigned)seeds && failures < 5; seed++) {
        const test_target *target = &targets[seed / 2 % TARGET_COUNT];
        host_wish wish;
        current_seed = seed;
        test_outcome outcome = draw_scrambled(subject, target, seed, &wish);
        make_current(CLEAN);
        read_picture(target, GL_COLOR_ATTACHMENT0, &found);
        read_picture(target, GL_COLOR_ATTACHMENT0 + 1, &bystander);
        clear_target(target);
        read_picture(target, GL_COLOR_ATTACHMENT0, &cleared);
        draw_clean(subject, target, &wish, &expected);
        assert_true(count_different_pixels(&cleared, &expected) > 0);

        int wrong_pixels = count_different_pixels(&found, &expected);
        int wrong_bystanders = count_different_pixels(&bystander, &cleared);
        if (outcome.error || outcome.debug_messages || outcome.differences || outcome.captured || wrong_pixels ||
            wrong_bystanders) {
            failures++;
            fprintf(stderr,
                    "seed %llu, %s: error 0x%x, %d debug messages, %d differences, %u primitives captured, %d pixels wrong, "
                    "%d pixels of a further draw buffer changed\n",
                    seed, target->name, outcome.error, outcome.debug_messages, outcome.differences, outcome.captured,
                    wrong_pixels, wrong_bystanders);
        }
    }
    make_current(SCRAMBLED);
    subject->destroy(SCRAMBLED);
    make_current(CLEAN);
    subject->destroy(CLEAN);
    assert_int_equal(failures, 0);
}

/* ---- The guard alone, about a draw that changes all that it may ---------------------------------------------------------- */

static ew_gl loaded;
static GLuint programs[2], vertex_arrays[2], uniform_buffers[2], samplers[2];

static void guarded_create(int context)
{
    assert_int_equal(ew_gl_load(&loaded, context_get_proc_address, contexts[context], NULL), EW_OK);
    GLuint program = build_program("void main() { vec2 p = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                                   "gl_Position = vec4(2.0 * p - 1.0, 0.0, 1.0); }\n",
                                   "layout(std140) uniform A { vec4 a; };\n"
                                   "uniform highp sampler2D depth;\nout vec4 color;\n"
                                   "void main() { color = a; color.rgb += 0.001 * gl_FragCoord.xyx;\n"
                                   "color.g += texture(depth, gl_FragCoord.xy / vec2(textureSize(depth, 0))).r; }\n",
                                   NULL);
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "A"), EW_GL_UNIFORM_BINDING);
    GLint depth = gl.GetUniformLocation(program, "depth");
    GLint current = 0;
    gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
    gl.UseProgram(program);
    gl.Uniform1i(depth, EW_GL_DEPTH_TEXTURE_UNIT);
    gl.UseProgram((GLuint)current);
    programs[context] = program;

    static const GLfloat color[4] = {0.9f, 0.6f, 0.3f, 0.15f};
    gl.GenVertexArrays(1, &vertex_arrays[context]);
    gl.GenBuffers(1, &uniform_buffers[context]);
    gl.BindBuffer(GL_UNIFORM_BUFFER, uniform_buffers[context]);
    gl.BufferData(GL_UNIFORM_BUFFER, sizeof color, color, GL_STATIC_DRAW);
    gl.GenSamplers(1, &samplers[context]);
    gl.SamplerParameteri(samplers[context], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.SamplerParameteri(samplers[context], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static void guarded_destroy(int context)
{
    gl.DeleteProgram(programs[context]);
    gl.DeleteVertexArrays(1, &vertex_arrays[context]);
    gl.DeleteBuffers(1, &uniform_buffers[context]);
}

/* Not all rasterizers show what each of these does to a picture. */
static void expect_capabilities_off(void)
{
    static const GLenum everywhere[] = {GL_CULL_FACE,    GL_DEPTH_TEST,     GL_RASTERIZER_DISCARD, GL_SAMPLE_ALPHA_TO_COVERAGE,
                                        GL_STENCIL_TEST, GL_SAMPLE_COVERAGE};
    static const GLenum desktop[] = {GL_CLIP_DISTANCE0,    GL_CLIP_DISTANCE7,      GL_COLOR_LOGIC_OP, GL_POLYGON_SMOOTH,
                                     GL_PRIMITIVE_RESTART, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_MASK};
    for (size_t i = 0; i < sizeof everywhere / sizeof everywhere[0]; i++)
        assert_false(gl.IsEnabled(everywhere[i]));
    for (size_t i = 0; !gl.es && i < sizeof desktop / sizeof desktop[0]; i++)
        assert_false(gl.IsEnabled(desktop[i]));
}

/* The draw call and its own bindings. */
static void draw_quad(int context)
{
    gl.BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, uniform_buffers[context]);
    gl.ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    gl.BindTexture(GL_TEXTURE_2D, depth_texture);
    gl.BindSampler(EW_GL_DEPTH_TEXTURE_UNIT, samplers[context]);
    gl.UseProgram(programs[context]);
    gl.BindVertexArray(vertex_arrays[context]);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

static bool is_srgb(const test_target *target)
{
    return target->format == GL_SRGB8_ALPHA8;
}

static bool has_srgb_switch(void)
{
    return api_has(33, NEVER, "GL_EXT_sRGB_write_control");
}

/* The clean context does without the guard, whose mistakes would be the same in both. */
static void draw_without_guard(const test_target *target)
{
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target->framebuffers[CLEAN]);
    gl.Viewport(0, 0, WIDTH, HEIGHT);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE);
    if (has_srgb_switch()) (is_srgb(target) ? gl.Enable : gl.Disable)(GL_FRAMEBUFFER_SRGB);
    draw_quad(CLEAN);
    gl.UseProgram(0);
    gl.Disable(GL_BLEND);
    if (has_srgb_switch()) gl.Disable(GL_FRAMEBUFFER_SRGB);
}

static void guarded_draw(int context, const test_target *target)
{
    if (context == CLEAN) {
        draw_without_guard(target);
        return;
    }
    const ew_gl *guarded = &loaded;
    const ew_gl_draw_state draw_state = {
        .framebuffer = target->framebuffers[context],
        .viewport = {0, 0, WIDTH, HEIGHT},
        .blend = true,
        .source_rgb = GL_ONE,
        .destination_rgb = GL_ONE_MINUS_SRC_ALPHA,
        .source_alpha = GL_DST_ALPHA,
        .destination_alpha = GL_ONE,
        .framebuffer_srgb = is_srgb(target),
    };
    ew_gl_state saved;
    ew_error error = {.text = ""};
    if (ew_gl_save_state(guarded, &saved, &error) != EW_OK) fail_msg("%s", error.text);
    gl.UseProgram(programs[context]); /* as compiling one for the first time may do */
    ew_gl_set_draw_state(guarded, &saved, &draw_state);
    expect_capabilities_off();
    draw_quad(context);
    /* as for multisampled depth, and a copy of the framebuffer's */
    if (has_multisampled_textures()) {
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, host_depth[MULTISAMPLED_DEPTH].name);
        gl.SampleMaski(0, 0x55);
    }
    if (!gl.es) gl.Enable(GL_MULTISAMPLE);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffers[context]);
    gl.ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT + 1);
    ew_gl_restore_state(guarded, &saved);
}

static void guard_restores_all_state_and_the_picture_is_clean(void **unused)
{
    (void)unused;
    static const test_subject subject = {guarded_draw, guarded_create, guarded_destroy};
    check_neutrality(&subject, GUARD_SEEDS);
}

/* ---- The effect itself ----------------------------------------------------------------------------------------------------
 */

static ew_effect *effects[2];

static void effect_create(int context)
{
    const ew_effect_desc desc = {.get_proc_address = context_get_proc_address, .user = contexts[context]};
    const ew_point point = {.position = {0.1, 0.1, 0}, .coefficient = 0.3, .color = {1, 0.5, 0.2}, .reach = 2};
    const ew_line line = {.position = {0, -0.5, 0}, .direction = {1, 0.2, 0.1}, .coefficient = 0.2, .color = {0.2, 0.5, 1}};
    const ew_torus torus = {.axis = {1, 0.3, 0}, .radius = 0.4, .coefficient = 0.1, .color = {0.3, 1, 0.4}};
    const ew_sources_desc sources = {
        .points = &point, .point_count = 1, .lines = &line, .line_count = 1, .tori = &torus, .torus_count = 1, .epsilon = 1e-2};
    ew_error error = {.text = ""};
    if (ew_create_effect(&desc, &effects[context], &error) != EW_OK) fail_msg("%s", error.text);
    if (ew_set_sources(effects[context], &sources, &error) != EW_OK) fail_msg("%s", error.text);
}

static void effect_destroy(int context)
{
    ew_destroy_effect(effects[context]);
    effects[context] = NULL;
}

/* Each source of depth comes to every target. */
static void choose_depth(ew_frame_desc *frame)
{
    const ew_depth_source sources[] = {EW_DEPTH_TEXTURE, EW_DEPTH_FRAMEBUFFER, EW_DEPTH_TEXTURE_MULTISAMPLE};
    frame->depth_source = sources[current_seed / (2 * TARGET_COUNT) % (has_multisampled_textures() ? 3 : 2)];
    if (frame->depth_source == EW_DEPTH_TEXTURE) frame->depth_texture = host_depth[ODD_DEPTH].name;
    if (frame->depth_source == EW_DEPTH_TEXTURE_MULTISAMPLE) frame->depth_texture = host_depth[MULTISAMPLED_DEPTH].name;
}

/* The scrambled host may draw upside down, which the effect follows; with this it draws what the clean one draws. */
static void turn_back(ew_frame_desc *frame)
{
    GLint origin = GL_LOWER_LEFT;
    if (api_has(45, NEVER, gl.es ? "GL_EXT_clip_control" : "GL_ARB_clip_control")) gl.GetIntegerv(GL_CLIP_ORIGIN, &origin);
    for (int column = 0; column < 4 && origin == GL_UPPER_LEFT; column++)
        frame->projection[4 * column + 1] *= -1;
}

static ew_frame_desc effect_frame(int context, const test_target *target)
{
    static const ew_output outputs[TARGET_COUNT] = {EW_OUTPUT_LERP, EW_OUTPUT_LUMINANCE, EW_OUTPUT_ADD};
    static const ew_encoding encodings[TARGET_COUNT] = {EW_ENCODING_LINEAR_8BIT, EW_ENCODING_FLOAT, EW_ENCODING_SRGB_8BIT};
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.view[14] = -3;
    frame.interval_start = 1;
    frame.interval_end = 5;
    frame.output = outputs[target - targets];
    frame.framebuffer = target->framebuffers[context];
    frame.viewport_width = WIDTH;
    frame.viewport_height = HEIGHT;
    frame.encoding = encodings[target - targets];
    frame.dither = 1;
    frame.resolution = current_seed % 2 ? EW_RESOLUTION_ADAPTIVE : EW_RESOLUTION_FULL;
    choose_depth(&frame);
    turn_back(&frame);
    return frame;
}

/* The clean context draws without having prepared: so it would show if preparing left anything in the picture. */
static void effect_draw(int context, const test_target *target)
{
    const ew_frame_desc frame = effect_frame(context, target);
    ew_error error = {.text = ""};
    int is_ready = context != SCRAMBLED;
    while (!is_ready)
        if (ew_prepare(effects[context], NULL, &frame, &is_ready, &error) != EW_OK) fail_msg("%s", error.text);
    if (ew_draw(effects[context], &frame, &error) != EW_OK) fail_msg("%s", error.text);
}

static void preparing_and_drawing_leave_all_state_and_the_picture_is_clean(void **unused)
{
    (void)unused;
    static const test_subject subject = {effect_draw, effect_create, effect_destroy};
    check_neutrality(&subject, EFFECT_SEEDS);
}

static void create_nothing(int context)
{
    (void)context;
}

static void effect_live(int context, const test_target *target)
{
    effect_create(context);
    effect_draw(context, target);
    effect_destroy(context);
}

static void create_and_destroy_leave_all_state(void **unused)
{
    (void)unused;
    static const test_subject subject = {effect_live, create_nothing, create_nothing};
    check_neutrality(&subject, LIFE_SEEDS);
}

static void expect_failure(int context, const ew_frame_desc *frame, ew_result result)
{
    ew_error error = {.text = ""};
    assert_int_equal(ew_draw(effects[context], frame, &error), result);
    assert_int_equal(error.code, result);
    assert_true(strlen(error.text) > 0);
}

/* Frames that are refused before GL is touched, and some that GL refuses; then a good one. */
static void effect_draw_after_failures(int context, const test_target *target)
{
    ew_frame_desc frame = effect_frame(context, target);
    frame.interval_end = frame.interval_start;
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    frame = effect_frame(context, target);
    frame.framebuffer = 12345;
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    frame = effect_frame(context, target);
    frame.depth_source = EW_DEPTH_TEXTURE;
    frame.depth_texture = 12345;
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    frame = effect_frame(context, target);
    frame.framebuffer = incomplete_framebuffers[context];
    debug_output_pause(); /* Mesa says what an incomplete framebuffer lacks, and what is wrong with a texture */
    expect_failure(context, &frame, EW_ERROR_OPENGL);
    frame = effect_frame(context, target);
    frame.depth_source = EW_DEPTH_TEXTURE;
    frame.depth_texture = cube_texture;
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    frame.depth_source = EW_DEPTH_TEXTURE_MULTISAMPLE;
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    frame.depth_source = EW_DEPTH_FRAMEBUFFER;
    frame.framebuffer = depthless_framebuffers[context];
    expect_failure(context, &frame, EW_ERROR_INVALID_ARGUMENT);
    if (context == SCRAMBLED) debug_output_resume();
    effect_draw(context, target);
}

static void failed_draws_leave_all_state(void **unused)
{
    (void)unused;
    static const test_subject subject = {effect_draw_after_failures, effect_create, effect_destroy};
    check_neutrality(&subject, LIFE_SEEDS);
}

/* ---- Without restoration --------------------------------------------------------------------------------------------------
 */

/* What energywave.h says that a draw with skip_restore leaves changed: the names of tests/gl/state.c; of those with an index,
 * the first. */
static struct dirty_state {
    const char *name;
    int count;      /* of units or bindings; 0 stands for 1 */
    bool may_stay;  /* on hardware, where some drivers leave it alone */
    int stays_from; /* the versions of OpenGL and OpenGL ES, times 10, from which on it is left alone; 0: none */
    int stays_from_es;
    bool known; /* in this context */
    bool seen;
} dirty_states[] = {
    {.name = "GL_CURRENT_PROGRAM"},
    {.name = "GL_VERTEX_ARRAY_BINDING"},
    {.name = "GL_ELEMENT_ARRAY_BUFFER_BINDING"},
    {.name = "GL_UNIFORM_BUFFER_BINDING"},
    {.name = "GL_UNIFORM_BUFFER", .count = 2},
    {.name = "GL_ACTIVE_TEXTURE"},
    {.name = "GL_SAMPLER_BINDING", .count = 7},
    {.name = "GL_TEXTURE_BINDING_2D", .count = 7},
    {.name = "GL_TEXTURE_BINDING_2D_MULTISAMPLE"},
    {.name = "GL_DRAW_FRAMEBUFFER_BINDING"},
    {.name = "GL_READ_FRAMEBUFFER_BINDING"},
    {.name = "GL_VIEWPORT"},
    {.name = "GL_VIEWPORT of the array"},
    {.name = "GL_BLEND"},
    {.name = "GL_BLEND of a draw buffer"},
    {.name = "GL_BLEND_SRC_RGB"},
    {.name = "GL_BLEND_DST_RGB"},
    {.name = "GL_BLEND_SRC_ALPHA"},
    {.name = "GL_BLEND_DST_ALPHA"},
    {.name = "GL_BLEND_EQUATION_RGB"},
    {.name = "GL_BLEND_EQUATION_ALPHA"},
    {.name = "GL_COLOR_WRITEMASK"},
    {.name = "GL_COLOR_WRITEMASK of a draw buffer"},
    {.name = "GL_SAMPLE_MASK_VALUE", .stays_from = 40, .stays_from_es = 32},
    {.name = "GL_POLYGON_MODE"},
    {.name = "GL_CLAMP_FRAGMENT_COLOR"},
    {.name = "GL_CULL_FACE"},
    {.name = "GL_DEPTH_TEST"},
    {.name = "GL_STENCIL_TEST"},
    {.name = "GL_RASTERIZER_DISCARD"},
    {.name = "GL_FRAMEBUFFER_SRGB"},
    {.name = "GL_MULTISAMPLE"},
    {.name = "GL_SAMPLE_ALPHA_TO_COVERAGE"},
    {.name = "GL_SAMPLE_ALPHA_TO_ONE"},
    {.name = "GL_SAMPLE_COVERAGE"},
    {.name = "GL_SAMPLE_MASK"},
    {.name = "GL_SAMPLE_SHADING"},
    {.name = "GL_POLYGON_SMOOTH"},
    {.name = "GL_COLOR_LOGIC_OP"},
    {.name = "GL_PRIMITIVE_RESTART"},
    {.name = "GL_PROGRAM_POINT_SIZE"},
    {.name = "GL_POINT_SMOOTH"},
    {.name = "GL_POINT_SPRITE"},
    {.name = "GL_CLIP_DISTANCE0"},
    {.name = "GL_CLIP_DISTANCE1"},
    {.name = "GL_CLIP_DISTANCE2"},
    {.name = "GL_CLIP_DISTANCE3"},
    {.name = "GL_CLIP_DISTANCE4"},
    {.name = "GL_CLIP_DISTANCE5"},
    {.name = "GL_CLIP_DISTANCE6"},
    {.name = "GL_CLIP_DISTANCE7"},
    {.name = "GL_ALPHA_TEST"},
    {.name = "GL_POLYGON_STIPPLE"},
    {.name = "GL_DEPTH_BOUNDS_TEST_EXT"},
    /* What Mesa tells of these is no larger than the draw framebuffer's stencil buffer can hold. */
    {.name = "GL_STENCIL_REF", .may_stay = true},
    {.name = "GL_STENCIL_BACK_REF", .may_stay = true},
};
enum { DIRTY_COUNT = sizeof dirty_states / sizeof dirty_states[0] };

static struct dirty_state *find_dirty(const state_value *value)
{
    for (int i = 0; i < DIRTY_COUNT; i++) {
        struct dirty_state *dirty = &dirty_states[i];
        bool stays = dirty->stays_from > 0 && api_has(dirty->stays_from, dirty->stays_from_es, NULL);
        if (!stays && strcmp(dirty->name, value->name) == 0) return dirty;
    }
    return NULL;
}

/* Counts the differences that are not on the list, and marks those that are. */
static int count_undocumented_differences(const state *before, const state *after)
{
    int undocumented = 0;
    assert_int_equal(before->count, after->count);
    for (size_t i = 0; i < before->count; i++) {
        const state_value *old = &before->values[i], *new = &after->values[i];
        struct dirty_state *dirty = find_dirty(old);
        if (dirty) dirty->known = true;
        if (old->value == new->value) continue;
        if (dirty && old->index < (dirty->count ? dirty->count : 1)) {
            dirty->seen = true;
        } else if (undocumented++ < 10) {
            fprintf(stderr, "%s [%d].%d was %.9g, is %.9g\n", old->name, old->index, old->component, old->value, new->value);
        }
    }
    return undocumented;
}

/* Draws with and without success from a state that is already scrambled. */
static void draw_without_restoring(const test_target *target)
{
    ew_frame_desc frame = effect_frame(SCRAMBLED, target);
    frame.skip_restore = 1;
    ew_error error = {.text = ""};
    frame.depth_source = EW_DEPTH_TEXTURE;
    frame.depth_texture = 12345;
    expect_failure(SCRAMBLED, &frame, EW_ERROR_INVALID_ARGUMENT);
    choose_depth(&frame);
    if (ew_draw(effects[SCRAMBLED], &frame, &error) != EW_OK) fail_msg("%s", error.text);
}

static void without_restoration_only_what_is_documented_is_dirty(void **unused)
{
    (void)unused;
    static state before, after;
    static test_picture expected, found;
    make_current(CLEAN);
    effect_create(CLEAN);
    make_current(SCRAMBLED);
    effect_create(SCRAMBLED);
    for (current_seed = 1; current_seed <= DIRTY_SEEDS; current_seed++) {
        const test_target *target = &targets[current_seed / 2 % TARGET_COUNT];
        make_current(CLEAN);
        clear_target(target);
        gl.Finish();
        make_current(SCRAMBLED);
        host_scramble(&host, current_seed, false);
        host_settle(&host); /* transform feedback must not be active */
        if (target->samples > 0) gl.Disable(GL_SCISSOR_TEST);
        scramble_draw_buffers(target);
        const host_wish wish = ask_wish();
        state_objects objects = host_objects(&host);
        objects.framebuffers = &target->framebuffers[SCRAMBLED];
        objects.framebuffer_count = 1;
        objects.textures = host_depth;
        objects.texture_count = has_multisampled_textures() ? HOST_DEPTH_COUNT : 1;
        state_take(&before, &objects);
        draw_without_restoring(target);
        state_take(&after, &objects);
        assert_int_equal(count_undocumented_differences(&before, &after), 0);
        assert_int_equal(gl.GetError(), GL_NO_ERROR);
        gl.Finish();
        make_current(CLEAN);
        read_picture(target, GL_COLOR_ATTACHMENT0, &found);
        const test_subject subject = {effect_draw, create_nothing, create_nothing};
        draw_clean(&subject, target, &wish, &expected);
        assert_int_equal(count_different_pixels(&found, &expected), 0);
        state_free(&before);
        state_free(&after);
    }
    for (int i = 0; i < DIRTY_COUNT; i++)
        if (dirty_states[i].known && !dirty_states[i].seen && !(dirty_states[i].may_stay && !api_is_software()))
            fail_msg("%s is documented as dirty, but never is", dirty_states[i].name);
    make_current(SCRAMBLED);
    effect_destroy(SCRAMBLED);
    make_current(CLEAN);
    effect_destroy(CLEAN);
}

/* Draws with `program` in use, which is the caller's to prepare, and expects a refusal that says `text`, or success if NULL. */
static void check_draw_with_program(GLuint program, const char *text)
{
    static state before, after;
    ew_error error = {.text = ""};
    const state_objects objects = {.programs = &program, .program_count = 1};
    const ew_frame_desc frame = effect_frame(SCRAMBLED, &targets[0]);
    state_take(&before, &objects);
    ew_result result = ew_draw(effects[SCRAMBLED], &frame, &error);
    state_take(&after, &objects);
    assert_int_equal(state_count_differences(&before, &after), 0);
    state_free(&before);
    state_free(&after);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    assert_int_equal(result, text ? EW_ERROR_OPENGL : EW_OK);
    if (text) assert_non_null(strstr(error.text, text));
}

static void a_program_that_cannot_be_restored_is_refused(void **unused)
{
    (void)unused;
    make_current(SCRAMBLED);
    host_scramble(&host, 1, false);
    host_settle(&host);
    effect_create(SCRAMBLED);

    GLuint program = build_host_program();
    gl.UseProgram(program);
    const char *nothing = "nothing";
    gl.TransformFeedbackVaryings(program, 1, &nothing, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(program); /* fails */
    check_draw_with_program(program, "linked again");
    gl.UseProgram(0);
    gl.DeleteProgram(program);

    program = build_host_program();
    gl.UseProgram(program);
    gl.DeleteProgram(program);
    check_draw_with_program(program, has_pipelines() ? NULL : "flagged for deletion");
    gl.UseProgram(0);
    assert_false(gl.IsProgram(program));
    effect_destroy(SCRAMBLED);
}

/* Surfaceless contexts have no window's framebuffer; OSMesa's is its buffer. */
static void the_window_s_framebuffer_is_drawn_to_if_there_is_one(void **unused)
{
    (void)unused;
    make_current(SCRAMBLED);
    effect_create(SCRAMBLED);
    host_scramble(&host, 1, false);
    host_settle(&host);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    bool complete = gl.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    ew_frame_desc frame = effect_frame(SCRAMBLED, &targets[0]);
    frame.framebuffer = 0;
    ew_error error = {.text = ""};
    ew_result result = ew_draw(effects[SCRAMBLED], &frame, &error);
    assert_int_equal(result, complete ? EW_OK : EW_ERROR_OPENGL);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    effect_destroy(SCRAMBLED);
}

static void objects_that_another_context_deleted_do_not_come_back(void **unused)
{
    (void)unused;
    make_current(SCRAMBLED);
    effect_create(SCRAMBLED);
    host_scramble(&host, 1, false);
    host_settle(&host);
    GLuint texture, multisampled = 0, sampler, buffer;
    gl.GenTextures(1, &texture);
    gl.ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    if (has_multisampled_textures()) {
        gl.GenTextures(1, &multisampled);
        gl.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, multisampled);
    }
    gl.GenSamplers(1, &sampler);
    gl.BindSampler(EW_GL_DEPTH_TEXTURE_UNIT, sampler);
    gl.GenBuffers(1, &buffer);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, EW_GL_UNIFORM_BINDING, buffer);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
    gl.Finish();
    make_current(CLEAN);
    gl.DeleteTextures(1, &texture);
    gl.DeleteTextures(1, &multisampled);
    gl.DeleteSamplers(1, &sampler);
    gl.DeleteBuffers(1, &buffer);
    gl.Finish();

    make_current(SCRAMBLED);
    for (current_seed = 0; current_seed < 6 * TARGET_COUNT; current_seed += 2 * TARGET_COUNT)
        effect_draw(SCRAMBLED, &targets[0]);
    assert_int_equal(gl.GetError(), GL_NO_ERROR);
    GLint bound = -1;
    gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    assert_int_equal(bound, 0);
    if (has_multisampled_textures()) {
        gl.GetIntegerv(GL_TEXTURE_BINDING_2D_MULTISAMPLE, &bound);
        assert_int_equal(bound, 0);
    }
    gl.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &bound);
    assert_int_equal(bound, 0);
    gl.GetIntegerv(GL_SAMPLER_BINDING, &bound);
    assert_int_equal(bound, 0);
    gl.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &bound);
    assert_int_equal(bound, 0);
    gl.GetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, EW_GL_UNIFORM_BINDING, &bound);
    assert_int_equal(bound, 0);
    /* Of these names the effect may have made objects of its own meanwhile, where the driver gives them out again. */
    effect_destroy(SCRAMBLED);
    assert_false(gl.IsTexture(texture));
    assert_false(multisampled && gl.IsTexture(multisampled));
    assert_false(gl.IsSampler(sampler));
    assert_false(gl.IsBuffer(buffer));
}

int main(int argc, char **argv)
{
    if (argc != 2 || (contexts[CLEAN] = open_context(argv[1], NULL)) == NULL) return 2;
    make_targets();
    incomplete_framebuffers[CLEAN] = make_incomplete_framebuffer();
    depthless_framebuffers[CLEAN] = make_depthless_framebuffer();
    contexts[SCRAMBLED] = open_context(argv[1], contexts[CLEAN]);
    if (contexts[SCRAMBLED] == NULL) return 2;
    host_create(&host);
    incomplete_framebuffers[SCRAMBLED] = make_incomplete_framebuffer();
    depthless_framebuffers[SCRAMBLED] = make_depthless_framebuffer();
    for (int j = 0; j < TARGET_COUNT; j++)
        targets[j].framebuffers[SCRAMBLED] = make_framebuffer(&targets[j]);

    const struct CMUnitTest tests[] = {
        cmocka_unit_test(guard_restores_all_state_and_the_picture_is_clean),
        cmocka_unit_test(preparing_and_drawing_leave_all_state_and_the_picture_is_clean),
        cmocka_unit_test(create_and_destroy_leave_all_state),
        cmocka_unit_test(failed_draws_leave_all_state),
        cmocka_unit_test(without_restoration_only_what_is_documented_is_dirty),
        cmocka_unit_test(a_program_that_cannot_be_restored_is_refused),
        cmocka_unit_test(the_window_s_framebuffer_is_drawn_to_if_there_is_one),
        cmocka_unit_test(objects_that_another_context_deleted_do_not_come_back),
    };
    int failed = cmocka_run_group_tests_name(argv[1], tests, NULL, NULL);
    close_context(contexts[SCRAMBLED]);
    close_context(contexts[CLEAN]);
    return failed;
}
