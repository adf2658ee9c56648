#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Number of blocks beside the diagonal in each row. One invocation per row.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const uint row = push.first_row + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  uint columns[most_columns];
  slices[row] = gather_columns(row, columns);
}
