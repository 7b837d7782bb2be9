/* A complete host: draws pillars to a GLFW window, and light among them that the pillars hide. Escape ends it. */
#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_GLCOREARB
#include <energywave.h>
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char vertex_shader[] =
    "#version 330 core\n"
    "uniform mat4 camera[2]; flat out float light; const int corners[6] = int[](0, 1, 2, 2, 1, 3);\n"
    "void main() {\n" /* a pillar's 6 sides of 2 triangles, from the vertex's number alone */
    "    int side = gl_VertexID / 6, corner = corners[gl_VertexID % 6], axis = side % 3;\n"
    "    vec3 p = vec3(side / 3, corner & 1, corner >> 1) * 2.0 - 1.0;\n"
    "    p = vec3(0.3, 1.5, 0.3) * (axis == 0 ? p.xyz : axis == 1 ? p.zxy : p.yzx);\n"
    "    float turn = float(gl_InstanceID) * 1.2566; light = 0.02 + 0.02 * float(axis);\n"
    "    gl_Position = camera[1] * camera[0] * vec4(p + 2.5 * vec3(cos(turn), 0, sin(turn)), 1);\n"
    "}\n";
static const char fragment_shader[] =
    "#version 330 core\nflat in float light; out vec4 color; void main() { color = vec4(vec3(light), 1); }\n";

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "glfw: %s\n", what);
    exit(1);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return glfwGetProcAddress(name);
}

static void attach(GLuint program, GLenum stage, const char *text)
{
    GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glAttachShader(program, shader);
}

int main(void)
{
    check(glfwInit(), "GLFW finds no display");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SRGB_CAPABLE, GLFW_TRUE);
    GLFWwindow *window = glfwCreateWindow(960, 540, "EnergyWave", NULL, NULL);
    check(window != NULL, "no window with OpenGL 3.3");
    glfwMakeContextCurrent(window);
    GLuint program = glCreateProgram(), vertex_array;
    attach(program, GL_VERTEX_SHADER, vertex_shader);
    attach(program, GL_FRAGMENT_SHADER, fragment_shader);
    glLinkProgram(program);
    glUseProgram(program);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);

    ew_effect *effect;
    ew_error error;
    ew_torus ring = {.axis = {0.3, 1, 0}, .radius = 2.5, .core = 0.03, .reach = 0.8, .brightness = 2, .color = {0.1, 0.4, 1}};
    ew_point orb = {.core = 0.2, .reach = 1.5, .brightness = 2, .color = {1, 0.4, 0.1}};
    ring.sharpness = orb.sharpness = 2;
    ew_sources_desc sources = {.tori = &ring, .torus_count = 1, .points = &orb, .point_count = 1};
    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    while (!glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS) {
        ew_frame_desc frame = EW_FRAME_DEFAULTS;
        glfwGetFramebufferSize(window, &frame.viewport_width, &frame.viewport_height);
        double angle = 0.5 * glfwGetTime(), c = cos(angle), s = sin(angle);
        double view[16] = {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, -0.3, -8, 1};
        double projection[16] = {
            [0] = 2.0 * frame.viewport_height / fmax(frame.viewport_width, 1), [5] = 2, [10] = -1, [11] = -1, [14] = -0.2};
        GLfloat camera[2][16];
        for (int i = 0; i < 16; i++) {
            camera[0][i] = (GLfloat)(frame.view[i] = view[i]);
            camera[1][i] = (GLfloat)(frame.projection[i] = projection[i]);
        }
        glViewport(0, 0, frame.viewport_width, frame.viewport_height);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUniformMatrix4fv(glGetUniformLocation(program, "camera"), 2, GL_FALSE, camera[0]);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 5);
        orb.position[1] = sin(2 * angle);
        frame.depth_source = EW_DEPTH_FRAMEBUFFER;
        frame.encoding = EW_ENCODING_SRGB_8BIT;
        check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);
        if (frame.viewport_width > 0) check(ew_draw(effect, &frame, &error) == EW_OK, error.text);
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    ew_destroy_effect(effect);
    glfwTerminate();
}
