// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "fem/load_case.hpp"
#include "mesh/finish_edit.hpp"
#include "protocol/report.hpp"

namespace tedit::actors {

/// A checked edit with its report and the load cases carried over.
struct finished_candidate {
  version_ptr version;
  std::vector<fem::load_case> load_cases;  ///< In the order given.
  edit_report report;  ///< Operation, selection, operation_ms and total_ms are the caller's.
};

/// What happens to a candidate after its operation: the improvement asked for, the postconditions,
/// the surface map and the receipt of each load case. Errors: those of `finish_edit` and, when
/// losses are to be refused, of `fem::refuse_losses`.
[[nodiscard]] expected<finished_candidate> finish_candidate(
  const version_ptr& base, const version_ptr& candidate, const edit_claim& claim,
  const improve_request& wanted, const std::vector<fem::load_case>& load_cases,
  const fem::carry_settings& settings, const execution& run);

}  // namespace tedit::actors
