// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>

#include "fem/multilevel/energy_bound.hpp"
#include "fem/vulkan/memory.hpp"
#include "fem/vulkan/row_operator.hpp"

namespace tedit::fem::vulkan {

/// Adds z = B right to a program.
using preconditioner =
  std::function<void(device_program&, const gpu::buffer& right, const gpu::buffer& z)>;

/// Preconditioned conjugate gradients whose scalars stay on the device, for one or several cases
/// side by side. One iteration is recorded; batches of it are submitted, and the device itself
/// stops within a batch: it zeroes the group counts of what follows. A case that is done before
/// others takes no step any more.
class krylov_solver {
public:
  /// All arguments must outlive the solver.
  krylov_solver(const kernel_set& kernels, device_memory& memory, const row_operator& k);

  /// From now on also solves `kernels.cases` at once, which must outlive the solver. All programs
  /// are to be prepared again.
  void widen(const kernel_set& kernels);
  [[nodiscard]] std::uint32_t width() const { return cases_; }
  /// Whether it solves so many at once.
  [[nodiscard]] bool has_width(std::uint32_t cases) const;

  /// Records the loops; `b` need not outlive the call. `filter` is S.
  [[nodiscard]] expected<void> prepare(const preconditioner& b, const gpu::buffer& filter);

  /// The same after operator and preconditioner followed an edit in their buffers: only programs
  /// with other dispatches are recorded.
  [[nodiscard]] expected<void> follow(const preconditioner& b, const gpu::buffer& filter);

  /// Contract: `linear_system::solve_many`, in the device's units; of `goals` only the ends count.
  /// `right` and `correction` have the cases of the first node, then of the next one, as many as
  /// the narrowest width that holds the goals: results in their order.
  [[nodiscard]] expected<std::vector<inner_result>> solve(const std::vector<device_float4>& right,
                                                          std::vector<device_float4>& correction,
                                                          std::span<const inner_case> goals,
                                                          int max_iterations, const execution& run);
  /// y = K x, for estimates and tests; needs no preconditioner.
  [[nodiscard]] expected<void> multiply(const std::vector<device_float4>& x,
                                        std::vector<device_float4>& y);
  /// z = B r: for tests.
  [[nodiscard]] expected<void> precondition(const std::vector<device_float4>& r,
                                            std::vector<device_float4>& z);

private:
  /// What is recorded for one number of cases.
  struct recorded_loop {
    const kernel_set* kernels;
    std::optional<device_program> start = {}, preconditioned = {}, first = {}, iteration = {};
  };

  void make_room(std::uint32_t cases);
  /// What every kernel is bound to; only some need the filter.
  [[nodiscard]] device_program::places vectors(const gpu::buffer* filter = nullptr) const;
  [[nodiscard]] krylov_push every_row() const { return {.rows = k_.rows()}; }
  [[nodiscard]] device_program product_steps() const;
  [[nodiscard]] device_program first_steps(const kernel_set& kernels) const;
  [[nodiscard]] device_program iteration_steps(const kernel_set& kernels, const preconditioner& b,
                                               const gpu::buffer& filter) const;
  [[nodiscard]] expected<void> record(recorded_loop& one, const preconditioner& b,
                                      const gpu::buffer& filter);
  [[nodiscard]] expected<void> begin(recorded_loop& one, std::span<const inner_case> goals);
  [[nodiscard]] expected<std::vector<krylov_scalars>> iterate(recorded_loop& one,
                                                              int max_iterations,
                                                              const execution& run);
  [[nodiscard]] inner_result read(const krylov_scalars& of);

  const kernel_set& kernels_;
  device_memory& memory_;
  const row_operator& k_;
  double smallest_ = usual_smallest;  ///< At most the smallest eigenvalue of B K, as far as known.
  std::uint32_t cases_ = 1;           ///< That the vectors have room for.
  gpu::buffer u_, r_, z_, p_, q_, partials_, scalars_, gates_;
  std::optional<device_program> product_;
  std::deque<recorded_loop> loops_;  ///< The one for one case first.
};

}  // namespace tedit::fem::vulkan
