// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>

#include "ops/loader/catalogue.hpp"

namespace tedit::ops {

/// What an operation may use up in a process of its own.
struct operation_limits {
  /// From its call to its answer; 0 for no limit. The same as a server's (limits.edit_timeout_s).
  std::chrono::milliseconds time{2 * 60 * 1000};
};

/// `run_operation` in a forked copy of this process, for programs whose own process must outlive
/// the plugin: a crash, an exit, a hang or used up memory is an error that names plugin and
/// operation and says what happened. It may use the memory that the machine has free. Progress and
/// what it logs arrive here while it runs; a cancel ends it at once.
/// Errors: those of `run_operation`; `internal` and `timeout` as above; `service_unavailable`.
/// Cost beyond that of the operation: a millisecond, and the copy of the pages that are new.
[[nodiscard]] expected<edit_result> run_operation_in_child(
  const catalogue& plugins, const std::string& id, const version_ptr& mesh, const selection& picked,
  const parameters& given, const context& ctx, const operation_limits& limits);

}  // namespace tedit::ops
