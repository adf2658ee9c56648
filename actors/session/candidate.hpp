// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "actors/session/session.hpp"
#include "protocol/report.hpp"

namespace tedit::actors {

/// What an operation made of the head, improved and checked: what an edit commits and a preview
/// shows.
struct session_state::checked_edit {
  version_ptr mesh;
  std::vector<std::string> load_cases;  ///< JSON each, carried over.
  edit_report report;                   ///< Without `total_ms`.
};

/// An operation on its way to a checked candidate, for an edit or for a preview. Neither `done` nor
/// `refuse` is called once it has ended; else one of them, once.
struct session_state::candidate_run {
  edit_request request;
  version_ptr base;
  std::vector<std::string> load_cases;  ///< Of the base, JSON each.
  bool preview = false;
  bool find_most = true;  ///< Where it is refused, look for the most that works.
  std::function<void(const std::shared_ptr<const checked_edit>&)> done;
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
  edit_request request;
  version_ptr base;
  std::vector<std::string> load_cases;  ///< Of the base.
  std::shared_ptr<const checked_edit> made;

  /// Whether an edit of a head with these load cases would make the very same.
  [[nodiscard]] bool serves(const edit_request& wanted, const graph_node& head) const {
    return base->id() == head.info.id && load_cases == head.load_cases &&
           request.operation == wanted.operation && request.surfaces == wanted.surfaces &&
           request.parameters == wanted.parameters && request.loads.policy == wanted.loads.policy &&
           request.loads.keep_traction == wanted.loads.keep_traction;
  }
};

}  // namespace tedit::actors
