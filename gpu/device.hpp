// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <volk.h>

#include "base/error.hpp"

namespace tedit::gpu {

/// What a caller needs to know of a device before it opens it.
struct device_summary {
  std::string name;
  std::string driver;
  std::string kind;                ///< "discrete", "integrated", "software" or "other".
  std::uint64_t memory_bytes = 0;  ///< Largest device-local heap.
};

/// Limits that decide how work is cut up.
struct device_limits {
  std::uint64_t storage_buffer_range = 0;  ///< Bytes that one binding can see.
  std::uint64_t texel_buffer_range = 0;    ///< Bytes that one binding can see as texels of 16.
  std::uint32_t subgroup_size = 1;
  std::uint32_t workgroup_size = 64;  ///< At most this many invocations in a group.
  std::uint64_t memory_bytes = 0;
};

/// A logical device with one compute queue. Not thread-safe: one thread at a time.
class device {
public:
  /// Every Vulkan 1.1 device with a compute queue; empty without a loader or driver.
  [[nodiscard]] static std::vector<device_summary> list();

  /// Opens the first device whose name holds `part` (case does not matter); "" takes the first.
  /// With TEDIT_VULKAN_VALIDATION=1 the validation layer watches and prints to stderr. Errors:
  /// `device_unavailable`.
  [[nodiscard]] static expected<std::shared_ptr<device>> open(const std::string& part);

  device(const device&) = delete;
  device& operator=(const device&) = delete;
  ~device();

  [[nodiscard]] const device_summary& summary() const { return summary_; }
  [[nodiscard]] const device_limits& limits() const { return limits_; }
  [[nodiscard]] VkDevice handle() const { return device_; }
  [[nodiscard]] const VolkDeviceTable& calls() const { return calls_; }
  [[nodiscard]] VkQueue queue() const { return queue_; }
  [[nodiscard]] VkCommandPool pool() const { return pool_; }

  /// Work that was submitted has not come back and never may: from now on nothing of this device is
  /// destroyed or freed, since the device may still use it. What it holds is lost until the process
  /// ends.
  void give_up() { given_up_ = true; }
  [[nodiscard]] bool given_up() const { return given_up_; }

  /// A memory type with all wanted properties, or -1.
  [[nodiscard]] int memory_type(std::uint32_t allowed, VkMemoryPropertyFlags wanted) const;

  /// Messages of the validation layers since the program began.
  [[nodiscard]] static int validation_messages();

private:
  device() = default;
  [[nodiscard]] expected<void> create(VkPhysicalDevice physical);

  device_summary summary_;
  device_limits limits_;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VolkDeviceTable calls_{};
  bool given_up_ = false;
};

/// A failed Vulkan call as an error: `device_lost`, `out_of_memory` or `device_unavailable`.
[[nodiscard]] error to_error(VkResult result, const std::string& what);

}  // namespace tedit::gpu
