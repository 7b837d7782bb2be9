/*
 * A text whose changes can be undone, without limit.
 */
#ifndef TEXT_HISTORY_H
#define TEXT_HISTORY_H

#include <stdbool.h>
#include <stddef.h>

/* Begins as all zeros. */
typedef struct text_history {
    char **texts; /* from the oldest to the newest; all of them are the history's */
    size_t count;
    size_t capacity;
    size_t current; /* which of them counts */
} text_history;

/* Makes `text`, which the history takes over, the current one, and forgets what was undone. Returns false where memory is
 * exhausted; then nothing changes, and the text is freed. */
bool text_history_add(text_history *history, char *text);

/* The current text; NULL before there is one. */
const char *text_history_current(const text_history *history);

/* Goes to the text before or after the current one; returns false if there is none. */
bool text_history_undo(text_history *history);
bool text_history_redo(text_history *history);

void text_history_free(text_history *history);

#endif
