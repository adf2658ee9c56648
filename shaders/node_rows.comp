#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Rows of linear tets in difference form, y_i = sum_{j != i} K_ij (x_j - x_i), for the rows of one chunk; an entry is
// three 128-bit loads. See row_modes.glsl for the rest.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "row_modes.glsl"

layout(set = 0, binding = 0) readonly buffer b0 { uvec2 slices[]; };  // first entry, width
layout(set = 0, binding = 1) readonly buffer b1 { uvec4 blocks[]; };  // 3 per entry: column, 9 values by rows

void main() {
  float sums[cases];
  for (uint c = 0; c < cases; ++c)
    sums[c] = 0;
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const uint row = push.first_row + i;
    vec3 own[cases];
    vec3 y[cases];
    for (uint c = 0; c < cases; ++c) {
      own[c] = x[cases * row + c].xyz;
      y[c] = vec3(0);
    }
    const uvec2 slice = slices[row / slice_rows];
    uint entry = 3 * (slice.x + row % slice_rows);
    for (uint k = 0; k < slice.y; ++k) {
      const uvec4 a = blocks[entry];
      const vec4 b = uintBitsToFloat(blocks[entry + 1]);
      const vec4 e = uintBitsToFloat(blocks[entry + 2]);
      for (uint c = 0; c < cases; ++c) {
        const vec3 d = x[cases * a.x + c].xyz - own[c];
        y[c].x += dot(uintBitsToFloat(a.yzw), d);
        y[c].y += dot(b.xyz, d);
        y[c].z += dot(vec3(b.w, e.xy), d);
      }
      entry += 3 * slice_rows;
    }
    for (uint c = 0; c < cases; ++c)
      sums[c] += finish_row(row, cases * row + c, own[c], y[c]);
  }
  finish_sums(sums);
}
