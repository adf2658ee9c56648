#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// p = z + beta p.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

layout(set = 0, binding = 2) readonly buffer b2 { vec4 z[]; };
layout(set = 0, binding = 6) buffer b6 { vec4 p[]; };
layout(set = 0, binding = 8) readonly buffer b8 { float scalars[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c) {
      if (scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_STATE] != 0)
        continue;
      const uint at = cases * n + c;
      p[at] = z[at] + scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_FACTOR] * p[at];
    }
}
