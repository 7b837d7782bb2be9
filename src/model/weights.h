/* Weights along a source: equations (14) to (16). */
#ifndef EW_WEIGHTS_H
#define EW_WEIGHTS_H

#include "model/kinds.h"

ew_result ew_check_weights(ew_weight_list weights, const ew_source_name *name, ew_error *error);

/* How many polynomial pieces they make. */
size_t ew_weight_piece_count(size_t weight_count);

/* The pieces of S(t), equation (15), as polynomials of the place f in [0, 1] along each. `weights` has at least one. */
void ew_make_weight_pieces(ew_weight_list weights, struct ew_weight_block *pieces);

/* The mean of the weights; 1 for none. */
double ew_mean_of_weights(ew_weight_list weights);

#endif
