// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "fem/incidence.hpp"
#include "fem/vulkan/vulkan_backend.hpp"
#include "fem/vulkan/vulkan_kernels.hpp"
#include "shaders/elasticity_bindings.h"

namespace tedit::fem {

/// A matrix on a Vulkan device. Lengths are divided by the part's size, stiffnesses by the largest
/// elasticity constant, vectors by their norm, so that single precision works near one; results are
/// scaled back.
class vulkan_system final : public linear_system {
public:
  [[nodiscard]] static expected<std::unique_ptr<linear_system>> make(
    std::shared_ptr<gpu::device> on, const problem& p, const vulkan_settings& settings,
    const execution& run);

  expected<inner_result> solve(std::span<const double> residual, std::span<double> correction,
                               double reduction, int max_iterations, const execution& run) override;
  expected<void> set_filter(std::span<const std::array<double, 6>> filter) override;
  expected<void> multiply(std::span<const double> x, std::span<double> y) override;
  expected<void> element_stress(std::span<const double> displacement,
                                std::span<double> stress) override;
  expected<void> nodal_stress(std::span<const double> element_stress,
                              std::span<double> nodal) override;
  double assembly_ms() const override { return assembly_ms_; }
  std::uint64_t device_bytes() const override { return device_bytes_; }

private:
  /// A range of rows whose blocks fit into one binding.
  struct chunk {
    std::uint32_t first_row = 0;
    std::uint32_t rows = 0;
    std::uint64_t entries = 0;
    gpu::buffer blocks;
    VkDescriptorSet set = VK_NULL_HANDLE;
  };

  vulkan_system(std::shared_ptr<gpu::device> on, const problem& p, const vulkan_settings& settings)
      : device_(std::move(on)), problem_(p), settings_(settings) {}

  [[nodiscard]] expected<void> build();
  [[nodiscard]] expected<void> upload_mesh(const incidence& corners);
  [[nodiscard]] expected<void> allocate_vectors();
  [[nodiscard]] expected<std::vector<std::uint32_t>> count_columns();
  [[nodiscard]] expected<void> cut_chunks(const std::vector<std::uint32_t>& columns);
  [[nodiscard]] expected<void> fill_chunks();
  [[nodiscard]] expected<gpu::commands*> batch();
  [[nodiscard]] push_constants constants_of(const chunk& part, std::uint32_t number) const;
  [[nodiscard]] expected<gpu::buffer> make_buffer(std::uint64_t bytes);
  [[nodiscard]] expected<VkDescriptorSet> bind(const gpu::buffer& slices, const gpu::buffer& blocks,
                                               const gpu::buffer& inverse);
  [[nodiscard]] expected<void> dispatch_rows(const gpu::kernel& k, VkDescriptorSet set,
                                             std::uint32_t rows, std::uint32_t first = 0);
  [[nodiscard]] expected<void> upload_vector(gpu::buffer& to, std::span<const double> values,
                                             double scale, bool trailing);

  std::shared_ptr<gpu::device> device_;
  const problem& problem_;
  vulkan_settings settings_;
  vulkan_kernels kernels_;
  double size_ = 1;       ///< m; the part's extent.
  double stiffness_ = 1;  ///< Pa; the largest elasticity constant.
  std::uint32_t groups_ = 16;
  std::uint32_t most_columns_ = 8;
  gpu::buffer position_high_, position_low_, element_nodes_, element_lame_;
  gpu::buffer corner_first_, corners_, slices_;
  gpu::buffer filter_, inverse_, u_, r_, c_, q_, scalars_, counts_, element_stresses_, nodal_;
  std::vector<chunk> chunks_;
  std::optional<gpu::commands> batch_;
  VkDescriptorSet stress_set_ = VK_NULL_HANDLE;
  double assembly_ms_ = 0;
  std::uint64_t device_bytes_ = 0;
};

}  // namespace tedit::fem
