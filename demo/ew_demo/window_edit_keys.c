/* Changing parts of a scene by keys: see window_edit_keys.h. */
#include "window_edit_keys.h"
#include "scene_edit.h"
#include "window_edit.h"

#include <string.h>

/* How far an arrow key moves a slider, in lengths of it; the second with Shift. */
static const double slider_steps[2] = {0.01, 0.001};

static void save(demo_window *window)
{
    char message[600];
    if (!scene_watch_save(&window->file, message, sizeof message))
        window_notify(window, message);
    else
        window_notify(window, "saved");
}

static void undo(demo_window *window)
{
    if (!scene_document_undo(&window->file.document)) window_notify(window, "there is nothing to undo");
}

static void redo(demo_window *window)
{
    if (!scene_document_redo(&window->file.document)) window_notify(window, "there is nothing to redo");
}

void window_edit_key_with_ctrl(demo_window *window, int key, int scancode, int mods)
{
    /* What the key says on this keyboard: Z and Y change places on some. */
    const char *name = glfwGetKeyName(key, scancode);
    if (!name || !window->options->scene) return;
    window->edit.grip = GRIP_NONE;
    if (strcmp(name, "s") == 0)
        save(window);
    else if (strcmp(name, "y") == 0 || (strcmp(name, "z") == 0 && mods & GLFW_MOD_SHIFT))
        redo(window);
    else if (strcmp(name, "z") == 0)
        undo(window);
    window_edit_check(window);
}

/* Behind the last part comes none, and then the first one. */
static void select_next(demo_window *window, bool backwards)
{
    window_edit *edit = &window->edit;
    const demo_scene *scene = &window->file.document.scene;
    size_t count = scene_part_total(scene);
    size_t number = edit->has_selection ? scene_part_number(scene, edit->selected) : count;
    number = (number + (backwards ? count : 1)) % (count + 1);
    edit->has_selection = scene_part_of_number(scene, number, &edit->selected);
    edit->grip = GRIP_NONE;
}

static void choose_slider(demo_window *window, int step)
{
    edit_panel panel = window_edit_panel(window);
    int chosen = panel.chosen + step;
    if (chosen >= 0 && chosen < panel.slider_count) window->edit.chosen_slider = chosen;
}

static void move_slider(demo_window *window, double way)
{
    char message[500];
    scene_document *document = &window->file.document;
    edit_panel panel = window_edit_panel(window);
    if (panel.slider_count == 0) return;
    const edit_slider *slider = &panel.sliders[panel.chosen];
    double value = edit_panel_value_beside(&panel, panel.chosen, way);
    if (value == slider->value) return;
    char *text = scene_edit_set_number(scene_document_text(document), window->edit.selected, slider->key, value);
    if (!scene_document_preview(document, text, message, sizeof message)) window_notify(window, message);
}

void window_edit_key_down(demo_window *window, int key, int mods)
{
    if (!window_edit_is_on(window)) return;
    bool has_shift = mods & GLFW_MOD_SHIFT;
    if (key == GLFW_KEY_N) select_next(window, has_shift);
    if (!window->edit.has_selection) return;
    if (key == GLFW_KEY_UP || key == GLFW_KEY_DOWN) choose_slider(window, key == GLFW_KEY_DOWN ? 1 : -1);
    if (key == GLFW_KEY_LEFT) move_slider(window, -slider_steps[has_shift]);
    if (key == GLFW_KEY_RIGHT) move_slider(window, slider_steps[has_shift]);
}

void window_edit_key_up(demo_window *window, int key)
{
    char message[500];
    if (!window->options->scene || (key != GLFW_KEY_LEFT && key != GLFW_KEY_RIGHT)) return;
    if (!scene_document_commit(&window->file.document, message, sizeof message)) window_notify(window, message);
}
