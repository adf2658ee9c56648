// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace tedit::scan {

/// What a zip archive holds.
class zip_archive {
public:
  /// Reads its directory. Errors: `bad_input`, `unsupported_format` with the byte offset.
  [[nodiscard]] static expected<zip_archive> open(std::span<const char> bytes);

  /// The names, in the order of the directory.
  [[nodiscard]] std::vector<std::string> names() const;

  /// A file, unpacked. `most`: bytes that it may have, whatever its directory says. Errors:
  /// `bad_input` where it is not there or damaged; `unsupported_format`. Cost: O(its bytes).
  [[nodiscard]] expected<std::string> unpack(std::string_view name, std::size_t most) const;

private:
  struct entry {
    std::string name;
    std::uint16_t flags = 0;
    std::uint16_t method = 0;
    std::uint32_t crc = 0;
    std::uint64_t packed = 0;
    std::uint64_t size = 0;
    std::uint64_t offset = 0;
  };

  std::span<const char> bytes_;
  std::vector<entry> entries_;
  std::size_t directory_ = 0;  ///< Where its directory begins.
};

}  // namespace tedit::scan
