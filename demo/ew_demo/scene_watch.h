/*
 * A scene file that is read again whenever it is saved.
 */
#ifndef SCENE_WATCH_H
#define SCENE_WATCH_H

#include "scene_file.h"

#include <stdbool.h>
#include <sys/stat.h>

typedef struct scene_watch {
    const char *path;
    demo_scene scene;  /* the last good one */
    char message[500]; /* what is wrong with the file now; empty if nothing is */
    struct stat seen;
} scene_watch;

/* False, with the reason in `message` and nothing to free, where there is no good scene to begin with. */
bool scene_watch_begin(scene_watch *watch, const char *path);

/* Looks at the file; returns whether it has been read anew, well or badly. */
bool scene_watch_look(scene_watch *watch);

void scene_watch_end(scene_watch *watch);

#endif
