// SPDX-License-Identifier: AGPL-3.0-or-later
// Shared by the kernels and by C++: buffers, push constants, places of the scalars.
#ifndef TEDIT_ELASTICITY_BINDINGS_H
#define TEDIT_ELASTICITY_BINDINGS_H

#define TEDIT_BIND_POSITION_HIGH 0   // vec4 per node: position / size, leading part
#define TEDIT_BIND_POSITION_LOW 1    // vec4 per node: what the leading part lacks
#define TEDIT_BIND_ELEMENT_NODES 2   // uvec4 per element
#define TEDIT_BIND_ELEMENT_LAME 3    // vec2 per element: lambda, mu, divided by the stiffness scale
#define TEDIT_BIND_CORNER_FIRST 4    // uint per node + 1: start in CORNERS
#define TEDIT_BIND_CORNERS 5         // uint: element * 4 + local node
#define TEDIT_BIND_SLICES 6          // uint pair per slice: first entry, width (counting: columns per row)
#define TEDIT_BIND_BLOCKS 7          // 3 uvec4 per entry: column, 9 values (row-major), 2 unused
#define TEDIT_BIND_FILTER 8          // 2 vec4 per node: S as xx xy xz yy | yz zz
#define TEDIT_BIND_INVERSE 9         // 2 vec4 per node: S (SDS + I-S)^-1 S, same order
#define TEDIT_BIND_U 10              // vec4 per node: correction
#define TEDIT_BIND_R 11              // vec4 per node: residual
#define TEDIT_BIND_C 12              // vec4 per node: direction
#define TEDIT_BIND_Q 13              // vec4 per node: S K c, then P^-1 r
#define TEDIT_BIND_SCALARS 14        // float: see TEDIT_SCALAR_...; then the partial sums
#define TEDIT_BIND_COUNTS 15         // 3 uint: groups of the next iteration, zero when done
#define TEDIT_BINDINGS 16

#define TEDIT_SCALAR_DELTA 0       // r.s of even and odd iterations (2 floats)
#define TEDIT_SCALAR_THRESHOLD 2   // stop when r.s is at most this
#define TEDIT_SCALAR_STATE 3       // 0 running, 1 converged, 2 broken down
#define TEDIT_SCALAR_ITERATIONS 4
#define TEDIT_SCALAR_PARTIALS 8    // partial sums of r.s (groups), then of c.q (chunks * groups)

#ifdef __cplusplus
#include <cstdint>
namespace tedit::fem {
using uint = std::uint32_t;
#define TEDIT_PUSH struct push_constants
#else
#define TEDIT_PUSH layout(push_constant) uniform push_constants
#endif

TEDIT_PUSH {
  uint nodes;
  uint elements;
  uint first_row;   // of the chunk
  uint rows;        // of the chunk
  uint groups;      // workgroups of a vector kernel
  uint chunk;       // number of the chunk
  uint chunks;
  uint parity;      // of the iteration; 2: multiply without the filter
  float reduction2; // square of the wanted reduction
#ifdef __cplusplus
};
static_assert(sizeof(push_constants) == 36);
}  // namespace tedit::fem
#else
} push;
#endif

#endif
