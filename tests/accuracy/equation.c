/* Equations between luminances: see equation.h. */
#include "equation.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BOUND 1e-3
#define DARK 1e-3

ew_frame_desc equation_frame(const equation_stage *s)
{
    render_settings settings = {.width = EQUATION_SIDE,
                                .height = EQUATION_SIDE,
                                .integrator = EW_INTEGRATOR_ADAPTIVE,
                                .quality = EW_QUALITY_ERROR_1E_3};
    ew_frame_desc frame = render_frame(s->scene, &settings, &s->drawer.target);
    frame.output = EW_OUTPUT_LUMINANCE;
    return frame;
}

bool equation_add_picture(equation_stage *s, const ew_sources_desc *sources, const ew_frame_desc *frame, const float *depth,
                          double sign, luminance_sum *sum)
{
    static float luminance[EQUATION_PIXEL_COUNT];
    double largest = 0;
    ew_error error;
    if (!field_drawer_draw(&s->drawer, sources, frame, depth, luminance, &error)) {
        fprintf(stderr, "metamorphic_test: %s: %s\n", s->path, error.text);
        return false;
    }
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++)
        largest = fmax(largest, (double)luminance[i]);
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        sum->sum[i] += sign * (double)luminance[i];
        sum->allowance[i] += BOUND * fmax((double)luminance[i], DARK * largest);
    }
    return true;
}

void equation_compare(equation_stage *s, const char *relation, const luminance_sum *left, const luminance_sum *right,
                      const bool *applies)
{
    double worst = 0;
    int where = 0, count = 0;
    for (int i = 0; i < EQUATION_PIXEL_COUNT; i++) {
        if (applies && !applies[i]) continue;
        double excess = fabs(left->sum[i] - right->sum[i]) / (left->allowance[i] + right->allowance[i] + 1e-30);
        count++;
        if (excess <= worst) continue;
        worst = isnan(excess) ? HUGE_VAL : excess;
        where = i;
    }
    const char *slash = strrchr(s->path, '/');
    bool ok = worst <= 1 && count > EQUATION_PIXEL_COUNT / 2;
    printf("%-36s %-32s %8.1e of what is allowed at (%2d, %2d): %.6g, %.6g; %d pixels%s\n", slash ? slash + 1 : s->path,
           relation, worst, where % EQUATION_SIDE, where / EQUATION_SIDE, left->sum[where], right->sum[where], count,
           ok ? "" : "  WRONG");
    s->wrong = s->wrong || !ok;
}
