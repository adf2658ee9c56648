#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first Chebyshev step on a level of rigid motions: r = right; step = z = fresh B right.
#extension GL_GOOGLE_include_directive : require
#include "rigid_cycle_bindings.h"
#include "kernel.glsl"
#include "rigid_cycle.glsl"

TEDIT_FLOATS(at_x, right)
layout(set = 0, binding = at_r) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_diagonal, inverses)
layout(set = 0, binding = at_next) writeonly buffer b5 { vec4 step_out[]; };
layout(set = 0, binding = at_z) writeonly buffer b6 { vec4 z[]; };

void main() {
  for (uint i = first_row(); i < push.rows; i += stride()) {
    block66 inverse;
    for (uint k = 0; k < 9; ++k)
      inverse.part[k] = inverses(9 * i + k);
    for (uint at = 2 * cases * i; at < 2 * cases * (i + 1); at += 2) {
      const vec4 a = right(at);
      const vec4 b = right(at + 1);
      const motion y = block_times(inverse, motion(a.xyz, b.xyz));
      const vec4 move = vec4(push.fresh * y.move, 0);
      const vec4 turn = vec4(push.fresh * y.turn, 0);
      r[at] = a;
      r[at + 1] = b;
      step_out[at] = move;
      step_out[at + 1] = turn;
      z[at] = move;
      z[at + 1] = turn;
    }
  }
}
