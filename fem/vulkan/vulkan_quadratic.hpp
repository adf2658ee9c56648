// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/incidence.hpp"
#include "fem/vulkan/vulkan_matrix.hpp"

namespace tedit::fem {

/// K x of straight-sided ten-node tets, element by element: one kernel writes the ten forces of
/// each element, a second one sums them at each node, in a fixed order. Elements come in ranges
/// whose forces fit a binding; the ranges share one buffer of forces.
class vulkan_quadratic final : public row_operator {
public:
  /// `kernels` and `memory` must outlive the operator; `p` has order 2.
  [[nodiscard]] static expected<std::unique_ptr<vulkan_quadratic>> make(
    const cycle_kernels& kernels, vulkan_memory& memory, const problem& p,
    const device_scale& scale);

  std::uint32_t rows() const override { return nodes_; }
  std::uint32_t most_partials() const override { return kernels_.sum_groups; }
  std::uint32_t add(vulkan_program& program, std::uint32_t mode, const row_buffers& at,
                    cycle_push push) const override;

private:
  struct range {
    std::uint32_t elements = 0;
    gpu::buffer nodes, values;  ///< Of the elements.
    gpu::buffer rows, list;     ///< Forces of each node, places in the range's forces.
  };

  vulkan_quadratic(const cycle_kernels& kernels, vulkan_memory& memory, std::uint32_t nodes)
      : kernels_(kernels), memory_(memory), nodes_(nodes) {}

  void add_range(const problem& p, const device_scale& scale, std::size_t first, std::size_t last);

  const cycle_kernels& kernels_;
  vulkan_memory& memory_;
  std::uint32_t nodes_;
  std::vector<range> ranges_;
  gpu::buffer forces_, sums_;
};

}  // namespace tedit::fem
