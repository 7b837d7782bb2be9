/* The tests' GL functions: see api.h. */
#include "api.h"
#include "host/gl.h"

#include <stdio.h>
#include <string.h>

struct api gl;

static void (*load(gl_context *context, const char *name, int es_version, const char *es_suffix))(void)
{
    char full_name[64];
    snprintf(full_name, sizeof full_name, "gl%s%s", name, gl.es && gl.version < es_version ? es_suffix : "");
    return context_get_proc_address(context, full_name);
}

void api_load(gl_context *context)
{
    memset(&gl, 0, sizeof gl);
    gl.GetString = (PFNGLGETSTRINGPROC)load(context, "GetString", 0, "");
    const char *version = (const char *)gl.GetString(GL_VERSION);
    int major = 0, minor = 0;
    gl.es = sscanf(version, "OpenGL ES %d.%d", &major, &minor) == 2;
    if (!gl.es) sscanf(version, "%d.%d", &major, &minor);
    gl.version = 10 * major + minor;
#define GL_LOAD(type, name) gl.name = (type)load(context, #name, 0, "");
    GL_FUNCTIONS(GL_LOAD)
#undef GL_LOAD
#define API_LOAD(type, name, es_version, es_suffix) gl.name = (type)load(context, #name, es_version, es_suffix);
    API_FUNCTIONS(API_LOAD)
    GLint profile = 0;
    if (!gl.es) gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    gl.compatibility = profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT;
    API_COMPATIBILITY_FUNCTIONS(API_LOAD)
#undef API_LOAD
}

bool api_has(int desktop_version, int es_version, const char *extension)
{
    if (gl.version >= (gl.es ? es_version : desktop_version)) return true;
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; extension && i < count; i++)
        if (strcmp((const char *)gl.GetStringi(GL_EXTENSIONS, (GLuint)i), extension) == 0) return true;
    return false;
}

bool api_is_software(void)
{
    return ew_gl_is_software((const char *)gl.GetString(GL_RENDERER));
}
