/* The list of programs, and the search in it. */
#include "host/program_cache.h"

#include "base/error.h"

#include <string.h>

static struct ew_cached_program *find(const ew_program_cache *cache, ew_key key)
{
    for (size_t i = 0; i < cache->count; ++i)
        if (cache->entries[i].key == key) return &cache->entries[i];
    return NULL;
}

static const struct ew_cached_program *find_ready(const ew_program_cache *cache, ew_key key)
{
    const struct ew_cached_program *general = NULL;
    for (size_t i = 0; i < cache->count; ++i) {
        const struct ew_cached_program *entry = &cache->entries[i];
        if (!entry->program.is_ready) continue;
        if (entry->key == key) return entry;
        if (ew_permutation_covers(entry->key, key)) general = entry;
    }
    return general;
}

/* Makes room for one more entry. */
static ew_result grow(ew_program_cache *cache, const ew_allocator *allocator, ew_error *error)
{
    if (cache->count < cache->capacity) return EW_OK;
    size_t capacity = cache->capacity > 0 ? 2 * cache->capacity : 8;
    struct ew_cached_program *entries = allocator->allocate(allocator->user, capacity * sizeof *entries);
    if (!entries) return ew_fail(error, EW_ERROR_OUT_OF_MEMORY, "no memory for %zu cached programs", capacity);
    if (cache->entries) {
        memcpy(entries, cache->entries, cache->count * sizeof *entries);
        allocator->deallocate(allocator->user, cache->entries);
    }
    cache->entries = entries;
    cache->capacity = capacity;
    return EW_OK;
}

/* Finds the entry of `key`, or starts to compile its program and adds it. */
static ew_result start(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, ew_key key,
                       struct ew_cached_program **entry, ew_error *error)
{
    *entry = find(cache, key);
    if (*entry) return EW_OK;
    ew_result result = grow(cache, allocator, error);
    if (result != EW_OK) return result;
    struct ew_cached_program *made = &cache->entries[cache->count];
    made->key = key;
    result = ew_program_start(gl, cache->pass, key, NULL, &made->program, error);
    if (result != EW_OK) return result;
    cache->count++;
    *entry = made;
    return EW_OK;
}

/* Waits for the entry's program. An entry that fails is removed. */
static ew_result finish(ew_program_cache *cache, const ew_gl *gl, struct ew_cached_program *entry, GLuint *name,
                        ew_error *error)
{
    ew_result result = ew_program_finish(gl, &entry->program, error);
    if (result == EW_OK)
        *name = entry->program.name;
    else
        *entry = cache->entries[--cache->count];
    return result;
}

bool ew_program_is_ready(const ew_program_cache *cache, ew_key key)
{
    return find_ready(cache, key) != NULL;
}

int ew_program_steps(const ew_program_cache *cache, ew_key key)
{
    const struct ew_cached_program *entry = find(cache, key);
    return !entry ? 3 : !entry->program.is_linking ? 2 : !entry->program.is_drawn ? 1 : 0;
}

void ew_program_set_drawn(ew_program_cache *cache, GLuint name)
{
    for (size_t i = 0; i < cache->count; ++i)
        if (cache->entries[i].program.name == name) cache->entries[i].program.is_drawn = true;
}

ew_result ew_program_prepare(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, ew_key key, GLuint *name,
                             int *steps_left, ew_error *error)
{
    struct ew_cached_program *entry = find(cache, key);
    *name = 0;
    *steps_left = entry ? 1 : 2;
    if (!entry) return start(cache, gl, allocator, key, &entry, error);
    if (!entry->program.is_linking) {
        ew_program_link(gl, &entry->program);
        return EW_OK;
    }
    if (!ew_program_is_complete(gl, &entry->program)) return EW_OK;
    *steps_left = 0;
    return finish(cache, gl, entry, name, error);
}

ew_result ew_program_get(ew_program_cache *cache, const ew_gl *gl, const ew_allocator *allocator, ew_key key, GLuint *name,
                         ew_error *error)
{
    const struct ew_cached_program *ready = find_ready(cache, key);
    if (ready) {
        *name = ready->program.name;
        return EW_OK;
    }
    struct ew_cached_program *entry;
    ew_result result = start(cache, gl, allocator, key, &entry, error);
    if (result != EW_OK) return result;
    return finish(cache, gl, entry, name, error);
}

void ew_program_cache_destroy(ew_program_cache *cache, const ew_gl *gl)
{
    for (size_t i = 0; i < cache->count; ++i)
        ew_program_destroy(gl, &cache->entries[i].program);
}

void ew_program_cache_abandon(ew_program_cache *cache, const ew_allocator *allocator)
{
    if (cache->entries) allocator->deallocate(allocator->user, cache->entries);
    *cache = (ew_program_cache){.pass = cache->pass};
}
