// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/vulkan/rigid_cycle.hpp"

namespace tedit::fem::vulkan {

/// One symmetric multilevel cycle on linear tets: the counterpart of `native::multilevel_cycle`.
class multilevel_cycle {
public:
  /// `k` and `h` must outlive the cycle.
  multilevel_cycle(device_memory& memory, const row_operator& k, const hierarchy& h,
                   filter_span filter, const cycle_settings& settings, double scale);

  /// As `smoother::widen`.
  void widen(device_memory& memory, std::uint32_t cases) {
    smoother_.widen(memory, cases);
    rigid_.widen(memory, cases);
  }
  /// Adds z = about (S K S)^-1 right.
  void add(device_program& program, const gpu::buffer& right, const gpu::buffer& z);
  /// After `update_hierarchy`; `filter` changed at `nodes`, ascending.
  void update(filter_span filter, std::span<const std::uint32_t> nodes, device_changes& changes);
  [[nodiscard]] const gpu::buffer& filter() const { return smoother_.filter(); }

private:
  [[nodiscard]] std::array<std::uint32_t, 4> arm_of(std::uint32_t node) const;
  [[nodiscard]] std::uint32_t aggregates() const { return hierarchy_.levels.front().nodes(); }

  const hierarchy& hierarchy_;
  cycle_settings settings_;
  std::uint32_t nodes_;
  smoother smoother_;
  rigid_cycle rigid_;
  gpu::buffer arms_;
  row_lists members_;
};

}  // namespace tedit::fem::vulkan
