/*
 * The court's orb while the camera flies from 100 m away into it, at a moment that stands still: its light grows evenly, and
 * neither pumps nor pops where its core becomes wider than a pixel, and where its reach and its core close around the eye.
 *
 * Exit status: 0; 1 for light that jumps; 77 if there is no context.
 */
#include "animation.h"
#include "effect_context.h"
#include "field_drawer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 160, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, FRAMES = 300 };

/* When the orb is charged. */
static const double moment = 4.5;
/* The camera comes nearer by 2.3 % a frame, and the orb's picture grows with the square of that: so the mean bends by (2 * 2.3
 * %)^2 = 0.21 % of itself. This is what the third power would bend by. */
static const double largest_bend = 0.0048;

static const render_settings settings = {
    .width = WIDTH, .height = HEIGHT, .integrator = EW_INTEGRATOR_ADAPTIVE, .quality = EW_QUALITY_ERROR_1E_3};

typedef struct light {
    double mean, largest; /* of all pixels; < 0 if one is none */
} light;

static light light_of(const float luminance[PIXELS])
{
    light found = {0, 0};
    for (int i = 0; i < PIXELS; i++) {
        if (!(luminance[i] >= 0)) return (light){-1, -1};
        found.mean += (double)luminance[i] / PIXELS;
        found.largest = fmax(found.largest, (double)luminance[i]);
    }
    return found;
}

/* How much a quantity bends at the middle one of three frames, relative to itself. */
static double bend(double before, double here, double after)
{
    return fabs(after - 2 * here + before) / here;
}

static bool is_even(const light lights[FRAMES])
{
    double most = 0;
    int where = 0;
    for (int i = 1; i + 1 < FRAMES; i++) {
        const light *at = &lights[i];
        double here = fmax(bend(at[-1].mean, at->mean, at[1].mean), bend(at[-1].largest, at->largest, at[1].largest));
        if (here <= most) continue;
        most = here;
        where = i;
    }
    printf("mean from %.3g to %.3g, largest from %.3g to %.3g; what bends most does so at frame %d, by %.2g of itself\n",
           lights[0].mean, lights[FRAMES - 1].mean, lights[0].largest, lights[FRAMES - 1].largest, where, most);
    return lights[FRAMES - 1].mean > 100 * lights[0].mean && most <= largest_bend;
}

static bool fly(field_drawer *drawer)
{
    static demo_animation court, flight;
    static float depth[PIXELS], luminance[PIXELS];
    light lights[FRAMES];
    ew_error error;
    animation_init(&court);
    animation_init(&flight);
    animation_set_time(&court, moment);
    flight.flies = true;
    const ew_sources_desc orb = {.points = &court.points[ANIMATION_ORB], .point_count = 1};
    for (int i = 0; i < PIXELS; i++)
        depth[i] = 1; /* nothing is opaque */
    for (int i = 0; i < FRAMES; i++) {
        animation_set_time(&flight, ANIMATION_SECONDS * i / FRAMES);
        ew_frame_desc frame = render_frame(&flight.scene, &settings, &drawer->target);
        frame.output = EW_OUTPUT_LUMINANCE;
        if (!field_drawer_draw(drawer, &orb, &frame, depth, luminance, &error)) {
            fprintf(stderr, "flight_test: %s\n", error.text);
            return false;
        }
        lights[i] = light_of(luminance);
        if (!(lights[i].mean > 0)) return false;
    }
    return is_even(lights);
}

int main(void)
{
    effect_context drawing;
    field_drawer drawer;
    char message[400];
    int status = effect_context_create("flight_test", &drawing);
    if (status != EXIT_SUCCESS) return status;
    bool ok = field_drawer_create(drawing.context, drawing.effect, WIDTH, HEIGHT, &drawer, message, sizeof message);
    if (ok) {
        ok = fly(&drawer);
        field_drawer_destroy(&drawer);
    } else {
        fprintf(stderr, "flight_test: %s\n", message);
    }
    effect_context_destroy(&drawing);
    return ok ? EXIT_SUCCESS : EXIT_WRONG;
}
