// SPDX-License-Identifier: AGPL-3.0-or-later
// Shared by the assembly kernels and by C++: buffers and push constants.
#ifndef TEDIT_ELASTICITY_BINDINGS_H
#define TEDIT_ELASTICITY_BINDINGS_H

#define TEDIT_BIND_POSITION_HIGH 0   // vec4 per node: position / size, leading part
#define TEDIT_BIND_POSITION_LOW 1    // vec4 per node: what the leading part lacks
#define TEDIT_BIND_ELEMENT_NODES 2   // uvec4 per element
#define TEDIT_BIND_ELEMENT_LAME 3    // vec2 per element: lambda, mu, divided by the stiffness scale
#define TEDIT_BIND_CORNER_ROWS 4     // uvec2 per node: first and last in CORNERS
#define TEDIT_BIND_CORNERS 5         // uint: element * 4 + local node
#define TEDIT_BIND_SLICES 6          // uint pair per slice: first entry, width and a mark (counting: columns per row)
#define TEDIT_BIND_BLOCKS 7          // 5 uvec4 per two entries: see split_block.glsl
#define TEDIT_BIND_LISTED 8          // uint: rows that are to be gathered again
#define TEDIT_BINDINGS 9

#ifdef __cplusplus
#include <cstdint>
namespace tedit::fem {
using uint = std::uint32_t;
#define TEDIT_PUSH struct push_constants
#else
#define TEDIT_PUSH layout(push_constant) uniform push_constants
#endif

TEDIT_PUSH {
  uint first_row;   // of the chunk
  uint rows;        // of the chunk
  uint listed;      // 1: the rows are places in LISTED (assemble_rows)
#ifdef __cplusplus
};
static_assert(sizeof(push_constants) == 12);
}  // namespace tedit::fem
#else
} push;
#endif

#endif
