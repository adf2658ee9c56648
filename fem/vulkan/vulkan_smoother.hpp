// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/node_smoother.hpp"
#include "fem/vulkan/vulkan_memory.hpp"
#include "fem/vulkan/vulkan_rows.hpp"

namespace tedit::fem {

/// Chebyshev smoothing of a level with three unknowns a node, on the device: the counterpart of
/// `smooth_from_zero` and `smooth_correction` of the native backend.
class vulkan_smoother {
public:
  /// Uploads the smoother; `k` and `s` must outlive it (lambda is read when steps are added).
  /// `scale`: the device's matrix times this is the real one.
  vulkan_smoother(vulkan_memory& memory, const row_operator& k, const node_smoother& s,
                  filter_span filter, double scale);

  vulkan_smoother(const vulkan_smoother&) = delete;  // holds pointers into itself

  /// Smooths from z = 0; leaves S (right - K z) in `residual`.
  void from_zero(vulkan_program& program, int degree, const gpu::buffer& right,
                 const gpu::buffer& z);
  /// Adds the correction in `step` to `z` and smooths.
  void correction(vulkan_program& program, int degree, const gpu::buffer& z);

  [[nodiscard]] const gpu::buffer& residual() const { return residual_; }
  [[nodiscard]] const gpu::buffer& filter() const { return filter_; }
  /// Where the next correction belongs; asked for after `from_zero`.
  [[nodiscard]] const gpu::buffer& step() const { return *step_; }

private:
  /// Nodes of clusters, as many as have their inverses in one binding.
  struct cluster_part {
    std::uint32_t rows = 0;
    gpu::buffer table, blocks;
  };

  void upload_clusters(vulkan_memory& memory, const cluster_inverses& clusters, double scale);
  void move(vulkan_program& program, chebyshev_weights weights, float enter, const gpu::buffer& z);
  void add_clusters(vulkan_program& program, float fresh, const gpu::buffer& step,
                    const gpu::buffer& z) const;

  const row_operator& k_;
  const node_smoother& smoother_;
  gpu::buffer inverse_, filter_, residual_, first_, second_;
  gpu::buffer* step_ = &first_;
  gpu::buffer* other_ = &second_;
  std::vector<cluster_part> clusters_;
};

}  // namespace tedit::fem
