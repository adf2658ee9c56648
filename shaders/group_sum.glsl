// SPDX-License-Identifier: AGPL-3.0-or-later
shared float lanes[1024];

// The sum of one value per invocation, in a fixed order; the same for all invocations.
float group_sum(float value) {
  lanes[gl_LocalInvocationID.x] = value;
  barrier();
  for (uint width = group_size / 2; width > 0; width /= 2) {
    if (gl_LocalInvocationID.x < width)
      lanes[gl_LocalInvocationID.x] += lanes[gl_LocalInvocationID.x + width];
    barrier();
  }
  const float sum = lanes[0];
  barrier();
  return sum;
}
