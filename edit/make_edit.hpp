// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/report.hpp"
#include "fem/load_case.hpp"
#include "ops/loader/catalogue.hpp"
#include "ops/loader/child_operation.hpp"
#include "ops/services/host_services.hpp"

/// The one way from a request to a version that may be shown and stored: the operation, then all
/// that follows it whoever wrote the operation. A server runs the two halves in two processes, so
/// that a plugin that corrupts its own cannot pass the checks; the command line runs them in one.
namespace tedit {

/// Where an operation runs, and what it may use.
struct operation_place {
  std::shared_ptr<ops::services> host = ops::make_host_services();
  /// Takes what the operation logs, as "OPERATION: line"; may be empty.
  std::function<void(const std::string&)> log = {};
  bool find_most = true;  ///< Where it is refused, look for the most that works.
  std::optional<ops::operation_limits> child = {};  ///< In a process of its own; else in this one.
};

/// What an operation made, and what it says about that: nothing of it is checked.
struct edit_candidate {
  ops::edit_result made;
  double operation_ms = 0;
};

/// The first half. Errors: those of `ops::run_operation`, and with `child` those of
/// `ops::run_operation_in_child`.
[[nodiscard]] expected<edit_candidate> run_operation(const ops::catalogue& plugins,
                                                     const version_ptr& base,
                                                     const edit_request& wanted,
                                                     const operation_place& place,
                                                     const execution& run);

/// A version that passed every postcondition, with the base's load cases carried over to it.
struct checked_edit {
  version_ptr version;
  std::vector<fem::load_case> load_cases;  ///< In the order given.
  edit_report report;                      ///< Without `total_ms`.
};

/// The second half: the improvement that the operation asks for, the postconditions, the surface
/// map and the receipt of each load case. Errors: those of `finish_edit` and, when losses are to be
/// refused, of `fem::refuse_losses`.
[[nodiscard]] expected<checked_edit> check_candidate(const version_ptr& base,
                                                     const edit_candidate& candidate,
                                                     const edit_request& wanted,
                                                     const std::vector<fem::load_case>& load_cases,
                                                     const execution& run);

/// In place of the second half for what is only looked at: the surface map and the receipt of each
/// load case, with the operation's word for the change of volume. Nothing is improved, checked or
/// counted.
[[nodiscard]] expected<checked_edit> draft_of(const version_ptr& base,
                                              const edit_candidate& candidate,
                                              const edit_request& wanted,
                                              const std::vector<fem::load_case>& load_cases);

/// Both, one after the other, with `total_ms`.
[[nodiscard]] expected<checked_edit> make_edit(const ops::catalogue& plugins,
                                               const version_ptr& base, const edit_request& wanted,
                                               const std::vector<fem::load_case>& load_cases,
                                               const operation_place& place, const execution& run);

}  // namespace tedit
