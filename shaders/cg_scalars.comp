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

// As energy_bound in fem/energy_bound.hpp.
void turn_bound(float alpha, float beta) {
  const float smallest = scalars[TEDIT_CG_SMALLEST];
  const float rest = scalars[TEDIT_CG_RADAU] - alpha;
  scalars[TEDIT_CG_RADAU] = rest > 1e-3 * alpha ? rest / (smallest * rest + beta) : 1 / smallest;
}

// What is left of the error, for r.z = delta.
bool is_small(float delta) {
  return scalars[TEDIT_CG_RADAU] * delta <=
         max(scalars[TEDIT_CG_ENERGY2], scalars[TEDIT_CG_SHARE2] * scalars[TEDIT_CG_GAINED]);
}

void note(uint which, float value) {
  const uint i = uint(scalars[TEDIT_CG_ITERATIONS]);
  if (i < TEDIT_CG_KEPT)
    scalars[TEDIT_CG_HISTORY + 2 * i + which] = value;
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
    scalars[TEDIT_CG_THRESHOLD] = push.reduction2 * sum;
    scalars[TEDIT_CG_ITERATIONS] = 0;
    scalars[TEDIT_CG_RADAU] = 1 / push.smallest;
    scalars[TEDIT_CG_GAINED] = 0;
    scalars[TEDIT_CG_ENERGY2] = push.energy2;
    scalars[TEDIT_CG_SHARE2] = push.share2;
    scalars[TEDIT_CG_SMALLEST] = push.smallest;
    set_state(sum >= 0 && is_small(sum) ? 1 : (sum > 0 && finite ? 0 : 2));
  } else if (mode == TEDIT_CG_ALPHA) {
    const bool sound = sum > 0 && finite;
    const float alpha = sound ? scalars[TEDIT_CG_DELTA] / sum : 0;
    scalars[TEDIT_CG_FACTOR] = alpha;
    scalars[TEDIT_CG_GAINED] += alpha * scalars[TEDIT_CG_DELTA];
    note(0, alpha);
    if (!sound)
      set_state(2);
  } else {
    const float beta = sum / scalars[TEDIT_CG_DELTA];
    turn_bound(scalars[TEDIT_CG_FACTOR], beta);
    note(1, beta);
    scalars[TEDIT_CG_FACTOR] = beta;
    scalars[TEDIT_CG_DELTA] = sum;
    scalars[TEDIT_CG_ITERATIONS] += 1;
    if (!(sum >= 0) || !finite)
      set_state(2);
    else if (sum <= scalars[TEDIT_CG_THRESHOLD] || is_small(sum))
      set_state(1);
  }
}
