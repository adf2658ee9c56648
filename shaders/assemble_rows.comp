#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// K_ab = V [lambda g_a g_b^T + mu g_b g_a^T + mu (g_a.g_b) I], summed over the elements around a row. One
// invocation per row gathers its own blocks: no atomics. Padding entries point at the row itself.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"
#include "split_block.glsl"

void put_block(uvec2 slice, uint k, uint lane, block33 block) {
  uvec3 head;
  uvec2 tail;
  uvec4 rest;
  split_block(block, head, tail, rest);
  blocks[head_place(slice.x, k, lane)].yzw = head;
  if (k % 2 == 0)
    blocks[tail_place(slice.x, k, lane)].xy = tail;
  else
    blocks[tail_place(slice.x, k, lane)].zw = tail;
  blocks[rest_place(slice.x, slice.y, k, lane)] = rest;
}

block33 block_at(uvec2 slice, uint k, uint lane) {
  const uvec4 tails = blocks[tail_place(slice.x, k, lane)];
  return exact_block(blocks[head_place(slice.x, k, lane)], k % 2 == 0 ? tails.xy : tails.zw,
                     blocks[rest_place(slice.x, slice.y, k, lane)]);
}

void add_block(uvec2 slice, uint k, uint lane, float volume, vec2 lame, vec3 ga, vec3 gb) {
  const float both = lame.y * dot(ga, gb);
  block33 sum = block_at(slice, k, lane);
  sum.x += volume * (lame.x * ga.x * gb + lame.y * gb.x * ga + vec3(both, 0, 0));
  sum.y += volume * (lame.x * ga.y * gb + lame.y * gb.y * ga + vec3(0, both, 0));
  sum.z += volume * (lame.x * ga.z * gb + lame.y * gb.z * ga + vec3(0, 0, both));
  put_block(slice, k, lane, sum);
}

void main() {
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  const uint place = push.first_row + gl_GlobalInvocationID.x;
  const uint row = push.listed == 1 ? listed[place] : place;
  uint columns[most_columns];
  const uint count = gather_columns(row, columns);
  const uint lane = row % slice_rows;
  const uvec2 slice =
    uvec2(slices[2 * (row / slice_rows)], slices[2 * (row / slice_rows) + 1] & ~TEDIT_EXACT_SLICE);
  const block33 zero = block33(vec3(0), vec3(0), vec3(0));
  for (uint k = 0; k < slice.y; ++k) {
    blocks[head_place(slice.x, k, lane)].x = k < count ? columns[k] : row;
    put_block(slice, k, lane, zero);
  }
  for (uint at = corner_rows[row].x; at < corner_rows[row].y; ++at) {
    const uint element = corners[at] / 4;
    const uint a = corners[at] % 4;
    const uvec4 n = element_nodes[element];
    vec3 g[4];
    const float volume = gradients_of(n, g);
    for (uint b = 0; b < 4; ++b) {
      if (b == a)
        continue;
      uint k = 0;
      while (columns[k] != n[b])
        ++k;
      add_block(slice, k, lane, volume, element_lame[element], g[a], g[b]);
    }
  }
}
