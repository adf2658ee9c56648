#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// r = S r; u = 0.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"

layout(set = 0, binding = at_u) writeonly buffer b0 { vec4 u[]; };
layout(set = 0, binding = at_r) buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_filter, filters)

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint at = cases * n; at < cases * (n + 1); ++at) {
      u[at] = vec4(0);
      r[at] = vec4(apply_symmetric(filters(2 * n), filters(2 * n + 1), r[at].xyz), 0);
    }
}
