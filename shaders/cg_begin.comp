#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// delta_0 from the partial sums, the threshold, and the group counts of the first iteration. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "elasticity.glsl"

void main() {
  const float delta = sum_of_partials(TEDIT_SCALAR_PARTIALS, push.groups);
  if (gl_LocalInvocationID.x != 0)
    return;
  const bool sound = delta > 0 && !isinf(delta);
  scalars[TEDIT_SCALAR_DELTA] = delta;
  scalars[TEDIT_SCALAR_DELTA + 1] = delta;
  scalars[TEDIT_SCALAR_THRESHOLD] = push.reduction2 * delta;
  scalars[TEDIT_SCALAR_STATE] = sound ? 0 : (delta == 0 ? 1 : 2);
  scalars[TEDIT_SCALAR_ITERATIONS] = 0;
  counts[0] = sound ? push.groups : 0;
  counts[1] = 1;
  counts[2] = 1;
}
