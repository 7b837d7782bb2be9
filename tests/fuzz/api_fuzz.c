/*
 * The library under random descriptors, hostile ones among them: each call is an error that leaves the picture, the effect and
 * GL as they were, or a picture without a value that is infinite, negative or not a number. Nothing else.
 *
 *     api_fuzz [FIRST_NUMBER COUNT]
 *
 * Each case follows from its number alone, which is printed where a promise is broken.
 */
#include "context.h"
#include "random_desc.h"
#include "random_numbers.h"
#include "spoil_desc.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 12, HEIGHT = 10, VALUES = 4 * WIDTH * HEIGHT, DEFAULT_COUNT = 3000, SKIPPED = 77 };

static const shader_mix mixes[] = {
    {.counts = {[KIND_POINT] = 1}},
    {.counts = {[KIND_LINE] = 1}, .depth = DEPTH_FRAMEBUFFER},
    {.counts = {[KIND_TORUS] = 1}, .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_CURVE] = 1}, .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_CURVE] = 1}, .weighted = true, .output = EW_OUTPUT_LUMINANCE, .depth = DEPTH_TEXTURE},
    {.counts = {[KIND_POINT] = 3, [KIND_LINE] = 2}, .output = EW_OUTPUT_LUMINANCE, .depth = DEPTH_MULTISAMPLE},
    {.count_of_each = 5,
     .counts = {[KIND_POINT] = 2, [KIND_LINE] = 1},
     .weighted = true,
     .output = EW_OUTPUT_ADD,
     .depth = DEPTH_TEXTURE},
    {.count_of_each = 5, .output = EW_OUTPUT_EVALUATIONS, .encoding = EW_ENCODING_FLOAT},
    {.count_of_each = 5, .weighted = true, .integrator = EW_INTEGRATOR_SIMPSON, .depth = DEPTH_TEXTURE},
    {.depth = DEPTH_TEXTURE},
    {.counts = {[KIND_LINE] = 1}, .dither = true},
    {.counts = {[KIND_POINT] = 1}, .dither = true, .encoding = EW_ENCODING_SRGB_8BIT},
    {.counts = {[KIND_PATH] = 1}, .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_PATH] = 3}, .weighted = true, .field = FIELD_REACH, .has_core_pixels = true, .depth = DEPTH_TEXTURE},
    {.count_of_each = 1, .field = FIELD_WORLD, .has_core_pixels = true, .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_PATH] = 2},
     .field = FIELD_WORLD,
     .weighted = true,
     .depth = DEPTH_TEXTURE,
     .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_TORUS] = 1, [KIND_CURVE] = 1}, .field = FIELD_WORLD, .weighted = true, .output = EW_OUTPUT_LUMINANCE},
    {.count_of_each = 5,
     .field = FIELD_WORLD,
     .weighted = true,
     .sharp = true,
     .has_core_pixels = true,
     .output = EW_OUTPUT_SOFT,
     .depth = DEPTH_FRAMEBUFFER},
    {.count_of_each = 2, .field = FIELD_REACH, .sharp = true, .output = EW_OUTPUT_ADD, .depth = DEPTH_MULTISAMPLE},
    {.count_of_each = 5,
     .field = FIELD_WORLD,
     .weighted = true,
     .integrator = EW_INTEGRATOR_SIMPSON,
     .has_core_pixels = true,
     .output = EW_OUTPUT_LUMINANCE},
    {.counts = {[KIND_POINT] = 1, [KIND_LINE] = 1},
     .field = FIELD_WORLD,
     .sharp = true,
     .output = EW_OUTPUT_SOFT,
     .dither = true},
    {.count_of_each = 1, .lights_surfaces = true, .output = EW_OUTPUT_SURFACES, .depth = DEPTH_TEXTURE},
    {.count_of_each = 5,
     .field = FIELD_WORLD,
     .weighted = true,
     .lights_surfaces = true,
     .has_shadows = true,
     .output = EW_OUTPUT_SURFACES,
     .depth = DEPTH_FRAMEBUFFER},
    {.counts = {[KIND_TORUS] = 2, [KIND_PATH] = 2},
     .field = FIELD_REACH,
     .lights_surfaces = true,
     .output = EW_OUTPUT_SURFACES,
     .depth = DEPTH_MULTISAMPLE},
};
enum { MIX_COUNT = sizeof mixes / sizeof mixes[0] };

