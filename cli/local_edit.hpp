// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/recipe.hpp"
#include "fem/load_case.hpp"
#include "ops/loader/child_operation.hpp"
#include "protocol/report.hpp"

namespace tedit::cli {

using client::edit_request;

/// An edit that was made.
struct edit_outcome {
  version_ptr version;
  edit_report report;
  std::vector<fem::load_case> load_cases;  ///< Carried over, in the order given.
};

/// Where the operation runs.
struct operation_place {
  std::optional<ops::operation_limits> child;   ///< In a process of its own; else in this one.
  std::function<void(const std::string&)> log;  ///< Takes "OPERATION: line"; may be empty.
};

/// Operation, improvement, checks and receipt. Errors: those of the steps; then there is no
/// version.
[[nodiscard]] expected<edit_outcome> apply_edit(const ops::catalogue& plugins,
                                                const version_ptr& base,
                                                const edit_request& request,
                                                const std::vector<fem::load_case>& load_cases,
                                                const execution& run,
                                                const operation_place& place = {});

/// "name=value" pairs to parameters. Errors: `usage`.
[[nodiscard]] expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs);

}  // namespace tedit::cli
