// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>

#include "fem/block_matrix.hpp"
#include "fem/vulkan/changes.hpp"
#include "fem/vulkan/row_operator.hpp"

namespace tedit::fem::vulkan {

/// By what a problem's numbers are divided, so that single precision works near one: lengths by
/// the part's size, stiffnesses by the largest Lame constant, both taken up to a power of two, so
/// that numbers keep their digits.
struct device_scale {
  double size = 1;       ///< m
  double stiffness = 1;  ///< Pa

  explicit device_scale(const problem& p);
  /// What the device holds of a stiffness, N/m, times this is the stiffness.
  [[nodiscard]] double matrix() const { return size * stiffness; }
};

/// The matrix of linear tets on the device, in difference form and in halves: the host's numbers in
/// sliced rows (shaders/split_block.glsl), cut into ranges that fit a binding.
class sliced_matrix final : public row_operator {
public:
  /// `kernels` and `memory` must outlive the matrix. Ask `memory` for its status afterwards. Cost:
  /// O(blocks), on all cores, and their upload.
  sliced_matrix(const kernel_set& kernels, device_memory& memory, const block_matrix& k,
                const device_scale& scale);

  std::uint32_t rows() const override { return rows_; }
  std::uint32_t most_partials(const kernel_set& kernels) const override;
  /// Bytes of the matrix that a product reads.
  [[nodiscard]] std::uint64_t read_bytes() const;
  std::uint32_t add(device_program& program, std::uint32_t mode, const row_buffers& at,
                    row_push push) const override;

  /// Smoothers read all but these rows rounded (`hierarchy::exact_rows`; empty: there are none);
  /// until then they read all exactly. What was recorded is to be recorded again.
  [[nodiscard]] expected<void> read_exactly(std::span<const std::uint8_t> rows);
  /// `rows` (ascending) of `k` changed, `exact` is as for `read_exactly`. Cost: O(rows) bytes, and
  /// the slices of those that changed.
  void update(const block_matrix& k, std::span<const std::uint32_t> rows,
              std::span<const std::uint8_t> exact, device_changes& changes);

private:
  using texel = std::array<std::uint32_t, 4>;
  /// A range of rows whose blocks fit into one binding.
  struct chunk {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    roomy_places slices;  ///< Of the blocks, by entries.
    gpu::buffer blocks;
  };

  void add_chunk(const block_matrix& k, std::uint32_t first_row,
                 std::span<const std::uint32_t> entries);
  void pack_slice(const block_matrix& k, const chunk& part, std::uint32_t slice,
                  std::span<texel> to) const;
  void pack_entry(const block_matrix& k, std::size_t entry, std::uint32_t width,
                  std::uint32_t place, std::uint32_t lane, std::span<texel> to) const;
  void update_chunk(const block_matrix& k, chunk& part, std::span<const std::uint32_t> rows,
                    std::span<const std::uint8_t> before, device_changes& changes);
  [[nodiscard]] std::uint32_t entries_of(const block_matrix& k, std::uint32_t first_row) const;
  [[nodiscard]] std::array<std::uint32_t, 2> slice_at(const chunk& part, std::uint32_t slice) const;
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> all_slices() const;
  [[nodiscard]] std::vector<std::uint8_t> slices_of(std::span<const std::uint8_t> rows) const;
  [[nodiscard]] std::uint32_t reading_of(std::uint32_t mode) const;

  device_memory& memory_;
  std::uint32_t per_slice_;
  float scale_;  ///< The host's numbers times this are the device's.
  std::uint32_t rows_;
  gpu::buffer slices_;
  std::deque<chunk> chunks_;
  std::vector<std::uint8_t> exact_slices_;  ///< 1: smoothers read them exactly.
};

}  // namespace tedit::fem::vulkan
