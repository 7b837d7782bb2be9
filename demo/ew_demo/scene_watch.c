/* Watching a scene file: see scene_watch.h. */
#include "scene_watch.h"

#include <string.h>

bool scene_watch_begin(scene_watch *watch, const char *path)
{
    *watch = (scene_watch){.path = path};
    /* This comes before reading, so that a save in between counts as a change. */
    stat(path, &watch->seen);
    return scene_load(path, &watch->scene, watch->message, sizeof watch->message);
}

/* Editors may write the file in place, or replace it by another one. */
static bool is_same(const struct stat *a, const struct stat *b)
{
    return a->st_ino == b->st_ino && a->st_size == b->st_size && a->st_mtim.tv_sec == b->st_mtim.tv_sec &&
           a->st_mtim.tv_nsec == b->st_mtim.tv_nsec;
}

bool scene_watch_look(scene_watch *watch)
{
    struct stat now = {0};
    stat(watch->path, &now);
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
