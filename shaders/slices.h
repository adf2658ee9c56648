// SPDX-License-Identifier: AGPL-3.0-or-later
// Shared by kernels and by C++.
#ifndef TEDIT_SLICES_H
#define TEDIT_SLICES_H

// With the width of a slice of matrix rows: smoothers read them exactly, too.
#define TEDIT_EXACT_SLICE 0x80000000u

#endif
