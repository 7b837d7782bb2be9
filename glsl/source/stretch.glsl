// The stretches of a ray beside an arc: intervals on which no end of the arc is nearest, one arm of the parabola is nearest all
// along, and the nearest point moves smoothly.

// Where start + s growth is 0; -1, behind the ray, if nowhere.
float ew_zero(float start, float growth)
{
    return growth != 0.0 ? -start / growth : -1.0;
}

// Where to split the ray; a component below 0 is no split. x: the nearest point jumps, or nearly jumps, to the other arm. y:
// the ray passes the centre of curvature of a sharp bend, or any vertex's closely, from where the nearest point leaves the
// vertex suddenly. zw: the planes of the ends at a sharp bend, past which one arm goes on alone.
vec4 ew_find_splits(ew_arc arc, ew_cell first, ew_cell last)
{
    float vertex = ew_zero(arc.equation_start.y, arc.equation_growth.y);
    float bend = ew_zero(arc.equation_start.x, arc.equation_growth.x);
    bool is_jump = arc.equation_start.x + vertex * arc.equation_growth.x < 0.1 * arc.cubic;
    bool is_sharp = arc.has_arms && arc.slope_x < 0.1 * arc.bend;
    bool is_close = arc.has_arms && abs(arc.equation_start.y + bend * arc.equation_growth.y) < 1e-3 * arc.cubic;
    vec2 planes = vec2(ew_zero(first.constant.x, first.constant.y), ew_zero(last.constant.x, last.constant.y));
    return vec4(is_jump ? vertex : -1.0, is_sharp || is_close ? bend : -1.0, is_sharp ? planes : vec2(-1.0));
}

// The first place from `s` on that is in neither end's part.
float ew_skip_parts(float s, vec2 first, vec2 last)
{
    if (s >= last.x && s < last.y) s = last.y;
    if (s >= first.x && s < first.y) s = first.y;
    if (s >= last.x && s < last.y) s = last.y;
    return s;
}

// Where the stretch that begins at `from` ends: at an end's part, a split or the segment's end. Of a curve with a reach also where
// the distance has its maximum, `farthest`: then it has one minimum in a stretch at the most.
float ew_end_of_stretch(float from, float end, vec2 first, vec2 last, vec4 splits, float farthest)
{
    float to = end;
#ifdef EW_REACH
    if (farthest > from * (1.0 + 1e-6)) to = min(to, farthest);
#endif
    if (first.x > from) to = min(to, first.x);
    if (last.x > from) to = min(to, last.x);
    if (splits.x > from * (1.0 + 1e-6)) to = min(to, splits.x);
    if (splits.y > from * (1.0 + 1e-6)) to = min(to, splits.y);
    if (splits.z > from * (1.0 + 1e-6)) to = min(to, splits.z);
    if (splits.w > from * (1.0 + 1e-6)) to = min(to, splits.w);
    return to;
}

// Which arm of the parabola is nearest on the stretch [from, to]. Both arms have a minimum of the distance where equation.x <
// 0. There, the nearer one is on the ray's side of the vertex, unless the arc lacks the minimum on that arm.
float ew_nearest_arm(ew_arc arc, ew_cell first, ew_cell last, float from, float to)
{
    float arm = arc.arm;
    if (arc.has_vertex) {
        float bend = clamp(ew_zero(arc.equation_start.x, arc.equation_growth.x), from, to);
        float two_arms_from = arc.equation_start.x + from * arc.equation_growth.x < 0.0 ? from : bend;
        float two_arms_to = arc.equation_start.x + to * arc.equation_growth.x < 0.0 ? to : bend;
        float place = 0.5 * (two_arms_from + two_arms_to);
        vec2 equation = arc.equation_start + place * arc.equation_growth;
        // The bound keeps rounding errors from choosing in a plane of symmetry.
        vec3 extent = abs(arc.start);
        bool is_negative = equation.y < -1e-6 * arc.slope_x * (extent.x + extent.y + extent.z);
        vec2 excess = is_negative ? first.constant : last.constant;
        bool is_lacking = excess.x + place * excess.y > 0.0;
        arm = is_negative == is_lacking ? 1.0 : -1.0;
        if (two_arms_to - two_arms_from <= 1e-6 * two_arms_to) arm = 0.0;
        // An arc that is folded back on itself is as long as its longer arm.
        if (arc.slope_x == 0.0) arm = -arc.first > arc.last ? -1.0 : 1.0;
    }
    return arm;
}
