/* Weights along a source: see weights.h. */
#include "model/weights.h"

#include "base/error.h"
#include "model/limits.h"

ew_result ew_check_weights(ew_weight_list weights, const ew_source_name *name, ew_error *error)
{
    if ((weights.values == NULL) != (weights.count == 0))
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT,
                       "%s[%zu].weights and weight_count must both be given, or be NULL and 0", name->list, name->index);
    if (weights.count > EW_MAX_WEIGHTS)
        return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].weight_count must be at most %d", name->list, name->index,
                       EW_MAX_WEIGHTS);
    for (size_t i = 0; i < weights.count; ++i)
        if (!(weights.values[i] >= 0 && weights.values[i] <= EW_MAX_COEFFICIENT))
            return ew_fail(error, EW_ERROR_INVALID_ARGUMENT, "%s[%zu].weights[%zu] must be in [0, %g]", name->list, name->index,
                           i, EW_MAX_COEFFICIENT);
    return EW_OK;
}

size_t ew_weight_piece_count(size_t weight_count)
{
    if (weight_count == 0) return 0;
    return weight_count > 2 ? weight_count - 2 : 1;
}

/* The quadratic B-spline with the knots of (16), from its value and slope at each piece's start and its value at the end. */
void ew_make_weight_pieces(ew_weight_list weights, struct ew_weight_block *pieces)
{
    const double *values = weights.values;
    if (weights.count < 3) {
        double slope = weights.count == 2 ? values[1] - values[0] : 0;
        pieces[0].polynomial = (ew_vec4){(float)values[0], (float)slope, 0, 0};
        return;
    }
    for (size_t i = 0; i < weights.count - 2; ++i) {
        /* The distances between knots i + 1, ..., i + 4 in units of the piece's own length: 1, but 0 between the repeated ones
         * at either end. */
        double before = i == 0 ? 0 : 1;
        double after = i == weights.count - 3 ? 0 : 1;
        double start = (values[i] + values[i + 1] * before) / (1 + before);
        double slope = 2 * (values[i + 1] - values[i]) / (1 + before);
        double end = (values[i + 1] * after + values[i + 2]) / (1 + after);
        pieces[i].polynomial = (ew_vec4){(float)start, (float)slope, (float)(end - start - slope), 0};
    }
}

double ew_mean_of_weights(ew_weight_list weights)
{
    if (weights.count == 0) return 1;
    double sum = 0;
    for (size_t i = 0; i < weights.count; ++i)
        sum += weights.values[i];
    return sum / (double)weights.count;
}
