/*
 * A scene file that is read again whenever it is saved, and saved itself.
 */
#ifndef SCENE_WATCH_H
#define SCENE_WATCH_H

#include "files.h"
#include "scene_document.h"

#include <stdbool.h>

typedef struct scene_watch {
    scene_document document; /* from the last good state of the file, and with what was changed since */
    char message[500];       /* what is wrong with the file now; empty if nothing is */
    file_state seen;
} scene_watch;

/* Returns false, with the reason in `message` and nothing to free, if the file is not good at the start. */
bool scene_watch_begin(scene_watch *watch, const char *path);

/* Reads the file again if it has changed. Returns whether it has; `message` says if it was good. */
bool scene_watch_look(scene_watch *watch);

/* Saves the document to the file, but not over what another program has saved meanwhile. On failure returns false, with a
 * message. */
bool scene_watch_save(scene_watch *watch, char *message, size_t size);

void scene_watch_end(scene_watch *watch);

#endif
