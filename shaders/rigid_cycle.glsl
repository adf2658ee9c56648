// SPDX-License-Identifier: AGPL-3.0-or-later
// Six unknowns: translation and rotation. A vector has two vec4 per aggregate and case, a 6x6 block nine: column by
// column.
struct motion {
  vec3 move;
  vec3 turn;
};

motion sum_of(motion a, motion b) { return motion(a.move + b.move, a.turn + b.turn); }

// Two columns of a block, from three vec4, times two numbers.
motion two_columns(vec4 a, vec4 b, vec4 c, float x, float y) {
  return motion(a.xyz * x + vec3(b.zw, c.x) * y, vec3(a.w, b.xy) * x + c.yzw * y);
}

// The nine vec4 of a 6x6 block: read once, used for each case.
struct block66 {
  vec4 part[9];
};

motion block_times(block66 b, motion v) {
  return sum_of(sum_of(two_columns(b.part[0], b.part[1], b.part[2], v.move.x, v.move.y),
                       two_columns(b.part[3], b.part[4], b.part[5], v.move.z, v.turn.x)),
                two_columns(b.part[6], b.part[7], b.part[8], v.turn.y, v.turn.z));
}
