#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first direction is the preconditioned residual.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"

TEDIT_FLOATS(at_z, z)
layout(set = 0, binding = at_p) writeonly buffer b6 { vec4 p[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint at = cases * n; at < cases * (n + 1); ++at)
      p[at] = z(at);
}
