#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// From nodes to aggregates: force and moment of the filtered residual. One invocation per aggregate.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

layout(set = 0, binding = 0) readonly buffer b0 { uvec2 rows[]; };  // first member, last
layout(set = 0, binding = 1) readonly buffer b1 { uint members[]; };
layout(set = 0, binding = 2) readonly buffer b2 { vec4 arms[]; };
layout(set = 0, binding = 3) readonly buffer b3 { vec4 r[]; };
layout(set = 0, binding = 6) writeonly buffer b6 { vec4 right[]; };  // 2 per aggregate

void main() {
  for (uint a = first_row(); a < push.rows; a += stride()) {
    vec3 force = vec3(0);
    vec3 moment = vec3(0);
    const uvec2 place = rows[a];
    for (uint at = place.x; at < place.y; ++at) {
      const uint n = members[at];
      const vec3 f = r[n].xyz;
      force += f;
      moment += cross(arms[n].xyz, f);
    }
    right[2 * a] = vec4(force, 0);
    right[2 * a + 1] = vec4(moment, 0);
  }
}
