// SPDX-License-Identifier: AGPL-3.0-or-later
// What the solver's kernels share. Nothing assumes a subgroup size. Workgroups stride over the rows, so that any
// number of them will do. Behind the bindings, which declare `push`.
#include "operands.glsl"

layout(local_size_x_id = 0) in;
layout(constant_id = 0) const uint group_size = 64;
layout(constant_id = 1) const uint slice_rows = 8;
layout(constant_id = 2) const uint mode = 0;
// So many load cases side by side: a vector has the cases of its first node, then of the next one.
layout(constant_id = 4) const uint cases = 1;

// Where an invocation starts.
uint first_row() { return push.from + gl_GlobalInvocationID.x; }
uint stride() { return gl_NumWorkGroups.x * group_size; }

// S x for a symmetric matrix held as xx xy xz yy | yz zz.
vec3 apply_symmetric(vec4 a, vec4 b, vec3 x) {
  return vec3(a.x * x.x + a.y * x.y + a.z * x.z, a.y * x.x + a.w * x.y + b.x * x.z,
              a.z * x.x + b.x * x.y + b.y * x.z);
}
