/* The host's depth textures, and copies of the depth of framebuffers. */
#include "host/depth_input.h"

#include "base/error.h"
#include "host/state_guard.h"
#include "host/texture_check.h"

/* A parameter of depth textures that the core profile dropped. */
enum { COMPATIBILITY_DEPTH_TEXTURE_MODE = 0x884B };

/* ---- The host's textures ---- */

/* Texture parameters that alter what a fetch of depth returns, and the values that leave it as it is. The sampler object
 * overrides the rest. */
static const struct {
    GLenum name;
    GLint wanted;
} parameters[EW_DEPTH_PARAMETER_COUNT] = {
    {GL_TEXTURE_SWIZZLE_R, GL_RED},
    {GL_TEXTURE_BASE_LEVEL, 0},
    {GL_DEPTH_STENCIL_TEXTURE_MODE, GL_DEPTH_COMPONENT},
    {COMPATIBILITY_DEPTH_TEXTURE_MODE, GL_RED},
};

static bool has_parameter(const ew_gl *gl, GLenum target, GLenum name)
{
    switch (name) {
    case GL_TEXTURE_SWIZZLE_R:
        return !gl->web;
    case GL_DEPTH_STENCIL_TEXTURE_MODE:
        return gl->stencil_texturing;
    case COMPATIBILITY_DEPTH_TEXTURE_MODE:
        return gl->compatibility && target == GL_TEXTURE_2D;
    default:
        return true;
    }
}

static void set_parameters(const ew_gl *gl, ew_depth_input *depth)
{
    for (int i = 0; i < EW_DEPTH_PARAMETER_COUNT; i++) {
        if (!has_parameter(gl, depth->target, parameters[i].name)) continue;
        gl->GetTexParameteriv(depth->target, parameters[i].name, &depth->parameters[i]);
        depth->changed[i] = depth->parameters[i] != parameters[i].wanted;
        if (depth->changed[i]) gl->TexParameteri(depth->target, parameters[i].name, parameters[i].wanted);
    }
}

/* GL cannot be asked for a texture's target. But binding a texture to another target is an error and leaves the old binding. */
static ew_result bind_texture(const ew_gl *gl, const ew_plan *plan, GLenum target, ew_error *error)
{
    bool multisampled = target == GL_TEXTURE_2D_MULTISAMPLE;
    GLint bound = 0;
    gl->BindTexture(target, plan->depth.texture);
    gl->GetIntegerv(multisampled ? GL_TEXTURE_BINDING_2D_MULTISAMPLE : GL_TEXTURE_BINDING_2D, &bound);
    if ((GLuint)bound == plan->depth.texture) return EW_OK;
    gl->GetError();
    return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "depth_texture %u is no %s, which depth_source says that it is",
                   plan->depth.texture, multisampled ? "GL_TEXTURE_2D_MULTISAMPLE" : "GL_TEXTURE_2D");
}

static ew_result bind_host_texture(const ew_gl *gl, const ew_plan *plan, ew_depth_input *depth, ew_error *error)
{
    ew_result result = bind_texture(gl, plan, depth->target, error);
    if (result == EW_OK) result = ew_depth_check(gl, plan, depth->target, error);
    if (result != EW_OK) return result;
    if (depth->target == GL_TEXTURE_2D_MULTISAMPLE)
        gl->GetTexLevelParameteriv(depth->target, 0, GL_TEXTURE_SAMPLES, &depth->samples);
    set_parameters(gl, depth);
    return EW_OK;
}

/* ---- Copies of a framebuffer's depth ---- */

/* The formats of depth buffers. GL copies depth only between equal formats (OpenGL ES 3.2, 16.2.1), but reveals only their
 * bits. Whether 24 bits of depth share a format with a stencil must be tried. */
static const struct {
    GLint depth_bits;
    GLenum component_type;
    GLint internal_format;
    GLenum format;
    GLenum type;
    bool stencil;
    bool es;
} copy_formats[] = {
    {16, GL_UNSIGNED_NORMALIZED, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, false, true},
    {24, GL_UNSIGNED_NORMALIZED, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, true, true},
    {24, GL_UNSIGNED_NORMALIZED, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, false, true},
    {32, GL_UNSIGNED_NORMALIZED, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, false, false},
    {32, GL_FLOAT, GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, true, true},
    {32, GL_FLOAT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, false, true},
};
enum { COPY_FORMAT_COUNT = sizeof copy_formats / sizeof copy_formats[0] };

static GLint attachment_parameter(const ew_gl *gl, GLenum attachment, GLenum name)
{
    GLint value = 0;
    gl->GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, attachment, name, &value);
    return value;
}

