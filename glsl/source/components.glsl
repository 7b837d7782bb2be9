// Names for the numbers that share a vec4 of a source's block with something else; layout.glsl says where they are packed.

float ew_radius(ew_torus_block torus)
{
    return torus.axis.w;
}

float ew_slope_x(ew_curve_block curve)
{
    return curve.axis_x.w;
}

float ew_slope_y(ew_curve_block curve)
{
    return curve.axis_y.w;
}

float ew_bend(ew_curve_block curve)
{
    return curve.axis_z.w;
}

float ew_mean_weight(ew_curve_block curve)
{
    return curve.origin.w;
}

float ew_first_tau(ew_curve_block curve)
{
    return curve.domain.x;
}

float ew_last_tau(ew_curve_block curve)
{
    return curve.domain.y;
}

float ew_first_piece(ew_curve_block curve)
{
    return curve.domain.z;
}

// 0: the curve has no weights.
float ew_piece_count(ew_curve_block curve)
{
    return curve.domain.w;
}

// Where the segment may be within reach of a torus: a sphere around its reach.
vec2 ew_chord(ew_segment segment, ew_torus_block torus)
{
    return ew_sphere_chord(segment, torus.center.xyz, ew_radius(torus) + torus.glow.y);
}

// Where the segment may be within reach of a curve: a sphere around the point at the middle m of its domain, no farther from which
// than |C'(m)| / 2 + bend / 4 the arc lies.
vec2 ew_chord(ew_segment segment, ew_curve_block curve)
{
    float middle = 0.5 * (ew_first_tau(curve) + ew_last_tau(curve));
    float slope_y = ew_slope_y(curve) + 2.0 * ew_bend(curve) * middle;
    vec3 center = curve.origin.xyz + ew_slope_x(curve) * middle * curve.axis_x.xyz
                  + (ew_slope_y(curve) + ew_bend(curve) * middle) * middle * curve.axis_y.xyz;
    float extent = 0.5 * length(vec2(ew_slope_x(curve), slope_y)) + 0.25 * ew_bend(curve);
    return ew_sphere_chord(segment, center, extent + curve.glow.y);
}

// Where the segment may be within reach of a path: a sphere around its ball, and around a straight beam the cylinder, too.
vec2 ew_chord(ew_segment segment, ew_path_block path)
{
    vec2 chord = ew_sphere_chord(segment, path.ball.xyz, path.ball.w + path.glow.y);
    if (path.pieces.y == 0.0 && path.ball.w > 0.0) {
        vec3 axis = path.beam.xyz / path.ball.w;
        vec3 to_line = path.ball.xyz - segment.origin;
        to_line -= dot(to_line, axis) * axis;
        vec3 across = segment.direction - dot(segment.direction, axis) * axis;
        float k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
        float s0 = dot(to_line, across) / k;
        vec2 cylinder = ew_chord_of(ew_length_squared(to_line - s0 * across), k, s0, path.glow.y, segment.end);
        chord = vec2(max(chord.x, cylinder.x), min(chord.y, cylinder.y));
    }
    return chord;
}
