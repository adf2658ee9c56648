#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds up partial sums in a fixed order and finds alpha or beta of each case that is not done; when all are, stops the
// loop by setting the group counts of all its dispatches to zero. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"
#include "group_sum.glsl"

layout(set = 0, binding = at_partials) readonly buffer b7 { float partials[]; };
layout(set = 0, binding = at_scalars) buffer b8 { krylov_scalars scalars[]; };
layout(set = 0, binding = at_gates) buffer b9 { uvec4 gates[]; };

// As energy_bound in fem/multilevel/energy_bound.hpp.
void turn_bound(uint c, float alpha, float beta) {
  const float smallest = scalars[c].smallest;
  const float rest = scalars[c].radau - alpha;
  scalars[c].radau = rest > 1e-3 * alpha ? rest / (smallest * rest + beta) : 1 / smallest;
}

// What is left of the error, for r.z = delta.
bool is_small(uint c, float delta) {
  return scalars[c].radau * delta <= max(scalars[c].energy2, scalars[c].share2 * scalars[c].gained);
}

void begin(uint c, float sum, float rr, bool finite) {
  scalars[c].delta = sum;
  scalars[c].start = sum;
  scalars[c].threshold = scalars[c].reduction2 * sum;
  scalars[c].enough *= rr;
  scalars[c].iterations = 0;
  scalars[c].radau = 1 / scalars[c].smallest;
  scalars[c].gained = 0;
  if (sum >= 0 && is_small(c, sum))
    scalars[c].state = TEDIT_KRYLOV_CONVERGED;
  else
    scalars[c].state = sum > 0 && finite ? TEDIT_KRYLOV_RUNNING : TEDIT_KRYLOV_BROKEN_DOWN;
}

void find_alpha(uint c, float sum, bool finite) {
  const bool sound = sum > 0 && finite;
  const float alpha = sound ? scalars[c].delta / sum : 0;
  scalars[c].factor = alpha;
  scalars[c].gained += alpha * scalars[c].delta;
  if (scalars[c].iterations < TEDIT_KRYLOV_KEPT)
    scalars[c].alpha[scalars[c].iterations] = alpha;
  if (!sound)
    scalars[c].state = TEDIT_KRYLOV_BROKEN_DOWN;
}

void find_beta(uint c, float sum, float rr, bool finite) {
  const float beta = sum / scalars[c].delta;
  turn_bound(c, scalars[c].factor, beta);
  if (scalars[c].iterations < TEDIT_KRYLOV_KEPT)
    scalars[c].beta[scalars[c].iterations] = beta;
  scalars[c].factor = beta;
  scalars[c].delta = sum;
  ++scalars[c].iterations;
  if (!(sum >= 0) || !finite)
    scalars[c].state = TEDIT_KRYLOV_BROKEN_DOWN;
  else if (sum <= scalars[c].threshold || rr <= scalars[c].enough || is_small(c, sum))
    scalars[c].state = TEDIT_KRYLOV_CONVERGED;
}

// Of one of the numbers that each workgroup left.
float total(uint each, uint which) {
  float sum = 0;
  for (uint i = gl_LocalInvocationID.x; i < push.sums; i += group_size)
    sum += partials[each * i + which];
  return group_sum(sum);
}

void main() {
  bool running = false;
  const bool has_rr = mode != TEDIT_KRYLOV_ALPHA;
  const uint each = has_rr ? 2 * cases : cases;
  for (uint c = 0; c < cases; ++c) {
    const float sum = total(each, c);
    const float rr = has_rr ? total(each, cases + c) : 0;
    if (gl_LocalInvocationID.x == 0) {
      const bool finite = !isnan(sum) && !isinf(sum);
      if (mode == TEDIT_KRYLOV_BEGIN)
        begin(c, sum, rr, finite);
      else if (scalars[c].state == TEDIT_KRYLOV_RUNNING) {
        if (mode == TEDIT_KRYLOV_ALPHA)
          find_alpha(c, sum, finite);
        else
          find_beta(c, sum, rr, finite);
      }
      running = running || scalars[c].state == TEDIT_KRYLOV_RUNNING;
    }
  }
  if (gl_LocalInvocationID.x == 0)
    for (uint k = 0; k < TEDIT_GATES; ++k)
      gates[k].xyz = uvec3(running ? gates[k].w : 0, 1, 1);
}
