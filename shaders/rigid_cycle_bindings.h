// SPDX-License-Identifier: AGPL-3.0-or-later
// Of kernels on levels of rigid motions.
#include "rows_bindings.h"

TEDIT_NAMES(rigid_cycle_at)
TEDIT_BINDING(table, 0)    // of the rows: first entry, last
TEDIT_BINDING(columns, 1)
TEDIT_BINDING(blocks, 8)
TEDIT_BINDING(inverse, 0)  // rigid_cycle_coarsest
TEDIT_END
