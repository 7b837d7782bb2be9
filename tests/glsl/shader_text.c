/*
 * Writes the text of every class of shader permutation to files, through a GL that only takes the shaders' sources:
 * shader_text FOLDER. Names are PROFILE-KEY.vert and PROFILE-KEY.frag.
 */
#include "base/allocator.h"
#include "host/program_cache.h"

#include <stdio.h>
#include <stdlib.h>

enum { VERTEX_SHADER = 1, FRAGMENT_SHADER = 2 };

static const char *folder;
static char shader_name[64]; /* of the shaders that come next */
static const char *profile;

static GLuint create_shader(GLenum stage)
{
    return stage == GL_VERTEX_SHADER ? VERTEX_SHADER : FRAGMENT_SHADER;
}

static void shader_source(GLuint shader, GLsizei count, const GLchar *const *strings, const GLint *lengths)
{
    (void)lengths;
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.%s", folder, shader_name, shader == VERTEX_SHADER ? "vert" : "frag");
    FILE *file = fopen(path, "w");
    for (GLsizei i = 0; file && i < count; ++i)
        fputs(strings[i], file);
    if (!file || fclose(file) != 0) {
        perror(path);
        exit(EXIT_FAILURE);
    }
}

static void do_nothing(GLuint object)
{
    (void)object;
}

static void attach_or_detach(GLuint program, GLuint shader)
{
    (void)program;
    (void)shader;
}

static void say_yes(GLuint object, GLenum query, GLint *answer)
{
    (void)object;
    (void)query;
    *answer = GL_TRUE;
}

static GLuint create_program(void)
{
    return 1;
}

static GLuint no_block(GLuint program, const GLchar *name)
{
    (void)program;
    (void)name;
    return GL_INVALID_INDEX;
}

static void ignore_binding(GLuint program, GLuint block, GLuint binding)
{
    (void)program;
    (void)block;
    (void)binding;
}

static GLint no_uniform(GLuint program, const GLchar *name)
{
    (void)program;
    (void)name;
    return -1;
}

static void write_permutation(ew_program_cache *cache, const ew_gl *gl, size_t capacity, unsigned key)
{
    GLuint program;
    ew_error error;
    snprintf(shader_name, sizeof shader_name, "%s-%05x", profile, key);
    if (ew_program_get(cache, gl, capacity, &ew_default_allocator, key, &program, &error) == EW_OK) return;
    fprintf(stderr, "%s: %s\n", shader_name, error.text);
    exit(EXIT_FAILURE);
}

/* What main() does with the integral is the same for all of them: multisampled depth and dither meet only some. */
static bool is_wanted_pass(unsigned flags)
{
    const unsigned dither = EW_PROGRAM_DITHER | EW_PROGRAM_DITHER_SRGB;
    if (flags & EW_PROGRAM_DEPTH_MULTISAMPLE)
        return flags & EW_PROGRAM_DEPTH && !(flags & (dither | EW_PROGRAM_SIMPSON | EW_PROGRAM_WEIGHTS));
    if (flags & dither) return flags == EW_PROGRAM_DITHER || flags == dither;
    return true;
}

/* Every set of flags that can meet, on every set of kinds, with few sources of each (a literal count) and with many. */
static void write_permutations(const ew_gl *gl, size_t capacity)
{
    enum { KIND_COUNT = 4, ALL_CURVES = 1 << 3, BOTH_OUTPUTS = EW_PROGRAM_LUMINANCE | EW_PROGRAM_EVALUATIONS };
    ew_program_cache cache = {0};
    for (unsigned flags = 0; flags < 1u << EW_PROGRAM_FLAG_COUNT; ++flags) {
        if ((flags & BOTH_OUTPUTS) == BOTH_OUTPUTS) continue;
        if (!is_wanted_pass(flags)) continue;
        for (unsigned kinds = 0; kinds < 1u << KIND_COUNT; ++kinds) {
            if (flags & EW_PROGRAM_WEIGHTS && !(kinds & ALL_CURVES)) continue;
            for (unsigned count = 1; count <= EW_PROGRAM_MAX_UNROLLED + 1; count += EW_PROGRAM_MAX_UNROLLED) {
                unsigned key = flags;
                for (unsigned kind = 0; kind < KIND_COUNT; ++kind)
                    if (kinds & 1u << kind) key |= count << (EW_PROGRAM_FLAG_COUNT + kind * EW_PROGRAM_COUNT_BITS);
                write_permutation(&cache, gl, capacity, key);
            }
        }
    }
    ew_program_cache_destroy(&cache, gl, &ew_default_allocator);
}

