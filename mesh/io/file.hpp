// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <concepts>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace tedit {

/// The bytes of a regular file. Errors: `io_error` naming the path and the system's reason.
[[nodiscard]] expected<std::vector<char>> read_file(const std::filesystem::path& path);

/// Where a writer puts a file: at a path, or into memory where nothing is left behind.
class file_target {
public:
  template <std::convertible_to<std::filesystem::path> Path>
  file_target(const Path& path) : path_(path) {}
  file_target(std::string* memory) : memory_(memory) {}

  /// To a path as `write_file` does it. Errors: `io_error`; `out_of_memory` when memory is short.
  [[nodiscard]] expected<void> write(const std::function<void(std::ostream&)>& write) const;

private:
  std::filesystem::path path_;
  std::string* memory_ = nullptr;
};

/// Writes to a temporary file beside `path` and renames it into place when all went well, so that
/// a file is never half-written. Makes missing folders. Errors: `io_error`.
[[nodiscard]] expected<void> write_file(const std::filesystem::path& path,
                                        const std::function<void(std::ostream&)>& write);

}  // namespace tedit