/* Of every so many cases one is in fog, or among media. */
static const shader_mix air_mixes[] = {
    {.count_of_each = 1, .weighted = true, .has_fog = true, .output = EW_OUTPUT_LUMINANCE},
    {.count_of_each = 5,
     .field = FIELD_WORLD,
     .weighted = true,
     .sharp = true,
     .has_core_pixels = true,
     .has_fog = true,
     .output = EW_OUTPUT_SOFT,
     .depth = DEPTH_TEXTURE},
    {.count_of_each = 1,
     .field = FIELD_WORLD,
     .weighted = true,
     .has_fog = true,
     .has_media = true,
     .output = EW_OUTPUT_LERP,
     .depth = DEPTH_FRAMEBUFFER},
    {.count_of_each = 1, .has_media = true, .output = EW_OUTPUT_SOFT, .depth = DEPTH_MULTISAMPLE, .dither = true},
};
enum { AIR_MIX_COUNT = sizeof air_mixes / sizeof air_mixes[0], AIR_INTERVAL = 8 };

typedef struct fuzzer {
    const gl_functions *gl;
    ew_effect *effect;
    GLuint framebuffer, depth_framebuffer, incomplete_framebuffer; /* the second has a depth of its own, the last nothing */
    GLuint color_texture, depth_texture, attached_texture, multisample_texture, cube_texture;
    uint64_t number; /* of the case */
    uint64_t random;
    size_t drawn, refused;
    float before[VALUES], after[VALUES];
} fuzzer;

static void fail(const fuzzer *f, const char *what)
{
    fprintf(stderr, "case %llu: %s; repeat it by: api_fuzz %llu 1\n", (unsigned long long)f->number, what,
            (unsigned long long)f->number);
    exit(EXIT_FAILURE);
}

static void require(const fuzzer *f, bool condition, const char *what)
{
    if (!condition) fail(f, what);
}

/* ---- GL ----------------------------------------------------------------------------------------------------------------- */

static GLuint create_texture(const gl_functions *gl, GLenum target)
{
    GLuint texture;
    gl->GenTextures(1, &texture);
    gl->BindTexture(target, texture);
    return texture;
}

static GLuint create_framebuffer(const gl_functions *gl, GLenum target, GLuint color, GLuint depth)
{
    GLuint framebuffer;
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, color, 0);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, target, depth, 0);
    return framebuffer;
}

static void put_depths(const gl_functions *gl, GLuint texture, const float depths[WIDTH * HEIGHT])
{
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
}

static void put_background(const fuzzer *f)
{
    f->gl->BindTexture(GL_TEXTURE_2D, f->color_texture);
    f->gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, WIDTH, HEIGHT, 0, GL_RGBA, GL_FLOAT, f->before);
}

static void create_objects(fuzzer *f, gl_context *context)
{
    const gl_functions *gl = f->gl;
    PFNGLTEXIMAGE2DMULTISAMPLEPROC tex_image_2d_multisample =
        (PFNGLTEXIMAGE2DMULTISAMPLEPROC)context_get_proc_address(context, "glTexImage2DMultisample");
    f->color_texture = create_texture(gl, GL_TEXTURE_2D);
    put_background(f);
    f->depth_texture = create_texture(gl, GL_TEXTURE_2D);
    f->attached_texture = create_texture(gl, GL_TEXTURE_2D);
    put_depths(gl, f->attached_texture, NULL);
    f->cube_texture = create_texture(gl, GL_TEXTURE_CUBE_MAP);
    f->multisample_texture = create_texture(gl, GL_TEXTURE_2D_MULTISAMPLE);
    tex_image_2d_multisample(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_DEPTH_COMPONENT24, WIDTH, HEIGHT, GL_TRUE);
    create_framebuffer(gl, GL_TEXTURE_2D_MULTISAMPLE, 0, f->multisample_texture);
    gl->ClearBufferfv(GL_DEPTH, 0, &(float){0.75f});
    f->incomplete_framebuffer = create_framebuffer(gl, GL_TEXTURE_2D, 0, 0);
    f->framebuffer = create_framebuffer(gl, GL_TEXTURE_2D, f->color_texture, 0);
    f->depth_framebuffer = create_framebuffer(gl, GL_TEXTURE_2D, f->color_texture, f->attached_texture);
}

