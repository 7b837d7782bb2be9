// The light of a pixel of a patch that is interpolated.

out vec4 ew_color;

void main()
{
    ew_color = ew_composite(ew_patch_light());
#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
}
