// SPDX-License-Identifier: AGPL-3.0-or-later
// Of kernels that work on the rows of an operator: matrix_rows, quadratic_rows, rigid_cycle_rows and smoothers.
#ifndef TEDIT_ROWS_BINDINGS_H
#define TEDIT_ROWS_BINDINGS_H

#include "bindings.h"

// What becomes of row i of y = K x (specialisation constant 2).
#define TEDIT_MULTIPLY 0    // r = y, partial sums of x.y
#define TEDIT_RESIDUAL 1    // r = S (r - y)
#define TEDIT_MOVE 2        // a Chebyshev step: see finish_row
#define TEDIT_ACCUMULATE 3  // sum += y (quadratic_rows with more than one range of elements)

TEDIT_NAMES(row_at)
TEDIT_BINDING(x, 2)         // of a smoother: its last step; where it starts: the right-hand side
TEDIT_BINDING(r, 3)         // y or the residual
TEDIT_BINDING(diagonal, 4)  // S (residual) or B (move)
TEDIT_BINDING(next, 5)      // step
TEDIT_BINDING(z, 6)         // sum of the steps
TEDIT_BINDING(partials, 7)
TEDIT_END

TEDIT_SHARED
struct row_push {
  uint rows;
  uint from;
  uint first_sum;  // place of the first partial sum
  uint first_row;  // of what is bound
  float before;    // Chebyshev weights: next step = before * old step + fresh * B r
  float fresh;
  float enter;     // how much of the old step enters z
  uint halves;     // rigid_cycle_coarsest: translations and rotations, two an aggregate
};
TEDIT_PUSH(row_push)
TEDIT_END

#endif
