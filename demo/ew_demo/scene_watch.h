/*
 * A scene file that is read again whenever it is saved.
 */
#ifndef SCENE_WATCH_H
#define SCENE_WATCH_H

#include "files.h"
#include "scene_file.h"

#include <stdbool.h>

typedef struct scene_watch {
    const char *path;
    demo_scene scene;  /* from the last good state of the file */
    char message[500]; /* what is wrong with the file now; empty if nothing is */
    file_state seen;
} scene_watch;

/* Returns false, with the reason in `message` and nothing to free, if the file is not good at the start. */
bool scene_watch_begin(scene_watch *watch, const char *path);

/* Reads the file again if it has changed. Returns whether it has; `message` says if it was good. */
bool scene_watch_look(scene_watch *watch);

void scene_watch_end(scene_watch *watch);

#endif
