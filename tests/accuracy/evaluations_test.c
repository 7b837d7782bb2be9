/*
 * How often the shader evaluates distances, a loss of efficiency that no picture shows:
 *
 *     evaluations_test SHARE SCENE.json...
 *
 * Averaged over a picture, a scene may cost one evaluation for each source that has a closed form, and for each other one SHARE
 * of the 201 that the published method takes (Simpson's rule with 200 divisions). And a better quality never costs less.
 *
 * Exit status: 0; 1 for a scene that costs more; 2 for bad input; 77 if there is no context.
 */
#include "effect_context.h"
#include "field_drawer.h"
#include "scene_file.h"
#include "scene_rays.h"
#include "source_kinds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64, PIXEL_COUNT = SIDE * SIDE, SIMPSON = 201 };

typedef struct quality_counts {
    double mean[3]; /* by ew_quality */
} quality_counts;

static bool count_evaluations(field_drawer *drawer, const demo_scene *scene, const scene_rays *rays, quality_counts *counts,
                              ew_error *error)
{
    static float depth[PIXEL_COUNT], evaluations[PIXEL_COUNT];
    scene_rays_cast_all(rays, depth);
    for (int quality = EW_QUALITY_ERROR_1E_2; quality <= EW_QUALITY_ERROR_1E_4; quality++) {
        render_settings settings = {
            .width = SIDE, .height = SIDE, .integrator = EW_INTEGRATOR_ADAPTIVE, .quality = (ew_quality)quality};
        ew_frame_desc frame = render_frame(scene, &settings, &drawer->target);
        frame.output = EW_OUTPUT_EVALUATIONS;
        if (!field_drawer_draw(drawer, &scene->sources, &frame, depth, evaluations, error)) return false;
        double sum = 0;
        for (int i = 0; i < PIXEL_COUNT; i++)
            sum += (double)evaluations[i];
        counts->mean[quality] = sum / PIXEL_COUNT;
    }
    return true;
}

static bool report(const char *path, const ew_sources_desc *sources, double share, const quality_counts *counts)
{
    const char *slash = strrchr(path, '/');
    const double *mean = counts->mean;
    double most = 0;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++)
        most += (double)source_count(source_kinds[k], sources) * (source_kinds[k]->has_closed_form ? 1 : share * SIMPSON);
    bool ok = mean[EW_QUALITY_ERROR_1E_3] <= most && mean[EW_QUALITY_ERROR_1E_2] <= mean[EW_QUALITY_ERROR_1E_3] &&
              mean[EW_QUALITY_ERROR_1E_3] <= mean[EW_QUALITY_ERROR_1E_4];
    printf("%-44s %7.1f evaluations a pixel, %7.1f allowed (1e-2: %.1f, 1e-4: %.1f)%s\n", slash ? slash + 1 : path,
           mean[EW_QUALITY_ERROR_1E_3], most, mean[EW_QUALITY_ERROR_1E_2], mean[EW_QUALITY_ERROR_1E_4], ok ? "" : "  WRONG");
    return ok;
}

static bool check_scene(field_drawer *drawer, const char *path, double share, bool *wrong)
{
    char message[400];
    demo_scene scene;
    scene_rays rays;
    ew_error error = {EW_ERROR_OUT_OF_MEMORY, "memory is exhausted"};
    quality_counts counts;
    if (!scene_load(path, &scene, message, sizeof message)) {
        fprintf(stderr, "evaluations_test: %s\n", message);
        return false;
    }
    bool ok = scene_rays_create(&scene, SIDE, SIDE, &rays);
    if (ok) {
        ok = count_evaluations(drawer, &scene, &rays, &counts, &error);
        scene_rays_free(&rays);
    }
    if (ok)
        *wrong = !report(path, &scene.sources, share, &counts) || *wrong;
    else
        fprintf(stderr, "evaluations_test: %s: %s\n", path, error.text);
    scene_free(&scene);
    return ok;
}

int main(int argc, char **argv)
{
    char message[400];
    effect_context drawing;
    field_drawer drawer;
    double share = argc > 1 ? strtod(argv[1], NULL) : 0;
    bool wrong = false;
    if (argc < 3 || !(share > 0)) {
        fprintf(stderr, "evaluations_test: give a share and scenes\n");
        return EXIT_BAD_INPUT;
    }
    int status = effect_context_create("evaluations_test", &drawing);
    if (status != EXIT_SUCCESS) return status;
    bool ok = field_drawer_create(drawing.context, drawing.effect, SIDE, SIDE, &drawer, message, sizeof message);
    if (ok) {
        for (int i = 2; ok && i < argc; i++)
            ok = check_scene(&drawer, argv[i], share, &wrong);
        field_drawer_destroy(&drawer);
    } else {
        fprintf(stderr, "evaluations_test: %s\n", message);
    }
    effect_context_destroy(&drawing);
    return !ok ? EXIT_BAD_INPUT : wrong ? EXIT_WRONG : EXIT_SUCCESS;
}
