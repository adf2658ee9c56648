#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The correction of the corners as a step of all nodes: the middle of an edge takes the mean of its ends, filtered.
#extension GL_GOOGLE_include_directive : require
#include "quadratic_cycle_bindings.h"
#include "kernel.glsl"

TEDIT_PAIRS(at_ends, ends)
TEDIT_FLOATS(at_coarse, coarse)
TEDIT_FLOATS(at_filter, filters)
layout(set = 0, binding = at_step) writeonly buffer b5 { vec4 step_out[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride()) {
    if (n < push.corners) {  // a corner
      step_out[n] = coarse(n);
      continue;
    }
    const uvec2 end = ends(n - push.corners);
    const vec3 mean = 0.5 * (coarse(end.x).xyz + coarse(end.y).xyz);
    step_out[n] = vec4(apply_symmetric(filters(2 * n), filters(2 * n + 1), mean), 0);
  }
}
