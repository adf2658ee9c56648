#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// p = z + beta p.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

TEDIT_FLOATS(2, z)
layout(set = 0, binding = 6) writeonly buffer b6 { vec4 p[]; };
TEDIT_FLOATS(6, old_p)
layout(set = 0, binding = 8) readonly buffer b8 { float scalars[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c) {
      if (scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_STATE] != 0)
        continue;
      const uint at = cases * n + c;
      p[at] = z(at) + scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_FACTOR] * old_p(at);
    }
}
