/* A scene file that is edited: see scene_document.h. */
#include "scene_document.h"
#include "file_replacement.h"
#include "files.h"
#include "message.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static bool complain_of_memory(char *message, size_t size)
{
    message_write(message, size, "memory is exhausted; close other programs");
    return false;
}

static char *copy_of(const char *text)
{
    char *copy = malloc(strlen(text) + 1);
    return copy ? strcpy(copy, text) : NULL;
}

/* Puts the scene that the text says in the place of what is shown. */
static bool show(scene_document *document, const char *text, size_t length, char *message, size_t size)
{
    demo_scene scene;
    if (!scene_parse(text, length, document->path, &scene, message, size)) return false;
    if (document->accepts && !document->accepts(document->user, &scene, message, size)) {
        scene_free(&scene);
        return false;
    }
    scene_free(&document->scene);
    document->scene = scene;
    return true;
}

static void drop_preview(scene_document *document)
{
    free(document->preview);
    document->preview = NULL;
}

bool scene_document_read_again(scene_document *document, char *message, size_t size)
{
    size_t length;
    char *text = scene_read_text(document->path, &length, message, size);
    if (!text) return false;
    char *saved = copy_of(text);
    bool ok = saved ? show(document, text, length, message, size) : complain_of_memory(message, size);
    if (!ok) {
        free(text);
        free(saved);
        return false;
    }
    drop_preview(document);
    free(document->saved);
    document->saved = saved;
    const char *current = text_history_current(&document->history);
    if (current && strcmp(current, text) == 0) {
        free(text);
        return true;
    }
    return text_history_add(&document->history, text) || complain_of_memory(message, size);
}

bool scene_document_open(scene_document *document, const char *path, char *message, size_t size)
{
    *document = (scene_document){.path = path};
    if (scene_document_read_again(document, message, size)) return true;
    scene_document_close(document);
    return false;
}

const char *scene_document_text(const scene_document *document)
{
    return document->preview ? document->preview : text_history_current(&document->history);
}

bool scene_document_preview(scene_document *document, char *text, char *message, size_t size)
{
    if (!text) return complain_of_memory(message, size);
    if (!show(document, text, strlen(text), message, size)) {
        free(text);
        return false;
    }
    drop_preview(document);
    document->preview = text;
    return true;
}

bool scene_document_commit(scene_document *document, char *message, size_t size)
{
    const char *current = text_history_current(&document->history);
    char *text = document->preview;
    document->preview = NULL;
    if (!text) return true;
    if (strcmp(text, current) == 0) {
        free(text);
        return true;
    }
    if (text_history_add(&document->history, text)) return true;
    char ignored[200];
    show(document, current, strlen(current), ignored, sizeof ignored);
    return complain_of_memory(message, size);
}

/* Every text of the history was shown before, so this is refused only where memory is exhausted; then the scene stays. */
static bool show_current(scene_document *document)
{
    const char *text = text_history_current(&document->history);
    char ignored[200];
    drop_preview(document);
    return show(document, text, strlen(text), ignored, sizeof ignored);
}

bool scene_document_undo(scene_document *document)
{
    return text_history_undo(&document->history) && show_current(document);
}

bool scene_document_redo(scene_document *document)
{
    return text_history_redo(&document->history) && show_current(document);
}

bool scene_document_is_saved(const scene_document *document)
{
    return document->saved && strcmp(document->saved, text_history_current(&document->history)) == 0;
}

bool scene_document_save(scene_document *document, char *message, size_t size)
{
    const char *text = text_history_current(&document->history);
    char *saved = copy_of(text), *path = file_behind_links(document->path);
    file_replacement replacement;
    bool ok = saved && path, can_write = ok;
    if (ok) {
        ok = file_replacement_begin(&replacement, path);
        if (ok) file_take_permissions(replacement.temporary, path);
        ok = ok && fputs(text, replacement.file) >= 0 && fflush(replacement.file) == 0;
        ok = file_replacement_end(&replacement, ok);
    }
    if (!can_write)
        complain_of_memory(message, size);
    else if (!ok)
        message_write(message, size, "%s: cannot be saved (%s); make it and its folder writable", document->path,
                      strerror(errno));
    free(path);
    if (ok) {
        free(document->saved);
        document->saved = saved;
    } else {
        free(saved);
    }
    return ok;
}

void scene_document_close(scene_document *document)
{
    scene_free(&document->scene);
    drop_preview(document);
    free(document->saved);
    text_history_free(&document->history);
    document->saved = NULL;
}
