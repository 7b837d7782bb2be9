// Where a straight piece of a path is nearest to a ray.

// The planes through the ends of a straight piece cut a ray in three: to what is before the start the start is nearest, to what
// is beyond the end the end, and in between a point of the line.
struct ew_slab {
    vec3 start;
    vec3 end;
    vec3 axis;
    float size;
    float along;  // of the ray's origin from the start
    float growth; // of it with s
    vec2 t;       // the path's parameter at both ends
};

ew_slab ew_make_slab(const ew_segment segment, const vec4 start, const vec4 end)
{
    vec3 way = end.xyz - start.xyz;
    float size = length(way);
    vec3 axis = way / max(size, 1e-30);
    return ew_slab(start.xyz, end.xyz, axis, size, dot(segment.origin - start.xyz, axis), dot(segment.direction, axis),
                   vec2(start.w, end.w));
}

// The s at which the ray comes to the plane at `place` along the piece, in `chord`. A ray parallel to the planes, which does
// not run along the piece, is before or beyond the plane all the way: it comes to it at the end of the chord, or has come at
// its start.
float ew_s_at_plane(const ew_slab slab, const float place, const vec2 chord)
{
    float way = place - slab.along;
    bool is_parallel = abs(slab.growth) <= 1e-20 * abs(way);
    return mix(clamp(way / slab.growth, chord.x, chord.y), mix(chord.y, chord.x, way > 0.0), is_parallel);
}

// The line's squared distance along the ray is b2 + k (s - s0)^2. `part` is cut to what is within reach.
void ew_find_line(const ew_segment segment, const ew_slab slab, const vec4 glow, inout vec2 part, out float b2, out float k,
                  out float s0)
{
    vec3 to_line = slab.start - segment.origin;
    to_line -= dot(to_line, slab.axis) * slab.axis;
    vec3 across = segment.direction - slab.growth * slab.axis;
    k = max(ew_length_squared(across), 1e-12 * ew_length_squared(segment.direction));
    s0 = dot(to_line, across) / k;
    b2 = ew_length_squared(to_line - s0 * across);
#ifdef EW_REACH
    if (ew_has_reach(glow)) {
        vec2 chord = ew_chord_of(b2, k, s0, glow.y, segment.end);
        part = vec2(clamp(part.x, chord.x, chord.y), clamp(part.y, chord.x, chord.y));
    }
#endif
}

// Where the ray comes to the planes of a piece, in `chord`; and whether it runs from the start's to the end's.
struct ew_planes {
    float start;
    float end;
    bool is_along;
};

ew_planes ew_find_planes(const ew_slab slab, const vec2 chord)
{
    return ew_planes(ew_s_at_plane(slab, 0.0, chord), ew_s_at_plane(slab, slab.size, chord), slab.growth > 0.0);
}
