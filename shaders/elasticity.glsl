// SPDX-License-Identifier: AGPL-3.0-or-later
// Buffers and functions of the assembly kernels. Nothing assumes a subgroup size.
#extension GL_GOOGLE_include_directive : require
#include "elasticity_bindings.h"

layout(local_size_x_id = 0) in;
layout(constant_id = 0) const uint group_size = 64;
layout(constant_id = 1) const uint slice_rows = 8;
layout(constant_id = 2) const uint most_columns = 64;

layout(set = 0, binding = TEDIT_BIND_POSITION_HIGH) readonly buffer b0 { vec4 position_high[]; };
layout(set = 0, binding = TEDIT_BIND_POSITION_LOW) readonly buffer b1 { vec4 position_low[]; };
layout(set = 0, binding = TEDIT_BIND_ELEMENT_NODES) readonly buffer b2 { uvec4 element_nodes[]; };
layout(set = 0, binding = TEDIT_BIND_ELEMENT_LAME) readonly buffer b3 { vec2 element_lame[]; };
layout(set = 0, binding = TEDIT_BIND_CORNER_ROWS) readonly buffer b4 { uvec2 corner_rows[]; };
layout(set = 0, binding = TEDIT_BIND_CORNERS) readonly buffer b5 { uint corners[]; };
layout(set = 0, binding = TEDIT_BIND_SLICES) buffer b6 { uint slices[]; };
layout(set = 0, binding = TEDIT_BIND_BLOCKS) buffer b7 { uvec4 blocks[]; };
layout(set = 0, binding = TEDIT_BIND_LISTED) readonly buffer b8 { uint listed[]; };

vec3 edge(uint a, uint b) {
  return (position_high[b].xyz - position_high[a].xyz) + (position_low[b].xyz - position_low[a].xyz);
}

// Gradients of the four shape functions; returns the volume.
float gradients_of(uvec4 n, out vec3 g[4]) {
  const vec3 e1 = edge(n.x, n.y);
  const vec3 e2 = edge(n.x, n.z);
  const vec3 e3 = edge(n.x, n.w);
  const vec3 c1 = cross(e2, e3);
  const float det = dot(e1, c1);
  g[1] = c1 / det;
  g[2] = cross(e3, e1) / det;
  g[3] = cross(e1, e2) / det;
  g[0] = -(g[1] + g[2] + g[3]);
  return det / 6;
}

// The other nodes around a row, ascending; returns how many.
uint gather_columns(uint row, out uint columns[most_columns]) {
  uint count = 0;
  for (uint at = corner_rows[row].x; at < corner_rows[row].y; ++at) {
    const uvec4 n = element_nodes[corners[at] / 4];
    for (uint b = 0; b < 4; ++b) {
      const uint node = n[b];
      if (node == row)
        continue;
      uint place = count;
      while (place > 0 && columns[place - 1] > node)
        --place;
      if (place > 0 && columns[place - 1] == node)
        continue;
      for (uint i = count; i > place; --i)
        columns[i] = columns[i - 1];
      columns[place] = node;
      ++count;
    }
  }
  return count;
}
