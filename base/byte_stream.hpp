// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tedit {

/// Numbers and texts as bytes in this machine's order: for what never leaves it, or what begins
/// with a tag by which another order is found out.
class byte_writer {
public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void number(T value) { raw(std::as_bytes(std::span(&value, 1))); }

  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    raw(std::as_bytes(std::span(value)));
  }

  /// A count and the items.
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void list(std::span<const T> items) {
    number(static_cast<std::uint64_t>(items.size()));
    raw(std::as_bytes(items));
  }

  void raw(std::span<const std::byte> more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

  std::vector<std::byte> bytes;
};

/// Reads what `byte_writer` wrote, with bounds: after a read past the end `ok` is false and every
/// value is zero.
class byte_reader {
public:
  explicit byte_reader(std::span<const std::byte> input) : left_(input) {}

  template <class T>
  T number() {
    T value{};
    const auto bytes = raw(sizeof(T));
    if (!bytes.empty())
      std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
  }

  std::string text() {
    const auto bytes = raw(number<std::uint32_t>());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  template <class T>
  std::vector<T> list() {
    std::vector<T> items(count(sizeof(T)));
    const auto bytes = raw(items.size() * sizeof(T));
    if (!bytes.empty())
      std::memcpy(items.data(), bytes.data(), bytes.size());
    return items;
  }

  /// A count of items of at least `item_bytes` each, checked against what is left.
  std::size_t count(std::size_t item_bytes) {
    const auto n = number<std::uint64_t>();
    if (n > left_.size() / item_bytes) {
      ok = false;
      return 0;
    }
    return n;
  }

  /// The next bytes, not copied; none when there are fewer.
  std::span<const std::byte> raw(std::size_t size) {
    if (left_.size() < size) {
      ok = false;
      return {};
    }
    const auto bytes = left_.first(size);
    left_ = left_.subspan(size);
    return bytes;
  }

  [[nodiscard]] bool at_end() const { return left_.empty(); }

  bool ok = true;

private:
  std::span<const std::byte> left_;
};

}  // namespace tedit
