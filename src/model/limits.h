/* The ranges inside which no intermediate result of the shader overflows a float or vanishes in one. They are far outside
 * anything that could be seen. */
#ifndef EW_LIMITS_H
#define EW_LIMITS_H

#define EW_MAX_COORDINATE 1e6 /* in lengths of the interval */
#define EW_MIN_EPSILON 1e-12  /* in lengths of the interval */
#define EW_MIN_CORE 1e-16     /* the same of the world integral, whose interval is as long as what is lit */
#define EW_MAX_COEFFICIENT 1e12
#define EW_MAX_COLOR 65504.0 /* the largest half float */
#define EW_MIN_BETA 1e-6
#define EW_MAX_BETA 1e6
#define EW_MAX_INTERVAL_RATIO 1e12
#define EW_MAX_VIEW_DEVIATION 1e-3 /* of R^T R from 1 */
#define EW_MAX_WINDOW_DEPTH 1e15
#define EW_MAX_CORE_PIXELS 64.0
#define EW_MAX_LIGHT_GAIN 1e6
#define EW_MAX_EXPOSURE 1e6
#define EW_MAX_EXTINCTION 1e12
#define EW_MIN_FLATNESS 1e-9 /* of a body: its volume, of that of a block with its axes at right angles */
#define EW_MAX_BODY_MAP 1e15 /* of what brings ray space to that of a body */

#endif
