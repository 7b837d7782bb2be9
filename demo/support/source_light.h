/*
 * What sources of every kind have in common: the members with which each of them ends.
 */
#ifndef SOURCE_LIGHT_H
#define SOURCE_LIGHT_H

typedef struct source_light {
    double coefficient, brightness, core, reach, sharpness;
    const double *color;
} source_light;

/* The light of an ew_point, ew_line, ew_torus, ew_curve or ew_path. */
#define SOURCE_LIGHT(source)                                                                                                   \
    ((source_light){(source)->coefficient, (source)->brightness, (source)->core, (source)->reach, (source)->sharpness,         \
                    (source)->color})

#endif
