/* Writes the measurements as a page. */
#include "report.h"
#include "comparison.h"
#include "message.h"
#include "output_file.h"
#include "page.h"
#include "plot.h"

#include <math.h>
#include <stdio.h>

/* The two integrators that the sentences and the summary compare. */
static const char ours[] = "adaptive:1e-3", published[] = "simpson:200";

static void write_measures(FILE *file, const bench_results *results)
{
    const measure_settings *settings = &results->settings;
    const bench_machine *machine = &results->machine;
    fputs("## What is measured\n\n", file);
    fprintf(file,
            "- Time: one frame, added to the target by this library and the published method, measured %s. All take turns. The "
            "median is over %d frames, or over fewer "
            "(at least %d) if these would take more than %g s.\n",
            machine->has_gl_timer ? "by GL's own timer" : "by the wall clock from `glFinish` to `glFinish`",
            settings->repetitions, MEASURE_MIN_REPETITIONS, MEASURE_BUDGET / 1000);
    fprintf(
        file,
        "- Limit: fragment shaders that do nothing but dependent multiply-adds do %s of them in a millisecond here. \"Limit\" "
        "in the tables is how many each pixel could have had in the frame's time.\n",
        page_number(machine->multiply_adds));
    fprintf(
        file,
        "- Error: relative to the luminance of a double-precision reference, or to a share of the picture's largest, "
        "whichever is greater. The largest error is over about %zu pixels: some spread evenly over the picture, the others "
        "where it is brightest, where it is darkest, at silhouettes of opaque shapes, and where two settings of this library "
        "differ most. 99 %% of the evenly spread pixels are below the next column. \"Light\" is all light of the picture over "
        "what it ought to be.\n\n",
        settings->error_samples);
}

static void write_glossary(FILE *file)
{
    fputs(
        "## What is compared\n\n"
        "- `adaptive:E`: this library, with the quality E, as a host gets it.\n"
        "- `full:E`: the same with the light integrated at every pixel (`EW_RESOLUTION_FULL`).\n"
        "- `simpson:N`: the published method, Simpson's rule with N divisions, with the nearest point of each sample in closed "
        "form.\n"
        "- `marching:N`: N equal steps over the part of the ray that a source reaches, jittered by interleaved gradient noise. "
        "Samples are neither averaged over frames nor filtered.\n"
        "- `half-marching:N`: the same at a quarter of the pixels, as games draw fog, with depth-aware upsampling. Leaves out "
        "what is thinner than two pixels: cores and silhouettes blur.\n"
        "- `billboards:N`: N soft sprites a source, and one more at each end, which add up. Their falloffs are fitted to the "
        "glow of "
        "a beam by least squares, and they fade at the opaque depth. Leave out where the light ends along each ray, bends "
        "within "
        "the reach, and the eye within the glow.\n"
        "- `ribbon:N`: a strip of N sections along each source that turns to the eye, painted with the exact glow of a beam "
        "that is "
        "seen from the side, brighter by 1 / sin (up to 4) where it is seen at an angle, with half discs at its ends. It is "
        "narrower "
        "within bends, or it would fold. Leaves out the same.\n"
        "- `equiangular:N`: N samples at equal angles about the point of each source that is nearest to the ray, as in path "
        "tracers. This is made for light that falls off with the square of the distance.\n"
        "- `bare`: a pass over the same target that only writes a constant.\n\n"
        "What the peers need of the sources is prepared once, outside of the time; this library packs them in every frame. "
        "Marching "
        "gets this library's lists of which sources light which tile of the picture. Sprites and ribbons need sources that "
        "have a "
        "reach, so the scenes of the papers' integral have none.\n\n",
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
        fprintf(file, "| [%s](#%s) | %s | %s | %s | %s | %s |", scene->name, scene->name, page_number(a->ms_median),
                page_number(a->max_error), page_number(b->ms_median), page_number(b->max_error),
                page_number(b->ms_median / a->ms_median));
        fprintf(file, " %s |\n", bare ? page_number(a->ms_median / bare->ms_median) : "");
    }
    fputs("\n", file);
}

