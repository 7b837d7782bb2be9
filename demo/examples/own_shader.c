/*
 * The light in the host's own shader, in a forward pass: a room whose walls are drawn together with the glow before them, and
 * whose floor mirrors it. Nothing calls ew_draw. Escape ends it.
 */
#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLCOREARB
#include <energywave.h>
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char version[] = "#version 330 core\n";
static const char vertex_shader[] =
    "uniform mat4 camera[2]; uniform vec3 eye; out vec3 from_eye; flat out vec3 inwards;\n"
    "const int corners[6] = int[](0, 1, 2, 2, 1, 3);\n"
    "void main() {\n" /* a room's 6 sides of 2 triangles, from the vertex's number alone */
    "    int side = gl_VertexID / 6, corner = corners[gl_VertexID % 6], axis = side % 3;\n"
    "    vec3 p = vec3(side / 3, corner & 1, corner >> 1) * 2.0 - 1.0, normal = vec3(-p.x, 0, 0);\n"
    "    p = vec3(6, 2, 6) * (axis == 0 ? p.xyz : axis == 1 ? p.zxy : p.yzx);\n"
    "    inwards = axis == 0 ? normal.xyz : axis == 1 ? normal.zxy : normal.yzx;\n"
    "    from_eye = p - eye;\n"
    "    gl_Position = camera[1] * camera[0] * vec4(p, 1);\n"
    "}\n";
static const char fragment_shader[] =
    "in vec3 from_eye; flat in vec3 inwards; out vec4 color;\n"
    "void main() {\n"
    "    float distance = length(from_eye);\n"
    "    vec3 direction = from_eye / distance, surface = vec3(0.05 + 0.02 * dot(inwards, vec3(0.3, 0.6, 0.9)));\n"
    "    float glow = ew_luminance(vec3(0), direction, distance);\n"
    "    if (inwards.y > 0.5) glow += 0.5 * ew_luminance(from_eye, reflect(direction, inwards), 20.0);\n"
    "    color = vec4(1.0 - (1.0 - surface) * exp(-glow * vec3(0.1, 0.4, 1.0)), 1);\n"
    "}\n";

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "own_shader: %s\n", what);
    exit(1);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return glfwGetProcAddress(name);
}

static void attach(GLuint program, GLenum stage, const char *library_text, const char *text)
{
    const char *const texts[] = {version, library_text, text};
    GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 3, texts, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glDeleteShader(shader);
}

static GLuint link_program(const char *light_text)
{
    GLint is_linked;
    GLuint program = glCreateProgram();
    attach(program, GL_VERTEX_SHADER, "", vertex_shader);
    attach(program, GL_FRAGMENT_SHADER, light_text, fragment_shader);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
    check(is_linked, "the shader is refused");
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, "ew_uniforms"), 0);
    return program;
}

static void draw_room(const ew_frame_desc *frame, GLuint program, GLuint uniforms)
{
    GLfloat camera[2][16];
    for (int i = 0; i < 16; i++) {
        camera[0][i] = (GLfloat)frame->view[i];
        camera[1][i] = (GLfloat)frame->projection[i];
    }
    glViewport(0, 0, frame->viewport_width, frame->viewport_height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "camera"), 2, GL_FALSE, camera[0]);
    glUniform3f(glGetUniformLocation(program, "eye"), 0, 0.5f, 5);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, uniforms);
    glDrawArrays(GL_TRIANGLES, 0, 36);
}

static GLFWwindow *open_window(void)
{
    check(glfwInit(), "GLFW finds no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    GLFWwindow *window = glfwCreateWindow(960, 540, "EnergyWave", NULL, NULL);
    check(window != NULL, "no window with OpenGL 3.3");
    glfwMakeContextCurrent(window);
    return window;
}

int main(void)
{
    GLFWwindow *window = open_window();
    GLuint vertex_array;
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glEnable(GL_DEPTH_TEST);

    ew_effect *effect;
    ew_error error;
    double ends[2][3] = {{-3, 0, 0}, {3, 0, 0}};
    ew_path beam = {.points = (const double(*)[3])ends, .point_count = 2, .core = 0.05, .reach = 1.5, .brightness = 2};
    beam.sharpness = 2;
    ew_sources_desc sources = {.paths = &beam, .path_count = 1};
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    frame.view[13] = -0.5, frame.view[14] = -5;
    frame.viewport_width = frame.viewport_height = 1;
    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);
    const char *light_text;
    check(ew_get_shader_text(effect, NULL, &frame, &light_text, &error) == EW_OK, error.text);
    GLuint program = link_program(light_text);
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS) {
        unsigned uniforms;
        glfwGetFramebufferSize(window, &frame.viewport_width, &frame.viewport_height);
        frame.projection[0] = (double)frame.viewport_height / fmax(frame.viewport_width, 1);
        ends[0][1] = sin(glfwGetTime()), ends[1][1] = -ends[0][1];
        check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);
        if (frame.viewport_width > 0) {
            check(ew_update_uniform_buffer(effect, &frame, &uniforms, &error) == EW_OK, error.text);
            draw_room(&frame, program, uniforms);
        }
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    ew_destroy_effect(effect);
    glfwTerminate();
}
