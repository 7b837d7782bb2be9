/* ew-demo's command line: see options.h. */
#include "options.h"
#include "command_line.h"
#include "image.h"
#include "message.h"

#include <getopt.h>
#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: ew-demo [SCENE.json] [option]...\n"
    "       ew-demo [SCENE.json] --offscreen [--frames A-B] [-o NAME] [--video FILE] [option]...\n"
    "Shows energy waves in a window: a court with beams, an orb, a ring and a blade, or a scene file, which is read\n"
    "again whenever it is saved. The window shows its keys.\n"
    "\n"
    "      --size WxH          of the window or the pictures, in pixels (default 1280x720)\n"
    "      --integrator NAME   adaptive, or with its largest relative error as in adaptive:1e-2,\n"
    "                          adaptive:1e-3 (default), adaptive:1e-4; or simpson:N, N divisions\n"
    "      --split NAME        integrate the right half of the picture so\n"
    "      --show WHAT         picture (default), evaluations: how often each pixel's ray was evaluated; or error: against\n"
    "                          Simpson's rule with 16384 divisions, which takes long\n"
    "      --samples N         N x N samples a pixel smooth the edges of shapes, 1 (default) to 4\n"
    "      --offscreen         write pictures or a video instead, without a window or a display\n"
    "      --frames A-B        which frames, counted from 0; or one, A (default 0-299, a whole repetition)\n"
    "      --fps N             frames in a second of the animation, 1 to 240 (default 30)\n"
    "  -o, --output NAME       pictures (.png), the frame's number in place of %d: -o frames/%05d.png\n"
    "      --video FILE        a video of the frames, by ffmpeg: .mp4, .webm, ...\n"
    "      --backend NAME      of --offscreen: egl, osmesa or auto (default): EGL or else OSMesa\n"
    "  -h, --help              print this help\n"
    "      --version           print the version\n"
    "\n"
    "A frame depends on nothing but its number, so that many machines can share the work: with Slurm, say,\n"
    "    mkdir -p frames\n"
    "    sbatch --array=0-9 --wrap='ew-demo --offscreen -o frames/%05d.png \\\n"
    "        --frames $((SLURM_ARRAY_TASK_ID * 30))-$((SLURM_ARRAY_TASK_ID * 30 + 29))'\n"
    "Exit status: 0, or 2 with one line of what to mend on standard error.\n";

enum {
    OPTION_SIZE = 256,
    OPTION_INTEGRATOR,
    OPTION_SPLIT,
    OPTION_SHOW,
    OPTION_SAMPLES,
    OPTION_OFFSCREEN,
    OPTION_FRAMES,
    OPTION_FPS,
    OPTION_VIDEO,
    OPTION_BACKEND,
    OPTION_HELP,
    OPTION_VERSION
};

static const struct option long_options[] = {{"size", required_argument, NULL, OPTION_SIZE},
                                             {"integrator", required_argument, NULL, OPTION_INTEGRATOR},
                                             {"split", required_argument, NULL, OPTION_SPLIT},
                                             {"show", required_argument, NULL, OPTION_SHOW},
                                             {"samples", required_argument, NULL, OPTION_SAMPLES},
                                             {"offscreen", no_argument, NULL, OPTION_OFFSCREEN},
                                             {"frames", required_argument, NULL, OPTION_FRAMES},
                                             {"fps", required_argument, NULL, OPTION_FPS},
                                             {"output", required_argument, NULL, 'o'},
                                             {"video", required_argument, NULL, OPTION_VIDEO},
                                             {"backend", required_argument, NULL, OPTION_BACKEND},
                                             {"help", no_argument, NULL, OPTION_HELP},
                                             {"version", no_argument, NULL, OPTION_VERSION},
                                             {NULL, 0, NULL, 0}};

static bool read_mode(const char *text, stage_mode *mode)
{
    static const char *const names[] = {"picture", "evaluations", "error"};
    for (int i = 0; i < 3; i++)
        if (strcmp(text, names[i]) == 0) {
            *mode = (stage_mode)i;
            return true;
        }
    return false;
}

