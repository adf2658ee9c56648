// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include <volk.h>

namespace tedit::gpu::test {

/// What goes wrong.
enum class fault {
  none,
  lost,         ///< VK_ERROR_DEVICE_LOST; every later call that may say so says it, too.
  device_full,  ///< VK_ERROR_OUT_OF_DEVICE_MEMORY, once.
  host_full,    ///< VK_ERROR_OUT_OF_HOST_MEMORY, once.
  late,         ///< VK_TIMEOUT, once.
  hung,         ///< VK_TIMEOUT from then on.
};

/// Stands between the program and the driver while it lives: numbers the calls that return a
/// VkResult from 1, lets one of them fail, and keeps account of what was made and not destroyed.
/// Works by the pointers of volk, so no other code knows of it. One at a time; opened devices of
/// before are not watched.
class fault_layer {
public:
  /// `list` or `open` of gpu::device must have been called once before.
  fault_layer();
  fault_layer(const fault_layer&) = delete;
  fault_layer& operator=(const fault_layer&) = delete;
  ~fault_layer();

  /// Numbers anew, and lets the first call from `at` on fail that can fail so (0: none). Numbers
  /// may shift from run to run: how many iterations go into a submission is measured.
  void plan(fault what, std::size_t at);

  /// Whether call `at` of the last run may fail so.
  [[nodiscard]] bool possible(fault what, std::size_t at) const;
  /// Calls since `plan`.
  [[nodiscard]] std::size_t calls() const;
  /// The name of call `at`.
  [[nodiscard]] const char* name(std::size_t at) const;
  [[nodiscard]] bool happened() const;

  /// Objects that were made under this layer and still stand.
  [[nodiscard]] std::size_t standing() const;
  /// Objects destroyed since the planned fault.
  [[nodiscard]] std::size_t destroyed_since() const;
  /// Forgets what still stands: after a device was given up on purpose.
  void forget();

  /// SPIR-V capabilities of all kernels that were loaded.
  [[nodiscard]] const std::set<std::uint32_t>& capabilities() const;
  /// Features that were switched on when devices were opened.
  [[nodiscard]] std::size_t features() const;
};

/// The capabilities that a SPIR-V module declares.
[[nodiscard]] std::set<std::uint32_t> capabilities_of(const std::uint32_t* words,
                                                      std::size_t count);

}  // namespace tedit::gpu::test
