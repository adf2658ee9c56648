#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first direction is the preconditioned residual.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

TEDIT_FLOATS(2, z)
layout(set = 0, binding = 6) writeonly buffer b6 { vec4 p[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint at = cases * n; at < cases * (n + 1); ++at)
      p[at] = z(at);
}