static bool read_frames(const char *text, demo_options *options)
{
    const char *end;
    if (!read_count(text, &end, &options->first_frame)) return false;
    options->last_frame = options->first_frame;
    if (*end == '\0') return true;
    return *end == '-' && read_count(end + 1, &end, &options->last_frame) && *end == '\0' &&
           options->last_frame >= options->first_frame;
}

/* Whether `name` has exactly one conversion, of an integer, such as %d or %05d. */
static bool has_one_number(const char *name)
{
    const char *percent = strchr(name, '%');
    if (!percent) return false;
    const char *conversion = percent + 1 + strspn(percent + 1, "0123456789");
    return *conversion == 'd' && conversion - percent <= 3 && !strchr(conversion, '%');
}

/* The checks that need more than one option. */
static bool check(const demo_options *options, char *message, size_t size)
{
    const char *output = options->output;
    bool several = options->last_frame > options->first_frame;
    if (!options->offscreen && (output || options->video))
        message_write(message, size, "%s: is written without a window; add --offscreen", output ? output : options->video);
    else if (options->offscreen && !output && !options->video)
        message_write(message, size, "--offscreen: no output is asked for; add -o frames/%%05d.png or --video demo.mp4");
    else if (output && image_format_of(output) != IMAGE_PNG)
        message_write(message, size, "%s: is no picture's name; let it end in .png", output);
    else if (output && (several || strchr(output, '%')) && !has_one_number(output))
        message_write(message, size, "%s: needs one place for the frame's number, as in frames/%%05d.png", output);
    else
        return true;
    return false;
}

bool options_read(int argc, char **argv, demo_options *options, char *message, size_t size)
{
    int option;
    message[0] = '\0';
    opterr = 0;
    while ((option = getopt_long(argc, argv, ":o:h", long_options, NULL)) != -1) {
        bool ok = true;
        const char *remedy = "";
        switch (option) {
        case OPTION_SIZE:
            ok = read_size(optarg, &options->settings.width, &options->settings.height);
            remedy = "--size: " SIZE_REMEDY;
            break;
        case OPTION_INTEGRATOR:
            ok = read_integrator(optarg, &options->settings);
            remedy = "--integrator: " INTEGRATOR_REMEDY;
            break;
        case OPTION_SPLIT:
            options->split = true;
            ok = read_integrator(optarg, &options->right);
            remedy = "--split: " INTEGRATOR_REMEDY;
            break;
        case OPTION_SHOW:
            ok = read_mode(optarg, &options->mode);
            remedy = "--show: must be picture, evaluations or error";
            break;
        case OPTION_SAMPLES:
            ok = read_number(optarg, 1, 4, &options->samples_per_axis);
            remedy = "--samples: must be a number from 1 to 4";
            break;
        case OPTION_OFFSCREEN:
            options->offscreen = true;
            break;
        case OPTION_FRAMES:
            ok = read_frames(optarg, options);
            remedy = "--frames: must be two numbers of frames, as in 0-299, or one";
            break;
        case OPTION_FPS:
            ok = read_number(optarg, 1, 240, &options->frames_per_second);
            remedy = "--fps: must be a number from 1 to 240";
            break;
        case 'o':
            options->output = optarg;
            break;
        case OPTION_VIDEO:
            options->video = optarg;
            break;
        case OPTION_BACKEND:
            ok = read_backend(optarg, &options->backend);
            remedy = "--backend: " BACKEND_REMEDY;
            break;
        case OPTION_HELP:
        case 'h':
            fputs(help, stdout);
            return false;
        case OPTION_VERSION:
            printf("ew-demo %d.%d.%d\n", EW_VERSION_MAJOR, EW_VERSION_MINOR, EW_VERSION_PATCH);
            return false;
        default:
            return refuse_option(option, argv, "ew-demo", message, size);
        }
        if (!ok) {
            message_write(message, size, "%s, not \"%s\"", remedy, optarg);
            return false;
        }
    }
    return read_scene_name(argc, argv, "show", &options->scene, message, size) && check(options, message, size);
}
