// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>

#include "fem/multilevel/quadratic_level.hpp"
#include "fem/vulkan/vulkan_smoother.hpp"

namespace tedit::fem {

/// Block rows of six unknowns on the device, cut into ranges that fit a binding: a level of rigid
/// motions, its prolongation or its restriction.
class vulkan_rigid_rows {
public:
  /// Where the rows come from; what it refers to must outlive them. `entry(row, k)` gives the
  /// column and the block, column by column, of one entry.
  struct source {
    std::function<std::uint32_t()> rows;
    std::function<std::uint32_t(std::uint32_t row)> length;
    std::function<std::pair<std::uint32_t, rigid_level::block6>(std::uint32_t row, std::uint32_t k)>
      entry;
  };

  vulkan_rigid_rows(vulkan_memory& memory, source from);
  void add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
           cycle_push push) const;
  /// `rows` (ascending) changed; more may have been added.
  void update(std::span<const std::uint32_t> rows, vulkan_changes& changes);

private:
  struct piece {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    vulkan_row_table table;
    gpu::buffer columns, blocks;
  };

  void add_piece(vulkan_memory& memory, std::uint32_t first_row,
                 std::span<const std::uint32_t> lengths);
  void append_row(std::uint32_t row, std::vector<std::uint32_t>& columns,
                  std::vector<rigid_level::block6>& blocks) const;

  source from_;
  std::deque<piece> parts_;
};

/// The levels of rigid motions on the device, the coarsest one as a dense inverse.
class vulkan_rigid_cycle {
public:
  vulkan_rigid_cycle(vulkan_memory& memory, const hierarchy& h, const cycle_settings& settings,
                     double scale);

  vulkan_rigid_cycle(const vulkan_rigid_cycle&) = delete;

  /// As `vulkan_smoother::widen`.
  void widen(vulkan_memory& memory, std::uint32_t cases);
  /// Adds z = about A_1^-1 right.
  void add(vulkan_program& program) { solve(program, 0); }
  /// After `update_hierarchy`.
  void update(const hierarchy& h, vulkan_changes& changes);

  [[nodiscard]] const gpu::buffer& right() const { return levels_.front().right; }
  [[nodiscard]] const gpu::buffer& z() const { return levels_.front().z; }

private:
  struct level {
    const rigid_level* host = nullptr;
    std::optional<vulkan_rigid_rows> matrix, up, down;
    gpu::buffer inverse, right, z, residual, first, second;
    gpu::buffer* step = &first;
    gpu::buffer* other = &second;
  };

  void upload(vulkan_memory& memory, const rigid_level& from, bool last);
  void solve(vulkan_program& program, std::size_t at);
  void correct(vulkan_program& program, std::size_t at);
  void move(vulkan_program& program, level& l, chebyshev_weights weights, float enter);

  cycle_settings settings_;
  double scale_;
  std::uint32_t cases_ = 1;   ///< That the vectors have room for.
  std::deque<level> levels_;  ///< Never moved: levels point into themselves.
  gpu::buffer dense_;
};

/// One symmetric multilevel cycle on linear tets: the counterpart of `multilevel_cycle`.
class vulkan_cycle {
public:
  /// `k` and `h` must outlive the cycle.
  vulkan_cycle(vulkan_memory& memory, const row_operator& k, const hierarchy& h, filter_span filter,
               const cycle_settings& settings, double scale);

  /// As `vulkan_smoother::widen`.
  void widen(vulkan_memory& memory, std::uint32_t cases) {
    smoother_.widen(memory, cases);
    rigid_.widen(memory, cases);
  }
  /// Adds z = about (S K S)^-1 right.
  void add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z);
  /// After `update_hierarchy`; `filter` changed at `nodes`, ascending.
  void update(filter_span filter, std::span<const std::uint32_t> nodes, vulkan_changes& changes);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  [[nodiscard]] std::array<std::uint32_t, 4> arm_of(std::uint32_t node) const;
  [[nodiscard]] std::uint32_t aggregates() const { return hierarchy_.levels.front().nodes(); }

  const hierarchy& hierarchy_;
  cycle_settings settings_;
  std::uint32_t nodes_;
  vulkan_smoother smoother_;
  vulkan_rigid_cycle rigid_;
  gpu::buffer arms_;
  vulkan_lists members_;
};

/// The cycle on quadratic tets over the one of their corners: the counterpart of `quadratic_cycle`.
class vulkan_quadratic_cycle {
public:
  /// All arguments but `filter` and `scale` must outlive the cycle.
  vulkan_quadratic_cycle(vulkan_memory& memory, const row_operator& k, const node_smoother& s,
                         const edge_transfer& edges, filter_span filter, vulkan_cycle& corners,
                         int degree, double scale);

  void add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z);
  /// After smoother and edges followed an edit, which added those from number `old_edges` on;
  /// `filter` changed at `nodes`, ascending.
  void update(filter_span filter, std::span<const std::uint32_t> nodes, std::size_t old_edges,
              vulkan_changes& changes);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  const row_operator& k_;
  const edge_transfer& edges_;
  std::uint32_t corner_count_;
  int degree_;
  vulkan_smoother smoother_;
  vulkan_cycle& corners_;
  gpu::buffer ends_, coarse_right_, coarse_;
  vulkan_lists middles_;
};

}  // namespace tedit::fem
