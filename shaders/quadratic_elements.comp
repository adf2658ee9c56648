#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The ten nodal forces of straight-sided quadratic tets, one invocation per element. The displacement gradient at corner
// k is sum_{b != k} (4 (u_kb - u_k) - (u_b - u_k)) (x) grad L_b, u_kb at the middle of edge kb; with corner stresses
// sigma_k, S_k = V/20 (sigma_k + sum sigma), the forces are 4 (S_k g_b + S_b g_k) at the middles and
// (4 S_k - sum S) g_k at the corners.
#extension GL_GOOGLE_include_directive : require
#include "quadratic_bindings.h"
#include "kernel.glsl"

TEDIT_WORDS(at_nodes, nodes)
TEDIT_FLOATS(at_values, elements)
TEDIT_FLOATS(at_x, x)
layout(set = 0, binding = at_forces) writeonly buffer b8 { vec4 forces[]; };

struct tensor {
  vec3 normal;  // xx yy zz
  vec3 shear;   // xy yz zx
};

tensor corner_stress(vec2 lame, vec3 u, vec3 ua, vec3 ma, vec3 ga, vec3 ub, vec3 mb, vec3 gb, vec3 uc, vec3 mc,
                     vec3 gc) {
  const vec3 a = 4 * (ma - u) - (ua - u);
  const vec3 b = 4 * (mb - u) - (ub - u);
  const vec3 c = 4 * (mc - u) - (uc - u);
  const vec3 x = a * ga.x + b * gb.x + c * gc.x;
  const vec3 y = a * ga.y + b * gb.y + c * gc.y;
  const vec3 z = a * ga.z + b * gb.z + c * gc.z;
  tensor s;
  s.normal = lame.x * (x.x + y.y + z.z) + 2 * lame.y * vec3(x.x, y.y, z.z);
  s.shear = lame.y * vec3(x.y + y.x, y.z + z.y, z.x + x.z);
  return s;
}

tensor add(tensor a, tensor b) { return tensor(a.normal + b.normal, a.shear + b.shear); }

vec3 times(tensor s, vec3 g) {
  return s.normal * g + vec3(s.shear.x * g.y + s.shear.z * g.z, s.shear.x * g.x + s.shear.y * g.z,
                             s.shear.z * g.x + s.shear.y * g.y);
}

void put(uint e, uint local, vec3 force) {
  forces[(e / slice_rows * 10 + local) * slice_rows + e % slice_rows] = vec4(force, 0);
}

vec3 corner_force(tensor s, tensor all, vec3 g) { return 4 * times(s, g) - times(all, g); }

void element_forces(uint e) {
  const uvec4 corner = nodes(3 * e);
  const uvec4 middle = nodes(3 * e + 1);
  const uvec4 rest = nodes(3 * e + 2);
  const vec4 first = elements(3 * e);
  const vec4 second = elements(3 * e + 1);
  const vec3 g1 = first.xyz;
  const vec3 g2 = second.xyz;
  const vec3 g3 = elements(3 * e + 2).xyz;
  const vec3 g0 = -(g1 + g2 + g3);
  const vec2 lame = vec2(first.w, second.w);
  const vec3 u0 = x(corner.x).xyz;
  const vec3 u1 = x(corner.y).xyz;
  const vec3 u2 = x(corner.z).xyz;
  const vec3 u3 = x(corner.w).xyz;
  const vec3 u01 = x(middle.x).xyz;
  const vec3 u12 = x(middle.y).xyz;
  const vec3 u20 = x(middle.z).xyz;
  const vec3 u03 = x(middle.w).xyz;
  const vec3 u13 = x(rest.x).xyz;
  const vec3 u23 = x(rest.y).xyz;
  tensor s0 = corner_stress(lame, u0, u1, u01, g1, u2, u20, g2, u3, u03, g3);
  tensor s1 = corner_stress(lame, u1, u0, u01, g0, u2, u12, g2, u3, u13, g3);
  tensor s2 = corner_stress(lame, u2, u0, u20, g0, u1, u12, g1, u3, u23, g3);
  tensor s3 = corner_stress(lame, u3, u0, u03, g0, u1, u13, g1, u2, u23, g2);
  const tensor sum = add(add(s0, s1), add(s2, s3));
  s0 = add(s0, sum);
  s1 = add(s1, sum);
  s2 = add(s2, sum);
  s3 = add(s3, sum);
  const tensor all = add(add(s0, s1), add(s2, s3));
  put(e, 0, corner_force(s0, all, g0));
  put(e, 1, corner_force(s1, all, g1));
  put(e, 2, corner_force(s2, all, g2));
  put(e, 3, corner_force(s3, all, g3));
  put(e, 4, 4 * (times(s0, g1) + times(s1, g0)));
  put(e, 5, 4 * (times(s1, g2) + times(s2, g1)));
  put(e, 6, 4 * (times(s0, g2) + times(s2, g0)));
  put(e, 7, 4 * (times(s0, g3) + times(s3, g0)));
  put(e, 8, 4 * (times(s1, g3) + times(s3, g1)));
  put(e, 9, 4 * (times(s2, g3) + times(s3, g2)));
}

void main() {
  for (uint e = first_row(); e < push.rows; e += stride())
    element_forces(e);
}
