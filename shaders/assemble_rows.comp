#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// K_ab = V [lambda g_a g_b^T + mu g_b g_a^T + mu (g_a.g_b) I], summed over the elements around a row. One
// invocation per row gathers its own blocks: no atomics. Padding entries point at the row itself.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void add_block(uint entry, float volume, vec2 lame, vec3 ga, vec3 gb) {
  const float both = lame.y * dot(ga, gb);
  const vec3 x = volume * (lame.x * ga.x * gb + lame.y * gb.x * ga + vec3(both, 0, 0));
  const vec3 y = volume * (lame.x * ga.y * gb + lame.y * gb.y * ga + vec3(0, both, 0));
  const vec3 z = volume * (lame.x * ga.z * gb + lame.y * gb.z * ga + vec3(0, 0, both));
  uvec4 first = blocks[3 * entry];
  vec4 middle = uintBitsToFloat(blocks[3 * entry + 1]);
  vec4 last = uintBitsToFloat(blocks[3 * entry + 2]);
  const vec3 head = uintBitsToFloat(first.yzw) + x;
  middle += vec4(y, z.x);
  last.xy += z.yz;
  blocks[3 * entry] = uvec4(first.x, floatBitsToUint(head));
  blocks[3 * entry + 1] = floatBitsToUint(middle);
  blocks[3 * entry + 2] = floatBitsToUint(last);
}

void main() {
  if (gl_GlobalInvocationID.x >= push.rows)
    return;
  const uint place = push.first_row + gl_GlobalInvocationID.x;
  const uint row = push.listed == 1 ? listed[place] : place;
  uint columns[most_columns];
  const uint count = gather_columns(row, columns);
  const uint width = slices[2 * (row / slice_rows) + 1];
  for (uint k = 0; k < width; ++k) {
    const uint entry = entry_of(row, k);
    blocks[3 * entry] = uvec4(k < count ? columns[k] : row, 0, 0, 0);
    blocks[3 * entry + 1] = uvec4(0);
    blocks[3 * entry + 2] = uvec4(0);
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
      add_block(entry_of(row, k), volume, element_lame[element], g[a], g[b]);
    }
  }
}
