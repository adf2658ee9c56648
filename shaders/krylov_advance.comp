#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// u += alpha p; r = S (r - alpha q). Without the filter r would keep the reactions, and their products with the rounding
// errors of z would outweigh r.z in the end.
#extension GL_GOOGLE_include_directive : require
#include "krylov_bindings.h"
#include "kernel.glsl"

layout(set = 0, binding = at_u) writeonly buffer b0 { vec4 u[]; };
TEDIT_FLOATS(at_u, old_u)
TEDIT_FLOATS(at_p, p)
TEDIT_FLOATS(at_q, q)
layout(set = 0, binding = at_r) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_r, old_r)
TEDIT_FLOATS(at_filter, filters)
layout(set = 0, binding = at_scalars) readonly buffer b8 { krylov_scalars scalars[]; };

void main() {
  for (uint n = first_row(); n < push.rows; n += stride())
    for (uint c = 0; c < cases; ++c) {
      if (scalars[c].state != TEDIT_KRYLOV_RUNNING)
        continue;
      const float alpha = scalars[c].factor;
      const uint at = cases * n + c;
      u[at] = old_u(at) + alpha * p(at);
      const vec3 left = old_r(at).xyz - alpha * q(at).xyz;
      r[at] = vec4(apply_symmetric(filters(2 * n), filters(2 * n + 1), left), 0);
    }
}
