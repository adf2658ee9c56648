// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>

#include "fem/vulkan/smoother.hpp"

namespace tedit::fem::vulkan {

/// Block rows of six unknowns on the device, cut into ranges that fit a binding: a level of rigid
/// motions, its prolongation or its restriction.
class rigid_rows {
public:
  /// Where the rows come from; what it refers to must outlive them. `entry(row, k)` gives the
  /// column and the block, column by column, of one entry.
  struct source {
    std::function<std::uint32_t()> rows;
    std::function<std::uint32_t(std::uint32_t row)> length;
    std::function<std::pair<std::uint32_t, rigid_level::block6>(std::uint32_t row, std::uint32_t k)>
      entry;
  };

  rigid_rows(device_memory& memory, source from);
  void add(device_program& program, std::uint32_t mode, const row_buffers& at, row_push push) const;
  /// `rows` (ascending) changed; more may have been added.
  void update(std::span<const std::uint32_t> rows, device_changes& changes);

private:
  struct piece {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    row_table table;
    gpu::buffer columns, blocks;
  };

  void add_piece(device_memory& memory, std::uint32_t first_row,
                 std::span<const std::uint32_t> lengths);
  void append_row(std::uint32_t row, std::vector<std::uint32_t>& columns,
                  std::vector<rigid_level::block6>& blocks) const;

  source from_;
  std::deque<piece> parts_;
};

/// The levels of rigid motions on the device, the coarsest one as a dense inverse.
class rigid_cycle {
public:
  rigid_cycle(device_memory& memory, const hierarchy& h, const cycle_settings& settings,
              double scale);

  rigid_cycle(const rigid_cycle&) = delete;

  /// As `smoother::widen`.
  void widen(device_memory& memory, std::uint32_t cases);
  /// Adds z = about A_1^-1 right.
  void add(device_program& program) { solve(program, 0); }
  /// After `update_hierarchy`.
  void update(const hierarchy& h, device_changes& changes);

  [[nodiscard]] const gpu::buffer& right() const { return levels_.front().right; }
  [[nodiscard]] const gpu::buffer& z() const { return levels_.front().z; }

private:
  struct level {
    const rigid_level* host = nullptr;
    std::optional<rigid_rows> matrix, up, down;
    gpu::buffer inverse, right, z, residual, first, second;
    gpu::buffer* step = &first;
    gpu::buffer* other = &second;
  };

  void upload(device_memory& memory, const rigid_level& from, bool last);
  void solve(device_program& program, std::size_t at);
  void correct(device_program& program, std::size_t at);
  void move(device_program& program, level& l, chebyshev_weights weights, float enter);

  cycle_settings settings_;
  double scale_;
  std::uint32_t cases_ = 1;   ///< That the vectors have room for.
  std::deque<level> levels_;  ///< Never moved: levels point into themselves.
  gpu::buffer dense_;
};

}  // namespace tedit::fem::vulkan
