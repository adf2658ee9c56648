// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/session/session.hpp"

namespace tedit::actors {

/// What an operation made of the head, improved and checked: what an edit commits and a preview
/// shows.
struct session_state::checked_candidate {
  version_ptr mesh;
  shared_load_cases load_cases = no_load_cases();  ///< Carried over.
  shared_report report;                            ///< Without `total_ms`.

  [[nodiscard]] shared_report timed_report(double total_ms) const {
    auto timed = std::make_shared<edit_report>(*report);
    timed->total_ms = total_ms;
    return timed;
  }
};

/// An operation on its way to a checked candidate, for an edit or for a preview. Neither `done` nor
/// `refuse` is called once it has ended; else one of them, once.
struct session_state::candidate_run {
  apply_request request;
  version_ptr base;
  shared_load_cases load_cases = no_load_cases();  ///< Of the base.
  page_set pages;  ///< Of the candidate: its worker may die before it is checked.
  bool preview = false;
  bool find_most = true;  ///< Where it is refused, look for the most that works.
  bool draft = false;     ///< Only what is seen of it.
  std::function<void(const std::shared_ptr<const checked_candidate>&)> done;
  std::function<void(const error&)> refuse;
  std::function<void()> cancel_job;
  bool cancelled = false;
  bool ended = false;  ///< Nobody waits for it any more.
  int retries = 0;

  /// Asks the worker to end; `refuse` says when it has.
  void cancel() {
    cancelled = true;
    if (cancel_job)
      cancel_job();
  }
};

/// A preview without an answer yet.
struct session_state::preview_run {
  std::shared_ptr<candidate_run> work;
  caf::typed_response_promise<previewed> promise;
};

/// The last finished preview, for the edit that may follow it.
struct session_state::kept_candidate {
  apply_request request;
  version_ptr base;
  shared_load_cases load_cases = no_load_cases();  ///< Of the base.
  std::shared_ptr<const checked_candidate> made;

  /// Whether an edit of a head with these load cases would make the very same.
  [[nodiscard]] bool serves(const apply_request& other, const graph_node& head) const {
    return base->id() == head.info.id && *load_cases == *head.load_cases &&
           request.wanted == other.wanted;
  }
};

}  // namespace tedit::actors
