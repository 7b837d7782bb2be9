/*
 * No stutter: a loading screen, on which a bar grows while the shaders of all sources that may come are compiled, and then the
 * game, in which no first shot waits for a compiler. Escape ends it.
 */
#include <energywave.h>
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "loading_screen: %s\n", what);
    exit(1);
}

static ew_gl_function get_proc_address(void *user, const char *name)
{
    (void)user;
    return glfwGetProcAddress(name);
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

/* The frame as both the loading screen and the game draw it: what compiles for one is what the other needs. */
static ew_frame_desc make_frame(GLFWwindow *window)
{
    ew_frame_desc frame = EW_FRAME_DEFAULTS;
    glfwGetFramebufferSize(window, &frame.viewport_width, &frame.viewport_height);
    frame.viewport_width = frame.viewport_width > 0 ? frame.viewport_width : 1; /* 0 while the window is an icon */
    frame.viewport_height = frame.viewport_height > 0 ? frame.viewport_height : 1;
    frame.view[14] = -4;
    frame.projection[0] = (double)frame.viewport_height / frame.viewport_width;
    frame.output = EW_OUTPUT_SOFT;
    frame.dither = 1;
    return frame;
}

static void draw_bar(const ew_frame_desc *frame, double share)
{
    glEnable(GL_SCISSOR_TEST);
    glScissor(frame->viewport_width / 10, frame->viewport_height / 10, (int)(0.8 * share * frame->viewport_width), 8);
    glClearColor(0.3f, 0.5f, 0.8f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(0, 0, 0, 1);
    glDisable(GL_SCISSOR_TEST);
}

/* One frame of loading. Returns whether every shader is ready. */
static int load(ew_effect *effect, const ew_frame_desc *frame, int frame_number)
{
    /* Orbs and straight beams, as many as there may ever be, each with a reach and a sharpness. */
    const ew_mix mix = {.point_count = EW_ANY_COUNT, .path_count = EW_ANY_COUNT, .has_reach = 1, .has_sharpness = 1};
    int is_ready;
    ew_error error;
    check(ew_prepare(effect, &mix, frame, &is_ready, &error) == EW_OK, error.text);
    draw_bar(frame, is_ready ? 1 : 1 - 1 / (1 + 0.1 * frame_number)); /* how long it takes, nobody knows */
    return is_ready;
}

/* One frame of the game: a shot a second, from an orb. */
static void play(ew_effect *effect, const ew_frame_desc *frame, double seconds)
{
    ew_point orb = {.position = {-3, 0, 0}, .core = 0.3, .reach = 2, .brightness = 2, .sharpness = 2, .color = {0.1, 0.4, 1}};
    const double flown = 6 * fmod(seconds, 1), ends[2][3] = {{flown - 3, 0, 0}, {flown - 2, 0, 0}};
    ew_path shot = {.points = ends, .point_count = 2, .core = 0.05, .reach = 0.8, .brightness = 2, .sharpness = 2};
    ew_sources_desc sources = {.points = &orb, .point_count = 1, .paths = &shot, .path_count = seconds >= 1};
    ew_error error;
    shot.color[0] = 1, shot.color[1] = 0.3, shot.color[2] = 0.1;
    check(ew_set_sources(effect, &sources, &error) == EW_OK, error.text);
    check(ew_draw(effect, frame, &error) == EW_OK, error.text);
}

int main(void)
{
    GLFWwindow *window = open_window();
    ew_effect *effect;
    ew_error error;
    int is_loaded = 0;
    check(ew_create_effect(&(ew_effect_desc){.get_proc_address = get_proc_address}, &effect, &error) == EW_OK, error.text);
    for (int i = 0; !glfwWindowShouldClose(window) && glfwGetKey(window, GLFW_KEY_ESCAPE) != GLFW_PRESS; i++) {
        const ew_frame_desc frame = make_frame(window);
        glClear(GL_COLOR_BUFFER_BIT);
        if (is_loaded)
            play(effect, &frame, glfwGetTime());
        else if ((is_loaded = load(effect, &frame, i)))
            glfwSetTime(0); /* the game begins */
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    ew_destroy_effect(effect);
    glfwTerminate();
}
