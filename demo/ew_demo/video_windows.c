/* A video of frames, on Windows: see video.h. */
#include "message.h"
#include "video.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct demo_video {
    FILE *frames;
    size_t frame_bytes;
    char path[1000];
};

demo_video *video_open(const char *path, int width, int height, int frames_per_second, char *message, size_t size)
{
    char command[1400];
    demo_video *video = calloc(1, sizeof *video);
    if (!video || strlen(path) >= sizeof video->path || strpbrk(path, "\"%")) {
        message_write(message, size, "--video: cannot begin; use a shorter name, without \" and %%");
        free(video);
        return NULL;
    }
    strcpy(video->path, path);
    video->frame_bytes = (size_t)width * (size_t)height * 3;
    /* All players know 4:2:0, which needs even sides. A name that begins with a dash is not to be taken for an option. */
    snprintf(command, sizeof command,
             "ffmpeg -loglevel error -y -f rawvideo -pixel_format rgb24 -video_size %dx%d -framerate %d -i - "
             "-vf vflip,crop=trunc(iw/2)*2:trunc(ih/2)*2 -pix_fmt yuv420p \"%s%s\"",
             width, height, frames_per_second, path[0] == '-' ? "./" : "", path);
    video->frames = _popen(command, "wb");
    if (video->frames) return video;
    message_write(message, size, "--video: ffmpeg cannot be started (%s)", strerror(errno));
    free(video);
    return NULL;
}

bool video_write(demo_video *video, const unsigned char *srgb)
{
    return fwrite(srgb, 1, video->frame_bytes, video->frames) == video->frame_bytes;
}

bool video_close(demo_video *video, char *message, size_t size)
{
    bool ok = _pclose(video->frames) == 0;
    if (!ok) message_write(message, size, "--video: ffmpeg could not write %s; the lines above say why", video->path);
    free(video);
    return ok;
}
