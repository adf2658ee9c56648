// SPDX-License-Identifier: AGPL-3.0-or-later
// Of cycle_restrict and cycle_prolongate.
#include "bindings.h"

TEDIT_NAMES(cycle_at)
TEDIT_BINDING(table, 0)  // of the members of each aggregate: first, last
TEDIT_BINDING(members, 1)
TEDIT_BINDING(arms, 2)   // of each node, and its aggregate; all ones: none
TEDIT_BINDING(residual, 3)
TEDIT_BINDING(filter, 4)
TEDIT_BINDING(step, 5)
TEDIT_BINDING(right, 6)   // 2 per aggregate and case
TEDIT_BINDING(coarse, 7)  // the same
TEDIT_END

TEDIT_SHARED
struct cycle_push {
  uint rows;
  uint from;
  uint aggregates;
  float over_correction;
};
TEDIT_PUSH(cycle_push)
TEDIT_END
