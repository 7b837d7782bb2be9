// Energy waves: for each pixel the sum, over all sources, of
//
//     B_i = integral from 0 to s_max of  coefficient * weight / max(epsilon, distance(L(s))) * alpha / (s + beta)^2  ds,
//
// equations (18), (20), (21), and its composite over the opaque scene: (1 - B) Cb + sum B_i color_i, thesis (4.8) with the
// background's weight kept from going negative, which blending with (ONE, ONE_MINUS_SRC_ALPHA) does.

// B_i is cut here, far above what any target shows, so that sums and products of it stay finite.
const float EW_MAX_LUMINANCE = 1e30;
// The largest half float: a colour beyond would be infinite in a 16-bit target.
const float EW_MAX_RADIANCE = 65504.0;

out vec4 ew_color;

void ew_add(float luminance, vec3 color, inout vec4 sum)
{
    luminance = clamp(luminance, 0.0, EW_MAX_LUMINANCE);
    sum += vec4(luminance * color, luminance);
}

// The light of all sources along a segment: sum B_i color_i, and sum B_i as the fourth component.
vec4 ew_integrate_all(ew_segment segment)
{
    vec4 sum = vec4(0.0);
#ifdef EW_POINTS
    for (int i = 0; i < EW_POINT_COUNT; ++i) {
        ew_point_block point = ew_point(i);
        ew_add(point.position.w * ew_integrate_point(segment, point), point.color.rgb, sum);
    }
#endif
#ifdef EW_LINES
    for (int i = 0; i < EW_LINE_COUNT; ++i) {
        ew_line_block line = ew_line(i);
        ew_add(line.position.w * ew_integrate_line(segment, line), line.color.rgb, sum);
    }
#endif
#ifdef EW_TORI
    for (int i = 0; i < EW_TORUS_COUNT; ++i) {
        ew_torus_block torus = ew_torus(i);
        ew_add(torus.center.w * ew_integrate_torus(segment, torus), torus.color.rgb, sum);
    }
#endif
#ifdef EW_CURVES
    for (int i = 0; i < EW_CURVE_COUNT; ++i) {
        ew_curve_block curve = ew_curve(i);
        ew_add(curve.origin.w * ew_integrate_curve(segment, curve), curve.color.rgb, sum);
    }
#endif
    return sum;
}

// What the light along a segment does to the target.
vec4 ew_shade(ew_segment segment)
{
    vec4 light = ew_integrate_all(segment);
#ifdef EW_LUMINANCE
    return vec4(light.a, 0.0, 0.0, 1.0);
#else
    return vec4(min(light.rgb, EW_MAX_RADIANCE), min(light.a, 1.0));
#endif
}

void main()
{
    vec2 pixel = gl_FragCoord.xy - ew_frame.pixel_center.xy;
    vec4 ray = ew_frame.ray_center + pixel.x * ew_frame.ray_right + pixel.y * ew_frame.ray_up;
    ew_segment segment = ew_segment(vec3(ray.xy, 0.0), vec3(ray.zw, -1.0), 1.0);

#ifdef EW_DEPTH_MULTISAMPLE
    // The mean of what is done to the target, not of the depths: a pixel on a silhouette is no wall half way.
    ew_color = vec4(0.0);
    for (int i = ew_samples.x; i < ew_samples.y; ++i) {
        segment.end = ew_opaque_parameter(pixel, i);
        ew_color += ew_shade(segment);
    }
    ew_color /= float(ew_samples.y - ew_samples.x);
#else
#ifdef EW_DEPTH
    segment.end = ew_opaque_parameter(pixel);
#endif
    ew_color = ew_shade(segment);
#endif

#ifdef EW_DITHER
    ew_color.rgb = ew_dither(ew_color.rgb);
#endif
#ifdef EW_EVALUATIONS
    ew_color = vec4(float(ew_evaluation_count), 0.0, 0.0, 1.0);
#endif
}
