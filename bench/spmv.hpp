// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <memory>

#include "fem/problem.hpp"

/// One product y = K x on a device, beside a copy there.
namespace tedit::bench {

/// What can be timed: nothing is converted or moved between host and device meanwhile.
class product_probe {
public:
  virtual ~product_probe() = default;

  /// Bytes that a product moves: every array that it reads or writes once (values at nodes that
  /// several rows read count once, too), and what lies between its two passes twice.
  [[nodiscard]] virtual double product_bytes() const = 0;
  /// Bytes that a copy moves, half read and half written: as many as a product or as were asked
  /// for, if the device can bind them.
  [[nodiscard]] virtual double copy_bytes() const = 0;

  [[nodiscard]] virtual expected<void> multiply(int times) = 0;
  [[nodiscard]] virtual expected<void> copy(int times) = 0;
};

/// The native operators: blocks of linear tets, patches of quadratic ones. `copy_bytes` 0: as many
/// as a product moves. `rounded`: blocks as smoothers read them, of linear tets only.
[[nodiscard]] std::unique_ptr<product_probe> probe_native(const fem::problem& p,
                                                          std::uint64_t copy_bytes = 0,
                                                          bool rounded = false);

/// Those of a Vulkan device, "lavapipe" or part of its name. Errors: those of the device.
[[nodiscard]] expected<std::unique_ptr<product_probe>> probe_vulkan(const std::string& device,
                                                                    const fem::problem& p,
                                                                    std::uint64_t copy_bytes = 0);

}  // namespace tedit::bench
