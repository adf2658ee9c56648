// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "fem/polled.hpp"
#include "fem/vulkan/backend.hpp"
#include "gpu/kernels.hpp"

namespace tedit::fem::vulkan {

/// Four floats as a kernel sees them.
using device_float4 = std::array<float, 4>;

/// Room for so many items and what edits may add to them.
[[nodiscard]] constexpr std::uint64_t with_spare(std::uint64_t items) {
  return items + items / 16 + 1024;
}

class device_changes;

/// Buffers of one system, counted. The first failure stays: later calls give empty buffers at once,
/// and `status` says what happened; ask it before any buffer is used.
class device_memory {
public:
  device_memory(std::shared_ptr<gpu::kernel_layout> layout, const vulkan_settings& settings);

  [[nodiscard]] gpu::buffer room(std::uint64_t bytes);
  /// A buffer with these values, and room for `items` if these are more.
  template <class T>
  [[nodiscard]] gpu::buffer put(const std::vector<T>& values, std::uint64_t items = 0) {
    return put_bytes(std::as_bytes(std::span(values)), items * sizeof(T));
  }
  void give_back(gpu::buffer& from);
  /// A buffer of another size in its place; its contents are lost.
  void replace(gpu::buffer& old, std::uint64_t bytes) {
    give_back(old);
    old = room(bytes);
  }
  /// Takes buffers that are gone off the count.
  void forget(std::uint64_t bytes) { bytes_ -= bytes; }
  [[nodiscard]] expected<void> status() const;

  template <class T>
  [[nodiscard]] expected<void> upload(gpu::buffer& to, const std::vector<T>& values) const {
    return gpu::upload(layout_, to, std::as_bytes(std::span(values)));
  }
  template <class T>
  [[nodiscard]] expected<void> download(const gpu::buffer& from, std::vector<T>& values) const {
    return gpu::download(layout_, from, std::as_writable_bytes(std::span(values)));
  }

  /// Bytes held on the device.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// Bytes that were put there, now or by changes, since the last call.
  [[nodiscard]] std::uint64_t take_uploaded() { return std::exchange(uploaded_, 0); }
  [[nodiscard]] expected<void> send(device_changes& changes);
  /// Bytes that one piece of data that can be cut may have.
  [[nodiscard]] std::uint64_t most_per_piece() const { return most_per_piece_; }

private:
  [[nodiscard]] gpu::buffer put_bytes(std::span<const std::byte> bytes, std::uint64_t room_bytes);

  std::shared_ptr<gpu::kernel_layout> layout_;
  std::uint64_t most_per_piece_ = 0;
  std::uint64_t bytes_ = 0;
  std::uint64_t uploaded_ = 0;
  expected<void> status_;
};

/// Six numbers, times `scale`, in two vec4: a symmetric 3x3 block.
template <class T>
[[nodiscard]] std::array<float, 8> packed_six(const T* values, double scale) {
  std::array<float, 8> result{};
  for (int i = 0; i < 6; ++i)
    result[i] = static_cast<float>(scale * static_cast<double>(values[i]));
  return result;
}
template <class T>
[[nodiscard]] std::vector<std::array<float, 8>> packed_symmetric(
  std::span<const std::array<T, 6>> blocks, double scale) {
  std::vector<std::array<float, 8>> result(blocks.size());
  polled_for(blocks.size(),
             [&](std::size_t n) { result[n] = packed_six(blocks[n].data(), scale); });
  return result;
}

/// Vectors with three numbers a node, one vec4 each, times `scale`.
[[nodiscard]] std::vector<device_float4> packed3(std::span<const double> values, double scale);
/// One of several cases side by side.
struct case_place {
  std::size_t number = 0;
  std::size_t of = 1;
};
void pack3(std::span<const double> values, double scale, std::span<device_float4> packed,
           case_place place);
void unpack3(std::span<const device_float4> packed, double scale, std::span<double> values,
             case_place place = {});

}  // namespace tedit::fem::vulkan
