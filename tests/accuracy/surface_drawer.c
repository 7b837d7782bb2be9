/* The irradiance of any surfaces: see surface_drawer.h. */
#include "surface_drawer.h"
#include "message.h"
#include "shader.h"
#include "texture.h"

#include <stdlib.h>
#include <string.h>

bool surface_drawer_create(gl_context *context, ew_effect *effect, surface_drawer *drawer, char *message, size_t size)
{
    const gl_functions *gl = context_gl(context);
    bool complete = true;
    *drawer = (surface_drawer){.gl = gl, .effect = effect};
    drawer->bind_buffer_base = (PFNGLBINDBUFFERBASEPROC)context_get_proc_address(context, "glBindBufferBase");
    drawer->positions = texture_create(gl, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE, GL_RGBA32F, GL_RGBA);
    drawer->normals = texture_create(gl, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE, GL_RGBA32F, GL_RGBA);
    drawer->target = texture_create(gl, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE, GL_RGBA32F, GL_RGBA);
    drawer->framebuffer = texture_framebuffer(gl, drawer->target, 0, &complete);
    gl->GenVertexArrays(1, &drawer->vertex_array);
    if (complete && drawer->bind_buffer_base) return true;
    message_write(message, size, "the context cannot draw to float textures");
    surface_drawer_destroy(drawer);
    return false;
}

void surface_drawer_destroy(surface_drawer *drawer)
{
    const gl_functions *gl = drawer->gl;
    const GLuint textures[] = {drawer->positions, drawer->normals, drawer->target};
    for (int i = 0; i < drawer->program_count; i++) {
        gl->DeleteProgram(drawer->programs[i].name);
        free(drawer->programs[i].text);
    }
    gl->DeleteVertexArrays(1, &drawer->vertex_array);
    gl->DeleteFramebuffers(1, &drawer->framebuffer);
    gl->DeleteTextures(3, textures);
}

/* Returns 0, with a message, on failure. */
static GLuint link_program(const gl_functions *gl, const char *light_text, char *message, size_t size)
{
    static const char vertex[] = "#version 330 core\nvoid main()\n{\n"
                                 "gl_Position = vec4(2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0);\n}\n";
    static const char begin[] = "#version 330 core\n";
    static const char end[] =
        "uniform sampler2D positions;\nuniform sampler2D normals;\nout vec4 color;\nvoid main()\n{\n"
        "ivec2 place = ivec2(gl_FragCoord.xy);\n"
        "color = vec4(ew_irradiance(texelFetch(positions, place, 0).xyz, texelFetch(normals, place, 0).xyz), 1.0);\n}\n";
    char *fragment = malloc(sizeof begin + strlen(light_text) + sizeof end);
    if (!fragment) {
        message_write(message, size, "memory is exhausted");
        return 0;
    }
    strcpy(fragment, begin);
    strcat(fragment, light_text);
    strcat(fragment, end);
    GLuint program = shader_link(gl, vertex, fragment, "the surfaces'", message, size);
    free(fragment);
    if (program) {
        gl->UseProgram(program);
        gl->Uniform1i(gl->GetUniformLocation(program, "normals"), 1);
        gl->UseProgram(0);
    }
    return program;
}

static GLuint get_program(surface_drawer *drawer, const char *text, char *message, size_t size)
{
    for (int i = 0; i < drawer->program_count; i++)
        if (strcmp(drawer->programs[i].text, text) == 0) return drawer->programs[i].name;
    surface_program *made = &drawer->programs[drawer->program_count];
    char *copy = drawer->program_count < MAX_SURFACE_PROGRAMS ? malloc(strlen(text) + 1) : NULL;
    GLuint name = copy ? link_program(drawer->gl, text, message, size) : 0;
    if (!copy) message_write(message, size, "the programs do not fit into memory");
    if (!name) {
        free(copy);
        return 0;
    }
    *made = (surface_program){strcpy(copy, text), name};
    drawer->program_count++;
    return name;
}

static void fill_texture(const gl_functions *gl, GLuint texture, const reference_surface *surfaces, bool of_normals)
{
    GLfloat data[SURFACE_DRAWER_COUNT][4] = {{0}};
    for (int i = 0; i < SURFACE_DRAWER_COUNT; i++)
        for (int k = 0; k < 3; k++)
            data[i][k] = (GLfloat)(of_normals ? surfaces[i].normal[k] : surfaces[i].position[k]);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE, GL_RGBA, GL_FLOAT, data);
}

static void shade(const surface_drawer *drawer, GLuint program, unsigned buffer, const reference_surface *surfaces,
                  float light[SURFACE_DRAWER_COUNT][4])
{
    const gl_functions *gl = drawer->gl;
    gl->ActiveTexture(GL_TEXTURE0 + 1);
    fill_texture(gl, drawer->normals, surfaces, true);
    gl->ActiveTexture(GL_TEXTURE0);
    fill_texture(gl, drawer->positions, surfaces, false);
    gl->BindFramebuffer(GL_FRAMEBUFFER, drawer->framebuffer);
    gl->Viewport(0, 0, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE);
    gl->UseProgram(program);
    drawer->bind_buffer_base(GL_UNIFORM_BUFFER, 0, buffer);
    gl->BindVertexArray(drawer->vertex_array);
    gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl->BindVertexArray(0);
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    texture_read(gl, drawer->framebuffer, (pixel_rectangle){0, 0, SURFACE_DRAWER_SIDE, SURFACE_DRAWER_SIDE}, GL_RGBA, GL_FLOAT,
                 light);
}

bool surface_drawer_draw(surface_drawer *drawer, const ew_sources_desc *sources, const ew_frame_desc *frame,
                         const reference_surface surfaces[SURFACE_DRAWER_COUNT], float light[SURFACE_DRAWER_COUNT][4],
                         bool *has_room, char *message, size_t size)
{
    const char *text = NULL;
    unsigned buffer = 0;
    ew_error error;
    ew_result result = ew_set_sources(drawer->effect, sources, &error);
    if (result == EW_OK) result = ew_get_shader_text(drawer->effect, NULL, frame, &text, &error);
    if (result == EW_OK) result = ew_update_uniform_buffer(drawer->effect, frame, &buffer, &error);
    *has_room = result != EW_ERROR_TOO_MANY_SOURCES;
    if (result != EW_OK) {
        message_write(message, size, "%s", error.text);
        return false;
    }
    GLuint program = get_program(drawer, text, message, size);
    if (program) shade(drawer, program, buffer, surfaces, light);
    return program != 0;
}
