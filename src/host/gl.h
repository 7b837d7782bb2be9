/* The host's GL: the functions that its loader returns, and the abilities of its context. */
#ifndef EW_GL_H
#define EW_GL_H

#include "energywave.h"

#include <GL/glcorearb.h>
#include <stdbool.h>

/* Each list expands X(type, name) for a group of functions. Every context has the functions of this group. */
#define EW_GL_FUNCTIONS(X)                                                                                                     \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                                   \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                                     \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                         \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                                                 \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange)                                                                               \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                               \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                                                                             \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                                                       \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                               \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation)                                                                                   \
    X(PFNGLBLENDEQUATIONSEPARATEPROC, BlendEquationSeparate)                                                                   \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                                                                           \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                                                                               \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                         \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                                                                                   \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                                 \
    X(PFNGLCLEARBUFFERFVPROC, ClearBufferfv)                                                                                   \
    X(PFNGLCOLORMASKPROC, ColorMask)                                                                                           \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                                   \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                                   \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                                     \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                                   \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                         \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                                   \
    X(PFNGLDELETESAMPLERSPROC, DeleteSamplers)                                                                                 \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                                 \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                         \
    X(PFNGLDETACHSHADERPROC, DetachShader)                                                                                     \
    X(PFNGLDISABLEPROC, Disable)                                                                                               \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                                         \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                                       \
    X(PFNGLENABLEPROC, Enable)                                                                                                 \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                                     \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                         \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                               \
    X(PFNGLGENSAMPLERSPROC, GenSamplers)                                                                                       \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                                       \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                               \
    X(PFNGLGETBOOLEANVPROC, GetBooleanv)                                                                                       \
    X(PFNGLGETERRORPROC, GetError)                                                                                             \
    X(PFNGLGETFLOATVPROC, GetFloatv)                                                                                           \
    X(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC, GetFramebufferAttachmentParameteriv)                                       \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v)                                                                               \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v)                                                                                   \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                                       \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                                     \
    X(PFNGLGETRENDERBUFFERPARAMETERIVPROC, GetRenderbufferParameteriv)                                                         \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                                             \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                                       \
    X(PFNGLGETSTRINGPROC, GetString)                                                                                           \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                                                         \
    X(PFNGLGETTEXPARAMETERIVPROC, GetTexParameteriv)                                                                           \
    X(PFNGLGETUNIFORMBLOCKINDEXPROC, GetUniformBlockIndex)                                                                     \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                         \
    X(PFNGLISBUFFERPROC, IsBuffer)                                                                                             \
    X(PFNGLISENABLEDPROC, IsEnabled)                                                                                           \
    X(PFNGLISFRAMEBUFFERPROC, IsFramebuffer)                                                                                   \
    X(PFNGLISSAMPLERPROC, IsSampler)                                                                                           \
    X(PFNGLISTEXTUREPROC, IsTexture)                                                                                           \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                                       \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                                                         \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)                                                                           \
    X(PFNGLSCISSORPROC, Scissor)                                                                                               \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                                     \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                                       \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                                                                                   \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                         \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                                   \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                                           \
    X(PFNGLUNIFORM2IPROC, Uniform2i)                                                                                           \
    X(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding)                                                                       \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                         \
    X(PFNGLVIEWPORTPROC, Viewport)

/* Contexts may lack the groups below; their functions are then NULL. This group sets masks and switches of one draw buffer. */
#define EW_GL_INDEXED_MASK_FUNCTIONS(X)                                                                                        \
    X(PFNGLCOLORMASKIPROC, ColorMaski)                                                                                         \
    X(PFNGLDISABLEIPROC, Disablei)                                                                                             \
    X(PFNGLENABLEIPROC, Enablei)                                                                                               \
    X(PFNGLISENABLEDIPROC, IsEnabledi)
/* Blending of one draw buffer. */
#define EW_GL_INDEXED_BLEND_FUNCTIONS(X)                                                                                       \
    X(PFNGLBLENDEQUATIONIPROC, BlendEquationi)                                                                                 \
    X(PFNGLBLENDEQUATIONSEPARATEIPROC, BlendEquationSeparatei)                                                                 \
    X(PFNGLBLENDFUNCSEPARATEIPROC, BlendFuncSeparatei)
/* Multisampled textures and sample masks. */
#define EW_GL_MULTISAMPLE_FUNCTIONS(X)                                                                                         \
    X(PFNGLGETTEXLEVELPARAMETERIVPROC, GetTexLevelParameteriv)                                                                 \
    X(PFNGLSAMPLEMASKIPROC, SampleMaski)
/* Questions about textures that are not bound. */
#define EW_GL_TEXTURE_QUERY_FUNCTIONS(X) X(PFNGLGETTEXTURELEVELPARAMETERIVPROC, GetTextureLevelParameteriv)
/* One viewport of a viewport array. */
#define EW_GL_VIEWPORT_ARRAY_FUNCTIONS(X)                                                                                      \
    X(PFNGLSCISSORINDEXEDPROC, ScissorIndexed)                                                                                 \
    X(PFNGLVIEWPORTINDEXEDFPROC, ViewportIndexedf)
