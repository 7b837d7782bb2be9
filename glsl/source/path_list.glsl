// The paths of a tile's lists. If any path of the frame has pieces, behind the place of each stands which of its pieces light the tile: see
// src/plan/tile_lists.h.

#define EW_PATH_STEP(i) int(ew_grid.tolerance.w)

#ifdef EW_PIECES
// The path at place i of the lists, with no pieces but those. The ends at which others join it are out of reach.
ew_path_block ew_listed_path(const int i)
{
    ew_path_block path = ew_path(ew_list_entry(i));
    int range = ew_list_entry(i + EW_PATH_STEP(i) - 1);
    int count = int(path.pieces.y);
    int step = (count + 255) >> 8;
    int first = step * (range & 255);
    int end = min(step * ((range >> 8) + 1), count);
    int units = EW_STRAIGHT_UNITS + int(EW_HAS_BENDS(path)) * (EW_BENT_UNITS - EW_STRAIGHT_UNITS);
    float is_closed = mix(path.pieces.w, 0.0, end - first < count);
    vec4 pieces = vec4(path.pieces.x + float(first * units), float(end - first), path.pieces.z, is_closed);
    return ew_path_block(path.ball, path.beam, pieces, path.weights, path.color, path.glow);
}
#else
#define ew_listed_path(i) ew_path(ew_list_entry(i))
#endif
