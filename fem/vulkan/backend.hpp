// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/kernels.hpp"
#include "fem/multilevel/hierarchy.hpp"

namespace tedit::fem {

struct vulkan_settings {
  /// Coarser than native, because the coarsest level is a dense inverse on the device.
  multilevel_settings multilevel{.coarsest = 96, .rounded = true};
  cycle_settings cycle;
  /// Linear tets under quadratic ones are solved more closely, as natively (`native_settings`).
  float corner_weak_edge = 0.15F;
  int corner_degree = 3;
  /// Bytes of matrix that one binding may hold; 0 takes the device's limit. Tests set it low.
  std::uint64_t most_bytes_per_binding = 0;
  /// Invocations of a workgroup, and rows side by side in memory; powers of two, 0 takes what suits
  /// the device. Kernels use no subgroup operations, so any will do: at most the device's limit and
  /// 1024, and as many rows as invocations.
  std::uint32_t group_size = 0;
  std::uint32_t slice_rows = 0;
  /// Whether kernels read as texels what they do not write (`shaders/operands.glsl`); nothing: on
  /// software devices, which gather texels with vectors. The same bits either way.
  std::optional<bool> texels;
  /// Rows of all dispatches in one part of a recorded program; 0 takes what suits the device.
  std::uint32_t rows_per_part = 0;
  /// Rows of one dispatch, which nothing can stop; 0 takes what suits the device.
  std::uint32_t rows_per_dispatch = 0;

  /// What counts for elements of this order.
  [[nodiscard]] vulkan_settings for_order(int order) const {
    vulkan_settings result = *this;
    if (order == 2) {
      result.multilevel.weak_edge = corner_weak_edge;
      result.multilevel.sliver_condition = quadratic_sliver_condition;
      result.cycle.node_degree = corner_degree;
    }
    return result;
  }
};

/// A Vulkan device as a backend, in single precision: both orders are solved under a multilevel
/// cycle; blocks of linear tets and hierarchy are built on the host. `part` is part of the device's
/// name, "lavapipe" means Mesa's software device, "" any. Errors: `device_unavailable`.
[[nodiscard]] expected<std::unique_ptr<backend>> open_vulkan(const std::string& part,
                                                             const vulkan_settings& settings = {});

/// The Vulkan devices of this machine; empty without a driver.
[[nodiscard]] std::vector<device_info> list_vulkan_devices();

}  // namespace tedit::fem
