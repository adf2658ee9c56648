// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "base/execution.hpp"
#include "mesh/vec3.hpp"

namespace tedit::ops {

/// A piece of a mesh in numbers of its own: vertices whose value is given, and free ones. Each free
/// vertex has all its tets here and hangs together with a given one.
struct field_piece {
  std::vector<vec3> at;  ///< m.
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<std::uint8_t> is_free;  ///< By vertex.
};

/// Fields over a piece that bend as little as possible: those of least energy of the integral of
/// (Laplacian)^2, linear in each tet, whose value and slope end where they are given (biharmonic).
/// Nothing is bounded by what is given: such a field may overshoot by some percent. Source: Botsch
/// and Kobbelt 2004, An intuitive framework for real-time freeform modeling; Jacobson and others
/// 2010, Mixed finite elements for variational surface modeling.
class smooth_field {
public:
  /// Errors: `degenerate_tet` where tets without volume leave no equations. Cost: a sparse Cholesky
  /// factorisation of the free vertices' Laplacian: 10 ms for 2,000, 0.3 s for 20,000.
  [[nodiscard]] static expected<smooth_field> create(const field_piece& piece);

  /// The field with these values at the given vertices; those of free ones are where it begins.
  /// Errors: `cancelled`, `not_converged`. Cost: some ten solutions with the factors.
  [[nodiscard]] expected<std::vector<double>> through(std::vector<double> values,
                                                      const cancel_token& cancel) const;

  /// The field that a load at free vertices makes, as one bends a plate: 0 where values are given.
  /// Errors and cost: the same.
  [[nodiscard]] expected<std::vector<double>> bent_by(const std::vector<double>& load,
                                                      const cancel_token& cancel) const;

private:
  struct equations;

  std::shared_ptr<const equations> equations_;
};

}  // namespace tedit::ops
