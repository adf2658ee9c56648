// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ops/sdk/operation.hpp"

/// The conformance kit: every rule that a plugin must keep, as a check with a name. docs/plugins.md
/// lists them for authors.
namespace tedit::ops {

enum class verdict { pass, fail, not_run };

/// What one check says.
struct conformance_row {
  std::string check;  ///< Stable, for example "volume_claim".
  std::string rule;   ///< What must hold, one sentence.
  verdict outcome = verdict::not_run;
  std::string seen;    ///< What was seen, or why the check was not run.
  std::string remedy;  ///< What the author can do; empty unless it failed.
  /// What the plugin wrote meanwhile to `context::log` and to stderr: the last 20 lines.
  std::vector<std::string> log;
  std::uint32_t operation = 0;  ///< Index in the plugin.
};

struct conformance_settings {
  std::filesystem::path file;        ///< The plugin.
  version_ptr part;                  ///< A mesh beside the kit's own; may be null.
  std::vector<surface_id> selected;  ///< A selection of `part` that must be accepted; may be empty.
  parameters values;                 ///< Instead of the defaults, wherever the edit shall succeed.
  /// Names of checks; empty for all. Those that others rest on (the file, the survey) run always.
  std::vector<std::string> checks;
  unsigned repeat =
    1;  ///< How often each of these is run, until it fails: for faults that come and go.
  cancel_token cancel;                     ///< Ends the check that runs, and no other begins.
  std::chrono::milliseconds limit{10000};  ///< For one call of the plugin.
  std::size_t memory_bytes = std::size_t{4} << 30;  ///< Address space of one check.
};

struct conformance_report {
  std::vector<conformance_row> rows;
  std::string plugin;    ///< Name and version; empty when they could not be read.
  bool blocked = false;  ///< Some check was kept from running by the failure of another.

  /// True when no check failed or was kept from running. Without `part` the check that needs one
  /// is not run, which is no failure.
  [[nodiscard]] bool ok() const;
};

/// Runs all checks on the plugin's operations. Each runs in a child process with limits of time and
/// memory, which alone loads the plugin: a crash or a hang is a failed check with a name. To be
/// called while the process has one thread. `done` hears of each row as it is ready; it may be
/// empty. Cost: some hundred applies on meshes of 500 tets, and some on `part`.
[[nodiscard]] conformance_report test_plugin(
  const conformance_settings& settings, const std::function<void(const conformance_row&)>& done);

/// The names of all checks with their rules, in the order in which they run.
[[nodiscard]] std::vector<conformance_row> conformance_checks();

}  // namespace tedit::ops