/* Returns what GL reveals about the depth of the read framebuffer. depth_bits is 0 if it has no depth. */
static ew_depth_copy ask_depth(const ew_gl *gl, bool is_window)
{
    const GLenum depth = is_window ? GL_DEPTH : GL_DEPTH_ATTACHMENT, stencil = is_window ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
    ew_depth_copy asked = {0};
    if (attachment_parameter(gl, depth, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE) return asked;
    asked.depth_bits = attachment_parameter(gl, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
    asked.component_type = attachment_parameter(gl, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
    if (attachment_parameter(gl, stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE)
        asked.stencil_bits = attachment_parameter(gl, stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    return asked;
}

/* Makes and binds a framebuffer without images. It serves one copy only, since contexts do not share framebuffers. */
static GLuint make_framebuffer(const ew_gl *gl)
{
    GLuint framebuffer;
    gl->GenFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    /* Before OpenGL 4.1, a framebuffer is incomplete if a draw or read buffer names a missing image. */
    gl->DrawBuffers(1, &(GLenum){GL_NONE});
    gl->ReadBuffer(GL_NONE);
    return framebuffer;
}

static void attach(const ew_depth_copy *copy, const ew_gl *gl)
{
    gl->FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, copy->target, copy->texture, 0);
}

/* Gives the copy's texture, which is bound, new storage. */
static void allocate(const ew_depth_copy *copy, const ew_gl *gl, int format)
{
    GLint internal_format = copy_formats[format].internal_format;
    if (copy->samples > 0) {
        gl->TexImage2DMultisample(copy->target, copy->samples, (GLenum)internal_format, copy->width, copy->height, GL_TRUE);
        return;
    }
    ew_gl_allocate(gl, copy->target, internal_format, copy->width, copy->height, copy_formats[format].format,
                   copy_formats[format].type);
}

/* Pixels from the lower left corner, inclusive, to the upper right corner, exclusive. */
typedef struct rectangle {
    GLint left, bottom, right, top;
} rectangle;

static GLint clamp(long long value, GLint limit)
{
    return value < 0 ? 0 : value > limit ? limit : (GLint)value;
}

static rectangle viewport_rectangle(const ew_plan *plan, GLint limit)
{
    const ew_viewport *viewport = &plan->target.viewport;
    return (rectangle){clamp(viewport->x, limit), clamp(viewport->y, limit),
                       clamp((long long)viewport->x + viewport->width, limit),
                       clamp((long long)viewport->y + viewport->height, limit)};
}

/* Both rectangles are equal because OpenGL ES requires that of multisampled framebuffers. The host's scissor stays in force: it
 * excludes only pixels that are not drawn either. */
static void copy_pixels(const ew_gl *gl, const rectangle *area)
{
    gl->BlitFramebuffer(area->left, area->bottom, area->right, area->top, area->left, area->bottom, area->right, area->top,
                        GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

/* The count is limited because a lost context never stops reporting errors. */
static void clear_errors(const ew_gl *gl)
{
    for (int i = 0; i < 16 && gl->GetError() != GL_NO_ERROR; i++)
        continue;
}

static bool try_formats(const ew_depth_copy *copy, const ew_gl *gl, const rectangle *area)
{
    bool with_stencil = copy->stencil_bits > 0;
    for (int pass = 0; pass < 2; pass++, with_stencil = !with_stencil) {
        for (int i = 0; i < COPY_FORMAT_COUNT; i++) {
            if (copy_formats[i].depth_bits != copy->depth_bits || copy_formats[i].stencil != with_stencil ||
                copy_formats[i].component_type != (GLenum)copy->component_type || (gl->es && !copy_formats[i].es))
                continue;
            clear_errors(gl);
            allocate(copy, gl, i);
            attach(copy, gl);
            if (gl->CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) continue;
            copy_pixels(gl, area);
            if (gl->GetError() == GL_NO_ERROR) return true;
        }
    }
    clear_errors(gl);
    return false;
}

void ew_depth_copy_destroy(ew_depth_copy *copy, const ew_gl *gl)
{
    gl->DeleteTextures(1, &copy->texture);
    *copy = (ew_depth_copy){0};
}

static bool has_same_format(const ew_depth_copy *a, const ew_depth_copy *b)
{
    return a->depth_bits == b->depth_bits && a->stencil_bits == b->stencil_bits && a->component_type == b->component_type &&
           a->samples == b->samples;
}

/* A texture object keeps its first target for ever, so another target needs a new one. */
static void bind_copy(ew_depth_copy *copy, const ew_gl *gl, GLenum target)
{
    if (copy->target != target) {
        ew_depth_copy_destroy(copy, gl);
        copy->target = target;
        gl->GenTextures(1, &copy->texture);
    }
    gl->BindTexture(target, copy->texture);
}

/* Copies depth from the read framebuffer to the copy's texture, which it attaches to the draw framebuffer. */
static ew_result copy_between(ew_depth_copy *copy, const ew_gl *gl, const ew_plan *plan, const ew_depth_input *depth,
                              ew_error *error)
{
    ew_depth_copy wanted = ask_depth(gl, plan->target.framebuffer == 0);
    if (wanted.depth_bits == 0)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "depth_source is EW_DEPTH_FRAMEBUFFER, but framebuffer %u has no depth", plan->target.framebuffer);
    wanted.samples = depth->samples;
    bind_copy(copy, gl, depth->target);
    GLint limit = 0;
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const rectangle area = viewport_rectangle(plan, limit);
    if (area.left == area.right || area.bottom == area.top) return EW_OK;
    bool same_format = has_same_format(copy, &wanted);
    if (same_format && area.right <= copy->width && area.top <= copy->height) {
        attach(copy, gl);
        copy_pixels(gl, &area);
        return EW_OK;
    }

    wanted.target = copy->target;
    wanted.texture = copy->texture;
    wanted.width = same_format && copy->width > area.right ? copy->width : area.right;
    wanted.height = same_format && copy->height > area.top ? copy->height : area.top;
    copy->width = copy->height = 0;
    if (!try_formats(&wanted, gl, &area))
        return ew_fail(error, EW_ERROR_OPENGL,
                       "the %d bit depth of framebuffer %u cannot be copied to a texture of %d x %d; copy it to a texture of "
                       "your own and name that as depth_texture",
                       wanted.depth_bits, plan->target.framebuffer, wanted.width, wanted.height);
    *copy = wanted;
    return EW_OK;
}

static ew_result bind_copied_depth(ew_depth_copy *copy, const ew_gl *gl, const ew_plan *plan, ew_depth_input *depth,
                                   ew_error *error)
{
    if (depth->target == GL_TEXTURE_2D_MULTISAMPLE) gl->GetIntegerv(GL_SAMPLES, &depth->samples);
    GLuint framebuffer = make_framebuffer(gl);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, plan->target.framebuffer);
    ew_result result = copy_between(copy, gl, plan, depth, error);
    gl->DeleteFramebuffers(1, &framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, plan->target.framebuffer);
    return result;
}

/* ---- Both kinds of source ---- */

ew_depth_kind ew_depth_input_kind(const ew_gl *gl, const ew_depth_request *request)
{
    /* OpenGL ES cannot copy samples without resolving them. */
    if (request->source == EW_DEPTH_FRAMEBUFFER) {
        GLint samples = 0;
        if (!gl->es) gl->GetIntegerv(GL_SAMPLES, &samples);
        return samples > 0 ? EW_DEPTH_KIND_MULTISAMPLE : EW_DEPTH_KIND_SINGLE;
    }
    if (request->texture == 0) return EW_DEPTH_KIND_NONE;
    return request->source == EW_DEPTH_TEXTURE_MULTISAMPLE ? EW_DEPTH_KIND_MULTISAMPLE : EW_DEPTH_KIND_SINGLE;
}

ew_result ew_depth_input_bind(ew_depth_copy *copy, const ew_gl *gl, const ew_plan *plan, ew_depth_kind kind,
                              ew_depth_input *depth, ew_error *error)
{
    static const GLenum targets[] = {[EW_DEPTH_KIND_NONE] = 0,
                                     [EW_DEPTH_KIND_SINGLE] = GL_TEXTURE_2D,
                                     [EW_DEPTH_KIND_MULTISAMPLE] = GL_TEXTURE_2D_MULTISAMPLE};
    *depth = (ew_depth_input){.target = targets[kind]};
    gl->ActiveTexture(GL_TEXTURE0 + EW_GL_DEPTH_TEXTURE_UNIT);
    if (plan->depth.source == EW_DEPTH_FRAMEBUFFER) return bind_copied_depth(copy, gl, plan, depth, error);
    return depth->target ? bind_host_texture(gl, plan, depth, error) : EW_OK;
}

void ew_depth_input_release(const ew_gl *gl, const ew_depth_input *depth)
{
    for (int i = 0; i < EW_DEPTH_PARAMETER_COUNT; i++)
        if (depth->changed[i]) gl->TexParameteri(depth->target, parameters[i].name, depth->parameters[i]);
}
