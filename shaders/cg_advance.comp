#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// u += alpha p; r = S (r - alpha q). Without the filter r would keep the reactions, and their products with the rounding
// errors of z would outweigh r.z in the end.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

layout(set = 0, binding = 0) writeonly buffer b0 { vec4 u[]; };
TEDIT_FLOATS(0, old_u)
TEDIT_FLOATS(1, p)
TEDIT_FLOATS(2, q)
layout(set = 0, binding = 3) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(3, old_r)
TEDIT_FLOATS(4, filters)
layout(set = 0, binding = 8) readonly buffer b8 { float scalars[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c) {
      if (scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_STATE] != 0)
        continue;
      const float alpha = scalars[TEDIT_CG_SCALARS * c + TEDIT_CG_FACTOR];
      const uint at = cases * n + c;
      u[at] = old_u(at) + alpha * p(at);
      const vec3 left = old_r(at).xyz - alpha * q(at).xyz;
      r[at] = vec4(apply_symmetric(filters(2 * n), filters(2 * n + 1), left), 0);
    }
}
