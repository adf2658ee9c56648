// SPDX-License-Identifier: AGPL-3.0-or-later
// Of quadratic_cycle_restrict and quadratic_cycle_prolongate.
#include "bindings.h"

TEDIT_NAMES(quadratic_cycle_at)
TEDIT_BINDING(table, 0)    // of the middles at each corner: first, last
TEDIT_BINDING(middles, 1)  // nodes
TEDIT_BINDING(ends, 2)     // corners of each middle
TEDIT_BINDING(residual, 3)
TEDIT_BINDING(filter, 4)
TEDIT_BINDING(step, 5)
TEDIT_BINDING(right, 6)
TEDIT_BINDING(coarse, 7)
TEDIT_END

TEDIT_SHARED
struct quadratic_cycle_push {
  uint rows;
  uint from;
  uint corners;
};
TEDIT_PUSH(quadratic_cycle_push)
TEDIT_END
