/* The GL functions that the tests call, loaded apart from the library's own, and what the current context can do. The functions
 * of GL_FUNCTIONS are among them. */
#ifndef TEST_API_H
#define TEST_API_H

#include "context.h"

/* The functions that only the tests call. X(type, name, es_version, es_suffix): OpenGL ES has it without the suffix from
 * `es_version` on. */
#define API_FUNCTIONS(X)                                                                                                       \
    X(PFNGLBEGINTRANSFORMFEEDBACKPROC, BeginTransformFeedback, 0, "")                                                          \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase, 0, "")                                                                          \
    X(PFNGLBINDBUFFERRANGEPROC, BindBufferRange, 0, "")                                                                        \
    X(PFNGLBINDPROGRAMPIPELINEPROC, BindProgramPipeline, 31, "EXT")                                                            \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer, 0, "")                                                                      \
    X(PFNGLBINDSAMPLERPROC, BindSampler, 0, "")                                                                                \
    X(PFNGLBINDTRANSFORMFEEDBACKPROC, BindTransformFeedback, 0, "")                                                            \
    X(PFNGLBLENDCOLORPROC, BlendColor, 0, "")                                                                                  \
    X(PFNGLBLENDEQUATIONPROC, BlendEquation, 0, "")                                                                            \
    X(PFNGLBLENDEQUATIONSEPARATEPROC, BlendEquationSeparate, 0, "")                                                            \
    X(PFNGLBLENDEQUATIONSEPARATEIPROC, BlendEquationSeparatei, 32, "OES")                                                      \
    X(PFNGLBLENDEQUATIONIPROC, BlendEquationi, 32, "OES")                                                                      \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate, 0, "")                                                                    \
    X(PFNGLBLENDFUNCSEPARATEIPROC, BlendFuncSeparatei, 32, "OES")                                                              \
    X(PFNGLCLAMPCOLORPROC, ClampColor, 0, "")                                                                                  \
    X(PFNGLCLEARPROC, Clear, 0, "")                                                                                            \
    X(PFNGLCLEARBUFFERFIPROC, ClearBufferfi, 0, "")                                                                            \
    X(PFNGLCLEARCOLORPROC, ClearColor, 0, "")                                                                                  \
    X(PFNGLCLEARDEPTHFPROC, ClearDepthf, 0, "")                                                                                \
    X(PFNGLCLEARSTENCILPROC, ClearStencil, 0, "")                                                                              \
    X(PFNGLCLIPCONTROLPROC, ClipControl, 99, "EXT")                                                                            \
    X(PFNGLCOLORMASKPROC, ColorMask, 0, "")                                                                                    \
    X(PFNGLCOLORMASKIPROC, ColorMaski, 32, "OES")                                                                              \
    X(PFNGLCULLFACEPROC, CullFace, 0, "")                                                                                      \
    X(PFNGLDEBUGMESSAGECALLBACKPROC, DebugMessageCallback, 32, "KHR")                                                          \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers, 0, "")                                                                \
    X(PFNGLDELETESAMPLERSPROC, DeleteSamplers, 0, "")                                                                          \
    X(PFNGLDEPTHFUNCPROC, DepthFunc, 0, "")                                                                                    \
    X(PFNGLDEPTHMASKPROC, DepthMask, 0, "")                                                                                    \
    X(PFNGLDEPTHRANGEINDEXEDPROC, DepthRangeIndexed, 0, "")                                                                    \
    X(PFNGLDEPTHRANGEFPROC, DepthRangef, 0, "")                                                                                \
    X(PFNGLDISABLEVERTEXATTRIBARRAYPROC, DisableVertexAttribArray, 0, "")                                                      \
    X(PFNGLDISABLEIPROC, Disablei, 32, "OES")                                                                                  \
    X(PFNGLENABLEIPROC, Enablei, 32, "OES")                                                                                    \
    X(PFNGLENDTRANSFORMFEEDBACKPROC, EndTransformFeedback, 0, "")                                                              \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer, 0, "")                                                        \
    X(PFNGLFRAMEBUFFERTEXTUREPROC, FramebufferTexture, 32, "OES")                                                              \
    X(PFNGLFRAMEBUFFERTEXTURELAYERPROC, FramebufferTextureLayer, 0, "")                                                        \
    X(PFNGLFRONTFACEPROC, FrontFace, 0, "")                                                                                    \
    X(PFNGLGENPROGRAMPIPELINESPROC, GenProgramPipelines, 31, "EXT")                                                            \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers, 0, "")                                                                      \
    X(PFNGLGENSAMPLERSPROC, GenSamplers, 0, "")                                                                                \
    X(PFNGLGENTRANSFORMFEEDBACKSPROC, GenTransformFeedbacks, 0, "")                                                            \
    X(PFNGLGETBUFFERPARAMETERIVPROC, GetBufferParameteriv, 0, "")                                                              \
    X(PFNGLGETFLOATI_VPROC, GetFloati_v, 99, "OES")                                                                            \
    X(PFNGLGETFLOATVPROC, GetFloatv, 0, "")                                                                                    \
    X(PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVPROC, GetFramebufferAttachmentParameteriv, 0, "")                                \
    X(PFNGLGETINTEGER64I_VPROC, GetInteger64i_v, 0, "")                                                                        \
    X(PFNGLGETINTEGERI_VPROC, GetIntegeri_v, 0, "")                                                                            \
    X(PFNGLGETSAMPLERPARAMETERIVPROC, GetSamplerParameteriv, 0, "")                                                            \
    X(PFNGLGETSTRINGIPROC, GetStringi, 0, "")                                                                                  \
    X(PFNGLGETTEXPARAMETERIVPROC, GetTexParameteriv, 0, "")                                                                    \
    X(PFNGLGETUNIFORMBLOCKINDEXPROC, GetUniformBlockIndex, 0, "")                                                              \
    X(PFNGLGETVERTEXATTRIBFVPROC, GetVertexAttribfv, 0, "")                                                                    \
    X(PFNGLGETVERTEXATTRIBIVPROC, GetVertexAttribiv, 0, "")                                                                    \
    X(PFNGLHINTPROC, Hint, 0, "")                                                                                              \
    X(PFNGLISBUFFERPROC, IsBuffer, 0, "")                                                                                      \
    X(PFNGLISENABLEDPROC, IsEnabled, 0, "")                                                                                    \
    X(PFNGLISENABLEDIPROC, IsEnabledi, 32, "OES")                                                                              \
    X(PFNGLISFRAMEBUFFERPROC, IsFramebuffer, 0, "")                                                                            \
    X(PFNGLISPROGRAMPROC, IsProgram, 0, "")                                                                                    \
    X(PFNGLISSAMPLERPROC, IsSampler, 0, "")                                                                                    \
    X(PFNGLISTEXTUREPROC, IsTexture, 0, "")                                                                                    \
    X(PFNGLLINEWIDTHPROC, LineWidth, 0, "")                                                                                    \
    X(PFNGLLOGICOPPROC, LogicOp, 0, "")                                                                                        \
    X(PFNGLMINSAMPLESHADINGPROC, MinSampleShading, 32, "OES")                                                                  \
    X(PFNGLPATCHPARAMETERIPROC, PatchParameteri, 32, "OES")                                                                    \
    X(PFNGLPAUSETRANSFORMFEEDBACKPROC, PauseTransformFeedback, 0, "")                                                          \
    X(PFNGLPOINTSIZEPROC, PointSize, 0, "")                                                                                    \
    X(PFNGLPOLYGONMODEPROC, PolygonMode, 0, "")                                                                                \
    X(PFNGLPOLYGONOFFSETPROC, PolygonOffset, 0, "")                                                                            \
    X(PFNGLPRIMITIVERESTARTINDEXPROC, PrimitiveRestartIndex, 0, "")                                                            \
    X(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex, 0, "")                                                                        \
    X(PFNGLREADBUFFERPROC, ReadBuffer, 0, "")                                                                                  \
    X(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage, 0, "")                                                                \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample, 0, "")                                          \
    X(PFNGLSAMPLECOVERAGEPROC, SampleCoverage, 0, "")                                                                          \
    X(PFNGLSAMPLEMASKIPROC, SampleMaski, 0, "")                                                                                \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri, 0, "")                                                                    \
    X(PFNGLSCISSORPROC, Scissor, 0, "")                                                                                        \
    X(PFNGLSCISSORINDEXEDPROC, ScissorIndexed, 99, "OES")                                                                      \
    X(PFNGLSTENCILFUNCSEPARATEPROC, StencilFuncSeparate, 0, "")                                                                \
    X(PFNGLSTENCILMASKSEPARATEPROC, StencilMaskSeparate, 0, "")                                                                \
    X(PFNGLSTENCILOPSEPARATEPROC, StencilOpSeparate, 0, "")                                                                    \
    X(PFNGLTEXIMAGE2DMULTISAMPLEPROC, TexImage2DMultisample, 0, "")                                                            \
    X(PFNGLTEXIMAGE3DPROC, TexImage3D, 0, "")                                                                                  \
    X(PFNGLTEXSTORAGE2DMULTISAMPLEPROC, TexStorage2DMultisample, 0, "")                                                        \
    X(PFNGLTRANSFORMFEEDBACKVARYINGSPROC, TransformFeedbackVaryings, 0, "")                                                    \
    X(PFNGLUNIFORM4FPROC, Uniform4f, 0, "")                                                                                    \
    X(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding, 0, "")                                                                \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv, 0, "")                                                                      \
    X(PFNGLVERTEXATTRIB4FVPROC, VertexAttrib4fv, 0, "")                                                                        \
    X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor, 0, "")                                                                \
    X(PFNGLVIEWPORTINDEXEDFPROC, ViewportIndexedf, 99, "OES")

