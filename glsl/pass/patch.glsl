// The light of a patch of the grid, as a polynomial of the place in it.

#ifdef EW_VERTEX_STAGE
#define EW_PATCH_VARYING flat out
#else
#define EW_PATCH_VARYING flat in
#endif

// With x and y from 0 to 1 over the patch: x^i is at [i], x^i y at [4 + i], x^i y^2 at [8 + i], x^i y^3 at [10 + i], and
// x (1 - x) y (1 - y) at [12].
EW_PATCH_VARYING vec4 ew_coefficients[13];
// xy: the centre of the patch's first pixel, as gl_FragCoord; z: 1 / its width in pixels.
EW_PATCH_VARYING vec3 ew_patch;

#ifndef EW_VERTEX_STAGE
// The light of the fragment.
vec4 ew_patch_light()
{
    vec2 place = (gl_FragCoord.xy - ew_patch.xy) * ew_patch.z;
    float x = place.x, y = place.y;
    vec4 row0 = ew_coefficients[0] + x * (ew_coefficients[1] + x * (ew_coefficients[2] + x * ew_coefficients[3]));
    vec4 row1 = ew_coefficients[4] + x * (ew_coefficients[5] + x * (ew_coefficients[6] + x * ew_coefficients[7]));
    vec4 row2 = ew_coefficients[8] + x * ew_coefficients[9];
    vec4 row3 = ew_coefficients[10] + x * ew_coefficients[11];
    vec4 bubble = (x * (1.0 - x) * y * (1.0 - y)) * ew_coefficients[12];
    return max(row0 + y * (row1 + y * (row2 + y * row3)) + bubble, 0.0);
}
#endif
