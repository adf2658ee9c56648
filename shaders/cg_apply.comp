#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// q_i = S sum_{j != i} K_ij (c_j - c_i) for the rows of one chunk, partial sums of c.q. Workgroups stride over the rows;
// an entry is three 128-bit loads. With parity 2 the filter is left out.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  float sum = 0;
  for (uint i = gl_GlobalInvocationID.x; i < push.rows; i += push.groups * group_size) {
    const uint row = push.first_row + i;
    const vec3 own = c[row].xyz;
    const uint width = slices[2 * (row / slice_rows) + 1];
    uint entry = 3 * entry_of(row, 0);
    vec3 y = vec3(0);
    for (uint k = 0; k < width; ++k) {
      const uvec4 a = blocks[entry];
      const vec4 b = uintBitsToFloat(blocks[entry + 1]);
      const vec4 e = uintBitsToFloat(blocks[entry + 2]);
      const vec3 d = c[a.x].xyz - own;
      y.x += dot(uintBitsToFloat(a.yzw), d);
      y.y += dot(b.xyz, d);
      y.z += dot(vec3(b.w, e.xy), d);
      entry += 3 * slice_rows;
    }
    if (push.parity != 2)
      y = apply_filter(row, y);
    q[row] = vec4(y, 0);
    sum += dot(own, y);
  }
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x == 0)
    scalars[TEDIT_SCALAR_PARTIALS + push.groups * (1 + push.chunk) + gl_WorkGroupID.x] = sum;
}
