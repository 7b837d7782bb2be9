// Loops over the sources of a kind. They test at their ends: llvmpipe runs the body of a loop that tests first once more, with every
// lane masked off.

// The sources of a kind, by its number: places from EW_FIRST to EW_END of its list.
#ifdef EW_LISTS
#define EW_FIRST(kind) ew_list_entry(ew_tile_row + kind)
#define EW_END(kind, count) ew_list_entry(ew_tile_row + kind + 1)
#define EW_PLACE(i) ew_list_entry(i)
#else
#define EW_FIRST(kind) 0
#define EW_END(kind, count) count
#define EW_PLACE(i) i
#endif
#define EW_EACH(kind, count, body) { int i = EW_FIRST(kind); int end = EW_END(kind, count); body }
