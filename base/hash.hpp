// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tedit {

/// An XXH3-128 content hash: the identity of a page or of a version. It serves caching among
/// trusted nodes; where a hash crosses a trust boundary use SHA-256 instead.
struct hash128 {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  friend auto operator<=>(const hash128&, const hash128&) = default;
};

/// Hashes bytes with XXH3-128. Cost: one pass, tens of GB/s.
[[nodiscard]] hash128 hash_bytes(std::span<const std::byte> bytes) noexcept;

/// 32 lower-case hexadecimal digits.
[[nodiscard]] std::string to_hex(const hash128& hash);

/// The inverse of `to_hex`; nothing when the text is not 32 hexadecimal digits.
[[nodiscard]] std::optional<hash128> hash_from_hex(std::string_view text) noexcept;

}  // namespace tedit

template <>
struct std::hash<tedit::hash128> {
  std::size_t operator()(const tedit::hash128& value) const noexcept { return value.low; }
};
