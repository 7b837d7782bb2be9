/* The text of the files in shaders/, embedded at build time. */
#ifndef SHADER_TEXT_H
#define SHADER_TEXT_H

extern const char shader_text_lit_opaque_vert[];
extern const char shader_text_lit_opaque_frag[];
extern const char shader_text_screen_vert[];
extern const char shader_text_film_frag[];
extern const char shader_text_overlay_vert[];
extern const char shader_text_overlay_frag[];

#endif
