/* ew-demo's command line: see options.h. */
#include "options.h"
#include "command_line.h"
#include "image.h"
#include "message.h"

#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: ew-demo [SCENE.json] [option]...\n"
    "       ew-demo [SCENE.json] --offscreen [--frames A-B] [-o NAME] [--video FILE] [option]...\n"
    "Shows energy waves in a window: a court with an orb, lightning, a beam, a ring, a spiral and a blade, or a scene file,\n"
    "which is read again whenever it is saved; docs/scene-format.md describes it. The window shows its keys.\n"
    "A source, a shape or a medium of a scene file is selected by a click on it, or by N. The mouse drags its points, its\n"
    "direction and its size, and sliders set a source's core, reach and brightness or a medium's extinction and albedo; so do\n"
    "the arrow keys. Ctrl+Z undoes, Ctrl+Y redoes, and Ctrl+S saves the file, in which all else stays as it was.\n"
    "\n"
    "      --size WxH          of the window or the pictures, in pixels (default 1280x720)\n"
    "      --integrator NAME   adaptive, or with its largest relative error as in adaptive:1e-2,\n"
    "                          adaptive:1e-3 (default), adaptive:1e-4; or simpson:N, N divisions\n"
    "      --resolution NAME   adaptive (default): fewer pixels are integrated where the light is smooth; or full: all are\n"
    "      --split NAME        integrator of the right half of the picture\n"
    "      --show WHAT         picture (default); evaluations, how often each pixel's ray was evaluated; or error, compared\n"
    "                          with Simpson's rule of 16384 divisions (4096 without an interval), which takes long\n"
    "      --samples N         N x N samples a pixel smooth the edges of shapes, 1 (the fastest) to 4 (default 2)\n"
    "      --flight            the court's camera flies from 100 m away into the orb in each repetition\n"
    "      --offscreen         write pictures or a video instead, without a window or a display\n"
    "      --frames A-B        frames A to B, or only A; the first is 0 (default 0-299, a whole repetition)\n"
    "      --fps N             frames per second of the animation, 1 to 240 (default 30)\n"
    "  -o, --output NAME       pictures (.png), the frame's number in place of %d: -o frames/%05d.png\n"
    "      --video FILE        a video of the frames, by ffmpeg: .mp4, .webm, ...\n"
    "      --backend NAME      of --offscreen: " BACKEND_HELP "\n"
    "  -h, --help              print this help\n"
    "      --version           print the version\n"
    "\n"
    "A frame depends only on its number, so many machines can share the work; with Slurm, for example:\n"
    "    mkdir -p frames\n"
    "    sbatch --array=0-9 --wrap='ew-demo --offscreen -o frames/%05d.png \\\n"
    "        --frames $((SLURM_ARRAY_TASK_ID * 30))-$((SLURM_ARRAY_TASK_ID * 30 + 29))'\n"
    "Exit status: 0, or 2 with one line of what to mend on standard error.\n";

static bool read_window_size(const char *text, void *target)
{
    render_settings *settings = target;
    return read_size(text, &settings->width, &settings->height);
}

static bool read_split(const char *text, void *target)
{
    demo_options *options = target;
    options->split = true;
    return read_integrator(text, &options->right);
}

static bool read_mode(const char *text, void *target)
{
    static const char *const names[] = {"picture", "evaluations", "error"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, names[i]) == 0) {
            *(display_mode *)target = (display_mode)i;
            return true;
        }
    return false;
}

static bool read_samples(const char *text, void *target)
{
    return read_number(text, 1, 4, target);
}

static bool read_frame_rate(const char *text, void *target)
{
    return read_number(text, 1, 240, target);
}

static bool read_frames(const char *text, void *target)
{
    demo_options *options = target;
    const char *end;
    options->has_frames = true;
    if (!read_count(text, &end, &options->first_frame)) return false;
    options->last_frame = options->first_frame;
    if (*end == '\0') return true;
    return *end == '-' && read_count(end + 1, &end, &options->last_frame) && *end == '\0' &&
           options->last_frame >= options->first_frame;
}

/* Whether `name` has exactly one conversion, and that of an integer, such as %d or %05d. */
static bool has_one_number(const char *name)
{
    const char *percent = strchr(name, '%');
    if (!percent) return false;
    const char *conversion = percent + 1 + strspn(percent + 1, "0123456789");
    return *conversion == 'd' && conversion - percent <= 3 && !strchr(conversion, '%');
}

/* Checks what concerns more than one option. */
static bool check(const demo_options *options, char *message, size_t size)
{
    const char *output = options->output;
    bool several = options->last_frame > options->first_frame;
    if (!options->offscreen && (output || options->video))
        message_write(message, size, "%s: is only written without a window; add --offscreen", output ? output : options->video);
    else if (!options->offscreen && options->has_frames)
        message_write(message, size, "--frames: is only for pictures; add --offscreen");
    else if (!options->offscreen && options->backend != CONTEXT_AUTO)
        message_write(message, size, "--backend: is only for pictures; add --offscreen");
    else if (options->offscreen && !output && !options->video)
        message_write(message, size, "--offscreen: no output is requested; add -o frames/%%05d.png or --video demo.mp4");
    else if (output && image_format_of(output) != IMAGE_PNG)
        message_write(message, size, "%s: is not a picture's name; let it end in .png", output);
    else if (output && (several || strchr(output, '%')) && !has_one_number(output))
        message_write(message, size, "%s: needs one place for the frame's number, as in frames/%%05d.png", output);
    else
        return true;
    return false;
}

bool options_read(int argc, char **argv, demo_options *options, char *message, size_t size)
{
    const command_option table[] = {
        {"size", 0, read_window_size, &options->settings, SIZE_REMEDY},
        {"integrator", 0, read_integrator, &options->settings, INTEGRATOR_REMEDY},
        {"resolution", 0, read_resolution, &options->settings.resolution, RESOLUTION_REMEDY},
        {"split", 0, read_split, options, INTEGRATOR_REMEDY},
        {"show", 0, read_mode, &options->mode, "must be picture, evaluations or error"},
        {"samples", 0, read_samples, &options->samples_per_axis, "must be a number from 1 to 4"},
        {"flight", 0, NULL, &options->flight, NULL},
        {"offscreen", 0, NULL, &options->offscreen, NULL},
        {"frames", 0, read_frames, options, "must be two frame numbers, the first no larger, as in 0-299, or one"},
        {"fps", 0, read_frame_rate, &options->frames_per_second, "must be a number from 1 to 240"},
        {"output", 'o', read_text, &options->output, NULL},
        {"video", 0, read_text, &options->video, NULL},
        {"backend", 0, read_backend, &options->backend, BACKEND_REMEDY},
    };
    const command_program program = {"ew-demo", help, table, sizeof table / sizeof *table};
    bool ok = command_line_read(&argc, argv, &program, message, size) &&
              command_line_read_scene(argc, argv, "show", &options->scene, message, size) && check(options, message, size);
    options->right.resolution = options->settings.resolution; /* both halves differ in the integrator alone */
    return ok;
}
