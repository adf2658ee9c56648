// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace tedit::cli {

/// The server's secret from a file that only its owner can read; it is made when it is missing.
/// Errors: `io_error`; `invalid_argument` when others may read the file or it is no secret.
[[nodiscard]] expected<std::string> read_or_make_token(const std::filesystem::path& file);

/// The secret from a file that is there. Errors: as above.
[[nodiscard]] expected<std::string> read_private_token(const std::filesystem::path& file);

/// The secret of a running server. Errors: `io_error` naming the file.
[[nodiscard]] expected<std::string> read_token(const std::filesystem::path& file);

}  // namespace tedit::cli
