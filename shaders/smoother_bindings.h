// SPDX-License-Identifier: AGPL-3.0-or-later
// Of smoother_start and smoother_clusters.
#include "rows_bindings.h"

TEDIT_NAMES(smoother_at)
TEDIT_BINDING(cluster_rows, 0)    // node, first entry, count
TEDIT_BINDING(cluster_blocks, 1)  // 3 per entry: column, 9 values by rows
TEDIT_END
