// The uniform block: the frame, the number of sources of each kind, and then the sources: kind after kind, the pieces of
// weights last.
//
// Behind this file C puts, for each kind that the shader knows, EW_..._COUNT and a function ew_...(i) that reads source i: see
// src/plan/shader_text.c. The count is a literal for one source, so that no loop is left and the block is read at constant
// places. (Elsewhere a software rasteriser gathers lane by lane.)

layout(std140) uniform ew_uniforms
{
    ew_frame_block ew_uniform_frame;
    ivec4 ew_uniform_source_counts[EW_COUNT_VECTORS];
    ivec4 ew_uniform_list_rows[EW_LIST_VECTORS];
    ew_grid_block ew_grid;
    ew_fog_block ew_uniform_fog;
    ew_medium_block ew_media[EW_MEDIUM_ROOM];
    vec4 ew_source_data[EW_SOURCE_DATA_SIZE];
};

// EW_SOFTWARE: llvmpipe checks the bounds of every component that a fragment reads from a block, which costs more than a closed
// form. So the vertex stage copies the frame to flat varyings; and the sources too, EW_SOURCE_VARYINGS vec4, where no kind
// has more than one. GPUs read blocks as constants. With varyings, a point took 1.4 times as long there.
#ifdef EW_VERTEX_STAGE
#define EW_VARYING flat out
#else
#define EW_VARYING flat in
#endif

#ifdef EW_SOFTWARE
EW_VARYING ew_frame_block ew_frame;
EW_VARYING ivec4 ew_source_counts[EW_COUNT_VECTORS];
#ifdef EW_LISTS
EW_VARYING ivec4 ew_list_rows[EW_LIST_VECTORS];
#endif
#ifdef EW_FOG
EW_VARYING ew_fog_block ew_fog;
#endif
#else
#define ew_frame ew_uniform_frame
#define ew_source_counts ew_uniform_source_counts
#define ew_list_rows ew_uniform_list_rows
#define ew_fog ew_uniform_fog
#endif

#ifdef EW_SOURCE_VARYINGS
EW_VARYING vec4 ew_sources[EW_SOURCE_VARYINGS];
#endif

#ifdef EW_SOURCE_TEXTURE
// There are more sources than the block takes.
uniform highp sampler2D ew_source_texture;
#endif

// Unit i of the sources.
vec4 ew_source_unit(const int i)
{
#ifdef EW_SOURCE_TEXTURE
    return texelFetch(ew_source_texture, ivec2(i % EW_TEXTURE_WIDTH, i / EW_TEXTURE_WIDTH), 0);
#else
    return ew_source_data[i];
#endif
}

#ifdef EW_VERTEX_STAGE
// Hands on what is the same for all fragments.
void ew_copy_varyings()
{
#ifdef EW_SOFTWARE
    ew_frame = ew_uniform_frame;
    ew_source_counts = ew_uniform_source_counts;
#ifdef EW_LISTS
    ew_list_rows = ew_uniform_list_rows;
#endif
#ifdef EW_FOG
    ew_fog = ew_uniform_fog;
#endif
#endif
#ifdef EW_SOURCE_VARYINGS
    for (int i = 0; i < EW_SOURCE_VARYINGS; ++i)
        ew_sources[i] = ew_source_unit(i);
#endif
}
#else
// beta of the decay, (21).
float ew_beta()
{
    return ew_frame.decay.x;
}

// The glow of sources that have none of their own.
vec4 ew_plain_glow()
{
    return vec4(ew_frame.decay.y, 0.0, 1.0, 1.0);
}

// How rough a panel of the adaptive integrator may be, relative to the integral.
float ew_tolerance()
{
    return ew_frame.decay.z;
}

// The s at E: the length of the interval, which is the unit in the papers' integral.
float ew_span()
{
    return ew_frame.decay.w;
}

// The s at which a ray ends that the opaque scene ends at `share` of the depths of ew_frame_block.
float ew_end_of_ray(const float share)
{
#ifdef EW_WORLD
    return share > 0.0 ? mix(ew_frame.depth_scale.w, ew_span(), share) : 0.0;
#else
    return share;
#endif
}

int ew_simpson_divisions()
{
    return ew_frame.choices.x;
}

// A member of source i. The first source has it at `start`, and each takes `size` vec4. There are varyings for the only source of a
// kind, at places that are constant: rasterisers that keep arrays in memory gather from others.
vec4 ew_source(const int start, const int size, const int i)
{
#ifdef EW_SOURCE_VARYINGS
    return ew_sources[start];
#else
    return ew_source_unit(start + i * size);
#endif
}
#endif
