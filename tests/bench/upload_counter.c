/* Counts what is uploaded: see upload_counter.h. */
#include "upload_counter.h"

#include <string.h>

static size_t bytes;
static PFNGLBUFFERDATAPROC BufferData;
static PFNGLBUFFERSUBDATAPROC BufferSubData;
static PFNGLTEXSUBIMAGE2DPROC TexSubImage2D;

static void APIENTRY count_buffer_data(GLenum target, GLsizeiptr size, const void *data, GLenum usage)
{
    if (data) bytes += (size_t)size;
    BufferData(target, size, data, usage);
}

static void APIENTRY count_buffer_sub_data(GLenum target, GLintptr offset, GLsizeiptr size, const void *data)
{
    bytes += (size_t)size;
    BufferSubData(target, offset, size, data);
}

static void APIENTRY count_tex_sub_image_2d(GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height,
                                            GLenum format, GLenum type, const void *pixels)
{
    bytes += (size_t)width * (size_t)height * (format == GL_RGBA || format == GL_RGBA_INTEGER ? 16 : 4);
    TexSubImage2D(target, level, x, y, width, height, format, type, pixels);
}

ew_gl_function upload_counter_get_proc_address(void *user, const char *name)
{
    ew_gl_function function = context_get_proc_address(user, name);
    if (!function) return NULL;
    if (strcmp(name, "glBufferData") == 0) {
        BufferData = (PFNGLBUFFERDATAPROC)function;
        return (ew_gl_function)count_buffer_data;
    }
    if (strcmp(name, "glBufferSubData") == 0) {
        BufferSubData = (PFNGLBUFFERSUBDATAPROC)function;
        return (ew_gl_function)count_buffer_sub_data;
    }
    if (strcmp(name, "glTexSubImage2D") == 0) {
        TexSubImage2D = (PFNGLTEXSUBIMAGE2DPROC)function;
        return (ew_gl_function)count_tex_sub_image_2d;
    }
    return function;
}

size_t upload_counter_take(void)
{
    size_t taken = bytes;
    bytes = 0;
    return taken;
}
