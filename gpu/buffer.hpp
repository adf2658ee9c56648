// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "gpu/device.hpp"

namespace tedit::gpu {

/// A storage buffer, which kernels may read as texels, too. Device buffers are fast and reached
/// through staging (queue.hpp); host buffers are mapped.
class buffer {
public:
  enum class place { device, host };

  /// `bytes` is rounded up to 16 (an empty buffer cannot be bound). Errors: `out_of_memory`.
  [[nodiscard]] static expected<buffer> make(std::shared_ptr<device> on, std::uint64_t bytes,
                                             place where);

  buffer() = default;
  buffer(buffer&& other) noexcept { *this = std::move(other); }
  buffer& operator=(buffer&& other) noexcept;
  buffer(const buffer&) = delete;
  buffer& operator=(const buffer&) = delete;
  ~buffer() { release(); }

  [[nodiscard]] VkBuffer handle() const { return buffer_; }
  /// A device buffer as texels of four uint32, as many as the device's limits allow; a host buffer
  /// has none.
  [[nodiscard]] VkBufferView texels() const { return texels_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  /// The mapped bytes of a host buffer; coherent. Empty for a device buffer.
  [[nodiscard]] std::span<std::byte> mapped() const { return mapped_; }

private:
  [[nodiscard]] expected<void> view_as_texels(const std::string& what);
  void release();

  std::shared_ptr<device> device_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkBufferView texels_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  std::uint64_t bytes_ = 0;
  std::span<std::byte> mapped_;
};

}  // namespace tedit::gpu
