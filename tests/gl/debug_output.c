/* What GL has to say: see debug_output.h. */
#include "debug_output.h"

#include "api.h"

#include <stdio.h>

static bool paused;
static int count;

static void APIENTRY on_message(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar *text,
                                const void *user)
{
    (void)source, (void)id, (void)length, (void)user;
    /* Hardware drivers may compile a shader again for the host's state, and say so; that is no fault. */
    if (paused || (type == GL_DEBUG_TYPE_PERFORMANCE && !api_is_software())) return;
    if (severity != GL_DEBUG_SEVERITY_HIGH && severity != GL_DEBUG_SEVERITY_MEDIUM) return;
    fprintf(stderr, "GL says: %s\n", text);
    count++;
}

void debug_output_watch(void)
{
    if (!api_has(43, 32, "GL_KHR_debug")) return;
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    gl.DebugMessageCallback(on_message, NULL);
}

void debug_output_pause(void)
{
    paused = true;
}

void debug_output_resume(void)
{
    paused = false;
}

int debug_output_count(void)
{
    return count;
}
