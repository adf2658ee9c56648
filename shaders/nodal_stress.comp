#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Volume-weighted mean of the stresses of the elements around each node. One invocation per node; element stresses come from the
// BLOCKS binding, 2 uvec4 each, the means are 2 vec4 each.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const uint node = push.first_row + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  vec4 a = vec4(0);
  vec4 b = vec4(0);
  float volume = 0;
  for (uint at = corner_rows[node].x; at < corner_rows[node].y; ++at) {
    const uint e = corners[at] / 4;
    vec3 g[4];
    const float v = gradients_of(element_nodes[e], g);
    a += v * uintBitsToFloat(blocks[2 * e]);
    b += v * uintBitsToFloat(blocks[2 * e + 1]);
    volume += v;
  }
  means[2 * node] = a / volume;
  means[2 * node + 1] = b / volume;
}
