// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit {

/// 256 random bits as 64 hexadecimal digits. Errors: `io_error` when the system has no randomness.
[[nodiscard]] expected<std::string> make_token();

}  // namespace tedit
