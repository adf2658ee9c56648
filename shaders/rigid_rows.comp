#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// Rows of a level of rigid motions, or of its prolongation or restriction. Modes: r = y; other = r - y; a Chebyshev step.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"
#include "rigid.glsl"

layout(set = 0, binding = 0) readonly buffer b0 { uvec2 rows[]; };  // first entry, last
layout(set = 0, binding = 1) readonly buffer b1 { uint columns[]; };
layout(set = 0, binding = 2) readonly buffer b2 { vec4 x[]; };
layout(set = 0, binding = 3) buffer b3 { vec4 r[]; };
layout(set = 0, binding = 4) readonly buffer b4 { vec4 inverses[]; };
layout(set = 0, binding = 5) writeonly buffer b5 { vec4 other[]; };
layout(set = 0, binding = 6) buffer b6 { vec4 z[]; };
layout(set = 0, binding = 8) readonly buffer b8 { vec4 blocks[]; };

motion block_times(uint block, motion v) {
  const uint at = 9 * block;
  return sum_of(sum_of(two_columns(blocks[at], blocks[at + 1], blocks[at + 2], v.move.x, v.move.y),
                       two_columns(blocks[at + 3], blocks[at + 4], blocks[at + 5], v.move.z, v.turn.x)),
                two_columns(blocks[at + 6], blocks[at + 7], blocks[at + 8], v.turn.y, v.turn.z));
}

motion inverse_times(uint row, motion v) {
  const uint at = 9 * row;
  return sum_of(sum_of(two_columns(inverses[at], inverses[at + 1], inverses[at + 2], v.move.x, v.move.y),
                       two_columns(inverses[at + 3], inverses[at + 4], inverses[at + 5], v.move.z, v.turn.x)),
                two_columns(inverses[at + 6], inverses[at + 7], inverses[at + 8], v.turn.y, v.turn.z));
}

void main() {
  for (uint i = first_row(); i < push.rows; i += stride()) {
    const uint row = push.first_row + i;
    motion y = motion(vec3(0), vec3(0));
    const uvec2 place = rows[i];
    for (uint s = place.x; s < place.y; ++s) {
      const uint column = columns[s];
      y = sum_of(y, block_times(s, motion(x[2 * column].xyz, x[2 * column + 1].xyz)));
    }
    if (mode == TEDIT_MULTIPLY) {
      r[2 * row] = vec4(y.move, 0);
      r[2 * row + 1] = vec4(y.turn, 0);
      continue;
    }
    const motion left = motion(r[2 * row].xyz - y.move, r[2 * row + 1].xyz - y.turn);
    if (mode == TEDIT_RESIDUAL) {
      other[2 * row] = vec4(left.move, 0);
      other[2 * row + 1] = vec4(left.turn, 0);
      continue;
    }
    const motion image = inverse_times(row, left);
    const vec3 old_move = x[2 * row].xyz;
    const vec3 old_turn = x[2 * row + 1].xyz;
    const vec3 move = push.before * old_move + push.fresh * image.move;
    const vec3 turn = push.before * old_turn + push.fresh * image.turn;
    r[2 * row] = vec4(left.move, 0);
    r[2 * row + 1] = vec4(left.turn, 0);
    other[2 * row] = vec4(move, 0);
    other[2 * row + 1] = vec4(turn, 0);
    z[2 * row] += vec4(push.enter * old_move + move, 0);
    z[2 * row + 1] += vec4(push.enter * old_turn + turn, 0);
  }
}
