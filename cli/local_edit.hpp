// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "client/recipe.hpp"
#include "fem/load_case.hpp"
#include "ops/loader/catalogue.hpp"
#include "protocol/report.hpp"

namespace tedit::cli {

using client::edit_request;

/// An edit that was made.
struct edit_outcome {
  version_ptr version;
  edit_report report;
  std::vector<fem::load_case> load_cases;  ///< Carried over, in the order given.
};

/// Operation, improvement, checks and receipt in this process. Errors: those of the steps; then
/// there is no version.
[[nodiscard]] expected<edit_outcome> apply_edit(const ops::catalogue& plugins,
                                                const version_ptr& base,
                                                const edit_request& request,
                                                const std::vector<fem::load_case>& load_cases,
                                                const execution& run);

/// "name=value" pairs to parameters. Errors: `usage`.
[[nodiscard]] expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs);

}  // namespace tedit::cli
