#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Adds up partial sums in a fixed order and finds alpha or beta of each case that is not done; when all are, stops the
// loop by setting the group counts of all its dispatches to zero. One workgroup.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "group_sum.glsl"

layout(set = 0, binding = 7) readonly buffer b7 { float partials[]; };
layout(set = 0, binding = 8) buffer b8 { float scalars[]; };
layout(set = 0, binding = 9) buffer b9 { uvec4 gates[]; };  // group counts of the dispatches; w: while running

// The scalars of one case; those of the others beside them.
uint place(uint c, uint which) { return TEDIT_CG_SCALARS * c + which; }

// As energy_bound in fem/multilevel/energy_bound.hpp.
void turn_bound(uint c, float alpha, float beta) {
  const float smallest = scalars[place(c, TEDIT_CG_SMALLEST)];
  const float rest = scalars[place(c, TEDIT_CG_RADAU)] - alpha;
  scalars[place(c, TEDIT_CG_RADAU)] = rest > 1e-3 * alpha ? rest / (smallest * rest + beta) : 1 / smallest;
}

// What is left of the error, for r.z = delta.
bool is_small(uint c, float delta) {
  return scalars[place(c, TEDIT_CG_RADAU)] * delta <=
         max(scalars[place(c, TEDIT_CG_ENERGY2)],
             scalars[place(c, TEDIT_CG_SHARE2)] * scalars[place(c, TEDIT_CG_GAINED)]);
}

void note(uint c, uint which, float value) {
  const uint i = uint(scalars[place(c, TEDIT_CG_ITERATIONS)]);
  if (i < TEDIT_CG_KEPT)
    scalars[place(c, TEDIT_CG_HISTORY + 2 * i + which)] = value;
}

void begin(uint c, float sum, float rr, bool finite) {
  scalars[place(c, TEDIT_CG_DELTA)] = sum;
  scalars[place(c, TEDIT_CG_START)] = sum;
  scalars[place(c, TEDIT_CG_THRESHOLD)] = scalars[place(c, TEDIT_CG_REDUCTION2)] * sum;
  scalars[place(c, TEDIT_CG_ENOUGH)] *= rr;
  scalars[place(c, TEDIT_CG_ITERATIONS)] = 0;
  scalars[place(c, TEDIT_CG_RADAU)] = 1 / scalars[place(c, TEDIT_CG_SMALLEST)];
  scalars[place(c, TEDIT_CG_GAINED)] = 0;
  scalars[place(c, TEDIT_CG_STATE)] = sum >= 0 && is_small(c, sum) ? 1 : (sum > 0 && finite ? 0 : 2);
}

void find_alpha(uint c, float sum, bool finite) {
  const bool sound = sum > 0 && finite;
  const float alpha = sound ? scalars[place(c, TEDIT_CG_DELTA)] / sum : 0;
  scalars[place(c, TEDIT_CG_FACTOR)] = alpha;
  scalars[place(c, TEDIT_CG_GAINED)] += alpha * scalars[place(c, TEDIT_CG_DELTA)];
  note(c, 0, alpha);
  if (!sound)
    scalars[place(c, TEDIT_CG_STATE)] = 2;
}

void find_beta(uint c, float sum, float rr, bool finite) {
  const float beta = sum / scalars[place(c, TEDIT_CG_DELTA)];
  turn_bound(c, scalars[place(c, TEDIT_CG_FACTOR)], beta);
  note(c, 1, beta);
  scalars[place(c, TEDIT_CG_FACTOR)] = beta;
  scalars[place(c, TEDIT_CG_DELTA)] = sum;
  scalars[place(c, TEDIT_CG_ITERATIONS)] += 1;
  if (!(sum >= 0) || !finite)
    scalars[place(c, TEDIT_CG_STATE)] = 2;
  else if (sum <= scalars[place(c, TEDIT_CG_THRESHOLD)] || rr <= scalars[place(c, TEDIT_CG_ENOUGH)] || is_small(c, sum))
    scalars[place(c, TEDIT_CG_STATE)] = 1;
}

// Of one of the numbers that each workgroup left.
float total(uint each, uint which) {
  float sum = 0;
  for (uint i = gl_LocalInvocationID.x; i < push.rows; i += group_size)
    sum += partials[each * i + which];
  return group_sum(sum);
}

void main() {
  bool running = false;
  const bool has_rr = mode != TEDIT_CG_ALPHA;
  const uint each = has_rr ? 2 * cases : cases;
  for (uint c = 0; c < cases; ++c) {
    const float sum = total(each, c);
    const float rr = has_rr ? total(each, cases + c) : 0;
    if (gl_LocalInvocationID.x == 0) {
      const bool finite = !isnan(sum) && !isinf(sum);
      if (mode == TEDIT_CG_BEGIN)
        begin(c, sum, rr, finite);
      else if (scalars[place(c, TEDIT_CG_STATE)] == 0) {
        if (mode == TEDIT_CG_ALPHA)
          find_alpha(c, sum, finite);
        else
          find_beta(c, sum, rr, finite);
      }
      running = running || scalars[place(c, TEDIT_CG_STATE)] == 0;
    }
  }
  if (gl_LocalInvocationID.x == 0)
    for (uint k = 0; k < TEDIT_GATES; ++k)
      gates[k].xyz = uvec3(running ? gates[k].w : 0, 1, 1);
}
