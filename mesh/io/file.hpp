// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <vector>

#include "base/error.hpp"

namespace tedit {

/// The bytes of a regular file. Errors: `io_error` naming the path and the system's reason.
[[nodiscard]] expected<std::vector<char>> read_file(const std::filesystem::path& path);

/// Writes to a temporary file beside `path` and renames it into place when all went well, so that
/// a file is never half-written. Makes missing folders. Errors: `io_error`.
[[nodiscard]] expected<void> write_file(const std::filesystem::path& path,
                                        const std::function<void(std::ostream&)>& write);

}  // namespace tedit
