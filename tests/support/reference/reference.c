/* The luminance along a ray, by adaptive quadrature: see reference.h. */
#include "reference.h"
#include "break_points.h"
#include "source_kinds.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <stdlib.h>

enum { MAX_PANELS = 8192 };

typedef struct quadrature_panel {
    double low, high;
    double value, error;
} quadrature_panel;

struct reference_workspace {
    break_point_search search;
    quadrature_panel panels[MAX_PANELS];
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
    free(workspace);
}

static double value_at(double x, void *f)
{
    return integrand_at(f, x).value;
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
static reference_value integrate(reference_workspace *workspace, integrand *f, double end)
{
    if (end <= 0 || f->coefficient == 0 || f->alpha == 0) return (reference_value){0};
    break_points_find(&workspace->search, f, end);
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
        if (sum.error <= 1e-10 * sum.luminance || count == MAX_PANELS || !(low < middle && middle < high)) {
            sum.error += 1e-13 * sum.luminance; /* for the integrand's own rounding */
            return sum;
        }
        panels[worst] = integrate_panel(f, low, middle);
        panels[count++] = integrate_panel(f, middle, high);
    }
}

bool reference_luminance(reference_workspace *workspace, const ew_sources_desc *sources, const reference_ray *ray,
                         reference_value *sum, reference_value *shares)
{
    *sum = (reference_value){0};
    size_t share_count = 0;
    for (int k = 0; k < SOURCE_KIND_COUNT; k++) {
        const source_kind *kind = source_kinds[k];
        for (size_t i = 0; i < source_count(kind, sources); i++) {
            integrand f = integrand_make(kind, source_at(kind, sources, i), ray, sources->epsilon);
            reference_value share = integrate(workspace, &f, ray->s_max);
            sum->luminance += share.luminance;
            sum->error += share.error;
            if (shares) shares[share_count++] = share;
        }
    }
    return sum->error <= REFERENCE_RELATIVE_ERROR * sum->luminance;
}
