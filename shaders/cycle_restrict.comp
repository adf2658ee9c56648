#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// From nodes to aggregates: force and moment of the filtered residual. One invocation per aggregate.
#extension GL_GOOGLE_include_directive : require
#include "cycle_bindings.h"
#include "kernel.glsl"

TEDIT_PAIRS(at_table, rows)
TEDIT_NUMBERS(at_members, members)
TEDIT_FLOATS(at_arms, arms)
TEDIT_FLOATS(at_residual, r)
layout(set = 0, binding = at_right) writeonly buffer b6 { vec4 right[]; };

void main() {
  for (uint a = first_row(); a < push.rows; a += stride()) {
    vec3 force[cases];
    vec3 moment[cases];
    for (uint c = 0; c < cases; ++c) {
      force[c] = vec3(0);
      moment[c] = vec3(0);
    }
    const uvec2 place = rows(a);
    for (uint at = place.x; at < place.y; ++at) {
      const uint n = members(at);
      const vec3 arm = arms(n).xyz;
      for (uint c = 0; c < cases; ++c) {
        const vec3 f = r(cases * n + c).xyz;
        force[c] += f;
        moment[c] += cross(arm, f);
      }
    }
    for (uint c = 0; c < cases; ++c) {
      right[2 * (cases * a + c)] = vec4(force[c], 0);
      right[2 * (cases * a + c) + 1] = vec4(moment[c], 0);
    }
  }
}
