#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// alpha = delta / c.q; u += alpha c; r -= alpha q; q = P r; partial sums of r.q. Every workgroup adds up the partial sums
// in the same order, so all have the same alpha.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const float bend = sum_of_partials(TEDIT_SCALAR_PARTIALS + push.groups, push.groups * push.chunks);
  const bool sound = bend > 0 && !isinf(bend);
  const float alpha = sound ? scalars[TEDIT_SCALAR_DELTA + push.parity] / bend : 0;
  float sum = 0;
  for (uint n = gl_GlobalInvocationID.x; n < push.nodes; n += push.groups * group_size) {
    u[n].xyz += alpha * c[n].xyz;
    const vec3 rn = r[n].xyz - alpha * q[n].xyz;
    const vec3 s = apply_inverse(n, rn);
    r[n] = vec4(rn, 0);
    q[n] = vec4(s, 0);
    sum += dot(rn, s);
  }
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x == 0) {
    scalars[TEDIT_SCALAR_PARTIALS + gl_WorkGroupID.x] = sum;
    if (gl_WorkGroupID.x == 0 && !sound)
      scalars[TEDIT_SCALAR_STATE] = 2;
  }
}
