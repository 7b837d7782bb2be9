/* Changing parts of a scene in the window: see window_edit.h. */
#include "window_edit.h"
#include "camera_ray.h"
#include "edit_outline.h"
#include "part_handle.h"
#include "scene_edit.h"
#include "scene_pick.h"

#include <math.h>
#include <string.h>

/* Both in units of the window at a scale of 1: how far a click may wander, and how far from a handle one may take it. */
static const double click_distance = 4, handle_distance = 9;

static const double warning_seconds = 6;

/* ---- The picture in the window ------------------------------------------------------------------------------------------- */

bool window_edit_is_on(const demo_window *window)
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

edit_panel window_edit_panel(demo_window *window)
{
    scene_document *document = document_of(window);
    edit_panel panel = edit_panel_of(&document->scene, scene_document_text(document), window->edit.selected);
    panel.chosen = window->edit.chosen_slider < panel.slider_count ? window->edit.chosen_slider : 0;
    panel.is_saved = !document->preview && scene_document_is_saved(document);
    return panel;
}

/* ---- Taking hold --------------------------------------------------------------------------------------------------------- */

/* Takes the handle that is seen nearest to the cursor, if it is near. */
static bool take_handle(demo_window *window)
{
    window_edit *edit = &window->edit;
    const scene_document *document = document_of(window);
    const char *text = scene_document_text(document);
    scene_camera camera = camera_of(window);
    double cursor[2], size[2], nearest = handle_distance;
    bool is_taken = false;
    cursor_place(window, cursor);
    window_size(window, size);
    size_t count = part_handle_count(&document->scene, text, edit->selected);
    for (size_t i = 0; i < count; i++) {
        part_handle handle = part_handle_at(&document->scene, text, edit->selected, &camera, i);
        double place[2];
        if (camera_project(&camera, size[0] / size[1], handle.position, place) <= 0) continue;
        double offset[2] = {place[0] - cursor[0], place[1] - cursor[1]};
        double distance = hypot(offset[0] * size[0], offset[1] * size[1]) / 2;
        if (!(distance < nearest)) continue;
        nearest = distance;
        edit->handle = i;
        memcpy(edit->offset, offset, sizeof offset);
        memcpy(edit->held_from, handle.position, sizeof handle.position);
        is_taken = true;
    }
    return is_taken;
}

static edit_grip take(demo_window *window)
{
    double pixel[2];
    edit_place place = panel_place(window, pixel);
    edit_panel panel = window_edit_panel(window);
    window->edit.slider = edit_panel_slider_at(&panel, place, pixel[0], pixel[1]);
    if (window->edit.slider != EDIT_NO_SLIDER) {
        window->edit.chosen_slider = window->edit.slider;
        return GRIP_SLIDER;
    }
    if (edit_panel_has(&panel, place, pixel[0], pixel[1])) return GRIP_PANEL;
    return take_handle(window) ? GRIP_HANDLE : GRIP_NONE;
}

void window_edit_press(demo_window *window)
{
    window_edit *edit = &window->edit;
    edit->grip = GRIP_NONE;
    edit->is_click = window_edit_is_on(window);
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

/* The text with the held handle where the cursor is, across the view. Its numbers are as fine as the pixels are. */
static char *moved_handle(demo_window *window)
{
    const window_edit *edit = &window->edit;
    const scene_document *document = document_of(window);
    const char *text = scene_document_text(document);
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
    part_handle handle = part_handle_at(&document->scene, text, edit->selected, &camera, edit->handle);
    return part_handle_move(&document->scene, text, edit->selected, &handle, position, pow(10, floor(log10(pixel / 3))));
}

static char *moved_slider(demo_window *window)
{
    const window_edit *edit = &window->edit;
    edit_panel panel = window_edit_panel(window);
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
    bool moves = (edit->grip == GRIP_HANDLE && !edit->is_click) || edit->grip == GRIP_SLIDER;
    if (!moves) return;
    char *text = edit->grip == GRIP_HANDLE ? moved_handle(window) : moved_slider(window);
    if (!scene_document_preview(document_of(window), text, message, sizeof message)) window_notify(window, message);
}

void window_edit_release(demo_window *window)
{
    char message[500];
    window_edit *edit = &window->edit;
    if (!window->options->scene) return;
    /* What was taken before the panel was hidden is let go all the same. */
    if (window_edit_is_on(window) && edit->is_click && edit->grip == GRIP_NONE) select_at_cursor(window);
    drag(window);
    if (!scene_document_commit(document_of(window), message, sizeof message)) window_notify(window, message);
    edit->grip = GRIP_NONE;
    edit->is_click = false;
}

/* The part may have gone when the file was read again, or by undoing that, or may be a shape of another kind now. */
void window_edit_check(demo_window *window)
{
    window_edit *edit = &window->edit;
    if (!edit->has_selection) return;
    const demo_scene *scene = window_scene(window);
    edit->has_selection = edit->selected.index < scene_part_count(scene, edit->selected.kind);
    bool has_handle = edit->has_selection &&
                      edit->handle < part_handle_count(scene, scene_document_text(document_of(window)), edit->selected);
    if (!edit->has_selection || (edit->grip == GRIP_HANDLE && !has_handle)) edit->grip = GRIP_NONE;
}

void window_edit_advance(demo_window *window)
{
    if (!window_edit_is_on(window)) return;
    window_edit_check(window);
    drag(window);
}

/* ---- The beginning, the end, and the picture ----------------------------------------------------------------------------- */

static bool can_be_drawn(void *user, const demo_scene *scene, char *message, size_t size)
{
    return display_set_sources(user, &scene->sources, message, size);
}

void window_edit_begin(demo_window *window)
{
    window->file.document.accepts = can_be_drawn;
    window->file.document.user = window->display;
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
    if (!window_edit_is_on(window) || !window->edit.has_selection) return;
    scene_document *document = document_of(window);
    scene_camera camera = camera_of(window);
    edit_outline outline = {&document->scene, scene_document_text(document), &camera, width, height, scale};
    edit_outline_draw(window->overlay, &outline, window->edit.selected);
    edit_panel panel = window_edit_panel(window);
    edit_panel_draw(window->overlay, &panel, (edit_place){width, scale});
}
