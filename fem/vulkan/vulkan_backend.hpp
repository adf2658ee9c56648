// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fem/kernels.hpp"

namespace tedit::fem {

struct vulkan_settings {
  /// Bytes of matrix that one binding may hold; 0 takes the device's limit. Tests set it low.
  std::uint64_t most_bytes_per_binding = 0;
};

/// A Vulkan device as a backend, in single precision: pattern, blocks, preconditioner, conjugate
/// gradients and stresses run on the device. `part` is part of the device's name, "lavapipe" means
/// Mesa's software device, "" any. Errors: `device_unavailable`.
[[nodiscard]] expected<std::unique_ptr<backend>> open_vulkan(const std::string& part,
                                                             const vulkan_settings& settings = {});

/// The Vulkan devices of this machine; empty without a driver.
[[nodiscard]] std::vector<device_info> list_vulkan_devices();

}  // namespace tedit::fem
