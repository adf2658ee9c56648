#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// z = M right with the dense inverse of the coarsest level; one invocation per unknown. Neighbours read neighbouring
// parts of M: entry k of row i lies at k * size + i, three columns each.
#extension GL_GOOGLE_include_directive : require
#include "rigid_cycle_bindings.h"
#include "kernel.glsl"

TEDIT_FLOATS(at_inverse, inverse_rows)
TEDIT_FLOATS(at_x, right)
layout(set = 0, binding = at_z) writeonly buffer b6 { float z[]; };

void main() {
  const uint size = 3 * push.halves;
  for (uint i = first_row(); i < push.rows; i += stride()) {
    float sums[cases];
    for (uint c = 0; c < cases; ++c)
      sums[c] = 0;
    for (uint k = 0; k < push.halves; ++k) {
      const vec4 part = inverse_rows(k * size + i);
      for (uint c = 0; c < cases; ++c)
        sums[c] += dot(part, right(2 * (cases * (k / 2) + c) + k % 2));
    }
    const uint half_motion = i / 3;
    for (uint c = 0; c < cases; ++c)
      z[4 * (2 * (cases * (half_motion / 2) + c) + half_motion % 2) + i % 3] = sums[c];
  }
}
