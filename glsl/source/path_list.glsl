// The paths of a tile's lists. Behind the place of a path with pieces stands which of them light the tile: see src/plan/tile_lists.h.

#ifdef EW_BEAMS
#define EW_HAS_RANGE(i) (i >= ew_list_entry(ew_tile_row + ew_list_row(EW_LIST_OF_POLYLINES)))
#else
#define EW_HAS_RANGE(i) true
#endif
#define EW_PATH_STEP(i) (1 + int(EW_HAS_RANGE(i)))

// The path at place i of the lists, with no pieces but those. The ends at which others join it are out of reach. It is made anew, since
// SwiftShader loses changes to a structure that is read in a loop.
ew_path_block ew_listed_path(const int i)
{
    ew_path_block path = ew_path(ew_list_entry(i));
    bool has_range = EW_HAS_RANGE(i);
    int range = ew_list_entry(i + int(has_range));
    int count = int(path.pieces.y);
    int step = (count + 255) >> 8;
    int first = step * (range & 255);
    int end = min(step * ((range >> 8) + 1), count);
    int units = EW_STRAIGHT_UNITS + int(EW_HAS_BENDS(path)) * (EW_BENT_UNITS - EW_STRAIGHT_UNITS);
    float is_closed = mix(path.pieces.w, 0.0, end - first < count);
    vec4 listed = vec4(path.pieces.x + float(first * units), float(end - first), path.pieces.z, is_closed);
    return ew_path_block(path.ball, path.beam, mix(path.pieces, listed, bvec4(has_range)), path.weights, path.color, path.glow);
}