/* A background that is not the same everywhere, and depths with the nearest and the farthest among them. */
static void fill_target(fuzzer *f)
{
    float depths[WIDTH * HEIGHT];
    for (int i = 0; i < VALUES; i++)
        f->before[i] = (float)(4 * random_unit(&f->random));
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        depths[i] = (float)fmin(fmax(random_unit(&f->random) * 3 - 1, 0), 1);
    put_depths(f->gl, f->depth_texture, depths);
    put_depths(f->gl, f->attached_texture, depths);
}

static void choose_target(const fuzzer *f, target_depth depth, ew_frame_desc *frame)
{
    frame->framebuffer = depth == DEPTH_FRAMEBUFFER ? f->depth_framebuffer : f->framebuffer;
    frame->depth_source = depth == DEPTH_FRAMEBUFFER   ? EW_DEPTH_FRAMEBUFFER
                          : depth == DEPTH_MULTISAMPLE ? EW_DEPTH_TEXTURE_MULTISAMPLE
                                                       : EW_DEPTH_TEXTURE;
    frame->depth_texture = depth == DEPTH_TEXTURE ? f->depth_texture : depth == DEPTH_MULTISAMPLE ? f->multisample_texture : 0;
}

static void read_target(const fuzzer *f, float values[VALUES])
{
    f->gl->BindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
    f->gl->ReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, values);
}

/* Every integral is cut to what is finite and not negative; in GLSL that leaves open what becomes of one that is not a number.
 * Here it becomes a negative pixel, to be seen. */
typedef struct shader_cut {
    const char *text, *telling;
    bool was_found;
} shader_cut;
static shader_cut cuts[] = {
    {"clamp(color.w * integral, 0.0, EW_MAX_LUMINANCE)",
     "(isnan(color.w * integral) ? -1e38 : clamp(color.w * integral, 0.0, EW_MAX_LUMINANCE))", false},
    {"clamp(color.w * irradiance, 0.0, EW_MAX_IRRADIANCE)",
     "(isnan(color.w * irradiance) ? -1e38 : clamp(color.w * irradiance, 0.0, EW_MAX_IRRADIANCE))", false},
};
enum { CUT_COUNT = sizeof cuts / sizeof *cuts };
static PFNGLSHADERSOURCEPROC shader_source;

static void APIENTRY telling_shader_source(GLuint shader, GLsizei count, const GLchar *const *strings, const GLint *lengths)
{
    enum { MAX_STRINGS = 128, MAX_LENGTH = 1 << 16 };
    static char text[CUT_COUNT][MAX_LENGTH];
    const char *changed[MAX_STRINGS], *found;
    for (GLsizei i = 0; i < count && i < MAX_STRINGS; i++) {
        changed[i] = strings[i];
        for (int k = 0; k < CUT_COUNT; k++) {
            if (!(found = strstr(strings[i], cuts[k].text))) continue;
            snprintf(text[k], sizeof text[k], "%.*s%s%s", (int)(found - strings[i]), strings[i], cuts[k].telling,
                     found + strlen(cuts[k].text));
            changed[i] = text[k];
            cuts[k].was_found = true;
        }
    }
    shader_source(shader, count, changed, lengths);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    ew_gl_function function = context_get_proc_address(user, name);
    if (strcmp(name, "glShaderSource") != 0) return function;
    shader_source = (PFNGLSHADERSOURCEPROC)function;
    return (ew_gl_function)telling_shader_source;
}

/* ---- Calls and their promises ------------------------------------------------------------------------------------------- */

static void check_error(const fuzzer *f, ew_result result, const ew_error *error, const ew_error *untouched)
{
    require(f, f->gl->GetError() == GL_NO_ERROR, "a GL error is left");
    if (result == EW_OK) {
        require(f, memcmp(error, untouched, sizeof *error) == 0, "a call that succeeds touches the error");
        return;
    }
    require(f, error->code == result, "the error's code is not the result");
    require(f, memchr(error->text, '\0', sizeof error->text) && error->text[0], "the error has no text");
    require(f, !strchr(error->text, '\n'), "the error's text has a line break");
}

static ew_result set_sources(fuzzer *f, const ew_sources_desc *sources)
{
    ew_error error, untouched;
    memset(&error, 0x55, sizeof error);
    untouched = error;
    ew_result result = ew_set_sources(f->effect, sources, &error);
    check_error(f, result, &error, &untouched);
    return result;
}

