// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace tedit::cli {

/// Sends the log of this process to stderr from `level` on ("debug", "info", "warn", "error");
/// `prefix` stands before every line's text.
void start_logging(const std::string& level, const std::string& prefix = {});

}  // namespace tedit::cli
