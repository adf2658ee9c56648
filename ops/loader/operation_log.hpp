// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace tedit::ops {

/// The `context::log` of one edit: hands "OPERATION: text" to `sink`, one call for each line, one
/// at a time. Control characters become blanks; lines are cut after 2000 characters, and after 200
/// lines one says that the rest is left out: a plugin cannot fill a log with one edit.
[[nodiscard]] std::function<void(std::string_view)> operation_log(
  std::string operation, std::function<void(const std::string&)> sink);

}  // namespace tedit::ops
