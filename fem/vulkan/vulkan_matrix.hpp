// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>

#include "fem/problem_update.hpp"
#include "fem/vulkan/vulkan_changes.hpp"
#include "fem/vulkan/vulkan_rows.hpp"
#include "shaders/elasticity_bindings.h"
#include "shaders/slices.h"

namespace tedit::fem {

/// By what a problem's numbers are divided, so that single precision works near one: lengths by
/// the part's size, stiffnesses by the largest elasticity constant, both taken up to a power of
/// two, so that rounded values of the matrix are the ones that the host rounds.
struct device_scale {
  double size = 1;       ///< m
  double stiffness = 1;  ///< Pa
  vec3 centre;           ///< m; positions are sent from here.

  explicit device_scale(const problem& p);
  /// What the device holds of a stiffness, N/m, times this is the stiffness.
  [[nodiscard]] double matrix() const { return size * stiffness; }
};

/// The matrix of the linear tets at the corners of a problem of any order, assembled on the device
/// in difference form: sliced rows, cut into ranges that fit a binding.
class vulkan_matrix final : public row_operator {
public:
  /// `kernels` and `memory` must outlive the matrix, `p` and `corners` the call.
  [[nodiscard]] static expected<std::unique_ptr<vulkan_matrix>> make(
    std::shared_ptr<gpu::device> on, const cycle_kernels& kernels, vulkan_memory& memory,
    const problem& p, const incidence& corners, const device_scale& scale);

  std::uint32_t rows() const override { return nodes_; }
  std::uint32_t most_partials(const cycle_kernels& kernels) const override;
  /// Bytes of the matrix that a product reads.
  [[nodiscard]] std::uint64_t read_bytes() const;
  std::uint32_t add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                    cycle_push push) const override;

  /// Smoothers read all but these rows rounded (`hierarchy::exact_rows`; empty: there are none);
  /// until then they read all exactly. What was recorded is to be recorded again.
  [[nodiscard]] expected<void> read_exactly(std::span<const std::uint8_t> rows);
  /// Follows `change` of the mesh; `lengths` are those of the rows now, `exact` as for
  /// `read_exactly`. When `changes` are sent, `gather_again` assembles the rows that it touched.
  void update(const problem& p, const incidence& corners, const row_places& lengths,
              std::span<const std::uint8_t> exact, const problem_change& change,
              vulkan_changes& changes);
  [[nodiscard]] expected<void> gather_again();

private:
  /// A range of rows whose blocks fit into one binding.
  struct chunk {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    roomy_places slices;  ///< Of the blocks, by entries.
    gpu::buffer blocks;
    std::vector<std::uint32_t> listed;  ///< Rows to be gathered again.
  };

  vulkan_matrix(const cycle_kernels& kernels, vulkan_memory& memory, const problem& p,
                const device_scale& scale);

  [[nodiscard]] expected<void> build(std::shared_ptr<gpu::device> on, const problem& p,
                                     const incidence& corners);
  [[nodiscard]] expected<void> upload_mesh(const problem& p, const incidence& corners);
  [[nodiscard]] expected<std::vector<std::uint32_t>> count_columns();
  [[nodiscard]] expected<void> cut_chunks(const std::vector<std::uint32_t>& columns);
  [[nodiscard]] expected<void> upload_slices();
  void add_chunk(std::uint32_t first_row, std::uint32_t rows,
                 std::span<const std::uint32_t> entries);
  [[nodiscard]] std::array<std::uint32_t, 2> slice_at(const chunk& part, std::uint32_t slice) const;
  [[nodiscard]] std::vector<std::uint8_t> slices_of(std::span<const std::uint8_t> rows) const;
  [[nodiscard]] std::uint32_t reading_of(std::uint32_t mode) const;
  void update_mesh(const problem& p, const incidence& corners, const problem_change& change,
                   vulkan_changes& changes);
  void update_chunk(chunk& part, std::span<const std::uint32_t> nodes, const row_places& lengths,
                    std::span<const std::uint8_t> before, vulkan_changes& changes);
  [[nodiscard]] device_float4 position(const problem& p, std::uint32_t node, bool leading) const;
  [[nodiscard]] std::array<float, 2> lame(const problem& p, std::uint32_t element) const;
  [[nodiscard]] expected<void> dispatch(const gpu::kernel& k, const gpu::buffer& blocks,
                                        std::uint32_t rows, std::uint32_t first = 0,
                                        const gpu::buffer* listed = nullptr);
  [[nodiscard]] expected<void> dispatch_rows(const gpu::kernel& k, VkDescriptorSet set,
                                             const push_constants& push);

  const cycle_kernels& shapes_;
  vulkan_memory& memory_;
  device_scale scale_;
  std::uint32_t nodes_ = 0;
  std::uint32_t elements_ = 0;
  std::uint32_t most_columns_ = 0;  ///< That the kernels have room for.
  elasticity_kernels kernels_;
  gpu::buffer position_high_, position_low_, element_nodes_, element_lame_;
  vulkan_lists corners_;
  gpu::buffer slices_;
  std::deque<chunk> chunks_;
  std::vector<std::uint8_t> exact_slices_;  ///< 1: smoothers read them exactly.
};

}  // namespace tedit::fem
