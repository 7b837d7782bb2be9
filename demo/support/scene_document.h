/*
 * A scene file that is edited: its text, and the scene that the text says.
 *
 * Changes are made to the text, so that what is not changed stays as it was written. A change is previewed, as often as one
 * likes while something is dragged, and then committed as one step that can be undone. What the parser or `accepts` refuses
 * changes nothing.
 */
#ifndef SCENE_DOCUMENT_H
#define SCENE_DOCUMENT_H

#include "scene_file.h"
#include "text_history.h"

typedef struct scene_document {
    const char *path;
    demo_scene scene; /* of the preview, or else of the current text */
    char *preview;    /* NULL while there is none */
    text_history history;
    char *saved; /* what the file holds, as far as is known */
    /* Whether who draws the scene can do so; writes a message if not. NULL where nobody is asked. */
    bool (*accepts)(void *user, const demo_scene *scene, char *message, size_t size);
    void *user;
} scene_document;

/* Reads the file. On failure returns false, with a message and nothing to close. */
bool scene_document_open(scene_document *document, const char *path, char *message, size_t size);

/* Reads the file again, which is a step that can be undone. On failure returns false, with a message, and nothing changes. */
bool scene_document_read_again(scene_document *document, char *message, size_t size);

/* The text of what is shown. */
const char *scene_document_text(const scene_document *document);

/* Shows `text`, which the document takes over. On failure returns false, with a message, and nothing changes. NULL, which is
 * what is left of a change for which memory was exhausted, is refused, too. */
bool scene_document_preview(scene_document *document, char *text, char *message, size_t size);

/* Makes the preview, if there is one that changes something, a step. On failure returns false, with a message, and reverts. */
bool scene_document_commit(scene_document *document, char *message, size_t size);

/* Each returns whether there was such a step. A preview is dropped. */
bool scene_document_undo(scene_document *document);
bool scene_document_redo(scene_document *document);

/* Whether the file holds the current text. */
bool scene_document_is_saved(const scene_document *document);

/* Writes the current text in the place of the file. On failure returns false, with a message, and the file is as it was. */
bool scene_document_save(scene_document *document, char *message, size_t size);

/* May be called for a document of zeros. */
void scene_document_close(scene_document *document);

#endif
