/* What can be undone: see text_history.h. */
#include "text_history.h"

#include <stdlib.h>

bool text_history_add(text_history *history, char *text)
{
    size_t kept = history->count ? history->current + 1 : 0;
    if (kept == history->capacity) {
        size_t capacity = history->capacity ? 2 * history->capacity : 16;
        char **larger = realloc(history->texts, capacity * sizeof *larger);
        if (!larger) {
            free(text);
            return false;
        }
        history->texts = larger;
        history->capacity = capacity;
    }
    for (size_t i = kept; i < history->count; i++)
        free(history->texts[i]);
    history->texts[kept] = text;
    history->current = kept;
    history->count = kept + 1;
    return true;
}

const char *text_history_current(const text_history *history)
{
    return history->count ? history->texts[history->current] : NULL;
}

bool text_history_undo(text_history *history)
{
    if (history->current == 0) return false;
    history->current--;
    return true;
}

bool text_history_redo(text_history *history)
{
    if (history->current + 1 >= history->count) return false;
    history->current++;
    return true;
}

void text_history_free(text_history *history)
{
    for (size_t i = 0; i < history->count; i++)
        free(history->texts[i]);
    free(history->texts);
    *history = (text_history){0};
}
