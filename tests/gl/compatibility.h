/* Enumerators of the compatibility profile: from <GL/gl.h>, and from here those that it leaves to glext.h, whose place the
 * core profile's header has taken. */
#ifndef TEST_COMPATIBILITY_H
#define TEST_COMPATIBILITY_H

#include <GL/glcorearb.h>

#include <GL/gl.h>

#define GL_CLAMP_VERTEX_COLOR 0x891A
#define GL_CLAMP_FRAGMENT_COLOR 0x891B
#define GL_COLOR_SUM 0x8458
#define GL_CURRENT_FOG_COORD 0x8453
#define GL_CURRENT_SECONDARY_COLOR 0x8459
#define GL_DEPTH_TEXTURE_MODE 0x884B
#define GL_GENERATE_MIPMAP_HINT 0x8192
#define GL_POINT_SPRITE 0x8861
#define GL_VERTEX_PROGRAM_TWO_SIDE 0x8643

#endif
