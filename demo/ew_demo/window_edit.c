/* Changing sources in the window: see window_edit.h. */
#include "window_edit.h"
#include "camera_ray.h"
#include "edit_outline.h"
#include "edit_panel.h"
#include "scene_edit.h"
#include "scene_pick.h"

#include <math.h>
#include <string.h>

/* Both in units of the window at a scale of 1: how far a click may wander, and how far from a point one may take it. */
static const double click_distance = 4, point_distance = 9;

static const double warning_seconds = 6;

/* ---- The picture in the window ------------------------------------------------------------------------------------------- */

static bool is_editable(const demo_window *window)
{
    return window->options->scene && window->shows_panel;
}

static scene_document *document_of(demo_window *window)
{
    return &window->file.document;
}

static scene_camera camera_of(const demo_window *window)
{
    return window->camera.is_free ? window->camera.camera : window_scene(window)->camera;
}

/* The size that the cursor moves in. */
static void window_size(const demo_window *window, double size[2])
{
    int width, height;
    glfwGetWindowSize(window->handle, &width, &height);
    size[0] = fmax(width, 1);
    size[1] = fmax(height, 1);
}

static double aspect_of(const demo_window *window)
{
    double size[2];
    window_size(window, size);
    return size[0] / size[1];
}

/* Where the cursor is in the picture, from -1 to 1, to the right and up. */
static void cursor_place(const demo_window *window, double place[2])
{
    double size[2];
    window_size(window, size);
    place[0] = 2 * window->cursor[0] / size[0] - 1;
    place[1] = 1 - 2 * window->cursor[1] / size[1];
}

/* The cursor in pixels, and where the panel is in these. */
static edit_place panel_place(const demo_window *window, double pixel[2])
{
    int width, height;
    float scale_x, scale_y;
    double size[2];
    window_size(window, size);
    glfwGetFramebufferSize(window->handle, &width, &height);
    glfwGetWindowContentScale(window->handle, &scale_x, &scale_y);
    pixel[0] = window->cursor[0] * width / size[0];
    pixel[1] = window->cursor[1] * height / size[1];
    return (edit_place){width, (double)scale_y};
}

static edit_panel panel_of(demo_window *window)
{
    scene_document *document = document_of(window);
    edit_panel panel = edit_panel_of(&document->scene, scene_document_text(document), window->edit.selected);
    panel.is_saved = !document->preview && scene_document_is_saved(document);
    return panel;
}

/* ---- Taking hold --------------------------------------------------------------------------------------------------------- */

/* Takes the point that is seen nearest to the cursor, if it is near. */
static bool take_point(demo_window *window)
{
    window_edit *edit = &window->edit;
    scene_document *document = document_of(window);
    scene_camera camera = camera_of(window);
    double cursor[2], size[2], nearest = point_distance;
    bool is_taken = false;
    cursor_place(window, cursor);
    window_size(window, size);
    size_t count = scene_edit_point_count(&document->scene, scene_document_text(document), edit->selected);
    for (size_t i = 0; i < count; i++) {
        double position[3], place[2];
        scene_edit_point(&document->scene, edit->selected, i, position);
        if (camera_project(&camera, size[0] / size[1], position, place) <= 0) continue;
        double offset[2] = {place[0] - cursor[0], place[1] - cursor[1]};
        double distance = hypot(offset[0] * size[0], offset[1] * size[1]) / 2;
        if (distance > nearest) continue;
        nearest = distance;
        edit->point = i;
        memcpy(edit->offset, offset, sizeof offset);
        memcpy(edit->held_from, position, sizeof position);
        is_taken = true;
    }
    return is_taken;
}

static edit_grip take(demo_window *window)
{
    double pixel[2];
    edit_place place = panel_place(window, pixel);
    window->edit.slider = edit_panel_slider_at(place, pixel[0], pixel[1]);
    if (window->edit.slider != EDIT_NO_SLIDER) return GRIP_SLIDER;
    if (edit_panel_has(place, pixel[0], pixel[1])) return GRIP_PANEL;
    return take_point(window) ? GRIP_POINT : GRIP_NONE;
}

void window_edit_press(demo_window *window)
{
    window_edit *edit = &window->edit;
    edit->grip = GRIP_NONE;
    edit->is_click = is_editable(window);
    memcpy(edit->pressed, window->cursor, sizeof edit->pressed);
    if (edit->is_click && edit->has_selection) edit->grip = take(window);
}

bool window_edit_has_cursor(demo_window *window)
{
    window_edit *edit = &window->edit;
    if (hypot(window->cursor[0] - edit->pressed[0], window->cursor[1] - edit->pressed[1]) > click_distance)
        edit->is_click = false;
    return edit->is_click || edit->grip != GRIP_NONE;
}

