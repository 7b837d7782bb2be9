/* Hulls as a view sees them. */
#ifndef EW_HULL_H
#define EW_HULL_H

#include "model/kinds.h"
#include "model/view.h"

/* The hull in view space, with depth as the third coordinate. */
ew_hull ew_see_hull(const ew_hull *hull, const ew_view *view);

bool ew_hull_is_line(const ew_hull *hull);

#endif
