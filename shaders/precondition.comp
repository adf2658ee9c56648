#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// P = S (S D S + t (I - S))^-1 S with D = -sum of the row's blocks and t its mean diagonal. One invocation per row.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

mat3 to_matrix(vec4 a, vec4 b) {
  return mat3(a.x, a.y, a.z, a.y, a.w, b.x, a.z, b.x, b.y);
}

void main() {
  const uint row = push.first_row + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  mat3 d = mat3(0);
  const uint width = slices[2 * (row / slice_rows) + 1];
  for (uint k = 0; k < width; ++k) {
    const uint entry = entry_of(row, k);
    const vec4 x = uintBitsToFloat(blocks[3 * entry]);
    const vec4 y = uintBitsToFloat(blocks[3 * entry + 1]);
    const vec4 z = uintBitsToFloat(blocks[3 * entry + 2]);
    d -= mat3(x.y, y.x, y.w, x.z, y.y, z.x, x.w, y.z, z.y);
  }
  const mat3 s = to_matrix(filters[2 * row], filters[2 * row + 1]);
  const float t = (d[0][0] + d[1][1] + d[2][2]) / 3;
  const mat3 p = s * inverse(s * d * s + (t > 0 ? t : 1) * (mat3(1) - s)) * s;
  inverses[2 * row] = vec4(p[0][0], p[1][0], p[2][0], p[1][1]);
  inverses[2 * row + 1] = vec4(p[2][1], p[2][2], 0, 0);
}