static void select_at_cursor(demo_window *window)
{
    const demo_scene *file_scene = window_scene(window);
    demo_scene seen = camera_control_scene(&window->camera, file_scene, true);
    double cursor[2], size[2];
    cursor_place(window, cursor);
    window_size(window, size);
    camera_ray ray = camera_ray_at(&seen.camera, size[0] / size[1], cursor);
    /* As wide as a few pixels. */
    double width = click_distance * 2 * camera_half_height(&seen.camera, 1) / size[1];
    window->edit.has_selection = scene_pick(&seen, &ray, width, &window->edit.selected);
}

/* ---- Dragging ------------------------------------------------------------------------------------------------------------ */

/* The text with the held point where the cursor is, across the view. Its numbers are as fine as the pixels are. */
static char *moved_point(demo_window *window)
{
    const window_edit *edit = &window->edit;
    scene_camera camera = camera_of(window);
    double position[3], place[2], size[2];
    memcpy(position, edit->held_from, sizeof position);
    cursor_place(window, place);
    window_size(window, size);
    double depth = camera_project(&camera, size[0] / size[1], position, (double[2]){0});
    place[0] += edit->offset[0];
    place[1] += edit->offset[1];
    camera_move_across(&camera, aspect_of(window), place, position);
    double pixel = 2 * camera_half_height(&camera, depth) / size[1];
    return scene_edit_move_point(scene_document_text(document_of(window)), edit->selected, edit->point, position,
                                 pow(10, floor(log10(pixel / 3))));
}

static char *moved_slider(demo_window *window)
{
    const window_edit *edit = &window->edit;
    edit_panel panel = panel_of(window);
    double pixel[2];
    edit_place place = panel_place(window, pixel);
    double value = edit_panel_value_at(&panel, edit->slider, place, pixel[0]);
    return scene_edit_set_number(scene_document_text(document_of(window)), edit->selected, panel.sliders[edit->slider].key,
                                 value);
}

static void drag(demo_window *window)
{
    char message[500];
    window_edit *edit = &window->edit;
    bool moves = (edit->grip == GRIP_POINT && !edit->is_click) || edit->grip == GRIP_SLIDER;
    if (!moves) return;
    char *text = edit->grip == GRIP_POINT ? moved_point(window) : moved_slider(window);
    if (!scene_document_preview(document_of(window), text, message, sizeof message)) window_notify(window, message);
}

void window_edit_release(demo_window *window)
{
    char message[500];
    window_edit *edit = &window->edit;
    if (!window->options->scene) return;
    /* What was taken before the panel was hidden is let go all the same. */
    if (is_editable(window) && edit->is_click && edit->grip == GRIP_NONE) select_at_cursor(window);
    drag(window);
    if (!scene_document_commit(document_of(window), message, sizeof message)) window_notify(window, message);
    edit->grip = GRIP_NONE;
    edit->is_click = false;
}

/* The source may have gone when the file was read again, or by undoing that. */
static void check_selection(demo_window *window)
{
    window_edit *edit = &window->edit;
    if (!edit->has_selection) return;
    const demo_scene *scene = window_scene(window);
    bool is_there = edit->selected.index < source_part_count(&scene->sources, edit->selected.kind);
    if (is_there && edit->grip == GRIP_POINT) {
        const char *text = scene_document_text(document_of(window));
        if (edit->point >= scene_edit_point_count(scene, text, edit->selected)) edit->grip = GRIP_NONE;
    }
    if (is_there) return;
    edit->has_selection = false;
    edit->grip = GRIP_NONE;
}

void window_edit_advance(demo_window *window)
{
    if (!is_editable(window)) return;
    check_selection(window);
    drag(window);
}

/* ---- Keys, and the end --------------------------------------------------------------------------------------------------- */

static bool can_be_drawn(void *user, const demo_scene *scene, char *message, size_t size)
{
    return display_set_sources(user, &scene->sources, message, size);
}

void window_edit_begin(demo_window *window)
{
    window->file.document.accepts = can_be_drawn;
    window->file.document.user = window->display;
}

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
    if (!scene_document_undo(document_of(window))) window_notify(window, "there is nothing to undo");
}

static void redo(demo_window *window)
{
    if (!scene_document_redo(document_of(window))) window_notify(window, "there is nothing to redo");
}

void window_edit_key(demo_window *window, int key, int scancode, int mods)
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
    check_selection(window);
}

bool window_edit_may_close(demo_window *window)
{
    if (!window->options->scene || scene_document_is_saved(document_of(window))) return true;
    if (glfwGetTime() < window->edit.warned_until) return true;
    window->edit.warned_until = glfwGetTime() + warning_seconds;
    window_notify(window, "there are changes that are not saved: Ctrl+S saves them; close again to drop them");
    return false;
}

void window_edit_draw(demo_window *window, int width, int height, double scale)
{
    if (!is_editable(window) || !window->edit.has_selection) return;
    scene_document *document = document_of(window);
    scene_camera camera = camera_of(window);
    edit_outline outline = {&document->scene, scene_document_text(document), &camera, width, height, scale};
    edit_outline_draw(window->overlay, &outline, window->edit.selected);
    edit_panel panel = panel_of(window);
    edit_panel_draw(window->overlay, &panel, (edit_place){width, scale});
}
