#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first Chebyshev step from zero: r = right; step = fresh B right; z = step.
#extension GL_GOOGLE_include_directive : require
#include "smoother_bindings.h"
#include "kernel.glsl"

TEDIT_FLOATS(at_x, right)
layout(set = 0, binding = at_r) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_diagonal, diagonal)
layout(set = 0, binding = at_next) writeonly buffer b5 { vec4 step_out[]; };
layout(set = 0, binding = at_z) writeonly buffer b6 { vec4 z[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride()) {
    const vec4 first = diagonal(2 * n);
    const vec4 second = diagonal(2 * n + 1);
    for (uint at = cases * n; at < cases * (n + 1); ++at) {
      const vec4 value = right(at);
      const vec4 now = vec4(push.fresh * apply_symmetric(first, second, value.xyz), 0);
      r[at] = value;
      step_out[at] = now;
      z[at] = now;
    }
  }
}
