#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Stress (xx yy zz xy | yz zx) of each element from displacement differences; which come as a leading and a
// trailing part. One invocation per element; written to the BLOCKS binding, 2 uvec4 each.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const uint e = push.first_row + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  const uvec4 n = element_nodes[e];
  vec3 g[4];
  gradients_of(n, g);
  mat3 grad = mat3(0);  // column j: derivative along axis j
  for (uint a = 1; a < 4; ++a) {
    const vec3 d = (leading[n[a]].xyz - leading[n.x].xyz) + (trailing[n[a]].xyz - trailing[n.x].xyz);
    grad += outerProduct(d, g[a]);
  }
  const vec2 lame = element_lame[e];
  const float pressure = lame.x * (grad[0][0] + grad[1][1] + grad[2][2]);
  blocks[2 * e] = floatBitsToUint(vec4(pressure + 2 * lame.y * grad[0][0], pressure + 2 * lame.y * grad[1][1],
                                       pressure + 2 * lame.y * grad[2][2], lame.y * (grad[1][0] + grad[0][1])));
  blocks[2 * e + 1] = floatBitsToUint(vec4(lame.y * (grad[2][1] + grad[1][2]), lame.y * (grad[0][2] + grad[2][0]), 0, 0));
}
