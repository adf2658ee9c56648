#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// The first direction is the preconditioned residual; the correction starts at zero.
#extension GL_GOOGLE_include_directive : require
#include "cycle.glsl"

layout(set = 0, binding = 0) writeonly buffer b0 { vec4 u[]; };
layout(set = 0, binding = 2) readonly buffer b2 { vec4 z[]; };
layout(set = 0, binding = 6) writeonly buffer b6 { vec4 p[]; };

void main() {
  for (uint n = gl_GlobalInvocationID.x; n < push.rows; n += stride()) {
    u[n] = vec4(0);
    p[n] = z[n];
  }
}
