// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

#include "fem/column_table.hpp"
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

/// Sums blocks of one row by column.
class row_sum {
public:
  /// Column c at 8 c; see six_by_six.hpp.
  struct alignas(64) block : std::array<double, 48> {};
  using view = Eigen::Map<matrix6, Eigen::Aligned64, Eigen::OuterStride<8>>;

  /// The sum of a column, zero at first. Valid until the next call.
  [[nodiscard]] block& at(std::uint32_t column) {
    const auto [number, is_new] = numbers_.at(column);
    return is_new ? add(column, number) : block_[*number];
  }
  [[nodiscard]] view matrix_at(std::uint32_t column) { return view(at(column).data()); }
  /// Appends the row, columns ascending, and begins another one.
  void finish(std::vector<std::uint32_t>& column, std::vector<matrix6>& blocks);

private:
  block& add(std::uint32_t column, std::uint32_t* number);

  column_table numbers_;
  std::vector<std::uint32_t> column_;
  std::vector<block> block_;  ///< More than columns: memory is kept from row to row.
};

/// Removes the motions of an aggregate that move none of its nodes: `gram` is sum P^T P of its
/// nodes. Adds stiffness in them to `diagonal` and returns the projector onto the others.
[[nodiscard]] matrix6 remove_null_motions(const matrix6& gram, row_sum::view diagonal);

/// What the levels were made from.
struct level_memory {
  std::vector<rigid_frame> frames;
  std::vector<matrix6> keep;         ///< Projector onto the motions that each aggregate has.
  std::vector<std::uint32_t> group;  ///< Aggregate of the next level; empty at the coarsest.
};

struct hierarchy_memory {
  std::vector<std::uint32_t> cluster_of;  ///< Sliver cluster of each node; empty: there are none.
  bool read_exactly = false;              ///< Rounded values were not good enough.
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

/// Factors the coarsest matrix. Errors: `not_converged` when it has no Cholesky factors even with a
/// shift of 1 % of its mean diagonal.
[[nodiscard]] expected<std::unique_ptr<coarsest_solver>> factor(const rigid_level& coarsest);

/// Room for `rows` (each once) of so many items, `length(i)` of rows[i], new rows included; where
/// each starts.
template <class Length>
[[nodiscard]] std::vector<std::uint32_t> make_room(row_places& places,
                                                   std::span<const std::uint32_t> rows,
                                                   const Length& length) {
  std::vector<std::uint32_t> at(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    while (rows[i] >= places.size())
      places.add(0);
    at[i] = places.replace(rows[i], static_cast<std::uint32_t>(length(i)));
  }
  return at;
}

/// Gives rows of a level (each once) another content, or adds them: `content(i)` has the columns
/// and blocks of rows[i]. On all cores; `renew_inverses` comes after it.
template <class Content>
void replace_rows(rigid_level& level, std::span<const std::uint32_t> rows, const Content& content) {
  const auto at =
    make_room(level.rows, rows, [&](std::size_t i) { return content(i).column.size(); });
  if (level.column.empty()) {
    reserve_for_edits(level.column, level.rows.room());
    reserve_for_edits(level.block, level.rows.room());
  }
  level.column.resize(level.rows.room());
  level.block.resize(level.rows.room());
  constexpr std::size_t rows_per_chunk = 64;
  parallel_for(
    rows.size(),
    [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t i = first; i < last; ++i) {
        std::ranges::copy(content(i).column, level.column.begin() + at[i]);
        for (std::size_t s = 0; s < content(i).block.size(); ++s)
          store(content(i).block[s], level.block[at[i] + s]);
      }
    },
    rows_per_chunk);
}

/// Inverts the diagonal blocks of these rows, on all cores.
void renew_inverses(rigid_level& level, std::span<const std::uint32_t> rows);

/// Fills the last level of `h` from the one below, whose groups are known, and whose prolongation
/// is made, too; the frames of the last level are there, its motions are found.
void build_coarser_level(hierarchy& h);

/// After `rows` of the first level changed, and with them all rows beside one with another frame:
/// everything above. Ascending; added aggregates have their group already. Errors: those of
/// `factor`.
[[nodiscard]] expected<void> update_rigid_levels(std::vector<std::uint32_t> rows, hierarchy& h);

/// Adds coarser levels to the first one until few aggregates are left. Errors: `cancelled`, those
/// of `factor`.
[[nodiscard]] expected<void> add_rigid_levels(const multilevel_settings& settings,
                                              const execution& run, hierarchy& h);

}  // namespace tedit::fem
