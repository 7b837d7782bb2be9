/* The reference on several threads: see reference_threads.h. */
#include "reference_threads.h"

#include <pthread.h>
#include <stdatomic.h>

enum { MAX_THREADS = 64 };

typedef struct shared_tasks {
    reference_task *task;
    void *user;
    size_t count;
    atomic_size_t next;
    atomic_bool failed;
} shared_tasks;

static void *work(void *user)
{
    shared_tasks *tasks = user;
    reference_workspace *workspace = reference_create_workspace();
    bool ok = workspace != NULL;
    for (size_t i; ok && (i = atomic_fetch_add(&tasks->next, 1)) < tasks->count;)
        ok = tasks->task(tasks->user, workspace, i);
    if (!ok) atomic_store(&tasks->failed, true);
    reference_destroy_workspace(workspace);
    return NULL;
}

bool reference_threads_run(reference_task *task, void *user, size_t count, int threads)
{
    shared_tasks tasks = {.task = task, .user = user, .count = count};
    pthread_t others[MAX_THREADS];
    int started = 0;
    while (started < threads - 1 && started < MAX_THREADS && pthread_create(&others[started], NULL, work, &tasks) == 0)
        started++;
    work(&tasks);
    for (int i = 0; i < started; i++)
        pthread_join(others[i], NULL);
    return !atomic_load(&tasks.failed);
}
