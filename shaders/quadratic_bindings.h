// SPDX-License-Identifier: AGPL-3.0-or-later
// Of quadratic_elements and quadratic_rows.
#include "rows_bindings.h"

TEDIT_NAMES(quadratic_at)
TEDIT_BINDING(nodes, 0)       // quadratic_elements: 3 per element: 10 nodes
TEDIT_BINDING(values, 1)      // 3 per element: grad L_1..3; lambda, mu * V/20
TEDIT_BINDING(force_rows, 0)  // quadratic_rows: first of the list, count of forces
TEDIT_BINDING(force_list, 1)  // into forces, four at a time
TEDIT_BINDING(forces, 8)      // see quadratic_operator::place_of
TEDIT_BINDING(sums, 9)        // of earlier ranges of elements
TEDIT_END
