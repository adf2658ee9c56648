#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// beta = delta' / delta; c = q + beta c. The first workgroup keeps delta', counts the iteration and stops the loop by
// setting the group counts to zero.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const float next = sum_of_partials(TEDIT_SCALAR_PARTIALS, push.groups);
  const float beta = next / scalars[TEDIT_SCALAR_DELTA + push.parity];
  for (uint n = gl_GlobalInvocationID.x; n < push.nodes; n += push.groups * group_size)
    c[n] = vec4(q[n].xyz + beta * c[n].xyz, 0);
  if (gl_GlobalInvocationID.x != 0)
    return;
  const bool broken = scalars[TEDIT_SCALAR_STATE] == 2 || !(next >= 0) || isinf(next);
  const bool done = next <= scalars[TEDIT_SCALAR_THRESHOLD];
  scalars[TEDIT_SCALAR_DELTA + 1 - push.parity] = next;
  scalars[TEDIT_SCALAR_ITERATIONS] += 1;
  if (broken || done) {
    scalars[TEDIT_SCALAR_STATE] = broken ? 2 : 1;
    counts[0] = 0;
  }
}
