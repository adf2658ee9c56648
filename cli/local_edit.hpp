// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "fem/receipt.hpp"
#include "mesh/finish_edit.hpp"
#include "ops/loader/catalogue.hpp"

namespace tedit::cli {

/// One edit to make.
struct edit_request {
  std::string operation;
  std::vector<surface_id> surfaces;
  ops::parameters parameters;
};

/// An edit that was made: the version, and all that a person wants to know about it.
struct edit_outcome {
  version_ptr version;
  std::vector<surface_change> surface_map;
  std::vector<fem::receipt_line> receipt;
  std::vector<fem::load_case> load_cases;  ///< Carried over, in the order given.
  std::vector<std::string> notices;
  finished_edit finished;
  std::size_t tets_added = 0;
  std::size_t tets_removed = 0;
  double volume_change = 0;  ///< m^3.
  double operation_ms = 0;
  double total_ms = 0;
};

/// Operation, improvement, checks and receipt in this process. Errors: those of the steps; then
/// there is no version.
[[nodiscard]] expected<edit_outcome> apply_edit(const ops::catalogue& plugins,
                                                const version_ptr& base,
                                                const edit_request& request,
                                                const std::vector<fem::load_case>& load_cases,
                                                const execution& run);

/// The JSON object of `tedit edit`.
[[nodiscard]] nlohmann::ordered_json to_json(const mesh_version& base, const edit_outcome& outcome);

/// The same for people.
[[nodiscard]] std::string describe(const edit_outcome& outcome);

/// "name=value" pairs to parameters. Errors: `usage`.
[[nodiscard]] expected<ops::parameters> parse_parameters(const std::vector<std::string>& pairs);

}  // namespace tedit::cli
