// Loops over the sources of a kind. They test at their ends: llvmpipe runs the body of a loop that tests first once more, with every
// lane masked off.

// The sources of a kind: places from EW_FIRST to EW_END of its lists, which are those from `first` up to `last`.
#ifdef EW_LISTS
#define EW_FIRST(first) ew_list_entry(ew_tile_row + ew_list_row(first))
#define EW_END(last, count) ew_list_entry(ew_tile_row + ew_list_row(last))
#define EW_PLACE(i) ew_list_entry(i)
#else
#define EW_FIRST(first) 0
#define EW_END(last, count) count
#define EW_PLACE(i) i
#endif
// `read` reads a source by its place in the lists, and `step` says how many places it takes there.
#define EW_EACH(first, last, count, body) { int i = EW_FIRST(first); int end = EW_END(last, count); body }
