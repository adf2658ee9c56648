// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include "ops/loader/catalogue.hpp"

namespace tedit::ops {

/// What an operation may use up in a process of its own.
struct operation_limits {
  /// From its call to its answer; 0 for no limit. The same as a server's (limits.edit_timeout_s).
  std::chrono::milliseconds time{2 * 60 * 1000};
  /// The programs that it may have started: those of the host's services and of files.
  std::vector<std::filesystem::path> programs = {};
};

/// `run_operation` in a forked copy of this process, for programs whose own process must outlive
/// the plugin: a crash, an exit, a hang, used up memory or a misdeed is an error that names plugin
/// and operation and says what happened. The copy is confined (sandbox/sandbox.hpp) where that is
/// wanted, and then has no file of this process open. It may use the memory that the machine has
/// free. Progress and what it logs arrive here while it runs; a cancel ends it at once. Errors:
/// those of `run_operation`; `internal` and `timeout` as above; `service_unavailable`. Cost beyond
/// that of the operation: a millisecond, and the copy of the pages that are new.
[[nodiscard]] expected<edit_result> run_operation_in_child(
  const catalogue& plugins, const std::string& id, const version_ptr& mesh, const selection& picked,
  const parameters& given, const context& ctx, const operation_limits& limits);

}  // namespace tedit::ops
