// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ops/loader/plugin_fit.hpp"
#include "ops/loader/plugin_report.hpp"

namespace tedit::ops {

/// An operation and what calls it.
struct callable_operation {
  described_operation about;
  std::shared_ptr<const operation> code;
};

/// Loads a plugin into this process until that ends, which runs its start-up code, and has its
/// operations described. Errors: `plugin_refused`, whose message goes on from "the plugin is not
/// used: ".
[[nodiscard]] expected<std::vector<callable_operation>> load_plugin(
  const std::filesystem::path& file, const sdk_offer& offer = {});

/// An operation that another process described. The process that first calls `apply` loads the
/// plugin; until then none of its code runs here. Errors of `apply`, beside the operation's:
/// `plugin_refused`, also where the file describes itself otherwise by then.
[[nodiscard]] callable_operation make_deferred(described_operation about,
                                               std::filesystem::path file,
                                               const sdk_offer& offer = {});

/// `plugin_refused`: the file and the reason.
[[nodiscard]] error plugin_not_used(const std::filesystem::path& file, const std::string& reason);

}  // namespace tedit::ops
