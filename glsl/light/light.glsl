// The sum over all sources.

// B_i is cut here, far above what any target shows, so that sums and products of it stay finite.
const float EW_MAX_LUMINANCE = 1e30;

void ew_add(float luminance, vec3 color, inout vec4 sum)
{
    luminance = clamp(luminance, 0.0, EW_MAX_LUMINANCE);
    sum += vec4(luminance * color, luminance);
}

// The light of all sources along a segment: sum B_i color_i, and sum B_i as the fourth component. Loops are left at their ends: one
// that tests first has its body run once too often on a software rasteriser, for no pixel at all.
vec4 ew_integrate_all(ew_segment segment)
{
    vec4 sum = vec4(0.0);
#ifdef EW_POINTS
    if (EW_POINT_COUNT > 0) {
        int i = 0;
        do {
            ew_point_block point = ew_point(i);
            ew_add(point.position.w * ew_integrate(segment, point, sum.a), point.color.rgb, sum);
        } while (++i < EW_POINT_COUNT);
    }
#endif
#ifdef EW_LINES
    if (EW_LINE_COUNT > 0) {
        int i = 0;
        do {
            ew_line_block line = ew_line(i);
            ew_add(line.position.w * ew_integrate(segment, line, sum.a), line.color.rgb, sum);
        } while (++i < EW_LINE_COUNT);
    }
#endif
#ifdef EW_TORI
    if (EW_TORUS_COUNT > 0) {
        int i = 0;
        do {
            ew_torus_block torus = ew_torus(i);
            ew_add(torus.center.w * ew_integrate(segment, torus, sum.a), torus.color.rgb, sum);
        } while (++i < EW_TORUS_COUNT);
    }
#endif
#ifdef EW_CURVES
    if (EW_CURVE_COUNT > 0) {
        int i = 0;
        do {
            ew_curve_block curve = ew_curve(i);
            // In the unit of the curve's integral: over its coefficient, which may be 0; so bounded that the quotient is finite.
            float others = min(sum.a, 1e6) / max(curve.origin.w, 1e-30);
            ew_add(curve.origin.w * ew_integrate(segment, curve, others), curve.color.rgb, sum);
        } while (++i < EW_CURVE_COUNT);
    }
#endif
    return sum;
}