/* Functions of the compatibility profile, which the core headers lack. */
typedef void(APIENTRYP api_alpha_func)(GLenum, GLfloat);
typedef void(APIENTRYP api_enum_value)(GLenum);
typedef void(APIENTRYP api_float4)(GLfloat, GLfloat, GLfloat, GLfloat);
typedef void(APIENTRYP api_stipple)(const GLubyte *);
typedef void(APIENTRYP api_get_stipple)(GLubyte *);
typedef void(APIENTRYP api_clip_plane)(GLenum, const GLdouble *);
typedef void(APIENTRYP api_get_clip_plane)(GLenum, GLdouble *);
typedef void(APIENTRYP api_translate)(GLfloat, GLfloat, GLfloat);
typedef void(APIENTRYP api_environment)(GLenum, GLenum, GLint);
typedef void(APIENTRYP api_get_environment)(GLenum, GLenum, GLint *);
#define API_COMPATIBILITY_FUNCTIONS(X)                                                                                         \
    X(api_alpha_func, AlphaFunc, 0, "")                                                                                        \
    X(api_enum_value, ClientActiveTexture, 0, "")                                                                              \
    X(api_clip_plane, ClipPlane, 0, "")                                                                                        \
    X(api_float4, Color4f, 0, "")                                                                                              \
    X(api_get_clip_plane, GetClipPlane, 0, "")                                                                                 \
    X(api_get_stipple, GetPolygonStipple, 0, "")                                                                               \
    X(api_get_environment, GetTexEnviv, 0, "")                                                                                 \
    X(api_enum_value, MatrixMode, 0, "")                                                                                       \
    X(api_stipple, PolygonStipple, 0, "")                                                                                      \
    X(api_enum_value, ShadeModel, 0, "")                                                                                       \
    X(api_environment, TexEnvi, 0, "")                                                                                         \
    X(api_translate, Translatef, 0, "")

/* The functions of the context that was current at api_load. */
extern struct api {
#define GL_MEMBER(type, name) type name;
    GL_FUNCTIONS(GL_MEMBER)
#undef GL_MEMBER
#define API_MEMBER(type, name, es_version, es_suffix) type name;
    API_FUNCTIONS(API_MEMBER)
    API_COMPATIBILITY_FUNCTIONS(API_MEMBER)
#undef API_MEMBER
    bool es;
    bool compatibility;
    int version; /* 10 * major + minor */
} gl;

/* Loads `gl` for the current context. Contexts of the same kind share it. Functions that GL lacks are NULL. */
void api_load(gl_context *context);

enum { NEVER = 99 };

/* Whether the context has what came with these versions of OpenGL and OpenGL ES, or with the extension (NULL for none). */
bool api_has(int desktop_version, int es_version, const char *extension);

/* Whether a software rasteriser draws: more can be expected of it than of drivers in general. */
bool api_is_software(void);

#endif
