// SPDX-License-Identifier: AGPL-3.0-or-later
// Six unknowns: translation and rotation. A vector has two vec4 per aggregate, a 6x6 block nine: column by column.
struct motion {
  vec3 move;
  vec3 turn;
};

motion sum_of(motion a, motion b) { return motion(a.move + b.move, a.turn + b.turn); }

// Two columns of a block, from three vec4, times two numbers.
motion two_columns(vec4 a, vec4 b, vec4 c, float x, float y) {
  return motion(a.xyz * x + vec3(b.zw, c.x) * y, vec3(a.w, b.xy) * x + c.yzw * y);
}
