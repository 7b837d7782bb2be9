/* Watching a scene file: see scene_watch.h. */
#include "scene_watch.h"

bool scene_watch_begin(scene_watch *watch, const char *path)
{
    /* The state comes before reading, so that a save in between counts as a change. */
    *watch = (scene_watch){.path = path, .seen = file_look_at(path)};
    return scene_load(path, &watch->scene, watch->message, sizeof watch->message);
}

/* Editors may write the file in place, or replace it by another one. */
static bool is_same(const file_state *a, const file_state *b)
{
    return a->number == b->number && a->size == b->size && a->seconds == b->seconds && a->nanoseconds == b->nanoseconds;
}

bool scene_watch_look(scene_watch *watch)
{
    file_state now = file_look_at(watch->path);
    if (is_same(&now, &watch->seen)) return false;
    watch->seen = now;
    demo_scene scene;
    if (!scene_load(watch->path, &scene, watch->message, sizeof watch->message)) return true;
    scene_free(&watch->scene);
    watch->scene = scene;
    watch->message[0] = '\0';
    return true;
}

void scene_watch_end(scene_watch *watch)
{
    scene_free(&watch->scene);
}