/* Draws over f->before; the picture is then in f->after. */
static ew_result draw(fuzzer *f, const ew_frame_desc *frame)
{
    ew_error error, untouched;
    memset(&error, 0x55, sizeof error);
    untouched = error;
    put_background(f);
    ew_result result = ew_draw(f->effect, frame, &error);
    check_error(f, result, &error, &untouched);
    read_target(f, f->after);
    if (result == EW_OK) {
        f->drawn++;
        for (int i = 0; i < VALUES; i++)
            require(f, isfinite(f->after[i]) && f->after[i] >= 0, "a pixel is infinite, negative or not a number");
    } else {
        f->refused++;
        require(f, memcmp(f->before, f->after, sizeof f->before) == 0, "a draw that fails changes the picture");
    }
    return result;
}

/* Sources that may be refused: then those of before are still there. */
static void try_sources(fuzzer *f, const random_desc *desc, const ew_sources_desc *sources, bool drawable)
{
    float picture[VALUES];
    memcpy(picture, f->after, sizeof picture);
    if (set_sources(f, sources) != EW_OK) {
        f->refused++;
        if (!drawable) return;
        require(f, draw(f, &desc->frame) == EW_OK, "after sources that were refused, the old ones are not drawn");
        require(f, memcmp(picture, f->after, sizeof picture) == 0, "sources that are refused change the picture");
    } else {
        draw(f, &desc->frame);
    }
}

/* Bounds lie in the viewport, or are left alone. */
static void try_bounds(fuzzer *f, const ew_frame_desc *frame)
{
    ew_error error, untouched;
    memset(&error, 0x55, sizeof error);
    untouched = error;
    ew_bounds bounds = {.x = -1, .width = -7};
    ew_result result = ew_get_bounds(f->effect, frame, &bounds, &error);
    check_error(f, result, &error, &untouched);
    if (result != EW_OK) {
        require(f, bounds.x == -1 && bounds.width == -7, "bounds are not left alone");
        return;
    }
    int64_t right = (int64_t)bounds.x + bounds.width, top = (int64_t)bounds.y + bounds.height;
    require(f, bounds.width >= 0 && bounds.height >= 0, "bounds have a negative size");
    if (bounds.width == 0 || bounds.height == 0) return;
    require(f, bounds.x >= frame->viewport_x && right <= (int64_t)frame->viewport_x + frame->viewport_width,
            "bounds leave the viewport");
    require(f, bounds.y >= frame->viewport_y && top <= (int64_t)frame->viewport_y + frame->viewport_height,
            "bounds leave the viewport");
    require(f, bounds.depth_start <= bounds.depth_end, "bounds have depths in the wrong order, or that are not numbers");
}

/* The calls that draw nothing leave the picture alone, whatever the frame is. */
static void try_other_calls(fuzzer *f, const shader_mix *sources, const ew_frame_desc *frame)
{
    const size_t any = random_index(&f->random, 2) ? SIZE_MAX : EW_ANY_COUNT;
    ew_mix mix = {.has_weights = sources->weighted,
                  .has_reach = sources->field != FIELD_PLAIN,
                  .has_sharpness = sources->sharp,
                  .has_bends = 1};
    for (int kind = 0; kind < SOURCE_KIND_COUNT; kind++) {
        size_t count = shader_mix_count(sources, kind);
        set_mix_count(source_kinds[kind], &mix, count < EW_ANY_COUNT ? count : any);
    }
    ew_error error, untouched;
    memset(&error, 0x55, sizeof error);
    untouched = error;
    int is_ready;
    unsigned buffer = 0;
    const char *text = NULL;
    memcpy(f->before, f->after, sizeof f->before);
    const ew_mix *prepared = random_index(&f->random, 2) ? &mix : NULL;
    ew_result result;
    do {
        is_ready = -1;
        error = untouched;
        result = ew_prepare(f->effect, prepared, frame, &is_ready, &error);
        check_error(f, result, &error, &untouched);
        require(f, result == EW_OK ? is_ready == 0 || is_ready == 1 : is_ready == -1, "is_ready is neither set nor left alone");
    } while (is_ready == 0);
    error = untouched;
    result = ew_update_uniform_buffer(f->effect, frame, &buffer, &error);
    check_error(f, result, &error, &untouched);
    require(f, (result == EW_OK) == (buffer != 0), "the uniform buffer's name is neither set nor left alone");
    error = untouched;
    result = ew_get_shader_text(f->effect, &mix, frame, &text, &error);
    check_error(f, result, &error, &untouched);
    require(f, (result == EW_OK) == (text != NULL), "the shader's text is neither set nor left alone");
    try_bounds(f, frame);
    read_target(f, f->after);
    require(f, memcmp(f->before, f->after, sizeof f->before) == 0, "a call that draws nothing changes the picture");
}

