// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>

#include "fem/multilevel/quadratic_level.hpp"
#include "fem/vulkan/vulkan_smoother.hpp"

namespace tedit::fem {

/// Block rows of six unknowns on the device, cut into ranges that fit a binding: a level of rigid
/// motions, its prolongation or its restriction.
class vulkan_rigid_rows {
public:
  /// Row i has the entries `first[i] .. first[i + 1]`; `entry(s)` gives the column and the block of
  /// one, column by column.
  template <class Entry>
  vulkan_rigid_rows(vulkan_memory& memory, std::span<const std::uint32_t> first, Entry&& entry);
  void add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
           cycle_push push) const;

private:
  struct piece {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    gpu::buffer first, columns, blocks;
  };
  std::vector<piece> parts_;
};

/// The levels of rigid motions on the device, the coarsest one as a dense inverse.
class vulkan_rigid_cycle {
public:
  vulkan_rigid_cycle(vulkan_memory& memory, const hierarchy& h, const cycle_settings& settings,
                     double scale);

  vulkan_rigid_cycle(const vulkan_rigid_cycle&) = delete;

  /// Adds z = about A_1^-1 right.
  void add(vulkan_program& program) { solve(program, 0); }

  [[nodiscard]] const gpu::buffer& right() const { return levels_.front().right; }
  [[nodiscard]] const gpu::buffer& z() const { return levels_.front().z; }

private:
  struct level {
    const rigid_level* host = nullptr;
    std::optional<vulkan_rigid_rows> matrix, up, down;
    gpu::buffer inverse, right, z, again, residual, first, second;
    gpu::buffer* step = &first;
    gpu::buffer* other = &second;
  };

  void upload(vulkan_memory& memory, const rigid_level& from, bool last, double scale);
  void solve(vulkan_program& program, std::size_t at);
  void once(vulkan_program& program, std::size_t at, const gpu::buffer& right, bool again);
  void move(vulkan_program& program, level& l, chebyshev_weights weights, float enter);

  cycle_settings settings_;
  std::deque<level> levels_;  ///< Never moved: levels point into themselves.
  gpu::buffer dense_;
};

/// One symmetric multilevel cycle on linear tets: the counterpart of `multilevel_cycle`.
class vulkan_cycle {
public:
  /// `k` and `h` must outlive the cycle.
  vulkan_cycle(vulkan_memory& memory, const row_operator& k, const hierarchy& h, filter_span filter,
               const cycle_settings& settings, double scale);

  /// Adds z = about (S K S)^-1 right.
  void add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  cycle_settings settings_;
  std::uint32_t nodes_, aggregates_;
  vulkan_smoother smoother_;
  vulkan_rigid_cycle rigid_;
  gpu::buffer arms_, member_first_, members_;
};

/// The cycle on quadratic tets over the one of their corners: the counterpart of `quadratic_cycle`.
class vulkan_quadratic_cycle {
public:
  /// All arguments but `edges`, `filter` and `scale` must outlive the cycle.
  vulkan_quadratic_cycle(vulkan_memory& memory, const row_operator& k, const node_smoother& s,
                         const edge_transfer& edges, filter_span filter, vulkan_cycle& corners,
                         int degree, double scale);

  void add(vulkan_program& program, const gpu::buffer& right, const gpu::buffer& z);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  std::uint32_t nodes_, corner_count_;
  int degree_;
  vulkan_smoother smoother_;
  vulkan_cycle& corners_;
  gpu::buffer ends_, middle_first_, middles_, coarse_right_, coarse_;
};

}  // namespace tedit::fem
