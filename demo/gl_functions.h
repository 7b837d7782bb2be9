/*
 * The GL functions that the demo calls, each loaded from the context that they are for. A program that holds an EGL and an
 * OSMesa context at once can share neither the linker's idea of `glClear` nor that of a loader such as libepoxy, which
 * resolves a name once for the whole process: the two contexts' functions come from different libraries.
 */
#ifndef GL_FUNCTIONS_H
#define GL_FUNCTIONS_H

#include <GL/glcorearb.h>

#include <stdbool.h>
#include <stddef.h>

#define GL_FUNCTIONS(X)                                                                                                        \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                                     \
    X(PFNGLBINDATTRIBLOCATIONPROC, BindAttribLocation)                                                                         \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                               \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                               \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                         \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                                 \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                                                   \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                                   \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                                   \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                                     \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                                   \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                         \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                                   \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                                 \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                         \
    X(PFNGLDISABLEPROC, Disable)                                                                                               \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                                                                                     \
    X(PFNGLENABLEPROC, Enable)                                                                                                 \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                               \
    X(PFNGLFINISHPROC, Finish)                                                                                                 \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                                     \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                         \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                               \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                                       \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                               \
    X(PFNGLGETERRORPROC, GetError)                                                                                             \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                                       \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                                     \
    X(PFNGLGETSTRINGPROC, GetString)                                                                                           \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                         \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                                       \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                         \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                                     \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                         \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                                   \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                                           \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                                                                           \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                                                                             \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                         \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                                                       \
    X(PFNGLVIEWPORTPROC, Viewport)

typedef struct gl_functions {
#define GL_MEMBER(type, name) type name;
    GL_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
} gl_functions;

#endif
