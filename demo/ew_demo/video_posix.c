/* A video of frames, on Unix: see video.h. */
#include "message.h"
#include "video.h"

#include <errno.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

extern char **environ;

struct demo_video {
    pid_t ffmpeg;
    FILE *frames;
    size_t frame_bytes;
    char path[1000];
};

/* Starts ffmpeg with `input` as its standard input; returns what failed, or 0. */
static int start(demo_video *video, int input, int other_end, int width, int height, int frames_per_second)
{
    char size[30], rate[20], path[1010];
    snprintf(size, sizeof size, "%dx%d", width, height);
    snprintf(rate, sizeof rate, "%d", frames_per_second);
    /* Keeps ffmpeg from taking a name that begins with a dash for an option. */
    snprintf(path, sizeof path, "%s%s", video->path[0] == '-' ? "./" : "", video->path);
    /* All players know 4:2:0, which needs even sides. */
    /* clang-format off */
    const char *const arguments[] = {
        "ffmpeg", "-loglevel", "error", "-y",
        "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", size, "-framerate", rate, "-i", "-",
        "-vf", "vflip,crop=trunc(iw/2)*2:trunc(ih/2)*2", "-pix_fmt", "yuv420p", path, NULL};
    /* clang-format on */
    posix_spawn_file_actions_t actions;
    int failure = posix_spawn_file_actions_init(&actions);
    if (failure) return failure;
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addclose(&actions, other_end);
    failure = posix_spawnp(&video->ffmpeg, "ffmpeg", &actions, NULL, (char *const *)arguments, environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure;
}

demo_video *video_open(const char *path, int width, int height, int frames_per_second, char *message, size_t size)
{
    int ends[2];
    demo_video *video = calloc(1, sizeof *video);
    if (!video || strlen(path) >= sizeof video->path || pipe(ends) != 0) {
        message_write(message, size, "--video: cannot begin; use a shorter name, or close other programs");
        free(video);
        return NULL;
    }
    strcpy(video->path, path);
    video->frame_bytes = (size_t)width * (size_t)height * 3;
    /* Without this, writing to an ffmpeg that has exited would end this program. */
    signal(SIGPIPE, SIG_IGN);
    int failure = start(video, ends[0], ends[1], width, height, frames_per_second);
    close(ends[0]);
    video->frames = failure ? NULL : fdopen(ends[1], "wb");
    if (video->frames) return video;
    close(ends[1]);
    if (failure == ENOENT)
        message_write(message, size,
                      "--video: ffmpeg is not installed; install it (on Debian: ffmpeg), or write pictures "
                      "with -o frames/%%05d.png");
    else
        message_write(message, size, "--video: ffmpeg cannot be started (%s)", strerror(failure));
    free(video);
    return NULL;
}

bool video_write(demo_video *video, const unsigned char *srgb)
{
    return fwrite(srgb, 1, video->frame_bytes, video->frames) == video->frame_bytes;
}

bool video_close(demo_video *video, char *message, size_t size)
{
    int status = 0;
    fclose(video->frames);
    bool ok = waitpid(video->ffmpeg, &status, 0) == video->ffmpeg && WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!ok) message_write(message, size, "--video: ffmpeg could not write %s; the lines above say why", video->path);
    free(video);
    return ok;
}
