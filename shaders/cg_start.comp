#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// u = 0, r = S q (q holds the right-hand side), c = P r, partial sums of r.c. Workgroups stride over the nodes.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  float sum = 0;
  for (uint n = gl_GlobalInvocationID.x; n < push.nodes; n += push.groups * group_size) {
    const vec3 rn = apply_filter(n, q[n].xyz);
    const vec3 s = apply_inverse(n, rn);
    u[n] = vec4(0);
    r[n] = vec4(rn, 0);
    c[n] = vec4(s, 0);
    sum += dot(rn, s);
  }
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x == 0)
    scalars[TEDIT_SCALAR_PARTIALS + gl_WorkGroupID.x] = sum;
}
