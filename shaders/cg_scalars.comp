#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds up partial sums in a fixed order, finds alpha or beta, and stops the loop by setting the group counts of all its
// dispatches to zero. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "group_sum.glsl"

layout(set = 0, binding = 7) readonly buffer b7 { float partials[]; };
layout(set = 0, binding = 8) buffer b8 { float scalars[]; };
layout(set = 0, binding = 9) buffer b9 { uvec4 gates[]; };  // group counts of the dispatches; w: while running

void set_state(float state) {
  scalars[TEDIT_CG_STATE] = state;
  for (uint k = 0; k < TEDIT_GATES; ++k)
    gates[k].xyz = uvec3(state == 0 ? gates[k].w : 0, 1, 1);
}

void main() {
  float sum = 0;
  for (uint i = gl_LocalInvocationID.x; i < push.rows; i += group_size)
    sum += partials[i];
  sum = group_sum(sum);
  if (gl_LocalInvocationID.x != 0)
    return;
  const bool finite = !isnan(sum) && !isinf(sum);
  if (mode == TEDIT_CG_BEGIN) {
    scalars[TEDIT_CG_DELTA] = sum;
    scalars[TEDIT_CG_START] = sum;
    scalars[TEDIT_CG_THRESHOLD] = max(push.reduction2 * sum, push.energy2);
    scalars[TEDIT_CG_ITERATIONS] = 0;
    set_state(sum == 0 || (sum > 0 && sum <= push.energy2) ? 1 : (sum > 0 && finite ? 0 : 2));
  } else if (mode == TEDIT_CG_ALPHA) {
    const bool sound = sum > 0 && finite;
    scalars[TEDIT_CG_FACTOR] = sound ? scalars[TEDIT_CG_DELTA] / sum : 0;
    if (!sound)
      set_state(2);
  } else {
    scalars[TEDIT_CG_FACTOR] = sum / scalars[TEDIT_CG_DELTA];
    scalars[TEDIT_CG_DELTA] = sum;
    scalars[TEDIT_CG_ITERATIONS] += 1;
    if (!(sum >= 0) || !finite)
      set_state(2);
    else if (sum <= scalars[TEDIT_CG_THRESHOLD])
      set_state(1);
  }
}
