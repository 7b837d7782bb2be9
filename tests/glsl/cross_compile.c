/*
 * Hands shaders to the compilers of Direct3D and Metal: GLSL to SPIR-V to HLSL and MSL, as WebGL and its like do. Says which
 * shaders are refused, and why.
 *
 *     cross_compile < FILES    a list of names, one a line, which end in .vert or .frag
 */
#include <glslang/Include/glslang_c_interface.h>
#include <glslang/Public/resource_limits_c.h>
#include <spirv_cross_c.h>

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_MAX = 1 << 20, NAME_MAX_LENGTH = 4096 };

/* SPIR-V takes GLSL ES from 3.10 on, which has all that 3.00 has. */
static bool read_shader(const char *name, char text[TEXT_MAX])
{
    static const char es_300[] = "#version 300 es", es_310[] = "#version 310 es";
    FILE *file = fopen(name, "r");
    if (!file) return false;
    text[fread(text, 1, TEXT_MAX - 1, file)] = '\0';
    const bool is_whole = feof(file);
    fclose(file);
    if (memcmp(text, es_300, strlen(es_300)) == 0) memcpy(text, es_310, strlen(es_310));
    return is_whole;
}

static bool complain(const char *name, const char *step, const char *text)
{
    printf("%s: %s: %s\n", name, step, text);
    return false;
}

/* ---- GLSL to SPIR-V ---- */

static bool parse(const char *name, glslang_shader_t *shader, const glslang_input_t *input)
{
    glslang_shader_set_options(shader, GLSLANG_SHADER_AUTO_MAP_BINDINGS | GLSLANG_SHADER_AUTO_MAP_LOCATIONS);
    if (glslang_shader_preprocess(shader, input) && glslang_shader_parse(shader, input)) return true;
    return complain(name, "GLSL", glslang_shader_get_info_log(shader));
}

static bool link_alone(const char *name, glslang_program_t *program, glslang_shader_t *shader, glslang_stage_t stage)
{
    glslang_program_add_shader(program, shader);
    if (!glslang_program_link(program, GLSLANG_MSG_SPV_RULES_BIT) || !glslang_program_map_io(program))
        return complain(name, "linking", glslang_program_get_info_log(program));
    glslang_program_SPIRV_generate(program, stage);
    const char *messages = glslang_program_SPIRV_get_messages(program);
    return messages ? complain(name, "SPIR-V", messages) : true;
}

/* ---- SPIR-V to the others ---- */

static bool translate(const char *name, spvc_context context, glslang_program_t *program, spvc_backend backend)
{
    spvc_parsed_ir ir;
    spvc_compiler compiler;
    spvc_compiler_options options;
    const char *text;
    if (spvc_context_parse_spirv(context, glslang_program_SPIRV_get_ptr(program), glslang_program_SPIRV_get_size(program),
                                 &ir) ||
        spvc_context_create_compiler(context, backend, ir, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler) ||
        spvc_compiler_create_compiler_options(compiler, &options) ||
        (backend == SPVC_BACKEND_HLSL && spvc_compiler_options_set_uint(options, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, 50)) ||
        spvc_compiler_install_compiler_options(compiler, options) || spvc_compiler_compile(compiler, &text))
        return complain(name, backend == SPVC_BACKEND_HLSL ? "HLSL" : "MSL", spvc_context_get_last_error_string(context));
    return true;
}

/* HLSL has no size of points: ANGLE makes quads of them. */
static bool translate_to_all(const char *name, glslang_program_t *program, bool has_point_size)
{
    spvc_context context;
    if (spvc_context_create(&context)) return complain(name, "SPIRV-Cross", "there is no memory");
    const bool crosses = (has_point_size || translate(name, context, program, SPVC_BACKEND_HLSL)) &&
                         translate(name, context, program, SPVC_BACKEND_MSL);
    spvc_context_destroy(context);
    return crosses;
}

static bool cross_compile(const char *name, const char *text)
{
    const char *suffix = strrchr(name, '.');
    const glslang_stage_t stage = suffix && strcmp(suffix, ".vert") == 0 ? GLSLANG_STAGE_VERTEX : GLSLANG_STAGE_FRAGMENT;
    const glslang_input_t input = {.language = GLSLANG_SOURCE_GLSL,
                                   .stage = stage,
                                   .client = GLSLANG_CLIENT_OPENGL,
                                   .client_version = GLSLANG_TARGET_OPENGL_450,
                                   .target_language = GLSLANG_TARGET_SPV,
                                   .target_language_version = GLSLANG_TARGET_SPV_1_0,
                                   .code = text,
                                   .default_version = 100,
                                   .default_profile = GLSLANG_NO_PROFILE,
                                   .messages = GLSLANG_MSG_SPV_RULES_BIT,
                                   .resource = glslang_default_resource()};
    glslang_shader_t *shader = glslang_shader_create(&input);
    glslang_program_t *program = glslang_program_create();
    const bool crosses = parse(name, shader, &input) && link_alone(name, program, shader, stage) &&
                         translate_to_all(name, program, strstr(text, "gl_PointSize"));
    glslang_program_delete(program);
    glslang_shader_delete(shader);
    return crosses;
}

int main(void)
{
    static char text[TEXT_MAX];
    char name[NAME_MAX_LENGTH];
    int status = EXIT_SUCCESS;
    glslang_initialize_process();
    while (fgets(name, sizeof name, stdin)) {
        name[strcspn(name, "\n")] = '\0';
        const bool is_read = read_shader(name, text) || complain(name, "reading", "the file cannot be read");
        if (!is_read || !cross_compile(name, text)) status = EXIT_FAILURE;
    }
    glslang_finalize_process();
    return status;
}
