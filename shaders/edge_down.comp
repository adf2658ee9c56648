#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// From quadratic tets to the linear ones of their corners: r of the corner and half of its edges' middles. The residual
// is filtered already.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

TEDIT_PAIRS(0, rows)    // first middle, last
TEDIT_NUMBERS(1, middles)  // nodes
TEDIT_FLOATS(3, r)
layout(set = 0, binding = 6) writeonly buffer b6 { vec4 right[]; };

void main() {
  for (uint c = first_row(); c < push.rows; c += stride()) {
    vec3 sum = vec3(0);
    const uvec2 place = rows(c);
    for (uint at = place.x; at < place.y; ++at)
      sum += r(middles(at)).xyz;
    right[c] = vec4(r(c).xyz + 0.5 * sum, 0);
  }
}
