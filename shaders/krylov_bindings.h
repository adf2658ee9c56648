// SPDX-License-Identifier: AGPL-3.0-or-later
// Of the vectors and scalars of conjugate gradients.
#include "bindings.h"

// Modes of krylov_scalars (specialisation constant 2).
#define TEDIT_KRYLOV_BEGIN 0
#define TEDIT_KRYLOV_ALPHA 1
#define TEDIT_KRYLOV_BETA 2

// krylov_scalars::state
#define TEDIT_KRYLOV_RUNNING 0
#define TEDIT_KRYLOV_CONVERGED 1
#define TEDIT_KRYLOV_BROKEN_DOWN 2

#define TEDIT_KRYLOV_KEPT 100  // first iterations whose alpha and beta are kept

TEDIT_NAMES(krylov_at)
TEDIT_BINDING(u, 0)       // correction
TEDIT_BINDING(p, 1)       // direction
TEDIT_BINDING(q, 2)       // K p
TEDIT_BINDING(r, 3)       // residual
TEDIT_BINDING(filter, 4)  // S
TEDIT_BINDING(z, 5)       // B r
TEDIT_BINDING(partials, 7)
TEDIT_BINDING(scalars, 8)  // a krylov_scalars for each case
TEDIT_BINDING(gates, 9)    // group counts of the dispatches; w: while running
TEDIT_END

TEDIT_SHARED
struct krylov_push {
  uint rows;
  uint from;
  uint first_sum;  // place of the first partial sum
  uint sums;       // of each number, that krylov_scalars adds up
};
TEDIT_PUSH(krylov_push)

// Of one case.
struct krylov_scalars {
  // Set before the first sum.
  float smallest;    // at most the smallest eigenvalue of B K
  float reduction2;  // square of the wanted reduction of sqrt(r.z)
  float enough;      // and of |r|; then: stop when r.r is at most this
  float energy2;     // stop when e.Ke is at most this,
  float share2;      // or this times what was gained

  uint state;
  uint iterations;
  float delta;      // r.z
  float start;      // r.z of the first iteration
  float threshold;  // stop when r.z is at most this
  float factor;     // alpha, then beta
  float radau;      // times r.z, this bounds e.Ke: see energy_bound.hpp
  float gained;     // by how much e.Ke has fallen
  float alpha[TEDIT_KRYLOV_KEPT];
  float beta[TEDIT_KRYLOV_KEPT];
};
TEDIT_END
