// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

#include "fem/multilevel/hierarchy.hpp"

/// The steps of `build_hierarchy`; internal to fem/multilevel/.
namespace tedit::fem {

using matrix6 = Eigen::Matrix<double, 6, 6>;
using matrix36 = Eigen::Matrix<double, 3, 6>;

/// Where an aggregate sits: the mean of its nodes and their root-mean-square distance from it.
struct rigid_frame {
  vec3 centre;
  double radius = 1;
};

/// [I, -[arm]x]: the displacement at `arm` of a unit translation or rotation.
[[nodiscard]] matrix36 rigid_modes(vec3 arm);

/// A block matrix with six unknowns a row while it is built.
struct rigid_rows {
  std::vector<std::vector<std::uint32_t>> column;
  std::vector<std::vector<matrix6>> block;
};

/// Sums blocks of one row by column; few columns, so that a linear search wins.
class row_sum {
public:
  matrix6& at(std::uint32_t column);
  /// Moves the row out, columns ascending.
  void finish(std::vector<std::uint32_t>& column, std::vector<matrix6>& block);

private:
  std::vector<std::uint32_t> column_;
  std::vector<matrix6> block_;
};

/// Removes the motions of an aggregate that move none of its nodes: `gram` is sum P^T P of its
/// nodes. Adds stiffness in them to `diagonal` and returns the projector onto the others.
[[nodiscard]] matrix6 remove_null_motions(const matrix6& gram, matrix6& diagonal);

/// Stores a level and adds coarser ones until few aggregates are left. `keep[i]` projects onto the
/// motions that node i has.
[[nodiscard]] expected<void> add_rigid_levels(rigid_rows rows, std::vector<rigid_frame> frames,
                                              std::vector<matrix6> keep,
                                              const multilevel_settings& settings,
                                              const execution& run, hierarchy& result);

}  // namespace tedit::fem
