// SPDX-License-Identifier: AGPL-3.0-or-later
// What is done with a row of y = K x on nodes with three unknowns; shared by both element orders.
#include "group_sum.glsl"

TEDIT_FLOATS(at_x, x)
layout(set = 0, binding = at_r) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_r, old_r)
TEDIT_FLOATS(at_diagonal, diagonal)  // 2 per node
layout(set = 0, binding = at_next) writeonly buffer b5 { vec4 next[]; };
layout(set = 0, binding = at_z) writeonly buffer b6 { vec4 z[]; };
TEDIT_FLOATS(at_z, old_z)
layout(set = 0, binding = at_partials) writeonly buffer b7 { float partials[]; };

// `at` is the place of a row of one case in the vectors, `own` x there. Returns a term of the case's partial sum.
float finish_row(uint row, uint at, vec3 own, vec3 y) {
  if (mode == TEDIT_MULTIPLY) {
    r[at] = vec4(y, 0);
    return dot(own, y);
  }
  const vec3 left = old_r(at).xyz - y;
  const vec3 image = apply_symmetric(diagonal(2 * row), diagonal(2 * row + 1), left);
  if (mode == TEDIT_RESIDUAL) {
    r[at] = vec4(image, 0);
    return 0;
  }
  const vec3 now = push.before * own + push.fresh * image;
  r[at] = vec4(left, 0);
  next[at] = vec4(now, 0);
  z[at] = old_z(at) + vec4(push.enter * own + now, 0);
  return 0;
}

void finish_sums(float sums[cases]) {
  if (mode != TEDIT_MULTIPLY)
    return;
  for (uint c = 0; c < cases; ++c) {
    const float sum = group_sum(sums[c]);
    if (gl_LocalInvocationID.x == 0)
      partials[cases * (push.first_sum + gl_WorkGroupID.x) + c] = sum;
  }
}