/* The text for hosts' shaders, as the only thing in a shader that uses it: of all kinds, one by one and all at once. */
static void write_includes(size_t capacity, const char *version)
{
    static const ew_mix mixes[] = {
        {0},
        {.point_count = 1},
        {.line_count = 2},
        {.torus_count = 3},
        {.curve_count = 4},
        {EW_ANY_COUNT, EW_ANY_COUNT, EW_ANY_COUNT, EW_ANY_COUNT, 1},
    };
    for (size_t i = 0; i < sizeof mixes / sizeof mixes[0]; ++i) {
        for (int integrator = EW_INTEGRATOR_ADAPTIVE; integrator <= EW_INTEGRATOR_SIMPSON; ++integrator) {
            unsigned key = ew_program_key(&mixes[i], &(ew_frame_desc){.integrator = (ew_integrator)integrator}, 0);
            char *text = malloc(ew_program_write_include(capacity, key, NULL) + 1);
            if (!text) exit(EXIT_FAILURE);
            ew_program_write_include(capacity, key, text);
            snprintf(shader_name, sizeof shader_name, "%s-include-%05x", profile, key);
            const char *const strings[] = {version, text, "out vec4 color;\nvoid main()\n{\n",
                                           "color = ew_light(vec3(0.0), vec3(1.0), vec2(0.0, 1.0), 1.0);\n",
                                           "color.a = ew_luminance(vec3(0.0), vec3(1.0), vec2(0.0, 1.0), 1.0);\n}\n"};
            shader_source(FRAGMENT_SHADER, 5, strings, NULL);
            free(text);
        }
    }
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: shader_text FOLDER\n");
        return EXIT_FAILURE;
    }
    folder = argv[1];
    ew_gl gl = {
        .CreateShader = create_shader,
        .ShaderSource = shader_source,
        .CompileShader = do_nothing,
        .GetShaderiv = say_yes,
        .DeleteShader = do_nothing,
        .CreateProgram = create_program,
        .AttachShader = attach_or_detach,
        .LinkProgram = do_nothing,
        .DetachShader = attach_or_detach,
        .GetProgramiv = say_yes,
        .DeleteProgram = do_nothing,
        .GetUniformBlockIndex = no_block,
        .UniformBlockBinding = ignore_binding,
        .GetUniformLocation = no_uniform,
    };
    /* The capacities of the smallest uniform blocks that GL allows and of the largest in use, likewise the varyings: all few
     * sources fit between the stages, or not even a curve; the profiles' least versions; hardware and software. */
    size_t smallest = ew_scene_capacity(16384), largest = ew_scene_capacity(65536);
    profile = "330";
    write_permutations(&gl, largest);
    write_includes(largest, "#version 330\n");
    gl.software = true;
    profile = "330-software";
    gl.max_varying_vectors = 31;
    write_permutations(&gl, largest);
    profile = "300es-software";
    gl.es = true;
    gl.max_varying_vectors = 16;
    write_permutations(&gl, smallest);
    gl.software = false;
    profile = "300es";
    write_permutations(&gl, smallest);
    write_includes(smallest, "#version 300 es\n");
    return EXIT_SUCCESS;
}
