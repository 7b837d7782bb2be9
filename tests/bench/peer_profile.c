/* Painted falloffs: see peer_profile.h. */
#include "peer_profile.h"

#include <math.h>

enum { PLACES_ACROSS = 64, PLACES_ALONG = 8, PLACES_AT_END = 40, SWEEPS = 1000 };

/* The place of a texel's centre, in reaches. */
static double texel_distance(double texel)
{
    double root = (texel + 0.5) / PROFILE_TEXELS;
    return root * root;
}

double profile_across(const source_light *light, double b)
{
    double r = light->core, R = light->reach;
    if (b >= R) return 0;
    double h = sqrt((R - b) * (R + b)), x = b < r ? sqrt((r - b) * (r + b)) : 0;
    double integral = 2 * (x / r + log((h + R) / (x + fmax(r, b))) - h / R);
    double share = fmin(1, fmax(0, integral / (2 * log(R / r))));
    return light->sharpness > 1 ? pow(share, light->sharpness) : share;
}

void profile_of_ribbon(const source_light *light, float texels[PROFILE_TEXELS])
{
    for (int i = 0; i < PROFILE_TEXELS; i++)
        texels[i] = (float)profile_across(light, light->reach * texel_distance(i));
}

/* Adds to `row` what a billboard `distance` away shows of each step of its falloff, as GL filters, linearly. A step is how much
 * lower a texel is than the one before it, seen from outside: so a falloff of steps that are not negative does not rise on its
 * way out, as no painter would have it. */
static void add_billboard(double distance, double reach, double row[PROFILE_TEXELS])
{
    if (distance >= reach) return;
    double place = fmax(0, sqrt(distance / reach) * PROFILE_TEXELS - 0.5);
    int texel = (int)place;
    double share = place - texel;
    for (int i = texel; i < PROFILE_TEXELS; i++)
        row[i] += i == texel ? 1 - share : 1;
}

/* What the billboards along a beam, which ends at x = 0 and goes on to the left without end, show at a place b across it. */
static void add_beam(const source_light *light, double spacing, double x, double b, double row[PROFILE_TEXELS])
{
    long nearest = lround(-x / spacing), others = (long)ceil(light->reach / spacing) + 1;
    for (long k = nearest - others; k <= nearest + others; k++)
        if (k >= 0) add_billboard(hypot(x + ((double)k + 0.5) * spacing, b), light->reach, row);
}

/* Equations for the steps of a falloff. */
typedef struct least_squares {
    double matrix[PROFILE_TEXELS][PROFILE_TEXELS];
    double right[PROFILE_TEXELS];
} least_squares;

/* That `row` shows `wanted`, as part of a luminance. */
static void add_equation(least_squares *system, const double row[PROFILE_TEXELS], double wanted, double luminance)
{
    double unit = fmax(luminance, 0.03), weight = 1 / (unit * unit);
    for (int i = 0; i < PROFILE_TEXELS; i++) {
        if (row[i] == 0) continue;
        system->right[i] += weight * row[i] * wanted;
        for (int k = 0; k < PROFILE_TEXELS; k++)
            system->matrix[i][k] += weight * row[i] * row[k];
    }
}

/* Gauss and Seidel's iteration, kept from going negative: it converges, since the matrix is positive semidefinite. */
static void solve(const least_squares *system, double steps[PROFILE_TEXELS])
{
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int i = 0; i < PROFILE_TEXELS; i++) {
            if (system->matrix[i][i] == 0) continue;
            double rest = system->right[i];
            for (int k = 0; k < PROFILE_TEXELS; k++)
                rest -= system->matrix[i][k] * steps[k];
            steps[i] = fmax(0, steps[i] + rest / system->matrix[i][i]);
        }
}

static void add_up(const double steps[PROFILE_TEXELS], float texels[PROFILE_TEXELS])
{
    double sum = 0;
    for (int i = PROFILE_TEXELS - 1; i >= 0; i--)
        texels[i] = (float)(sum += steps[i]);
}

/* The places across a beam: dense near the core. */
static double place_across(const source_light *light, int i)
{
    double root = (i + 0.5) / PLACES_ACROSS;
    return light->reach * root * root;
}

static void fit_along(const source_light *light, double spacing, double steps[PROFILE_TEXELS])
{
    least_squares system = {0};
    for (int across = 0; across < PLACES_ACROSS; across++)
        for (int i = 0; i < PLACES_ALONG; i++) {
            double b = place_across(light, across), row[PROFILE_TEXELS] = {0}, wanted = profile_across(light, b);
            add_beam(light, spacing, -2 * light->reach - spacing * i / PLACES_ALONG, b, row);
            add_equation(&system, row, wanted, wanted);
        }
    solve(&system, steps);
}

/* What the billboards along the beam leave to the one at its end. */
static void fit_end(const source_light *light, double spacing, const double along[PROFILE_TEXELS], double steps[PROFILE_TEXELS])
{
    least_squares system = {0};
    for (int across = 0; across < PLACES_ACROSS; across++)
        for (int i = 0; i < PLACES_AT_END; i++) {
            double b = place_across(light, across), x = light->reach * ((2 * i + 1) / (double)PLACES_AT_END - 1);
            double row[PROFILE_TEXELS] = {0}, beam[PROFILE_TEXELS] = {0};
            double luminance = profile_across(light, hypot(fmax(0, x), b)), wanted = luminance;
            add_beam(light, spacing, x, b, beam);
            for (int k = 0; k < PROFILE_TEXELS; k++)
                wanted -= beam[k] * along[k];
            add_billboard(hypot(x, b), light->reach, row);
            add_equation(&system, row, wanted, luminance);
        }
    solve(&system, steps);
}

void profiles_of_billboards(const source_light *light, double spacing, float along[PROFILE_TEXELS], float end[PROFILE_TEXELS])
{
    double steps_along[PROFILE_TEXELS] = {0}, steps_end[PROFILE_TEXELS] = {0};
    fit_along(light, spacing, steps_along);
    fit_end(light, spacing, steps_along, steps_end);
    add_up(steps_along, along);
    add_up(steps_end, end);
}
