// What the light of all parts of the sources does to a pixel: see part.frag.

uniform sampler2D ew_light_texture;

out vec4 ew_color;

void main()
{
    vec4 sum = texelFetch(ew_light_texture, ivec2(gl_FragCoord.xy) - ew_grid.viewport.xy, 0);
#ifdef EW_EVALUATIONS
    ew_color = vec4(sum.r, 0.0, 0.0, 1.0);
#else
    ew_color = ew_composite(sum);
#endif
#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
}
