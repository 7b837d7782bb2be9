/* The files of glsl/, embedded at build time: zero-terminated text. */
#ifndef EW_GLSL_TEXT_H
#define EW_GLSL_TEXT_H

extern const char ew_glsl_layout_glsl[];
extern const char ew_glsl_blocks_glsl[];
extern const char ew_glsl_depth_glsl[];
extern const char ew_glsl_dither_glsl[];
extern const char ew_glsl_segment_glsl[];
extern const char ew_glsl_quadrature_glsl[];
extern const char ew_glsl_components_glsl[];
extern const char ew_glsl_point_glsl[];
extern const char ew_glsl_line_glsl[];
extern const char ew_glsl_torus_side_glsl[];
extern const char ew_glsl_torus_core_glsl[];
extern const char ew_glsl_torus_panel_glsl[];
extern const char ew_glsl_torus_glsl[];
extern const char ew_glsl_weight_glsl[];
extern const char ew_glsl_arc_glsl[];
extern const char ew_glsl_passage_glsl[];
extern const char ew_glsl_cell_glsl[];
extern const char ew_glsl_stretch_glsl[];
extern const char ew_glsl_rest_glsl[];
extern const char ew_glsl_knot_glsl[];
extern const char ew_glsl_rest_panels_glsl[];
extern const char ew_glsl_curve_glsl[];
extern const char ew_glsl_simpson_glsl[];
extern const char ew_glsl_light_glsl[];
extern const char ew_glsl_include_glsl[];
extern const char ew_glsl_wave_frag[];
extern const char ew_glsl_quad_vert[];

#endif
