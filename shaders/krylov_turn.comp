#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// p = z + beta p.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"

TEDIT_FLOATS(at_z, z)
layout(set = 0, binding = at_p) writeonly buffer b6 { vec4 p[]; };
TEDIT_FLOATS(at_p, old_p)
layout(set = 0, binding = at_scalars) readonly buffer b8 { krylov_scalars scalars[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c) {
      if (scalars[c].state != TEDIT_KRYLOV_RUNNING)
        continue;
      const uint at = cases * n + c;
      p[at] = z(at) + scalars[c].factor * old_p(at);
    }
}
