// SPDX-License-Identifier: AGPL-3.0-or-later
#include "gpu/buffer.hpp"

#include <algorithm>
#include <utility>

namespace tedit::gpu {

expected<buffer> buffer::make(std::shared_ptr<device> on, std::uint64_t bytes, place where) {
  buffer result;
  result.device_ = std::move(on);
  result.bytes_ = std::max<std::uint64_t>(16, (bytes + 15) / 16 * 16);
  const auto& calls = result.device_->calls();
  const auto handle = result.device_->handle();
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = result.bytes_;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
               VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
               VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  const auto what = "allocating " + std::to_string((result.bytes_ >> 10) + 1) + " KiB";
  if (const auto r = calls.vkCreateBuffer(handle, &info, nullptr, &result.buffer_); r != VK_SUCCESS)
    return fail(to_error(r, what));
  VkMemoryRequirements needs;
  calls.vkGetBufferMemoryRequirements(handle, result.buffer_, &needs);
  const VkMemoryPropertyFlags host =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  int type = -1;
  if (where == place::host)
    // Cached host memory reads back many times faster where it exists.
    for (const auto flags : {host | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, host})
      type = type < 0 ? result.device_->memory_type(needs.memoryTypeBits, flags) : type;
  else
    for (const VkMemoryPropertyFlags flags :
         {VkMemoryPropertyFlags{VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT}, VkMemoryPropertyFlags{0}})
      type = type < 0 ? result.device_->memory_type(needs.memoryTypeBits, flags) : type;
  if (type < 0)
    return fail(ec::device_unavailable, "the device has no memory of the kind that is needed");
  VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = static_cast<std::uint32_t>(type);
  if (const auto r = calls.vkAllocateMemory(handle, &allocate, nullptr, &result.memory_);
      r != VK_SUCCESS)
    return fail(to_error(r, what));
  if (const auto r = calls.vkBindBufferMemory(handle, result.buffer_, result.memory_, 0);
      r != VK_SUCCESS)
    return fail(to_error(r, what));
  if (where == place::host) {
    void* mapped = nullptr;
    if (const auto r = calls.vkMapMemory(handle, result.memory_, 0, VK_WHOLE_SIZE, 0, &mapped);
        r != VK_SUCCESS)
      return fail(to_error(r, what));
    result.mapped_ = {static_cast<std::byte*>(mapped), result.bytes_};
  } else if (auto ok = result.view_as_texels(what); !ok) {
    return fail(ok.error());
  }
  return result;
}

expected<void> buffer::view_as_texels(const std::string& what) {
  VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = buffer_;
  info.format = VK_FORMAT_R32G32B32A32_UINT;
  info.range = std::min(bytes_, device_->limits().texel_buffer_range);
  if (const auto r =
        device_->calls().vkCreateBufferView(device_->handle(), &info, nullptr, &texels_);
      r != VK_SUCCESS)
    return fail(to_error(r, what));
  return {};
}

buffer& buffer::operator=(buffer&& other) noexcept {
  if (this == &other)
    return *this;
  release();
  device_ = std::move(other.device_);
  buffer_ = std::exchange(other.buffer_, VK_NULL_HANDLE);
  texels_ = std::exchange(other.texels_, VK_NULL_HANDLE);
  memory_ = std::exchange(other.memory_, VK_NULL_HANDLE);
  bytes_ = std::exchange(other.bytes_, 0);
  mapped_ = std::exchange(other.mapped_, {});
  return *this;
}

void buffer::release() {
  if (!device_)
    return;
  const auto& calls = device_->calls();
  const bool free = !device_->given_up();
  if (texels_ && free)
    calls.vkDestroyBufferView(device_->handle(), texels_, nullptr);
  if (buffer_ && free)
    calls.vkDestroyBuffer(device_->handle(), buffer_, nullptr);
  if (memory_ && free)
    calls.vkFreeMemory(device_->handle(), memory_, nullptr);
  texels_ = VK_NULL_HANDLE;
  buffer_ = VK_NULL_HANDLE;
  memory_ = VK_NULL_HANDLE;
  device_.reset();
}

}  // namespace tedit::gpu
