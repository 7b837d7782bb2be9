/* The luminance along a ray, by adaptive quadrature: see reference.h. */
#include "reference.h"
#include "break_points.h"
#include "path_parts.h"
#include "source_kinds.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <math.h>
#include <stdlib.h>

enum { MAX_PANELS = 8192 };

/* The relative error that the quadrature aims for. The parts of a path all but cancel. */
#define TOLERANCE 1e-10
#define TOLERANCE_OF_PARTS 1e-12

typedef struct quadrature_panel {
    double low, high;
    double value, error;
} quadrature_panel;

struct reference_workspace {
    break_point_search search;
    quadrature_panel panels[MAX_PANELS];
    path_parts path; /* the parts of the path at hand */
};

reference_workspace *reference_create_workspace(void)
{
    gsl_set_error_handler_off();
    reference_workspace *workspace = calloc(1, sizeof *workspace);
    if (!workspace) return NULL;
    workspace->search.solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    if (workspace->search.solver) return workspace;
    free(workspace);
    return NULL;
}

void reference_destroy_workspace(reference_workspace *workspace)
{
    if (!workspace) return;
    gsl_root_fsolver_free(workspace->search.solver);
    path_parts_free(&workspace->path);
    free(workspace);
}

static double value_at(double x, void *f)
{
    return integrand_at(f, x).value * exp(-integrand_optical_depth(f, x));
}

static quadrature_panel integrate_panel(integrand *f, double low, double high)
{
    const gsl_function function = {value_at, f};
    quadrature_panel panel = {.low = low, .high = high};
    double absolute, variation;
    gsl_integration_qk21(&function, low, high, &panel.value, &panel.error, &absolute, &variation);
    return panel;
}

/* QUADPACK's global strategy: bisect the panel with the largest error until the sum of the errors is small. QAGP does so too,
 * but also extrapolates, which near-jumps (the nearest point rushing around a narrow bend) lead astray. */
static reference_value integrate_panels(reference_workspace *workspace, integrand *f, double tolerance)
{
    const double *break_points = workspace->search.break_points;
    quadrature_panel *panels = workspace->panels;
    size_t count = workspace->search.break_point_count - 1;
    for (size_t i = 0; i < count; i++)
        panels[i] = integrate_panel(f, break_points[i], break_points[i + 1]);
    for (;;) {
        reference_value sum = {0};
        size_t worst = 0;
        for (size_t i = 0; i < count; i++) {
            sum.luminance += panels[i].value;
            sum.error += panels[i].error;
            if (panels[i].error > panels[worst].error) worst = i;
        }
        double low = panels[worst].low, high = panels[worst].high, middle = 0.5 * (low + high);
        if (sum.error <= tolerance * sum.luminance || count == MAX_PANELS || !(low < middle && middle < high)) {
            sum.error += 1e-13 * sum.luminance; /* for the integrand's own rounding */
            return sum;
        }
        panels[worst] = integrate_panel(f, low, middle);
        panels[count++] = integrate_panel(f, middle, high);
    }
}

static reference_value integrate(reference_workspace *workspace, integrand *f, double s_max, double tolerance)
{
    double low = 0, high = s_max;
    bool is_off = f->coefficient == 0 || (f->alpha == 0 && !f->is_world);
    if (is_off || !integrand_limit(f, &low, &high)) return (reference_value){0};
    if (!isfinite(high)) return (reference_value){.error = HUGE_VAL};
    integrand_set_origin(f, low);
    break_points_find(&workspace->search, f, high - low);
    if (workspace->search.break_point_count == 0) return (reference_value){0};
    return integrate_panels(workspace, f, tolerance);
}
/* ---- Sources ------------------------------------------------------------------------------------------------------------ */

/* A source's light without what stands for something else. */
static source_light resolved_light(const source_kind *kind, const void *source, double epsilon)
{
    source_light light = source_light_of(kind, source);
    if (light.core == 0) light.core = epsilon;
    if (light.reach == 0) light.reach = HUGE_VAL;
    if (light.sharpness == 0) light.sharpness = 1;
    double share = 2 * log(light.reach / light.core);
    if (light.brightness > 0)
        light.coefficient = light.brightness / share;
    else
        light.brightness = light.coefficient * share;
    return light;
}

static reference_value integrate_path(reference_workspace *workspace, const ew_path *path, const integrand_light *light,
                                      const reference_ray *ray)
{
    reference_value sum = {0};
    path_parts *parts = &workspace->path;
    if (!path_parts_make(parts, path, light->core)) return (reference_value){.error = HUGE_VAL};
    for (size_t i = 0; i < parts->piece_count; i++) {
        integrand f = integrand_make(&path_piece_kind, &parts->pieces[i], light, ray);
        reference_value piece = integrate(workspace, &f, ray->s_max, TOLERANCE_OF_PARTS);
        sum.luminance += piece.luminance;
        sum.error += piece.error;
    }
    for (size_t i = 0; i < parts->joint_count; i++) {
        integrand_light joint_light = *light;
        joint_light.coefficient *= parts->joints[i].weight;
        integrand f = integrand_make(&point_kind, &parts->joints[i].point, &joint_light, ray);
        reference_value joint = integrate(workspace, &f, ray->s_max, TOLERANCE_OF_PARTS);
        sum.luminance -= joint.luminance;
        sum.error += joint.error;
    }
    if (sum.luminance < -sum.error) return (reference_value){0};
    sum.luminance = fmax(0, sum.luminance);
    return sum;
}

/* b g(B / b), with g(x) = x^sharpness for x <= 1 and 1 + sharpness (x - 1) beyond, and the error that it leaves. */
static reference_value sharpen(reference_value value, const source_light *light)
{
    double sharpness = light->sharpness, x = value.luminance / light->brightness;
    if (sharpness == 1 || value.luminance == 0) return value;
    return (reference_value){
        .luminance = light->brightness * (x <= 1 ? pow(x, sharpness) : 1 + sharpness * (x - 1)),
        .error = value.error * sharpness * fmin(1, pow(x, sharpness - 1)),
    };
}

static reference_value integrate_source(reference_workspace *workspace, const source_kind *kind, const void *source,
                                        double epsilon, const reference_ray *ray)
{
    source_light light = resolved_light(kind, source, epsilon);
    integrand_light given = {light.coefficient, light.core, light.reach};
    if (kind == &path_kind) return sharpen(integrate_path(workspace, source, &given, ray), &light);
    integrand f = integrand_make(kind, source, &given, ray);
    return sharpen(integrate(workspace, &f, ray->s_max, TOLERANCE), &light);
}

bool reference_luminance(reference_workspace *workspace, const ew_sources_desc *sources, const reference_ray *ray,
                         reference_value *sum, reference_value *shares)
{
    *sum = (reference_value){0};
    size_t share_count = 0;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        for (size_t i = 0; i < source_count(kind, sources); i++) {
            const void *source = source_at(kind, sources, i);
            reference_value share = integrate_source(workspace, kind, source, sources->epsilon, ray);
            sum->luminance += share.luminance;
            sum->error += share.error;
            if (shares) shares[share_count++] = share;
        }
    }
    return sum->error <= REFERENCE_RELATIVE_ERROR * sum->luminance;
}
