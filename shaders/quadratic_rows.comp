#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Rows of quadratic tets: the sum of the element forces at a node, in a fixed order. Elements come in ranges that fit a
// binding; all but the last range only add to the sums. One load case.
#extension GL_GOOGLE_include_directive : require
#include "quadratic_bindings.h"
#include "kernel.glsl"
#include "rows.glsl"

layout(constant_id = 3) const uint earlier = 0;  // 1: the sums of earlier ranges are in `sums`

TEDIT_PAIRS(at_force_rows, rows)
TEDIT_WORDS(at_force_list, list)
TEDIT_FLOATS(at_forces, forces)
layout(set = 0, binding = at_sums) buffer b9 { vec4 sums[]; };

void main() {
  float sums_of[cases];
  sums_of[0] = 0;
  for (uint row = first_row(); row < push.rows; row += stride()) {
    vec3 y = vec3(0);
    const uvec2 own = rows(row);
    for (uint k = 0; k < own.y; k += 4) {
      const uvec4 at = list(own.x + k / 4);
      y += forces(at.x).xyz;
      if (k + 1 < own.y)
        y += forces(at.y).xyz;
      if (k + 2 < own.y)
        y += forces(at.z).xyz;
      if (k + 3 < own.y)
        y += forces(at.w).xyz;
    }
    if (earlier == 1)
      y += sums[row].xyz;
    if (mode == TEDIT_ACCUMULATE)
      sums[row] = vec4(y, 0);
    else
      sums_of[0] += finish_row(row, row, x(row).xyz, y);
  }
  finish_sums(sums_of);
}
