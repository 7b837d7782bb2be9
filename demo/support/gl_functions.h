/*
 * The GL functions that the programs call, loaded for each context. Neither the linker nor a loader such as libepoxy would do:
 * they resolve a name once for the whole process, but the functions of an EGL and an OSMesa context come from different
 * libraries.
 */
#ifndef GL_FUNCTIONS_H
#define GL_FUNCTIONS_H

#include <GL/glcorearb.h>

#include <stdbool.h>
#include <stddef.h>

#define GL_FUNCTIONS(X)                                                                                                        \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                                   \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                                     \
    X(PFNGLBEGINQUERYPROC, BeginQuery)                                                                                         \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                               \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                               \
    X(PFNGLBLENDFUNCPROC, BlendFunc)                                                                                           \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                                               \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                         \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                                 \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                                                   \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                                   \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                                   \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                                     \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                                   \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                         \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                                   \
    X(PFNGLDELETEQUERIESPROC, DeleteQueries)                                                                                   \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                                 \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                         \
    X(PFNGLDISABLEPROC, Disable)                                                                                               \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                                       \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                                         \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                                                                                     \
    X(PFNGLENABLEPROC, Enable)                                                                                                 \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                               \
    X(PFNGLENDQUERYPROC, EndQuery)                                                                                             \
    X(PFNGLFINISHPROC, Finish)                                                                                                 \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                                     \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                         \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                               \
    X(PFNGLGENQUERIESPROC, GenQueries)                                                                                         \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                                       \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                               \
    X(PFNGLGETERRORPROC, GetError)                                                                                             \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                                       \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                                     \
    X(PFNGLGETQUERYOBJECTUIVPROC, GetQueryObjectuiv)                                                                           \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                                                         \
    X(PFNGLGETSTRINGPROC, GetString)                                                                                           \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                         \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                                       \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                                       \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                         \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                                     \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                         \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                                   \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                                                                                   \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                                           \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                                           \
    X(PFNGLUNIFORM2FPROC, Uniform2f)                                                                                           \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                                                                           \
    X(PFNGLUNIFORM4FVPROC, Uniform4fv)                                                                                         \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                                                             \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                         \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                                                       \
    X(PFNGLVIEWPORTPROC, Viewport)
/* Functions that OpenGL has and WebGL lacks, where they are NULL. */
#define GL_DESKTOP_FUNCTIONS(X) X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)

typedef struct gl_functions {
#define GL_MEMBER(type, name) type name;
    GL_FUNCTIONS(GL_MEMBER)
    GL_DESKTOP_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
} gl_functions;

/* Loads all of them with `get_proc_address`, to which `user` is passed. Returns the name of one that is missing, or NULL. */
const char *gl_load_functions(gl_functions *gl, void (*(*get_proc_address)(void *user, const char *name))(void), void *user);

#endif