/* A framebuffer or a texture that is not there, not complete, of another kind or in use. */
static void spoil_target(fuzzer *f, ew_frame_desc *frame)
{
    const GLuint framebuffers[] = {0, f->incomplete_framebuffer, 4000000000u, 12345};
    const GLuint textures[] = {
        f->cube_texture, f->multisample_texture, f->depth_texture, f->attached_texture, 4000000000u, 12345};
    if (frame->depth_texture && random_index(&f->random, 2) == 0) {
        frame->depth_texture = textures[random_index(&f->random, 6)];
        frame->framebuffer = f->depth_framebuffer;
    } else {
        frame->framebuffer = framebuffers[random_index(&f->random, 4)];
    }
}

static void run_case(fuzzer *f)
{
    f->random = f->number;
    const shader_mix *mix = &mixes[random_index(&f->random, MIX_COUNT)];
    if (f->number % AIR_INTERVAL == 0) mix = &air_mixes[f->number / AIR_INTERVAL % AIR_MIX_COUNT];
    bool extreme = random_index(&f->random, 2) == 0;
    random_desc desc = {.sources = {0}};
    fill_target(f);
    require(f, random_desc_make(&desc, mix, extreme, WIDTH, HEIGHT, &f->random), "memory is exhausted");
    choose_target(f, mix->depth, &desc.frame);

    ew_result set = set_sources(f, &desc.sources);
    bool drawable = set == EW_OK && draw(f, &desc.frame) == EW_OK;
    /* Long splines with small cores have more pieces than fit. */
    bool is_too_much = set == EW_ERROR_TOO_MANY_SOURCES && desc.sources.path_count > 0;
    require(f, drawable || extreme || is_too_much, "an ordinary scene is refused");
    switch (random_index(&f->random, 8)) {
    case 0:
        spoil_source_number(&desc, &f->random);
        try_sources(f, &desc, &desc.sources, drawable);
        break;
    case 1:
        spoil_all_source_numbers(&desc, &f->random);
        try_sources(f, &desc, &desc.sources, drawable);
        break;
    case 2:
        spoil_lists(&desc, &f->random);
        try_sources(f, &desc, &desc.sources, drawable);
        break;
    case 3:
        spoil_frame_number(&desc, &f->random);
        break;
    case 4:
        spoil_all_frame_numbers(&desc, &f->random);
        break;
    case 5:
        spoil_frame_integer(&desc, &f->random);
        break;
    case 6:
        spoil_target(f, &desc.frame);
        break;
    default:
        try_sources(f, &desc, NULL, drawable);
        draw(f, NULL);
        break;
    }
    draw(f, &desc.frame);
    try_other_calls(f, mix, &desc.frame);
    random_desc_free(&desc);
}

int main(int argc, char **argv)
{
    uint64_t first = argc == 3 ? strtoull(argv[1], NULL, 10) : 1,
             count = argc == 3 ? strtoull(argv[2], NULL, 10) : DEFAULT_COUNT;
    char message[256];
    gl_context *context = context_create(CONTEXT_EGL, message, sizeof message);
    if (!context) {
        printf("SKIPPED: %s\n", message);
        return SKIPPED;
    }
    static fuzzer f;
    ew_error error;
    f.gl = context_gl(context);
    if (ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address, .user = context}, &f.effect, &error) !=
        EW_OK) {
        fprintf(stderr, "%s\n", error.text);
        return EXIT_FAILURE;
    }
    create_objects(&f, context);
    for (f.number = first; f.number < first + count; f.number++)
        run_case(&f);
    bool has_all_cuts = cuts[0].was_found && cuts[1].was_found;
    require(&f, has_all_cuts || count < DEFAULT_COUNT, "no shader cuts integrals in these words: see telling_shader_source");
    printf("%llu cases: %zu pictures, %zu refusals\n", (unsigned long long)count, f.drawn, f.refused);
    ew_destroy_effect(f.effect);
    context_destroy(context);
    return EXIT_SUCCESS;
}
