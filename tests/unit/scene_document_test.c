/* A scene file that is edited: changes, undo and saving, in which all else stays as it was written. */
#include "check.h"
#include "scene_document.h"
#include "scene_edit.h"

#include <stdio.h>
#include <stdlib.h>

static const char path[] = "scene_document_test.json";

static const char original[] =
    "{ \"comment\": \"kept\",\n"
    "  \"camera\": { \"eye\": [0, 0, 8], \"target\": [0, 0, 0] },\n"
    "  \"points\": [{ \"name\": \"orb\", \"position\": [1.0, 2, 3], \"reach\": 1.50, \"brightness\": 2 }],\n"
    "  \"curves\": [{ \"control_points\": [[0, 0, 0], [1, 2, 0], [3, 1, 1]], \"reach\": 1 },\n"
    "             { \"polynomial\": [[1, 2, 3], [4, 5, 6], [7, 8, 9]], \"reach\": 1 }],\n"
    "  \"paths\": [{ \"points\": [[0,0,0], [1,0,0]], \"core\": 0.1, \"reach\": 1 }] }\n";

static const scene_part orb = {PART_POINT, 0}, path_part = {PART_PATH, 0};

static void write_file(const char *text)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
}

static void check_file(const char *expected)
{
    char text[2000];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text, expected);
}

static scene_document open_original(void)
{
    scene_document document;
    char message[256] = "";
    write_file(original);
    if (!scene_document_open(&document, path, message, sizeof message)) fail_msg("%s", message);
    return document;
}

static void preview(scene_document *document, char *text)
{
    char message[256] = "";
    if (!scene_document_preview(document, text, message, sizeof message)) fail_msg("%s", message);
}

static void commit(scene_document *document)
{
    char message[256] = "";
    if (!scene_document_commit(document, message, sizeof message)) fail_msg("%s", message);
}

static void set(scene_document *document, scene_part part, const char *key, double number)
{
    preview(document, scene_edit_set_number(scene_document_text(document), part, key, number));
}

/* The original with one part of it replaced. */
static const char *original_with(const char *part, const char *other)
{
    static char text[2000];
    const char *found = strstr(original, part);
    assert_non_null(found);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(found - original), original, other, found + strlen(part));
    return text;
}

static void a_drag_is_one_step(void **state)
{
    (void)state;
    char message[256];
    scene_document document = open_original();
    assert_true(scene_document_is_saved(&document));
    assert_false(scene_document_undo(&document));
    for (int i = 0; i < 5; i++)
        set(&document, orb, "reach", 2 + i);
    check_close(document.scene.sources.points[0].reach, 6, 0);
    commit(&document);
    assert_false(scene_document_is_saved(&document));
    assert_string_equal(scene_document_text(&document), original_with("1.50", "6"));
    assert_true(scene_document_undo(&document));
    assert_string_equal(scene_document_text(&document), original);
    check_close(document.scene.sources.points[0].reach, 1.5, 0);
    assert_true(scene_document_is_saved(&document));
    assert_false(scene_document_undo(&document));
    assert_true(scene_document_redo(&document));
    assert_false(scene_document_redo(&document));
    assert_true(scene_document_save(&document, message, sizeof message));
    check_file(original_with("1.50", "6"));
    assert_true(scene_document_is_saved(&document));

    /* A change after undoing takes the place of what was undone; a change of nothing is no step. */
    assert_true(scene_document_undo(&document));
    set(&document, orb, "brightness", 3);
    commit(&document);
    assert_false(scene_document_redo(&document));
    set(&document, orb, "brightness", 3);
    commit(&document);
    assert_true(scene_document_undo(&document));
    assert_string_equal(scene_document_text(&document), original);
    scene_document_close(&document);
}

static bool refuses_long_reaches(void *user, const demo_scene *scene, char *message, size_t size)
{
    snprintf(message, size, "too long");
    return scene->sources.points[0].reach < *(double *)user;
}

static void what_is_refused_changes_nothing(void **state)
{
    (void)state;
    char message[256];
    double longest = 10;
    scene_document document = open_original();
    char *text = scene_edit_set_number(original, path_part, "core", 2);
    assert_false(scene_document_preview(&document, text, message, sizeof message));
    assert_non_null(strstr(message, "paths[0].reach: must be more than the radius of the core"));
    document.accepts = refuses_long_reaches;
    document.user = &longest;
    set(&document, orb, "reach", 9);
    text = scene_edit_set_number(original, orb, "reach", 11);
    assert_false(scene_document_preview(&document, text, message, sizeof message));
    assert_string_equal(message, "too long");
    check_close(document.scene.sources.points[0].reach, 9, 0);
    commit(&document);
    assert_string_equal(scene_document_text(&document), original_with("1.50", "9"));
    write_file("{ \"camera\": 3 }");
    assert_false(scene_document_read_again(&document, message, sizeof message));
    assert_string_equal(scene_document_text(&document), original_with("1.50", "9"));
    scene_document_close(&document);
}

static void what_is_read_again_can_be_undone(void **state)
{
    (void)state;
    char message[256];
    scene_document document = open_original();
    set(&document, orb, "reach", 4);
    commit(&document);
    write_file(original_with("kept", "other"));
    assert_true(scene_document_read_again(&document, message, sizeof message));
    assert_true(scene_document_is_saved(&document));
    check_close(document.scene.sources.points[0].reach, 1.5, 0);
    assert_true(scene_document_undo(&document));
    assert_string_equal(scene_document_text(&document), original_with("1.50", "4"));
    assert_false(scene_document_is_saved(&document));
    scene_document_close(&document);
}

static void what_cannot_be_saved_is_said(void **state)
{
    (void)state;
    char message[256];
    scene_document document = open_original();
    document.path = "missing/scene.json";
    assert_false(scene_document_save(&document, message, sizeof message));
    assert_non_null(strstr(message, "missing/scene.json: cannot be saved ("));
    scene_document_close(&document);
}

static void parts_are_called_by_their_names(void **state)
{
    (void)state;
    char title[20];
    scene_edit_title(original, orb, title, sizeof title);
    assert_string_equal(title, "orb");
    scene_edit_title(original, (scene_part){PART_CURVE, 1}, title, sizeof title);
    assert_string_equal(title, "curves[1]");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drag_is_one_step),
        cmocka_unit_test(what_is_refused_changes_nothing),
        cmocka_unit_test(what_is_read_again_can_be_undone),
        cmocka_unit_test(what_cannot_be_saved_is_said),
        cmocka_unit_test(parts_are_called_by_their_names),
    };
    int failures = cmocka_run_group_tests(tests, NULL, NULL);
    remove(path);
    return failures;
}
