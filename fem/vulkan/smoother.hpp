// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <deque>

#include "fem/multilevel/node_smoother.hpp"
#include "fem/vulkan/changes.hpp"
#include "fem/vulkan/row_operator.hpp"

namespace tedit::fem::vulkan {

/// Chebyshev smoothing of a level with three unknowns a node, on the device: the counterpart of
/// `smooth_from_zero` and `smooth_correction` of the native backend.
class smoother {
public:
  /// Uploads the smoother; `k` and `s` must outlive it (lambda is read when steps are added).
  /// `scale`: the device's matrix times this is the real one.
  smoother(device_memory& memory, const row_operator& k, const node_smoother& s, filter_span filter,
           double scale);

  smoother(const smoother&) = delete;  // holds pointers into itself

  /// Makes room for so many cases; what was recorded is to be recorded again.
  void widen(device_memory& memory, std::uint32_t cases);

  /// After the smoother followed an edit: what it changed, and `filter` at `nodes`, ascending.
  void update(filter_span filter, std::span<const std::uint32_t> nodes, device_changes& changes);

  /// Smooths from z = 0; leaves S (right - K z) in `residual`.
  void from_zero(device_program& program, int degree, const gpu::buffer& right,
                 const gpu::buffer& z);
  /// Adds the correction in `step` to `z` and smooths.
  void correction(device_program& program, int degree, const gpu::buffer& z);

  [[nodiscard]] const gpu::buffer& residual() const { return residual_; }
  [[nodiscard]] const gpu::buffer& filter() const { return filter_; }
  /// Where the next correction belongs; asked for after `from_zero`.
  [[nodiscard]] const gpu::buffer& step() const { return *step_; }

private:
  /// A node of a cluster: node, first block, number of blocks (none: no longer in use), nothing.
  using cluster_row = std::array<std::uint32_t, 4>;
  /// Clusters, as many as have their inverses in one binding.
  struct cluster_part {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    roomy_places rows, places;  ///< Of each cluster, in `table` and `blocks`.
    std::vector<cluster_row> host_table;
    gpu::buffer table, blocks;
  };

  [[nodiscard]] std::uint32_t size_of(std::size_t cluster) const;
  void upload_clusters(device_memory& memory);
  void add_part(device_memory& memory, std::uint32_t first, std::uint32_t last);
  void update_part(cluster_part& part, std::span<const std::uint32_t> clusters,
                   device_changes& changes) const;
  void fill_table(cluster_part& part, std::uint32_t cluster) const;
  void move(device_program& program, chebyshev_weights weights, float enter, const gpu::buffer& z);
  void add_clusters(device_program& program, float fresh, const gpu::buffer& step,
                    const gpu::buffer& z) const;

  const row_operator& k_;
  const node_smoother& smoother_;
  double scale_;
  gpu::buffer inverse_, filter_, residual_, first_, second_;
  gpu::buffer* step_ = &first_;
  gpu::buffer* other_ = &second_;
  std::deque<cluster_part> clusters_;
};

}  // namespace tedit::fem::vulkan
