// SPDX-License-Identifier: AGPL-3.0-or-later
#include "fem/vulkan/memory.hpp"

#include "fem/polled.hpp"
#include "fem/vulkan/changes.hpp"

namespace tedit::fem::vulkan {

device_memory::device_memory(std::shared_ptr<gpu::kernel_layout> layout,
                             const vulkan_settings& settings)
    : layout_(std::move(layout)), most_per_piece_(layout_->on()->limits().storage_buffer_range) {
  if (settings.most_bytes_per_binding > 0)
    most_per_piece_ = std::min(most_per_piece_, settings.most_bytes_per_binding);
}

gpu::buffer device_memory::room(std::uint64_t bytes) {
  if (!status_)
    return {};
  if (const auto most = layout_->on()->limits().storage_buffer_range; bytes > most) {
    status_ = fail(ec::out_of_memory,
                   "a part of this problem has " + std::to_string(bytes >> 20) +
                     " MiB, the device can bind " + std::to_string(most >> 20),
                   "Take a coarser mesh, or use --device cpu");
    return {};
  }
  auto made = gpu::buffer::make(layout_->on(), bytes, gpu::buffer::place::device);
  if (!made) {
    status_ = fail(made.error());
    return {};
  }
  bytes_ += made->bytes();
  return std::move(*made);
}

gpu::buffer device_memory::put_bytes(std::span<const std::byte> bytes, std::uint64_t room_bytes) {
  check_cancelled();
  auto result = room(std::max<std::uint64_t>(bytes.size(), room_bytes));
  if (status_)
    status_ = gpu::upload(layout_, result, bytes);
  uploaded_ += bytes.size();
  return result;
}

expected<void> device_memory::send(device_changes& changes) {
  uploaded_ += changes.bytes();
  return changes.send(layout_);
}

void device_memory::give_back(gpu::buffer& from) {
  bytes_ -= from.bytes();
  from = {};
}

expected<void> device_memory::status() const {
  return status_;
}

std::vector<device_float4> packed3(std::span<const double> values, double scale) {
  std::vector<device_float4> result(values.size() / 3);
  pack3(values, scale, result, {});
  return result;
}

void pack3(std::span<const double> values, double scale, std::span<device_float4> packed,
           case_place place) {
  polled_for(values.size() / 3, [&](std::size_t n) {
    for (int i = 0; i < 3; ++i)
      packed[place.of * n + place.number][i] = static_cast<float>(scale * values[3 * n + i]);
  });
}

void unpack3(std::span<const device_float4> packed, double scale, std::span<double> values,
             case_place place) {
  polled_for(values.size() / 3, [&](std::size_t n) {
    for (int i = 0; i < 3; ++i)
      values[3 * n + i] = scale * static_cast<double>(packed[place.of * n + place.number][i]);
  });
}

}  // namespace tedit::fem::vulkan
