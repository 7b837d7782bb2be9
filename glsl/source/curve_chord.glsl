// Where the segment may be within reach of a curve: a sphere around the point at the middle m of its domain, no farther from which
// than |C'(m)| / 2 + bend / 4 the arc lies.
vec2 ew_chord(const ew_segment segment, const ew_curve_block curve)
{
    float middle = 0.5 * (ew_first_tau(curve) + ew_last_tau(curve));
    float slope_y = ew_slope_y(curve) + 2.0 * ew_bend(curve) * middle;
    vec3 center = curve.origin.xyz + ew_slope_x(curve) * middle * curve.axis_x.xyz
                  + (ew_slope_y(curve) + ew_bend(curve) * middle) * middle * curve.axis_y.xyz;
    float extent = 0.5 * length(vec2(ew_slope_x(curve), slope_y)) + 0.25 * ew_bend(curve);
    return ew_sphere_chord(segment, center, extent + curve.glow.y);
}
