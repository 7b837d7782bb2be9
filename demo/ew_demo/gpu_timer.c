/* How long the GPU takes: see gpu_timer.h. */
#include "gpu_timer.h"

#include <stdbool.h>
#include <string.h>

/* A rasteriser in software draws when it likes, not where the commands are, and there is no GPU to time. */
static bool is_software(const gl_functions *gl)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software"};
    const char *renderer = (const char *)gl->GetString(GL_RENDERER);
    for (size_t i = 0; renderer && i < sizeof names / sizeof *names; i++)
        if (strstr(renderer, names[i])) return true;
    return false;
}

void gpu_timer_create(const gl_functions *gl, gpu_timer *timer)
{
    GLint bits = 0;
    *timer = (gpu_timer){.milliseconds = -1};
    if (is_software(gl) || !gl->GetQueryObjectui64v) return;
    gl->GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits > 0) gl->GenQueries(GPU_TIMER_QUERIES, timer->queries);
}

void gpu_timer_destroy(const gl_functions *gl, gpu_timer *timer)
{
    gl->DeleteQueries(GPU_TIMER_QUERIES, timer->queries);
}

/* Takes the results that are available. Waits for one only if every query is in use. */
static void collect(const gl_functions *gl, gpu_timer *timer)
{
    while (timer->finished < timer->begun) {
        GLuint query = timer->queries[timer->finished % GPU_TIMER_QUERIES], available = 0;
        gl->GetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
        if (!available && timer->begun - timer->finished < GPU_TIMER_QUERIES) return;
        GLuint64 nanoseconds = 0;
        gl->GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        timer->milliseconds = (double)nanoseconds / 1e6;
        timer->finished++;
    }
}

void gpu_timer_begin(const gl_functions *gl, gpu_timer *timer)
{
    if (!timer->queries[0]) return;
    collect(gl, timer);
    gl->BeginQuery(GL_TIME_ELAPSED, timer->queries[timer->begun++ % GPU_TIMER_QUERIES]);
}

void gpu_timer_end(const gl_functions *gl, gpu_timer *timer)
{
    if (timer->queries[0]) gl->EndQuery(GL_TIME_ELAPSED);
}
