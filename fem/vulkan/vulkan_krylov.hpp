// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>

#include "fem/energy_bound.hpp"
#include "fem/vulkan/vulkan_memory.hpp"
#include "fem/vulkan/vulkan_rows.hpp"

namespace tedit::fem {

/// Adds z = B right to a program.
using preconditioner =
  std::function<void(vulkan_program&, const gpu::buffer& right, const gpu::buffer& z)>;

/// Preconditioned conjugate gradients whose scalars stay on the device. One iteration is recorded;
/// batches of it are submitted, and the device itself stops within a batch: it zeroes the group
/// counts of what follows.
class vulkan_krylov {
public:
  /// All arguments must outlive the solver.
  vulkan_krylov(const cycle_kernels& kernels, vulkan_memory& memory, const row_operator& k);

  /// Records the loop; `b` need not outlive the call. `filter` is S.
  [[nodiscard]] expected<void> prepare(const preconditioner& b, const gpu::buffer& filter);

  /// The same after operator and preconditioner followed an edit in their buffers: only programs
  /// with other dispatches are recorded.
  [[nodiscard]] expected<void> follow(const preconditioner& b, const gpu::buffer& filter);

  /// Contract: `linear_system::solve`, in the device's units; of `goal` only the ends count.
  [[nodiscard]] expected<inner_result> solve(const std::vector<device_float4>& right,
                                             std::vector<device_float4>& correction,
                                             const inner_case& goal, int max_iterations,
                                             const execution& run);
  /// y = K x, for estimates and tests; needs no preconditioner.
  [[nodiscard]] expected<void> multiply(const std::vector<device_float4>& x,
                                        std::vector<device_float4>& y);
  /// z = B r: for tests.
  [[nodiscard]] expected<void> precondition(const std::vector<device_float4>& r,
                                            std::vector<device_float4>& z);

private:
  [[nodiscard]] vulkan_program product_steps() const;
  [[nodiscard]] vulkan_program iteration_steps(const preconditioner& b,
                                               const gpu::buffer& filter) const;
  [[nodiscard]] expected<void> begin(const inner_case& goal);

  const cycle_kernels& kernels_;
  vulkan_memory& memory_;
  const row_operator& k_;
  double smallest_ = usual_smallest;  ///< At most the smallest eigenvalue of B K, as far as known.
  gpu::buffer u_, r_, z_, p_, q_, partials_, scalars_, gates_;
  std::optional<vulkan_program> product_, start_, preconditioned_, iteration_;
};

}  // namespace tedit::fem
