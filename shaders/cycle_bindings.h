// SPDX-License-Identifier: AGPL-3.0-or-later
// Shared by the solver's kernels and by C++: bindings, modes, push constants, places of the scalars. Each kernel says
// at its top which of the ten bindings it uses for what; the others hold any buffer.
#ifndef TEDIT_CYCLE_BINDINGS_H
#define TEDIT_CYCLE_BINDINGS_H

#define TEDIT_CYCLE_BINDINGS 10

// What becomes of row i of y = K x (specialisation constant 2 of node_rows, quadratic_rows, rigid_rows).
#define TEDIT_MULTIPLY 0    // r = y, partial sums of x.y
#define TEDIT_RESIDUAL 1    // r = S (r - y)
#define TEDIT_MOVE 2        // a Chebyshev step: see finish_row
#define TEDIT_ACCUMULATE 3  // sum += y (quadratic_rows with more than one range of elements)

// How node_rows reads the values of the matrix (its specialisation constant 3).
#define TEDIT_READ_EXACTLY 0  // to the bit
#define TEDIT_READ_ROUNDED 1
#define TEDIT_READ_MIXED 2    // rounded, but in slices that are marked (slices.h)

// Modes of cg_scalars.
#define TEDIT_CG_BEGIN 0
#define TEDIT_CG_ALPHA 1
#define TEDIT_CG_BETA 2

// Places in the scalars of one case; those of the next one follow.
#define TEDIT_CG_DELTA 0      // r.z
#define TEDIT_CG_THRESHOLD 1  // stop when r.z is at most this
#define TEDIT_CG_STATE 2      // 0 running, 1 converged, 2 broken down
#define TEDIT_CG_ITERATIONS 3
#define TEDIT_CG_FACTOR 4     // alpha, then beta
#define TEDIT_CG_START 5      // r.z of the first iteration
#define TEDIT_CG_RADAU 6      // times r.z, this bounds e.Ke: see energy_bound.hpp
#define TEDIT_CG_GAINED 7     // by how much e.Ke has fallen
#define TEDIT_CG_ENERGY2 8    // stop when e.Ke is at most this,
#define TEDIT_CG_SHARE2 9     // or this times what was gained
#define TEDIT_CG_SMALLEST 10  // at most the smallest eigenvalue of B K
#define TEDIT_CG_REDUCTION2 11  // square of the wanted reduction of sqrt(r.z),
#define TEDIT_CG_ENOUGH 12    // and of |r|: these and the three before are set before the first sum. Then: stop when r.r
                              // is at most this
#define TEDIT_CG_HISTORY 13   // alpha and beta of the first iterations
#define TEDIT_CG_KEPT 100     // of so many
#define TEDIT_CG_SCALARS (TEDIT_CG_HISTORY + 2 * TEDIT_CG_KEPT)

// Numbers of workgroups that a dispatch of the loop can have: powers of two, at most 65535.
#define TEDIT_GATES 17

#ifdef __cplusplus
#include <cstdint>
namespace tedit::fem::vulkan {
using uint = std::uint32_t;
#define TEDIT_CYCLE_PUSH struct cycle_push
#else
#define TEDIT_CYCLE_PUSH layout(push_constant) uniform cycle_push
#endif

TEDIT_CYCLE_PUSH {
  uint rows;       // up to which this dispatch goes,
  uint from;       // and where it starts
  uint first_row;
  uint count;      // entries of a row, corners, aggregates, room for elements: see the kernel
  uint place;      // of the first partial sum
  float before;    // Chebyshev weights: next step = before * old step + fresh * B r
  float fresh;
  float enter;     // how much of the old step enters z
#ifdef __cplusplus
};
static_assert(sizeof(cycle_push) == 32);
}  // namespace tedit::fem::vulkan
#else
} push;
#endif

#endif
