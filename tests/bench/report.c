/* Writes the measurements as a page. */
#include "report.h"
#include "comparison.h"
#include "message.h"
#include "output_file.h"
#include "plot.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* The two integrators that the sentences and the summary compare. */
static const char ours[] = "adaptive:1e-3", published[] = "simpson:200";

/* Formats a number to two or three digits. The text is valid until the eighth call after this one. */
static const char *number(double value)
{
    static char texts[8][32];
    static int next;
    char *text = texts[next++ % 8];
    double magnitude = fabs(value);
    if (value == 0 || !isfinite(value))
        snprintf(text, sizeof texts[0], "%g", value);
    else if (magnitude >= 1e5 || magnitude < 1e-2)
        snprintf(text, sizeof texts[0], "%.1fe%d", value / pow(10, floor(log10(magnitude))), (int)floor(log10(magnitude)));
    else
        snprintf(text, sizeof texts[0], "%.*f", magnitude >= 100 ? 0 : magnitude >= 10 ? 1 : magnitude >= 1 ? 2 : 3, value);
    return text;
}

static void write_introduction(FILE *file, const bench_results *results)
{
    const measure_settings *settings = &results->settings;
    const bench_machine *machine = &results->machine;
    fputs("# Speed against error\n\n"
          "`ew-bench` wrote this page, every number and every sentence. In the plots, left is faster and down is more "
          "accurate.\n\n",
          file);
    fprintf(file, "- Machine: %s, %ld core%s; %s, OpenGL %s.\n", machine->processor, machine->cores,
            machine->cores == 1 ? "" : "s", machine->renderer, machine->version);
    fprintf(file, "- Time: one frame of %d x %d pixels, luminance only, measured %s.", settings->width, settings->height,
            machine->has_gl_timer ? "by GL's own timer" : "by the wall clock from `glFinish` to `glFinish`");
    fprintf(
        file,
        " The integrators take turns. The median is over %d frames, or over fewer (at least %d) if these would take more than "
        "%g s.\n",
        settings->repetitions, MEASURE_MIN_REPETITIONS, MEASURE_BUDGET / 1000);
    fprintf(
        file,
        "- Error: relative to the luminance of a double-precision reference, or to %g of the picture's largest luminance, "
        "whichever is greater. The largest error is over about %zu pixels: some spread evenly over the picture, the others "
        "where it is brightest, where it is darkest, at silhouettes of opaque shapes, and at and around the places where two "
        "settings of this library differ most. The 99th percentile is over the evenly spread pixels.\n\n",
        TRUTH_DARK, settings->error_samples);
    fputs(
        "What is compared:\n\n"
        "- `adaptive:E`: this library, with the quality E, as a host gets it.\n"
        "- `full:E`: the same with the light integrated at every pixel (`EW_RESOLUTION_FULL`).\n"
        "- `simpson:N`: the published method, Simpson's rule with N divisions, with the nearest point of each sample in closed "
        "form.\n"
        "- `marching:N`: N equal steps, jittered by interleaved gradient noise, as in game engines.\n"
        "- `equiangular:N`: N samples at equal angles about the point of each source that is nearest to the ray, as in path "
        "tracers. This is made for light that falls off with the square of the distance.\n"
        "- `bare`: a pass over the same target that only writes a constant.\n\n"
        "Marching and equiangular sampling find the nearest point of a curve as the published method does. Samples are neither "
        "averaged over frames nor filtered.\n\n",
        file);
}

static void write_summary(FILE *file, const bench_results *results)
{
    fprintf(file,
            "| scene | `%s`, ms | largest error | `%s`, ms | largest error | times the speed | times a bare pass |\n"
            "|---|--:|--:|--:|--:|--:|--:|\n",
            ours, published);
    for (size_t i = 0; i < results->scene_count; i++) {
        const bench_scene *scene = &results->scenes[i];
        const measurement *a = results_find(results, scene, ours), *b = results_find(results, scene, published);
        const measurement *bare = results_find(results, scene, "bare");
        fprintf(file, "| [%s](#%s) | %s | %s | %s | %s | %s |", scene->name, scene->name, number(a->ms_median),
                number(a->max_error), number(b->ms_median), number(b->max_error), number(b->ms_median / a->ms_median));
        fprintf(file, " %s |\n", bare ? number(a->ms_median / bare->ms_median) : "");
    }
    fputs("\n", file);
}

/* Sums up the table. */
static void write_conclusion(FILE *file, const bench_results *results)
{
    double slowest = HUGE_VAL, fastest = 0, worst = 0, peer_best = HUGE_VAL, peer_worst = 0;
    for (size_t i = 0; i < results->scene_count; i++) {
        const bench_scene *scene = &results->scenes[i];
        const measurement *a = results_find(results, scene, ours), *b = results_find(results, scene, published);
        slowest = fmin(slowest, b->ms_median / a->ms_median);
        fastest = fmax(fastest, b->ms_median / a->ms_median);
        worst = fmax(worst, a->max_error);
        peer_best = fmin(peer_best, b->max_error);
        peer_worst = fmax(peer_worst, b->max_error);
    }
    fprintf(file, "On these scenes `%s` is %s to %s times as fast as `%s`. ", ours, number(slowest), number(fastest),
            published);
    fprintf(file, "Its largest error is %s; that of `%s` is from %s to %s.\n\n", number(worst), published, number(peer_best),
            number(peer_worst));
}

