/* The places of the context at which the effect's shaders read. */
#ifndef EW_BINDING_POINTS_H
#define EW_BINDING_POINTS_H

/* The units of textures and their samplers: the opaque depth, the sources, the grid of adaptive resolution, and
 * the light that is summed up. */
enum {
    EW_GL_DEPTH_TEXTURE_UNIT,
    EW_GL_SOURCE_TEXTURE_UNIT,
    EW_GL_NODE_TEXTURE_UNIT,
    EW_GL_MIDDLE_TEXTURE_UNIT,
    EW_GL_FIELD_TEXTURE_UNIT,
    EW_GL_CELL_TEXTURE_UNIT,
    EW_GL_BLOCK_TEXTURE_UNIT, /* while there are no blocks yet, the peak of the nodes */
    EW_GL_TEXTURE_UNIT_COUNT,
    EW_GL_LIGHT_TEXTURE_UNIT = EW_GL_FIELD_TEXTURE_UNIT, /* of parts, once a grid has its classes */
    EW_GL_NORMAL_TEXTURE_UNIT = EW_GL_NODE_TEXTURE_UNIT, /* of surfaces, which have no grid */
};

/* The bindings of the uniform blocks. */
enum { EW_GL_UNIFORM_BINDING, EW_GL_LIST_BINDING, EW_GL_BINDING_COUNT };

#endif
