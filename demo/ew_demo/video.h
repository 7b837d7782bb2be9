/*
 * A video, encoded by the program ffmpeg.
 */
#ifndef VIDEO_H
#define VIDEO_H

#include <stdbool.h>
#include <stddef.h>

typedef struct demo_video demo_video;

/* Starts ffmpeg, which replaces the file at `path`. The ending of the name decides the format. Returns NULL, with a message, on
 * failure. */
demo_video *video_open(const char *path, int width, int height, int frames_per_second, char *message, size_t size);

/* Writes a frame: 3 bytes a pixel, rows from the bottom up. Returns false once ffmpeg has exited; video_close says why. */
bool video_write(demo_video *video, const unsigned char *srgb);

/* Waits for ffmpeg to finish the file. On failure returns false, with a message. */
bool video_close(demo_video *video, char *message, size_t size);

#endif
