#version 450
// SPDX-License-Identifier: AGPL-3.0-or-later
// to = from, one vec4 an invocation and stride: what a product's share of the bandwidth is measured against.
#extension GL_GOOGLE_include_directive : require
#include "rows_bindings.h"
#include "kernel.glsl"

layout(set = 0, binding = 0) readonly buffer b0 { vec4 from[]; };
layout(set = 0, binding = 1) writeonly buffer b1 { vec4 to[]; };

void main() {
  for (uint i = first_row(); i < push.rows; i += stride())
    to[i] = from[i];
}
