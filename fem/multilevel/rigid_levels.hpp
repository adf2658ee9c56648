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

/// What the levels were made from.
struct level_memory {
  std::vector<rigid_frame> frames;
  std::vector<matrix6> keep;         ///< Projector onto the motions that each aggregate has.
  std::vector<std::uint32_t> group;  ///< Aggregate of the next level; empty at the coarsest.
};

struct hierarchy_memory {
  std::vector<std::uint32_t> cluster_of;  ///< Sliver cluster of each node; empty: there are none.
  std::vector<level_memory> levels;
};

/// Unsmoothed prolongation of child i of a level: the parent's rigid motions.
[[nodiscard]] matrix6 parent_modes(const level_memory& level, const level_memory& parents,
                                   std::size_t i);

/// A block of a level in double precision.
[[nodiscard]] inline matrix6 wide(const rigid_level::block6& block) {
  return Eigen::Map<const Eigen::Matrix<float, 6, 6>>(block.data()).cast<double>();
}
inline void store(const matrix6& from, rigid_level::block6& to) {
  Eigen::Map<Eigen::Matrix<float, 6, 6>>(to.data()) = from.cast<float>();
}

/// Of a diagonal block.
[[nodiscard]] matrix6 inverse_of(const matrix6& m);

/// Row i of the prolongation (I - omega D^-1 A) P_0: rigid motions of the groups, with the energy
/// at their rims smoothed away (Vanek, Mandel & Brezina 1996). `columns` and `block_of(s)` are row
/// i of A, `modes_of(j)` are those of P_0.
template <class BlockOf, class ModesOf>
void prolongation_row(std::size_t i, std::span<const std::uint32_t> columns, BlockOf&& block_of,
                      const matrix6& scaled_inverse, std::span<const std::uint32_t> group,
                      ModesOf&& modes_of, std::vector<std::uint32_t>& column,
                      std::vector<matrix6>& block) {
  row_sum sum;
  for (std::size_t s = 0; s < columns.size(); ++s)
    sum.at(group[columns[s]]).noalias() -= block_of(s) * modes_of(columns[s]);
  sum.finish(column, block);
  for (std::size_t s = 0; s < block.size(); ++s) {
    block[s] = scaled_inverse * block[s];
    if (column[s] == group[i])
      block[s] += modes_of(i);
  }
}

/// Factors the coarsest matrix.
[[nodiscard]] std::unique_ptr<coarsest_solver> factor(const rigid_level& coarsest);

/// Gives a row of a level another content, or adds it; `renew_inverses` comes after all rows.
void replace_row(rigid_level& level, std::uint32_t row, std::span<const std::uint32_t> column,
                 std::span<const matrix6> block);

/// Inverts the diagonal blocks of these rows, on all cores.
void renew_inverses(rigid_level& level, std::span<const std::uint32_t> rows);

/// Fills the last level of `h` from the one below, whose groups are known, and whose prolongation
/// is made, too; the frames of the last level are there, its motions are found.
void build_coarser_level(hierarchy& h);

/// After `rows` of the first level changed, and with them all rows beside one with another frame:
/// everything above. Ascending; added aggregates have their group already.
void update_rigid_levels(std::vector<std::uint32_t> rows, hierarchy& h);

/// Adds coarser levels to the first one until few aggregates are left. Errors: `cancelled`.
[[nodiscard]] expected<void> add_rigid_levels(const multilevel_settings& settings,
                                              const execution& run, hierarchy& h);

}  // namespace tedit::fem
