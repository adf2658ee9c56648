#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Partial sums of r.z of each case.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "group_sum.glsl"

layout(set = 0, binding = 2) readonly buffer b2 { vec4 z[]; };
layout(set = 0, binding = 3) readonly buffer b3 { vec4 r[]; };
layout(set = 0, binding = 7) writeonly buffer b7 { float partials[]; };

void main() {
  float sums[cases];
  for (uint c = 0; c < cases; ++c)
    sums[c] = 0;
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c)
      sums[c] += dot(r[cases * n + c].xyz, z[cases * n + c].xyz);
  for (uint c = 0; c < cases; ++c) {
    const float sum = group_sum(sums[c]);
    if (gl_LocalInvocationID.x == 0)
      partials[cases * (push.place + gl_WorkGroupID.x) + c] = sum;
  }
}
