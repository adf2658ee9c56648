#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Rows of linear tets in difference form, y_i = sum_{j != i} K_ij (x_j - x_i), for the rows of one chunk. Products read
// the values of the matrix to the bit, smoothers rounded ones, but in marked slices. See rows.glsl for the rest.
#extension GL_GOOGLE_include_directive : require
#include "matrix_bindings.h"
#include "kernel.glsl"
#include "rows.glsl"
#include "split_block.glsl"

layout(constant_id = 3) const uint reading = TEDIT_READ_EXACTLY;

TEDIT_PAIRS(at_slices, slices)
TEDIT_WORDS(at_blocks, blocks)

void add_entry(block33 b, uint column, vec3 own[cases], inout vec3 y[cases]) {
  for (uint c = 0; c < cases; ++c) {
    const vec3 d = x(cases * column + c).xyz - own[c];
    y[c] += b.x * d.x + b.y * d.y + b.z * d.z;
  }
}

void add_rounded(uint first, uint width, uint lane, vec3 own[cases], inout vec3 y[cases]) {
  for (uint k = 0; k < width; k += 2) {
    const uvec4 a = blocks(head_place(first, k, lane));
    const uvec4 b = blocks(head_place(first, k + 1, lane));
    const uvec4 tails = blocks(tail_place(first, k, lane));
    add_entry(rounded_block(a, tails.xy), a.x, own, y);
    add_entry(rounded_block(b, tails.zw), b.x, own, y);
  }
}

void add_exact(uint first, uint width, uint lane, vec3 own[cases], inout vec3 y[cases]) {
  for (uint k = 0; k < width; k += 2) {
    const uvec4 a = blocks(head_place(first, k, lane));
    const uvec4 b = blocks(head_place(first, k + 1, lane));
    const uvec4 tails = blocks(tail_place(first, k, lane));
    add_entry(exact_block(a, tails.xy, blocks(rest_place(first, width, k, lane))), a.x, own, y);
    add_entry(exact_block(b, tails.zw, blocks(rest_place(first, width, k + 1, lane))), b.x, own, y);
  }
}

void main() {
  float sums[cases];
  for (uint c = 0; c < cases; ++c)
    sums[c] = 0;
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const uint row = push.first_row + i;
    vec3 own[cases];
    vec3 y[cases];
    for (uint c = 0; c < cases; ++c) {
      own[c] = x(cases * row + c).xyz;
      y[c] = vec3(0);
    }
    const uvec2 slice = slices(row / slice_rows);
    const uint width = slice.y & ~TEDIT_EXACT_SLICE;
    const uint lane = row % slice_rows;
    if (reading == TEDIT_READ_EXACTLY)
      add_exact(slice.x, width, lane, own, y);
    else if (reading == TEDIT_READ_ROUNDED || slice.y == width)
      add_rounded(slice.x, width, lane, own, y);
    else
      add_exact(slice.x, width, lane, own, y);
    for (uint c = 0; c < cases; ++c)
      sums[c] += finish_row(row, cases * row + c, own[c], y[c]);
  }
  finish_sums(sums);
}
