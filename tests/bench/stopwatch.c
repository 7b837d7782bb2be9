/* How long GL takes to draw: see stopwatch.h. */
#include "stopwatch.h"
#include "host/gl.h"

#include <time.h>

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e3 + (double)time.tv_nsec * 1e-6;
}

bench_stopwatch stopwatch_create(gl_context *context)
{
    bench_stopwatch made = {.gl = context_gl(context)};
    /* A software rasteriser draws when it is flushed, on threads of its own, and its timer queries may see none of that. */
    if (ew_gl_is_software((const char *)made.gl->GetString(GL_RENDERER))) return made;
    PFNGLGETQUERYIVPROC GetQueryiv = (PFNGLGETQUERYIVPROC)context_get_proc_address(context, "glGetQueryiv");
    made.DeleteQueries = (PFNGLDELETEQUERIESPROC)context_get_proc_address(context, "glDeleteQueries");
    made.BeginQuery = (PFNGLBEGINQUERYPROC)context_get_proc_address(context, "glBeginQuery");
    made.EndQuery = (PFNGLENDQUERYPROC)context_get_proc_address(context, "glEndQuery");
    made.GetQueryObjectui64v = (PFNGLGETQUERYOBJECTUI64VPROC)context_get_proc_address(context, "glGetQueryObjectui64v");
    GLint bits = 0;
    GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits == 0) return made;
    made.GenQueries = (PFNGLGENQUERIESPROC)context_get_proc_address(context, "glGenQueries");
    made.GenQueries(1, &made.query);
    return made;
}

void stopwatch_destroy(bench_stopwatch *stopwatch)
{
    if (stopwatch_is_gl_timer(stopwatch)) stopwatch->DeleteQueries(1, &stopwatch->query);
}

bool stopwatch_is_gl_timer(const bench_stopwatch *stopwatch)
{
    return stopwatch->GenQueries != NULL;
}

void stopwatch_start(bench_stopwatch *stopwatch)
{
    stopwatch->gl->Finish();
    if (stopwatch_is_gl_timer(stopwatch))
        stopwatch->BeginQuery(GL_TIME_ELAPSED, stopwatch->query);
    else
        stopwatch->started = now();
}

double stopwatch_stop(bench_stopwatch *stopwatch)
{
    if (!stopwatch_is_gl_timer(stopwatch)) {
        stopwatch->gl->Finish();
        return now() - stopwatch->started;
    }
    GLuint64 nanoseconds = 0;
    stopwatch->EndQuery(GL_TIME_ELAPSED);
    stopwatch->GetQueryObjectui64v(stopwatch->query, GL_QUERY_RESULT, &nanoseconds);
    return (double)nanoseconds * 1e-6;
}