/* Where NDC's y points in a target. */
#define EW_GL_CLIP_CONTROL_FUNCTIONS(X) X(PFNGLCLIPCONTROLPROC, ClipControl)
/* Program pipelines. */
#define EW_GL_PIPELINE_FUNCTIONS(X)                                                                                            \
    X(PFNGLACTIVESHADERPROGRAMPROC, ActiveShaderProgram)                                                                       \
    X(PFNGLDELETEPROGRAMPIPELINESPROC, DeleteProgramPipelines)                                                                 \
    X(PFNGLGENPROGRAMPIPELINESPROC, GenProgramPipelines)
/* Transform feedback that can be paused. */
#define EW_GL_TRANSFORM_FEEDBACK_FUNCTIONS(X)                                                                                  \
    X(PFNGLPAUSETRANSFORMFEEDBACKPROC, PauseTransformFeedback)                                                                 \
    X(PFNGLRESUMETRANSFORMFEEDBACKPROC, ResumeTransformFeedback)
/* Functions that OpenGL has and OpenGL ES lacks. */
#define EW_GL_DESKTOP_FUNCTIONS(X)                                                                                             \
    X(PFNGLPOLYGONMODEPROC, PolygonMode)                                                                                       \
    X(PFNGLTEXIMAGE2DMULTISAMPLEPROC, TexImage2DMultisample)
/* Functions that only the compatibility profile uses. */
#define EW_GL_COMPATIBILITY_FUNCTIONS(X) X(PFNGLCLAMPCOLORPROC, ClampColor)

enum { EW_GL_MAX_CAPABILITIES = 40 };

typedef struct ew_gl {
#define EW_GL_MEMBER(type, name) type name;
    EW_GL_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_INDEXED_MASK_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_INDEXED_BLEND_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_MULTISAMPLE_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_TEXTURE_QUERY_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_VIEWPORT_ARRAY_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_CLIP_CONTROL_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_PIPELINE_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_TRANSFORM_FEEDBACK_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_DESKTOP_FUNCTIONS(EW_GL_MEMBER)
    EW_GL_COMPATIBILITY_FUNCTIONS(EW_GL_MEMBER)
#undef EW_GL_MEMBER

    bool es;                      /* OpenGL ES, not OpenGL */
    bool web;                     /* WebGL, which is OpenGL ES without some of its queries */
    bool compatibility;           /* OpenGL in its compatibility profile */
    int version;                  /* 10 * major + minor */
    bool software;                /* a software rasteriser */
    bool parallel_shader_compile; /* the driver can be asked whether a program is complete */
    GLint max_uniform_block_size;
    GLint max_varying_vectors; /* from the vertex to the fragment shader, besides gl_Position */
    GLint max_draw_buffers;
    GLint max_viewport[2];     /* width and height */
    bool clip_control;         /* the host may have moved the clip origin */
    bool float_targets;        /* textures of floats can be drawn to, and points be as large as a block of the grid */
    bool float_sums;           /* textures of floats can be drawn to, with blending */
    bool framebuffer_srgb;     /* GL_FRAMEBUFFER_SRGB can be enabled and disabled */
    bool sample_mask;          /* shaders know gl_SampleMask */
    bool multisample;          /* GL_MULTISAMPLE can be enabled and disabled */
    bool layered_framebuffers; /* a whole array of images can be attached */
    bool multiview;            /* the same by OVR_multiview */
    bool stencil_texturing;    /* textures have GL_DEPTH_STENCIL_TEXTURE_MODE */

    /* Capabilities of this context, for glDisable, that must be off while the effect draws. */
    GLenum unwanted_capabilities[EW_GL_MAX_CAPABILITIES];
    int unwanted_capability_count;
} ew_gl;

/* Whether a GL_RENDERER string, which may be NULL, names a software rasteriser. */
bool ew_gl_is_software(const char *renderer);

/* Gives level 0 of the bound texture storage without contents. GL would fill it from a pixel unpack buffer if one were bound.
 */
void ew_gl_allocate(const ew_gl *gl, GLenum target, GLint internal_format, GLsizei width, GLsizei height, GLenum format,
                    GLenum type);

/* Whether the context draws upside down: the host has set glClipControl(GL_UPPER_LEFT, ...). */
bool ew_gl_is_upside_down(const ew_gl *gl);

/* Loads the functions of the current context and finds out its abilities.
 *
 * Errors: MISSING_FUNCTION (names the functions), UNSUPPORTED_CONTEXT (says what was found). `gl` is then undefined.
 * GL:     changes nothing. */
ew_result ew_gl_load(ew_gl *gl, ew_gl_function (*get_proc_address)(void *user, const char *name), void *user, ew_error *error);

#endif
