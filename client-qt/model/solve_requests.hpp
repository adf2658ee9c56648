// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QObject>

#include "client-qt/net/remote.hpp"

namespace tedit::desktop {

class document;
class version_store;

/// How far the field of the head is.
enum class field_state { none, waiting, solving, interim, converged, failed, stopped };

/// Whether the server solves something, for whomever.
[[nodiscard]] bool is_solving(const client::server_status& server);

/// The solver: what it is told, how far it is, and which quantities come with its fields.
class solve_requests : public QObject {
  Q_OBJECT

public:
  solve_requests(document& part, version_store& versions, remote& link);

  [[nodiscard]] field_state progress() const noexcept { return progress_; }
  [[nodiscard]] const client::solve_status& status() const { return status_; }
  /// Whether a solve runs or is about to.
  [[nodiscard]] bool is_running() const noexcept { return job_ != 0; }
  /// Solves all load cases of the head; from then on every new head is solved by itself. Fields of
  /// the solve `held` do not come again.
  void solve(std::uint64_t held = 0);
  /// Ends the solve that runs, also one that followed an edit by itself.
  void cancel();
  void set_settings(const client::solve_settings& settings);
  [[nodiscard]] const client::solve_settings& settings() const { return settings_; }
  /// Fields bring this, too, from now on, and the one of the head comes again with it. What was
  /// watched before stays so until the document is closed.
  void watch(const client::watched_quantities& wanted);

  // -- for the document ----------------------------------------------------------------

  void set_progress(field_state next);
  /// Also after the document was opened again: the server forgets it with the connection. `held`
  /// as in `solve`.
  void send_watch(std::uint64_t held = 0);
  /// The solve whose fields, with all that is watched, the head's row has; 0: none.
  [[nodiscard]] std::uint64_t held_solve() const;
  /// `document`: the one that is left. A solve of it goes on at the server.
  void forget(const QString& document);
  void forget_watch() { watched_ = {}; }

signals:
  void changed();

private:
  void take_outcome(const solve_outcome& outcome);
  void take_status(const client::solve_status& status);
  void note_residual(const client::solve_status& status);
  void note_job();
  void note_server();

  document& part_;
  version_store& versions_;
  remote& link_;
  client::solve_settings settings_;
  client::watched_quantities watched_;
  field_state progress_ = field_state::none;
  client::solve_status status_;
  int job_ = 0;  ///< 0: no solve runs.
};

}  // namespace tedit::desktop
