#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// From quadratic tets to the linear ones of their corners: r of the corner and half of its edges' middles. The residual
// is filtered already.
#extension GL_GOOGLE_include_directive : require
#include "quadratic_cycle_bindings.h"
#include "kernel.glsl"

TEDIT_PAIRS(at_table, rows)
TEDIT_NUMBERS(at_middles, middles)
TEDIT_FLOATS(at_residual, r)
layout(set = 0, binding = at_right) writeonly buffer b6 { vec4 right[]; };

void main() {
  for (uint c = first_row(); c < push.rows; c += stride()) {
    vec3 sum = vec3(0);
    const uvec2 place = rows(c);
    for (uint at = place.x; at < place.y; ++at)
      sum += r(middles(at)).xyz;
    right[c] = vec4(r(c).xyz + 0.5 * sum, 0);
  }
}
