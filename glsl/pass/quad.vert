// The camera-facing quad that covers the viewport or, with EW_LIT_QUAD, what of it can be lit: a strip of four vertices without any vertex
// data.
void main()
{
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
#ifdef EW_LIT_QUAD
    // Vertices behind the strip's lie beyond the upper edge of the viewport.
    vec2 place = corner.y > 1.0 ? 2.0 * corner - 1.0 : mix(ew_grid.lit.xy, ew_grid.lit.zw, corner);
#else
    vec2 place = 2.0 * corner - 1.0;
#endif
    gl_Position = vec4(place, 0.0, 1.0);
    ew_copy_varyings();
}
