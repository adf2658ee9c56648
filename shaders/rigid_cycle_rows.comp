#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Rows of a level of rigid motions, or of its prolongation or restriction. Modes: r = y; next = r - y; a Chebyshev step.
#extension GL_GOOGLE_include_directive : require
#include "rigid_cycle_bindings.h"
#include "kernel.glsl"
#include "rigid_cycle.glsl"

TEDIT_PAIRS(at_table, rows)
TEDIT_NUMBERS(at_columns, columns)
TEDIT_FLOATS(at_x, x)
layout(set = 0, binding = at_r) writeonly buffer b3 { vec4 r[]; };
TEDIT_FLOATS(at_r, old_r)
TEDIT_FLOATS(at_diagonal, inverses)
layout(set = 0, binding = at_next) writeonly buffer b5 { vec4 next[]; };
layout(set = 0, binding = at_z) writeonly buffer b6 { vec4 z[]; };
TEDIT_FLOATS(at_z, old_z)
TEDIT_FLOATS(at_blocks, blocks)

block66 block_at(uint block) {
  block66 b;
  for (uint i = 0; i < 9; ++i)
    b.part[i] = blocks(9 * block + i);
  return b;
}

block66 inverse_at(uint row) {
  block66 b;
  for (uint i = 0; i < 9; ++i)
    b.part[i] = inverses(9 * row + i);
  return b;
}

void main() {
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const uint row = push.first_row + i;
    motion y[cases];
    for (uint c = 0; c < cases; ++c)
      y[c] = motion(vec3(0), vec3(0));
    const uvec2 place = rows(i);
    for (uint s = place.x; s < place.y; ++s) {
      const uint column = cases * columns(s);
      const block66 block = block_at(s);
      for (uint c = 0; c < cases; ++c)
        y[c] = sum_of(y[c], block_times(block, motion(x(2 * (column + c)).xyz, x(2 * (column + c) + 1).xyz)));
    }
    block66 inverse;
    if (mode == TEDIT_MOVE)
      inverse = inverse_at(row);
    for (uint c = 0; c < cases; ++c) {
      const uint at = 2 * (cases * row + c);
      if (mode == TEDIT_MULTIPLY) {
        r[at] = vec4(y[c].move, 0);
        r[at + 1] = vec4(y[c].turn, 0);
        continue;
      }
      const motion left = motion(old_r(at).xyz - y[c].move, old_r(at + 1).xyz - y[c].turn);
      if (mode == TEDIT_RESIDUAL) {
        next[at] = vec4(left.move, 0);
        next[at + 1] = vec4(left.turn, 0);
        continue;
      }
      const motion image = block_times(inverse, left);
      const vec3 old_move = x(at).xyz;
      const vec3 old_turn = x(at + 1).xyz;
      const vec3 move = push.before * old_move + push.fresh * image.move;
      const vec3 turn = push.before * old_turn + push.fresh * image.turn;
      r[at] = vec4(left.move, 0);
      r[at + 1] = vec4(left.turn, 0);
      next[at] = vec4(move, 0);
      next[at + 1] = vec4(turn, 0);
      z[at] = old_z(at) + vec4(push.enter * old_move + move, 0);
      z[at + 1] = old_z(at + 1) + vec4(push.enter * old_turn + turn, 0);
    }
  }
}