/* All that is compared on all scenes. */
static void write_overview(FILE *file, const bench_results *results)
{
    const measure_settings *settings = &results->settings;
    fputs("Milliseconds a frame and, in brackets, the error that 99 % of the pixels are below:\n\n| drawn by |", file);
    for (size_t i = 0; i < results->scene_count; i++)
        fprintf(file, " [%s](#%s) |", results->scenes[i].name, results->scenes[i].name);
    fputs("\n|---|", file);
    for (size_t i = 0; i < results->scene_count; i++)
        fputs("--:|", file);
    for (size_t k = 0; k < settings->integrator_count; k++) {
        fprintf(file, "\n| `%s` |", settings->integrators[k].name);
        for (size_t i = 0; i < results->scene_count; i++) {
            const measurement *cell = &results->scenes[i].measurements.integrators[k];
            fprintf(file, " %s", page_number(cell->ms_median));
            if (settings->integrators[k].family != FAMILY_BARE) fprintf(file, " (%s)", page_number(cell->p99_error));
            fputs(" |", file);
        }
    }
    fputs("\n\n", file);
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
    fprintf(file, "On these scenes `%s` is %s to %s times as fast as `%s`. ", ours, page_number(slowest), page_number(fastest),
            published);
    fprintf(file, "Its largest error is %s; that of `%s` is from %s to %s.\n\n", page_number(worst), published,
            page_number(peer_best), page_number(peer_worst));
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
                ours, page_number(a->ms_median), page_number(a->max_error), published, page_number(b->ms_median),
                page_number(b->max_error), page_number(b->ms_median / a->ms_median), page_number(b->max_error / a->max_error));
    size_t peers = 0, unbeaten = 0;
    for (size_t i = 0; i < settings->integrator_count; i++) {
        const measurement *peer = &scene->measurements.integrators[i];
        if (!is_peer(&settings->integrators[i])) continue;
        peers++;
        if (is_beaten(results, scene, peer)) continue;
        fprintf(file, "%s `%s` (%s ms, with errors up to %s, and up to %s at 99 %% of the pixels)",
                unbeaten++ == 0 ? "No setting of this library is both faster and more accurate than" : ",",
                settings->integrators[i].name, page_number(peer->ms_median), page_number(peer->max_error),
                page_number(peer->p99_error));
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

static void write_row(FILE *file, const bench_results *results, const bench_integrator *integrator, const measurement *row)
{
    fprintf(file, "| `%s` | %s | %s | %d | %s |", integrator->name, page_number(row->ms_median), page_number(row->ms_min),
            row->repetitions, page_number(results_multiply_adds(results, row->ms_median)));
    if (integrator->family == FAMILY_BARE) {
        fputs(" | | | |\n", file);
        return;
    }
    fprintf(file, " %s |", integrator_counts_evaluations(integrator) ? page_number(row->evaluations_per_pixel) : "");
    fprintf(file, " %s | %s | %.2f |\n", page_number(row->max_error), page_number(row->p99_error), row->brightness);
}

static void write_table(FILE *file, const bench_results *results, const bench_scene *scene)
{
    const measure_settings *settings = &results->settings;
    fputs("| drawn by | ms, median | ms, least | frames | limit | evaluations a pixel | largest error | 99 % below | light |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
          file);
    for (size_t i = 0; i < settings->integrator_count; i++)
        write_row(file, results, &settings->integrators[i], &scene->measurements.integrators[i]);
    if (scene->measurements.unreliable_pixels > 0)
        fprintf(file, "\nThe reference was not sure of %zu of %zu pixels, which were left out.\n",
                scene->measurements.unreliable_pixels, scene->measurements.unreliable_pixels + scene->measurements.pixels);
    fputs("\n", file);
}

static void write_head(FILE *file, const bench_results *results)
{
    const measure_settings *settings = &results->settings;
    fprintf(file,
            "## %s\n\nFrames of %d x %d pixels. Errors are relative to %g of the picture's largest luminance at the least.\n\n",
            results->title, settings->width, settings->height, settings->dark);
    if (results->is_frames) {
        write_overview(file, results);
    } else if (results_find(results, &results->scenes[0], ours) && results_find(results, &results->scenes[0], published)) {
        write_summary(file, results);
        write_conclusion(file, results);
    }
}

static void write_scenes(FILE *file, const bench_results *results, const char *base)
{
    for (size_t i = 0; i < results->scene_count; i++) {
        const bench_scene *scene = &results->scenes[i];
        fprintf(file, "### %s\n\n", scene->name);
        write_table(file, results, scene);
        write_sentences(file, results, scene);
        fprintf(file,
                "![Largest error against time, on logarithmic axes: left is faster, down is more accurate](%s/%s.svg)\n\n",
                base, scene->name);
    }
}

/* What the first set costs comes first, then what the figures are. */
static void write_page(FILE *file, const bench_results *sets, size_t set_count, const char *base)
{
    page_begin(file, "Speed against error", "ew-bench", &sets[0].machine);
    fputs(
        "\nWhat light on surfaces costs beside point lights is on [a page of its own](light-on-surfaces.md), and what fog and "
        "media cost on [another](fog-and-media.md).\n\n",
        file);
    write_head(file, &sets[0]);
    write_measures(file, &sets[0]);
    write_glossary(file);
    for (size_t i = 0; i < set_count; i++) {
        if (i == 0)
            fprintf(file, "## %s: scene by scene\n\n", sets[i].title);
        else
            write_head(file, &sets[i]);
        write_scenes(file, &sets[i], base);
    }
}

bool report_write(const bench_results *sets, size_t set_count, const char *folder, const char *name, char *message, size_t size)
{
    page_paths paths;
    if (!page_make_folders("speed-and-error", folder, name, &paths, message, size)) return false;
    FILE *file = fopen(paths.page, "w");
    if (file) write_page(file, sets, set_count, paths.base);
    if (!output_file_close(file, paths.page, message, size)) return false;
    bool drawn = true;
    for (size_t set = 0; set < set_count; set++)
        for (size_t i = 0; i < sets[set].scene_count; i++)
            drawn = plot_draw(&sets[set], &sets[set].scenes[i], paths.plots, message, size) && drawn;
    return drawn;
}
