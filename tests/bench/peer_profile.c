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

/* The unknowns: how much lower than the texel before each texel of both falloffs is, the last one as against 0. So neither
 * rises on its way out, as no painter would have it. */
enum { UNKNOWNS = 2 * PROFILE_TEXELS };

/* Adds to `row`, in which each texel of a falloff has its share, what a billboard `distance` away shows: as GL filters,
 * linearly. */
static void add_billboard(double distance, double reach, double *row)
{
    if (distance >= reach) return;
    double place = fmax(0, sqrt(distance / reach) * PROFILE_TEXELS - 0.5);
    int texel = (int)place;
    double share = place - texel;
    for (int i = texel; i < PROFILE_TEXELS; i++)
        row[i] += i == texel ? 1 - share : 1;
}

typedef struct least_squares {
    double matrix[UNKNOWNS][UNKNOWNS];
    double right[UNKNOWNS];
} least_squares;

static void add_equation(least_squares *system, const double row[UNKNOWNS], double wanted)
{
    double unit = fmax(wanted, 0.03), weight = 1 / (unit * unit);
    for (int i = 0; i < UNKNOWNS; i++) {
        if (row[i] == 0) continue;
        system->right[i] += weight * row[i] * wanted;
        for (int k = 0; k < UNKNOWNS; k++)
            system->matrix[i][k] += weight * row[i] * row[k];
    }
}

/* What is wanted at a place `b` across a beam, which ends at x = 0 and goes on to the left without end. */
static void add_place(const source_light *light, double spacing, double x, double b, least_squares *system)
{
    double row[UNKNOWNS] = {0};
    long nearest = lround(-x / spacing), others = (long)ceil(light->reach / spacing) + 1;
    for (long k = nearest - others; k <= nearest + others; k++)
        if (k >= 0) add_billboard(hypot(x + ((double)k + 0.5) * spacing, b), light->reach, row);
    add_billboard(hypot(x, b), light->reach, row + PROFILE_TEXELS);
    add_equation(system, row, profile_across(light, hypot(fmax(0, x), b)));
}

/* Gauss and Seidel's iteration, kept from going negative: it converges, since the matrix is positive semidefinite. */
static void solve(const least_squares *system, double solution[UNKNOWNS])
{
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int i = 0; i < UNKNOWNS; i++) {
            if (system->matrix[i][i] == 0) continue;
            double rest = system->right[i];
            for (int k = 0; k < UNKNOWNS; k++)
                rest -= system->matrix[i][k] * solution[k];
            solution[i] = fmax(0, solution[i] + rest / system->matrix[i][i]);
        }
}

void profiles_of_billboards(const source_light *light, double spacing, float along[PROFILE_TEXELS], float end[PROFILE_TEXELS])
{
    least_squares system = {0};
    double solution[UNKNOWNS] = {0};
    for (int across = 0; across < PLACES_ACROSS; across++) {
        double root = (across + 0.5) / PLACES_ACROSS, b = light->reach * root * root;
        for (int i = 0; i < PLACES_ALONG; i++)
            add_place(light, spacing, -2 * light->reach - spacing * i / PLACES_ALONG, b, &system);
        for (int i = 0; i < PLACES_AT_END; i++)
            add_place(light, spacing, light->reach * ((2 * i + 1) / (double)PLACES_AT_END - 1), b, &system);
    }
    solve(&system, solution);
    double sum = 0, end_sum = 0;
    for (int i = PROFILE_TEXELS - 1; i >= 0; i--) {
        along[i] = (float)(sum += solution[i]);
        end[i] = (float)(end_sum += solution[PROFILE_TEXELS + i]);
    }
}
