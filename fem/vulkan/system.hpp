// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>

#include "fem/multilevel/multilevel_setup.hpp"
#include "fem/vulkan/krylov.hpp"
#include "fem/vulkan/quadratic.hpp"
#include "fem/vulkan/quadratic_cycle.hpp"

namespace tedit::fem::vulkan {

/// A matrix of either element order on a Vulkan device. Lengths are divided by the part's size,
/// stiffnesses by the largest elasticity constant, vectors by their norm, so that single precision
/// works near one; results are scaled back.
class system final : public linear_system {
public:
  /// `kernels` are those of a store with the same settings.
  [[nodiscard]] static expected<std::unique_ptr<system>> make(std::shared_ptr<gpu::device> on,
                                                              std::shared_ptr<kernel_store> kernels,
                                                              const problem& p,
                                                              const vulkan_settings& settings,
                                                              const execution& run);

  /// Up to eight cases of linear tets share every read of the matrix and the hierarchy. With
  /// quadratic tets they are solved one after the other: arithmetic is what takes long there.
  expected<std::vector<inner_result>> solve_many(std::span<const inner_case> cases,
                                                 int max_iterations, const execution& run) override;
  /// Builds the hierarchy anew; the matrix stays.
  expected<void> set_filter(filter_span filter) override;
  /// Host and device renew the same rows; one submission carries what changed.
  expected<bool> update(const problem_change& change, const incidence& corners) override;
  expected<void> multiply(std::span<const double> x, std::span<double> y) override;
  /// Raises the bounds of the eigenvalues before the next solve.
  void distrust() override { distrusted_ = true; }
  double assembly_ms() const override { return assembly_ms_; }
  std::uint64_t device_bytes() const override { return memory_->bytes(); }
  std::uint64_t uploaded_bytes() const override { return uploaded_bytes_; }

  /// z = B r, one cycle: for tests against the native one.
  [[nodiscard]] expected<void> precondition(std::span<const double> r, std::span<double> z);

private:
  system(std::shared_ptr<gpu::device> on, std::shared_ptr<kernel_store> kernels, const problem& p,
         const vulkan_settings& settings);

  [[nodiscard]] bool is_quadratic() const { return problem_.element_order == 2; }

  [[nodiscard]] expected<void> check_memory() const;
  [[nodiscard]] expected<void> build();
  [[nodiscard]] expected<void> prepare(filter_span filter, const execution& run);
  [[nodiscard]] multilevel_setup::product product();
  /// Up to `most_cases` without their guard.
  [[nodiscard]] expected<std::vector<inner_result>> correct(std::span<const inner_case> cases,
                                                            int max_iterations,
                                                            const execution& run);
  [[nodiscard]] expected<void> widen(std::uint32_t cases);
  [[nodiscard]] bool fits_on_device(std::uint32_t cases) const;
  /// `update` without its guard.
  [[nodiscard]] expected<bool> follow(const problem_change& change, const incidence& corners);
  [[nodiscard]] device_changes update_device(const problem_change& change, const incidence& corners,
                                             std::size_t old_edges);
  [[nodiscard]] preconditioner cycle();
  [[nodiscard]] const gpu::buffer& filter_buffer() const;
  [[nodiscard]] expected<void> record();
  [[nodiscard]] expected<void> raise_bounds();
  [[nodiscard]] expected<void> check_ready() const;

  std::shared_ptr<gpu::device> device_;
  const problem& problem_;
  vulkan_settings settings_;
  device_scale scale_;
  double assembly_ms_ = 0;
  bool distrusted_ = false;
  /// All programs are recorded and their buffers stand; false after a failure on the way there.
  bool ready_ = false;
  std::uint64_t cycle_bytes_ = 0;  ///< On the device, of the cycles.
  std::uint64_t uploaded_bytes_ = 0;

  std::optional<multilevel_setup> setup_;  ///< On the host.

  // On the device. What is recorded last goes first.
  std::shared_ptr<kernel_store> kernels_;
  std::unique_ptr<device_memory> memory_;
  std::unique_ptr<sliced_matrix> matrix_;
  std::unique_ptr<quadratic_operator> quadratic_;
  std::optional<multilevel_cycle> cycle_;
  std::optional<quadratic_cycle> quadratic_cycle_;
  std::optional<krylov_solver> krylov_;
};

}  // namespace tedit::fem::vulkan
