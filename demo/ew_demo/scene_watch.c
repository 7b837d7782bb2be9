/* Watching a scene file: see scene_watch.h. */
#include "scene_watch.h"
#include "message.h"

bool scene_watch_begin(scene_watch *watch, const char *path)
{
    /* The state comes before reading, so that a save in between counts as a change. */
    *watch = (scene_watch){.seen = file_look_at(path)};
    return scene_document_open(&watch->document, path, watch->message, sizeof watch->message);
}

/* Editors may write the file in place, or replace it by another one. */
static bool is_same(const file_state *a, const file_state *b)
{
    return a->number == b->number && a->size == b->size && a->seconds == b->seconds && a->nanoseconds == b->nanoseconds;
}

bool scene_watch_look(scene_watch *watch)
{
    file_state now = file_look_at(watch->document.path);
    if (is_same(&now, &watch->seen)) return false;
    watch->seen = now;
    if (scene_document_read_again(&watch->document, watch->message, sizeof watch->message)) watch->message[0] = '\0';
    return true;
}

bool scene_watch_save(scene_watch *watch, char *message, size_t size)
{
    scene_document *document = &watch->document;
    if (scene_watch_look(watch) && !watch->message[0]) {
        message_write(message, size, "not saved: another program has saved the file, which was read again; undo, then save");
        return false;
    }
    if (watch->message[0] && file_exists(document->path)) {
        message_write(message, size, "not saved: the file has a fault that another program has saved; mend it or remove it");
        return false;
    }
    if (!scene_document_save(document, message, size)) return false;
    watch->seen = file_look_at(document->path);
    watch->message[0] = '\0';
    return true;
}

void scene_watch_end(scene_watch *watch)
{
    scene_document_close(&watch->document);
}
