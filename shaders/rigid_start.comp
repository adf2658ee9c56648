#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first Chebyshev step on a level of rigid motions: r = right; step = fresh B right; z = step, or z += step when
// the cycle is repeated (`enter` 1).
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "rigid.glsl"

layout(set = 0, binding = 2) readonly buffer b2 { vec4 right[]; };
layout(set = 0, binding = 3) writeonly buffer b3 { vec4 r[]; };
layout(set = 0, binding = 4) readonly buffer b4 { vec4 inverses[]; };
layout(set = 0, binding = 5) writeonly buffer b5 { vec4 step_out[]; };
layout(set = 0, binding = 6) buffer b6 { vec4 z[]; };

void main() {
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const vec4 a = right[2 * i];
    const vec4 b = right[2 * i + 1];
    const uint at = 9 * i;
    const motion y =
      sum_of(sum_of(two_columns(inverses[at], inverses[at + 1], inverses[at + 2], a.x, a.y),
                    two_columns(inverses[at + 3], inverses[at + 4], inverses[at + 5], a.z, b.x)),
             two_columns(inverses[at + 6], inverses[at + 7], inverses[at + 8], b.y, b.z));
    const vec4 move = vec4(push.fresh * y.move, 0);
    const vec4 turn = vec4(push.fresh * y.turn, 0);
    r[2 * i] = a;
    r[2 * i + 1] = b;
    step_out[2 * i] = move;
    step_out[2 * i + 1] = turn;
    z[2 * i] = push.enter == 0 ? move : z[2 * i] + move;
    z[2 * i + 1] = push.enter == 0 ? turn : z[2 * i + 1] + turn;
  }
}
