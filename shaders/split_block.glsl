// SPDX-License-Identifier: AGPL-3.0-or-later
// The blocks of linear tets in halves of 16 bits a value, column by column, as natively (half_block of fem/split_float.hpp):
// the number rounded to eight bits of mantissa, and what that lacks; both together are the number to the bit.
//
// A slice holds its entries in pairs, lane by lane: for each pair two heads and one tail, then, behind all pairs, one rest
// an entry. Who reads rounded values reads 24 bytes an entry in a row, who reads all of it 40.
//   head  number of the column; upper halves of column 0 (low 16 bits) and 1 (high)
//   tail  of each of two entries: upper halves of column 2, rows 0 (low) and 1 (high); of its row 2 both halves (low, high)
//   rest  lower halves of column 0 (low) and 1 (high); of column 2, rows 0 (low) and 1 (high)

struct block33 {
  vec3 x, y, z;  // columns
};

// Where the parts of entry k lie, in units of four words, for a slice with this first entry and width, both even.
uint head_place(uint first, uint k, uint lane) {
  return first / 2 * 5 + (k / 2 * 3 + k % 2) * slice_rows + lane;
}
uint tail_place(uint first, uint k, uint lane) { return first / 2 * 5 + (k / 2 * 3 + 2) * slice_rows + lane; }
uint rest_place(uint first, uint width, uint k, uint lane) {
  return first / 2 * 5 + (width / 2 * 3 + k) * slice_rows + lane;
}

// The upper halves, as bits of a float, and what they lack, as an integer.
uvec3 low_up(uvec3 w) { return w << 16; }
uvec3 high_up(uvec3 w) { return w & 0xFFFF0000u; }
uvec3 low_rest(uvec3 w) { return uvec3(ivec3(w << 16) >> 16); }
uvec3 high_rest(uvec3 w) { return uvec3(ivec3(w) >> 16); }

block33 rounded_block(uvec4 head, uvec2 tail) {
  const uvec3 third = uvec3(tail.x << 16, tail.x & 0xFFFF0000u, tail.y & 0xFFFF0000u);
  return block33(uintBitsToFloat(low_up(head.yzw)), uintBitsToFloat(high_up(head.yzw)), uintBitsToFloat(third));
}

block33 exact_block(uvec4 head, uvec2 tail, uvec4 rest) {
  const uvec3 third = uvec3(tail.x << 16, tail.x & 0xFFFF0000u, tail.y & 0xFFFF0000u);
  const uvec3 lacks = low_rest(uvec3(rest.w, rest.w >> 16, tail.y));
  return block33(uintBitsToFloat(low_up(head.yzw) + low_rest(rest.xyz)),
                 uintBitsToFloat(high_up(head.yzw) + high_rest(rest.xyz)), uintBitsToFloat(third + lacks));
}
