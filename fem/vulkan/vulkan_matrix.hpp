// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/incidence.hpp"
#include "fem/vulkan/vulkan_memory.hpp"
#include "fem/vulkan/vulkan_rows.hpp"
#include "shaders/elasticity_bindings.h"

namespace tedit::fem {

/// By what a problem's numbers are divided, so that single precision works near one: lengths by
/// the part's size, stiffnesses by the largest elasticity constant.
struct device_scale {
  double size = 1;       ///< m
  double stiffness = 1;  ///< Pa
  vec3 centre;           ///< m; positions are sent from here.

  explicit device_scale(const problem& p);
  /// What the device holds of a stiffness, N/m, times this is the stiffness.
  [[nodiscard]] double matrix() const { return size * stiffness; }
};

/// The matrix of linear tets, assembled on the device in difference form: sliced rows, cut into
/// ranges that fit a binding. Also recovers stresses.
class vulkan_matrix final : public row_operator {
public:
  /// `kernels` and `memory` must outlive the matrix, `p` (of order 1) and `corners` the call.
  [[nodiscard]] static expected<std::unique_ptr<vulkan_matrix>> make(
    std::shared_ptr<gpu::device> on, const cycle_kernels& kernels, vulkan_memory& memory,
    const problem& p, const incidence& corners, const device_scale& scale);

  std::uint32_t rows() const override { return nodes_; }
  std::uint32_t most_partials() const override;
  std::uint32_t add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                    cycle_push push) const override;

  /// As `linear_system`. Not after `drop_mesh`.
  [[nodiscard]] expected<void> element_stress(std::span<const double> displacement,
                                              std::span<double> stress);
  [[nodiscard]] expected<void> nodal_stress(std::span<const double> element_stress,
                                            std::span<double> nodal);
  /// Gives back what only assembly and stresses need.
  void drop_mesh();

private:
  /// A range of rows whose blocks fit into one binding.
  struct chunk {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    std::uint64_t entries = 0;
    gpu::buffer blocks;
  };

  vulkan_matrix(const cycle_kernels& kernels, vulkan_memory& memory, const problem& p,
                const device_scale& scale);

  [[nodiscard]] expected<void> build(std::shared_ptr<gpu::device> on, const problem& p,
                                     const incidence& corners);
  [[nodiscard]] expected<void> upload_mesh(const problem& p, const incidence& corners);
  [[nodiscard]] expected<std::vector<std::uint32_t>> count_columns();
  [[nodiscard]] expected<void> cut_chunks(const std::vector<std::uint32_t>& columns);
  [[nodiscard]] expected<void> make_stress_room();
  [[nodiscard]] expected<void> dispatch(const gpu::kernel& k, const gpu::buffer& blocks,
                                        std::uint32_t rows, std::uint32_t first = 0);
  [[nodiscard]] expected<void> dispatch_rows(const gpu::kernel& k, VkDescriptorSet set,
                                             const push_constants& push);

  const cycle_kernels& shapes_;
  vulkan_memory& memory_;
  device_scale scale_;
  std::uint32_t nodes_ = 0;
  std::uint32_t elements_ = 0;
  elasticity_kernels kernels_;
  gpu::buffer position_high_, position_low_, element_nodes_, element_lame_, corner_first_, corners_;
  gpu::buffer slices_;
  gpu::buffer leading_, trailing_, element_stresses_, means_;
  std::vector<chunk> chunks_;
};

}  // namespace tedit::fem
