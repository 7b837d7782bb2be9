/* Enumerators of the compatibility profile: from <GL/gl.h>, and from here those that it leaves to glext.h, whose place the
 * core profile's header has taken. */
#ifndef TEST_COMPATIBILITY_H
#define TEST_COMPATIBILITY_H

#include <GL/glcorearb.h>

#include <GL/gl.h>

#ifndef GL_DEPTH_BOUNDS_TEST_EXT /* Windows' GL/gl.h is that of OpenGL 1.1. */
#define GL_CLIENT_ACTIVE_TEXTURE 0x84E1
#define GL_DEPTH_BOUNDS_TEST_EXT 0x8890
#define GL_MAX_TEXTURE_UNITS 0x84E2
#define GL_RESCALE_NORMAL 0x803A
#endif

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
