/* The window's mouse and camera: see window_mouse.h. */
#include "window_mouse.h"
#include "window_edit.h"

#include <math.h>

static bool is_down(const demo_window *window, int key)
{
    return key != window->command_key && glfwGetKey(window->handle, key) == GLFW_PRESS;
}

void window_on_cursor(GLFWwindow *handle, double x, double y)
{
    demo_window *window = glfwGetWindowUserPointer(handle);
    const double degrees_a_pixel = 0.25;
    double right = degrees_a_pixel * (x - window->cursor[0]), down = degrees_a_pixel * (y - window->cursor[1]);
    window->cursor[0] = x;
    window->cursor[1] = y;
    if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS && window_edit_has_cursor(window)) return;
    if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS)
        camera_control_orbit(&window->camera, window_scene(window), -right, down);
    else if (glfwGetMouseButton(handle, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS)
        camera_control_look(&window->camera, window_scene(window), right, -down);
}

void window_on_button(GLFWwindow *handle, int button, int action, int mods)
{
    (void)mods;
    demo_window *window = glfwGetWindowUserPointer(handle);
    if (button != GLFW_MOUSE_BUTTON_LEFT) return;
    if (action == GLFW_PRESS)
        window_edit_press(window);
    else
        window_edit_release(window);
}

void window_on_scroll(GLFWwindow *handle, double x, double y)
{
    (void)x;
    demo_window *window = glfwGetWindowUserPointer(handle);
    camera_control_approach(&window->camera, window_scene(window), pow(1.1, y));
}

void window_fly(demo_window *window, double seconds)
{
    static const int keys[3][2] = {{GLFW_KEY_A, GLFW_KEY_D}, {GLFW_KEY_Q, GLFW_KEY_E}, {GLFW_KEY_S, GLFW_KEY_W}};
    /* Ctrl+S saves, and does not fly. */
    if (is_down(window, GLFW_KEY_LEFT_CONTROL) || is_down(window, GLFW_KEY_RIGHT_CONTROL)) return;
    const scene_camera *camera = &window_scene(window)->camera;
    double sight = 0, way[3];
    for (int i = 0; i < 3; i++)
        sight += (camera->target[i] - camera->eye[i]) * (camera->target[i] - camera->eye[i]);
    /* World units per second: a part of the distance from the eye to the target of the scene's own camera. */
    double speed = sqrt(sight) * (is_down(window, GLFW_KEY_LEFT_SHIFT) ? 1.2 : 0.3);
    bool moves = false;
    for (int i = 0; i < 3; i++) {
        way[i] = speed * seconds * (is_down(window, keys[i][1]) - is_down(window, keys[i][0]));
        moves = moves || way[i] != 0;
    }
    if (moves) camera_control_fly(&window->camera, window_scene(window), way);
}
