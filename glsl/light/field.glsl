// What a node of adaptive resolution must know of a source beside its light: see node.frag.
//
// C puts this file into the shader once for each kind, with EW_SOURCE defined as the kind's block.

// The field where the segment ends, times the coefficient and the sharpness, which bounds how much steeper sharpened light is; or
// EW_UNRESOLVED, where the source may shine within a cell of the ray and its reach is less than a cell's diagonal: a wider one is seen
// by some node at a good part of its light.
float ew_field_of(const ew_segment segment, const EW_SOURCE source)
{
#ifdef EW_REACH
    if (source.glow.y > 0.0) {
        EW_SOURCE wide = source;
        wide.glow.y = source.glow.y + ew_cell_diagonal(segment.end);
        // The cell is as wide as that only at the end, so the part of the ray that is found is searched once more.
        float last = ew_chord(segment, wide).y;
        wide.glow.y = source.glow.y + ew_cell_diagonal(last);
        vec2 chord = ew_chord(segment, wide);
        if (chord.x < chord.y && source.glow.y < ew_cell_diagonal(chord.y)) return EW_UNRESOLVED;
    }
#endif
    float field = ew_sample_at(source, segment.origin + segment.end * segment.direction, segment.end);
#ifdef EW_MEDIA
    field *= ew_leg_share;
#endif
    return abs(field) * source.color.w * max(source.glow.z, 1.0);
}