/* Whether some setting of the adaptive integrator is at least as fast and as accurate. */
static bool is_beaten(const bench_results *results, const bench_scene *scene, const measurement *peer)
{
    for (size_t i = 0; i < results->settings.integrator_count; i++) {
        const measurement *own = &scene->measurements.integrators[i];
        if (integrator_is_ours(&results->settings.integrators[i]) && own->ms_median <= peer->ms_median &&
            own->max_error <= peer->max_error)
            return true;
    }
    return false;
}

static bool is_peer(const bench_integrator *integrator)
{
    return !integrator_is_ours(integrator) && integrator->family != FAMILY_BARE;
}

static void write_sentences(FILE *file, const bench_results *results, const bench_scene *scene)
{
    const measure_settings *settings = &results->settings;
    const measurement *a = results_find(results, scene, ours), *b = results_find(results, scene, published);
    if (a && b)
        fprintf(file,
                "`%s` takes %s ms, with a largest error of %s; `%s` takes %s ms, with %s: %s times the speed at %s times the "
                "accuracy.\n",
                ours, number(a->ms_median), number(a->max_error), published, number(b->ms_median), number(b->max_error),
                number(b->ms_median / a->ms_median), number(b->max_error / a->max_error));
    size_t peers = 0, unbeaten = 0;
    for (size_t i = 0; i < settings->integrator_count; i++) {
        const measurement *peer = &scene->measurements.integrators[i];
        if (!is_peer(&settings->integrators[i])) continue;
        peers++;
        if (is_beaten(results, scene, peer)) continue;
        fprintf(file, "%s `%s` (%s ms, %s)",
                unbeaten++ == 0 ? "No setting of this library is both faster and more accurate than" : ",",
                settings->integrators[i].name, number(peer->ms_median), number(peer->max_error));
    }
    if (unbeaten > 0 && unbeaten < peers)
        fprintf(file, ". Each of the other %zu of its %zu peers is slower and less accurate than some setting.\n\n",
                peers - unbeaten, peers);
    else if (unbeaten > 0)
        fprintf(file, ". These are all of its peers.\n\n");
    else if (peers == 1)
        fprintf(file, "Its only peer is slower and less accurate than some setting of this library.\n\n");
    else if (peers > 0)
        fprintf(file, "Each of the %zu peers is slower and less accurate than some setting of this library.\n\n", peers);
}

static void write_table(FILE *file, const bench_results *results, const bench_scene *scene)
{
    const measure_settings *settings = &results->settings;
    fputs("| integrator | ms, median | ms, minimum | frames | evaluations per pixel | largest error | 99th percentile |\n"
          "|---|--:|--:|--:|--:|--:|--:|\n",
          file);
    for (size_t i = 0; i < settings->integrator_count; i++) {
        const measurement *row = &scene->measurements.integrators[i];
        fprintf(file, "| `%s` | %s | %s | %d |", settings->integrators[i].name, number(row->ms_median), number(row->ms_min),
                row->repetitions);
        if (settings->integrators[i].family == FAMILY_BARE)
            fputs(" | | |\n", file);
        else
            fprintf(file, " %s | %s | %s |\n", number(row->evaluations_per_pixel), number(row->max_error),
                    number(row->p99_error));
    }
    if (scene->measurements.unreliable_pixels > 0)
        fprintf(file, "\nThe reference was not sure of %zu of %zu pixels, which were left out.\n",
                scene->measurements.unreliable_pixels, scene->measurements.unreliable_pixels + scene->measurements.pixels);
    fputs("\n", file);
}

static void write_page(FILE *file, const bench_results *results, const char *base)
{
    write_introduction(file, results);
    if (results_find(results, &results->scenes[0], ours) && results_find(results, &results->scenes[0], published)) {
        write_summary(file, results);
        write_conclusion(file, results);
    }
    for (size_t i = 0; i < results->scene_count; i++) {
        const bench_scene *scene = &results->scenes[i];
        fprintf(file, "## %s\n\n", scene->name);
        write_sentences(file, results, scene);
        fprintf(file, "![Largest error against time, on logarithmic axes](%s/%s.svg)\n\n", base, scene->name);
        write_table(file, results, scene);
    }
}

static bool make_folder(const char *path, char *message, size_t size)
{
    if (mkdir(path, 0777) == 0 || errno == EEXIST) return true;
    message_write(message, size, "%s: cannot be made a folder (%s)", path, strerror(errno));
    return false;
}

bool report_write(const bench_results *results, const char *folder, const char *name, char *message, size_t size)
{
    char base[128], page[4096], plots[4096];
    snprintf(base, sizeof base, "speed-and-error%s%s", name ? "-" : "", name ? name : "");
    snprintf(page, sizeof page, "%s/%s.md", folder, base);
    snprintf(plots, sizeof plots, "%s/%s", folder, base);
    if (!make_folder(folder, message, size) || !make_folder(plots, message, size)) return false;
    FILE *file = fopen(page, "w");
    if (file) write_page(file, results, base);
    if (!output_file_close(file, page, message, size)) return false;
    bool drawn = true;
    for (size_t i = 0; i < results->scene_count; i++)
        drawn = plot_draw(results, &results->scenes[i], plots, message, size) && drawn;
    return drawn;
}
