// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include "base/error.hpp"

namespace tedit {

/// What the system says to `what` ("cannot read part.msh"), with the remedy that fits its reason:
/// too many open files, a full disk, missing permissions, ... Errors: always `io_error`.
/// @param error_number of errno.
[[nodiscard]] tl::unexpected<error> system_failure(const std::string& what, int error_number);

}  // namespace tedit
