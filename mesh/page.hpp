// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>

#include "base/hash.hpp"

namespace tedit {

/// Pages hold at most this many bytes.
inline constexpr std::size_t max_page_bytes = 64 * 1024;

/// What somebody made of a page's bytes and wants to find again with the page.
struct page_facts {
  virtual ~page_facts() = default;
};

/// A block of bytes that never changes once shared, known by its content hash. Pages are the unit
/// of sharing between versions, of transport between nodes and of storage.
class page {
public:
  /// A zeroed page of `size` bytes that its maker may still write through `mutable_bytes`.
  explicit page(std::size_t size);

  /// One that begins with a copy of `bytes`; zeros follow up to `size`.
  page(std::span<const std::byte> bytes, std::size_t size);

  /// Copies `bytes` into a new page.
  [[nodiscard]] static std::shared_ptr<const page> from_bytes(std::span<const std::byte> bytes);

  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return {data_.get(), size_}; }

  /// Only for the maker, before the page is shared.
  [[nodiscard]] std::span<std::byte> mutable_bytes() noexcept { return {data_.get(), size_}; }

  /// XXH3-128 of the bytes; computed on first use, then kept. Thread-safe.
  [[nodiscard]] const hash128& id() const;

  /// What was kept last; null when nothing was. Thread-safe.
  [[nodiscard]] std::shared_ptr<const page_facts> facts() const;
  /// Instead of what was kept before; it goes with the page and is no part of it: not hashed,
  /// sent or stored. Thread-safe.
  void keep(std::shared_ptr<const page_facts> made) const;

private:
  std::unique_ptr<std::byte[]> data_;
  std::size_t size_;
  mutable std::once_flag hashed_;
  mutable hash128 id_;
  mutable std::mutex keeping_;
  mutable std::shared_ptr<const page_facts> facts_;
};

using page_ptr = std::shared_ptr<const page>;

}  // namespace tedit
