// The camera-facing quad that covers the viewport, as a strip of four vertices without any vertex data; and the varyings that
// are the same for all fragments.
void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
#ifdef EW_SOFTWARE
    ew_frame = ew_uniform_frame;
    ew_source_counts = ew_uniform_source_counts;
#endif
#ifdef EW_SOURCE_VARYINGS
    for (int i = 0; i < EW_SOURCE_VARYINGS; ++i)
        ew_sources[i] = ew_source_data[i];
#endif
}
