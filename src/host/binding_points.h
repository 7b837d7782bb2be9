/* The places of the context at which the effect's shaders read. */
#ifndef EW_BINDING_POINTS_H
#define EW_BINDING_POINTS_H

/* The unit of the depth texture and its sampler. */
enum { EW_GL_DEPTH_TEXTURE_UNIT = 0 };

/* The binding of the uniform block. */
enum { EW_GL_UNIFORM_BINDING = 0 };

#endif
