// The stretches of a ray beside an arc: intervals on which no end of the arc is nearest, one arm of the parabola is nearest all
// along, and the nearest point moves smoothly.

// Where start + s growth is 0; -1, behind the ray, if nowhere.
float ew_zero(const float start, const float growth)
{
    return mix(-1.0, -start / growth, growth != 0.0);
}

// Where to split the ray; a component below 0 is no split. x: the nearest point jumps, or nearly jumps, to the other arm. y:
// the ray passes the centre of curvature of a sharp bend, or any vertex's closely, from where the nearest point leaves the
// vertex suddenly. zw: the planes of the ends at a sharp bend, past which one arm goes on alone.
vec4 ew_find_splits(const ew_arc arc, const ew_cell first, const ew_cell last)
{
    float vertex = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    float bend = ew_zero(arc.equation_start.x, arc.equation_growth.x);
    bool is_jump = arc.equation_start.x + vertex * arc.equation_growth.x < 0.1 * arc.cubic;
    bool is_sharp = arc.has_arms && arc.slope_x < 0.1 * arc.bend;
    bool is_close = arc.has_arms && abs(arc.equation_start.y + bend * arc.equation_growth.y) < 1e-3 * arc.cubic;
    vec2 planes = vec2(ew_zero(first.constant.x, first.constant.y), ew_zero(last.constant.x, last.constant.y));
    return mix(vec4(-1.0), vec4(vertex, bend, planes), bvec4(is_jump, is_sharp || is_close, is_sharp, is_sharp));
}

// The first place from `s` on that is in neither end's part.
float ew_skip_parts(float s, const vec2 first, const vec2 last)
{
    s = mix(s, last.y, s >= last.x && s < last.y);
    s = mix(s, first.y, s >= first.x && s < first.y);
    return mix(s, last.y, s >= last.x && s < last.y);
}

// Where the stretch that begins at `from` ends: at an end's part, a split or the segment's end. Of a curve with a reach also where
// the distance has its maximum, `farthest`: then it has one minimum in a stretch at the most.
float ew_end_of_stretch(const float from, const float end, const vec2 first, const vec2 last, const vec4 splits,
                        const float farthest)
{
    float to = end;
#ifdef EW_REACH
    to = mix(to, min(to, farthest), farthest > from * (1.0 + 1e-6));
#endif
    to = mix(to, min(to, first.x), first.x > from);
    to = mix(to, min(to, last.x), last.x > from);
    vec4 ends = mix(vec4(to), min(vec4(to), splits), greaterThan(splits, vec4(from * (1.0 + 1e-6))));
    return min(min(ends.x, ends.y), min(ends.z, ends.w));
}

// Which arm of the parabola is nearest on the stretch [from, to]. Both arms have a minimum of the distance where equation.x <
// 0. There, the nearer one is on the ray's side of the vertex, unless the arc lacks the minimum on that arm.
float ew_nearest_arm(const ew_arc arc, const ew_cell first, const ew_cell last, const float from, const float to)
{
    float arm = arc.arm;
    if (arc.has_vertex) {
        float bend = clamp(ew_zero(arc.equation_start.x, arc.equation_growth.x), from, to);
        float two_arms_from = mix(bend, from, arc.equation_start.x + from * arc.equation_growth.x < 0.0);
        float two_arms_to = mix(bend, to, arc.equation_start.x + to * arc.equation_growth.x < 0.0);
        float place = 0.5 * (two_arms_from + two_arms_to);
        vec2 equation = arc.equation_start + place * arc.equation_growth;
        // The bound keeps rounding errors from choosing in a plane of symmetry.
        vec3 extent = abs(arc.start);
        bool is_negative = equation.y < -1e-6 * arc.slope_x * (extent.x + extent.y + extent.z);
        vec2 excess = mix(last.constant, first.constant, bvec2(is_negative));
        bool is_lacking = excess.x + place * excess.y > 0.0;
        arm = mix(-1.0, 1.0, is_negative == is_lacking);
        arm = mix(arm, 0.0, two_arms_to - two_arms_from <= 1e-6 * two_arms_to);
        // An arc that is folded back on itself is as long as its longer arm.
        arm = mix(arm, mix(1.0, -1.0, -arc.first > arc.last), arc.slope_x == 0.0);
    }
    return arm;
}
