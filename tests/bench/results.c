/* What a run of the benchmark found: see results.h. */
#include "results.h"
#include "message.h"
#include "peer_multiply_add.h"
#include "stopwatch.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

const measurement *results_find(const bench_results *results, const bench_scene *scene, const char *integrator)
{
    for (size_t i = 0; i < results->settings.integrator_count; i++)
        if (strcmp(results->settings.integrators[i].name, integrator) == 0) return &scene->measurements.integrators[i];
    return NULL;
}

/* Linux tells the processor's name in a file; other systems have none. */
static void describe_processor(char *text, size_t size)
{
    char line[512];
    FILE *file = fopen("/proc/cpuinfo", "r");
    message_write(text, size, "unknown processor");
    while (file && fgets(line, sizeof line, file)) {
        char *value = strstr(line, ": ");
        if (strncmp(line, "model name", 10) != 0 || !value) continue;
        line[strcspn(line, "\n")] = '\0';
        message_write(text, size, "%s", value + 2);
        break;
    }
    if (file) fclose(file);
}

bool machine_describe(gl_context *context, bench_machine *machine, char *message, size_t size)
{
    const gl_functions *gl = context_gl(context);
    *machine = (bench_machine){.cores = sysconf(_SC_NPROCESSORS_ONLN)};
    describe_processor(machine->processor, sizeof machine->processor);
    message_write(machine->renderer, sizeof machine->renderer, "%s", (const char *)gl->GetString(GL_RENDERER));
    message_write(machine->version, sizeof machine->version, "%s", (const char *)gl->GetString(GL_VERSION));
    bench_stopwatch stopwatch = stopwatch_create(context);
    machine->has_gl_timer = stopwatch_is_gl_timer(&stopwatch);
    stopwatch_destroy(&stopwatch);
    machine->multiply_adds = multiply_adds_a_millisecond(context, message, size);
    return machine->multiply_adds > 0;
}

double results_multiply_adds(const bench_results *results, double ms)
{
    return results->machine.multiply_adds * ms / ((double)results->settings.width * results->settings.height);
}
