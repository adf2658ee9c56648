// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/multilevel/quadratic_level.hpp"
#include "fem/vulkan/cycle.hpp"

namespace tedit::fem::vulkan {

/// The cycle on quadratic tets over the one of their corners: the counterpart of
/// `native::quadratic_cycle`.
class quadratic_cycle {
public:
  /// All arguments but `filter` and `scale` must outlive the cycle.
  quadratic_cycle(device_memory& memory, const row_operator& k, const node_smoother& s,
                  const edge_transfer& edges, filter_span filter, multilevel_cycle& corners,
                  int degree, double scale);

  void add(device_program& program, const gpu::buffer& right, const gpu::buffer& z);
  /// After smoother and edges followed an edit, which added those from number `old_edges` on;
  /// `filter` changed at `nodes`, ascending.
  void update(filter_span filter, std::span<const std::uint32_t> nodes, std::size_t old_edges,
              device_changes& changes);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  const row_operator& k_;
  const edge_transfer& edges_;
  std::uint32_t corner_count_;
  int degree_;
  smoother smoother_;
  multilevel_cycle& corners_;
  gpu::buffer ends_, coarse_right_, coarse_;
  row_lists middles_;
};

}  // namespace tedit::fem::vulkan
