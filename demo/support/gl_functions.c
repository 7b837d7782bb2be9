/* Loading GL functions: see gl_functions.h. */
#include "gl_functions.h"

const char *gl_load_functions(gl_functions *gl, void (*(*get_proc_address)(void *user, const char *name))(void), void *user)
{
#define LOAD(type, name) gl->name = (type)get_proc_address(user, "gl" #name);
#define LOAD_NEEDED(type, name)                                                                                                \
    LOAD(type, name)                                                                                                           \
    if (!gl->name) return "gl" #name;
    GL_DESKTOP_FUNCTIONS(LOAD)
    GL_FUNCTIONS(LOAD_NEEDED)
#undef LOAD_NEEDED
#undef LOAD
    return NULL;
}
