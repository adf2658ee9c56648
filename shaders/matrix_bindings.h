// SPDX-License-Identifier: AGPL-3.0-or-later
// Of matrix_rows.
#include "rows_bindings.h"

// How values are read (specialisation constant 3).
#define TEDIT_READ_EXACTLY 0  // to the bit
#define TEDIT_READ_ROUNDED 1
#define TEDIT_READ_MIXED 2    // rounded, but in marked slices

// With the width of a slice: smoothers read it exactly, too.
#define TEDIT_EXACT_SLICE 0x80000000u

TEDIT_NAMES(matrix_at)
TEDIT_BINDING(slices, 0)  // first entry; width, and TEDIT_EXACT_SLICE
TEDIT_BINDING(blocks, 1)  // see split_block.glsl
TEDIT_END
