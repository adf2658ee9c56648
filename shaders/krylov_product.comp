#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Partial sums of each case: r.z, then those of r.r behind them.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"
#include "group_sum.glsl"

TEDIT_FLOATS(at_z, z)
TEDIT_FLOATS(at_r, r)
layout(set = 0, binding = at_partials) writeonly buffer b7 { float partials[]; };

void main() {
  vec2 sums[cases];
  for (uint c = 0; c < cases; ++c)
    sums[c] = vec2(0);
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c)
      sums[c] += vec2(dot(r(cases * n + c).xyz, z(cases * n + c).xyz), dot(r(cases * n + c).xyz, r(cases * n + c).xyz));
  for (uint c = 0; c < cases; ++c) {
    const float rz = group_sum(sums[c].x);
    const float rr = group_sum(sums[c].y);
    const uint at = 2 * cases * (push.first_sum + gl_WorkGroupID.x) + c;
    if (gl_LocalInvocationID.x == 0) {
      partials[at] = rz;
      partials[at + cases] = rr;
    }
  }
}
