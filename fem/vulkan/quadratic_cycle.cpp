// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/quadratic_cycle.hpp"

namespace tedit::fem::vulkan {

namespace {

/// The nodes in the middle of the edges at each corner.
row_lists::source middles_of(const edge_transfer& edges) {
  return [&edges](std::uint32_t corner, std::vector<std::uint32_t>& list) {
    for (const auto side : edges.middles.of(corner))
      list.push_back(static_cast<std::uint32_t>(edges.corners()) + side / 2);
  };
}

}  // namespace

quadratic_cycle::quadratic_cycle(device_memory& memory, const row_operator& k,
                                 const node_smoother& s, const edge_transfer& edges,
                                 filter_span filter, multilevel_cycle& corners, int degree,
                                 double scale)
    : k_(k),
      edges_(edges),
      corner_count_(static_cast<std::uint32_t>(edges.corners())),
      degree_(degree),
      smoother_(memory, k, s, filter, scale),
      corners_(corners) {
  ends_ = memory.put(edges.ends, with_spare(edges.ends.size()));
  coarse_right_ = memory.room(16 * std::uint64_t{corner_count_});
  coarse_ = memory.room(16 * std::uint64_t{corner_count_});
  middles_ = row_lists(memory, corner_count_, middles_of(edges));
}

void quadratic_cycle::update(filter_span filter, std::span<const std::uint32_t> nodes,
                             std::size_t old_edges, device_changes& changes) {
  smoother_.update(filter, nodes, changes);
  const std::vector added(edges_.ends.begin() + static_cast<std::ptrdiff_t>(old_edges),
                          edges_.ends.end());
  changes.put(ends_, old_edges, added);
  std::vector<std::uint32_t> corners;
  for (const auto& ends : added)
    corners.insert(corners.end(), ends.begin(), ends.end());
  sort_unique(corners);
  middles_.update(corners, corner_count_, middles_of(edges_), changes);
}

void quadratic_cycle::add(device_program& program, const gpu::buffer& right, const gpu::buffer& z) {
  const auto& kernels = program.kernels();
  smoother_.from_zero(program, degree_, right, z);
  program.add(kernels.quadratic_cycle_restrict,
              {{quadratic_cycle_at::table, &middles_.table()},
               {quadratic_cycle_at::middles, &middles_.items()},
               {quadratic_cycle_at::residual, &smoother_.residual()},
               {quadratic_cycle_at::right, &coarse_right_}},
              quadratic_cycle_push{corner_count_, 0, corner_count_});
  corners_.add(program, coarse_right_, coarse_);
  program.add(kernels.quadratic_cycle_prolongate,
              {{quadratic_cycle_at::ends, &ends_},
               {quadratic_cycle_at::coarse, &coarse_},
               {quadratic_cycle_at::filter, &smoother_.filter()},
               {quadratic_cycle_at::step, &smoother_.step()}},
              quadratic_cycle_push{k_.rows(), 0, corner_count_});
  smoother_.correction(program, degree_, z);
}

}  // namespace tedit::fem::vulkan
