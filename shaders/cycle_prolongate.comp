#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The motions of the aggregates as a step of their nodes, filtered, over-corrected.
#extension GL_GOOGLE_include_directive : require
#include "cycle_bindings.h"
#include "kernel.glsl"

TEDIT_WORDS(at_arms, arms)
TEDIT_FLOATS(at_coarse, coarse)
TEDIT_FLOATS(at_filter, filters)
layout(set = 0, binding = at_step) writeonly buffer b5 { vec4 step_out[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride()) {
    const uvec4 arm = arms(n);
    const uint a = arm.w;
    const vec4 first = filters(2 * n);
    const vec4 second = filters(2 * n + 1);
    for (uint c = 0; c < cases; ++c) {
      vec3 u = vec3(0);
      if (a < push.aggregates) {
        const uint at = 2 * (cases * a + c);
        u = apply_symmetric(first, second, coarse(at).xyz + cross(coarse(at + 1).xyz, uintBitsToFloat(arm.xyz)));
      }
      step_out[cases * n + c] = vec4(push.over_correction * u, 0);
    }
  }
}
