#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds fresh * C^-1 r of the nodes of sliver clusters to the step and to z; one invocation per node. Their own blocks are
// zero in B.
#extension GL_GOOGLE_include_directive : require
#include "smoother_bindings.h"
#include "kernel.glsl"

layout(set = 0, binding = at_cluster_rows) readonly buffer b0 { uvec4 rows[]; };
TEDIT_WORDS(at_cluster_blocks, blocks)
TEDIT_FLOATS(at_r, r)
layout(set = 0, binding = at_next) buffer b5 { vec4 step_out[]; };
layout(set = 0, binding = at_z) buffer b6 { vec4 z[]; };

void main() {
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const uvec4 row = rows[i];
    if (row.z == 0)
      continue;  // Left by a cluster that an edit dissolved; another row may have the node now.
    vec3 y[cases];
    for (uint c = 0; c < cases; ++c)
      y[c] = vec3(0);
    for (uint k = 0; k < row.z; ++k) {
      const uint entry = 3 * (row.y + k);
      const uvec4 a = blocks(entry);
      const vec4 b = uintBitsToFloat(blocks(entry + 1));
      const vec4 e = uintBitsToFloat(blocks(entry + 2));
      for (uint c = 0; c < cases; ++c) {
        const vec3 d = r(cases * a.x + c).xyz;
        y[c] += vec3(dot(uintBitsToFloat(a.yzw), d), dot(b.xyz, d), dot(vec3(b.w, e.xy), d));
      }
    }
    for (uint c = 0; c < cases; ++c) {
      step_out[cases * row.x + c] += vec4(push.fresh * y[c], 0);
      z[cases * row.x + c] += vec4(push.fresh * y[c], 0);
    }
  }
}
