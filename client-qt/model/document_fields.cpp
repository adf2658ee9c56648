// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document.hpp"

namespace tedit::desktop {

void document::take_field(const shared_field& field) {
  auto* row = find(field->version_id());
  if (!row)
    return;
  const bool next = !row->fields.empty() && row->fields.back()->remaining > 0 &&
                    row->fields.back()->remaining == field->remaining + 1 &&
                    row->fields.back()->interim() == field->interim();
  if (!next)
    row->fields.clear();
  row->fields.push_back(field);
  if (field->remaining > 0)
    return;
  if (row == head()) {
    set_field_state(field->interim() ? field_state::interim : field_state::converged);
    emit field_changed();
  }
}

void document::take_outcome(const solve_outcome& outcome) {
  if (outcome.cases.empty() || outcome.cases.front().interim)
    return;
  if (auto* row = find(outcome.version_id())) {
    row->outcome = outcome;
    for (const auto& report : outcome.cases)
      if (!report.notice.empty())
        emit notice(QString::fromStdString(report.notice));
    emit solve_changed();
    emit history_changed();
  }
}

void document::take_status(const client::solve_status& status) {
  const auto* now = head();
  if (!now || now->info.version_id != status.version_id)
    return;
  solve_status_ = status;
  using phase = client::solve_phase;
  if (status.phase == phase::started || status.phase == phase::converging) {
    if (field_state_ != field_state::interim)
      set_field_state(field_state::solving);
  } else if (status.phase == phase::failed) {
    set_field_state(field_state::failed);
    if (solves_ == 0)  // Else the answer to the request says it.
      emit failed(tr("Solve"), {ec::not_converged, status.message, {}, {}});
  } else if (status.phase == phase::cancelled) {
    set_field_state(field_state::none);
  }
  emit solve_changed();
}

void document::set_field_state(field_state next) {
  if (std::exchange(field_state_, next) != next)
    emit solve_changed();
}

// -- what is watched -----------------------------------------------------------------

void document::watch(const client::watched_quantities& wanted) {
  const client::watched_quantities all{watched_.stress || wanted.stress,
                                       watched_.safety_factor || wanted.safety_factor,
                                       watched_.relative_error || wanted.relative_error};
  if (std::exchange(watched_, all) != all)
    send_watch();
}

/// Also after the document was opened again: the server forgets it with the connection.
void document::send_watch() {
  if (!is_open() || watched_ == client::watched_quantities{})
    return;
  const int mine = opening_;
  link_.run<std::string>(
    [wanted = watched_](client::client& c, const execution&) { return c.watch_fields(wanted); },
    [this, mine](const expected<std::string>& got) {
      if (mine != opening_ || link_.current() != remote::state::connected)
        return;
      if (!got)
        emit failed(tr("Fields on demand"), got.error());
      else if (!got->empty() && field_state_ == field_state::converged)
        emit notice(QString::fromStdString(*got));
    });
}

// -- solving -------------------------------------------------------------------------

void document::set_solve_settings(const client::solve_settings& settings) {
  settings_ = settings;
  solve();
}

void document::solve() {
  const auto* now = head();
  if (!now)
    return;
  const int mine = opening_;
  ++solves_;
  set_field_state(field_state::waiting);
  solving_ = link_.run<solve_outcome>(
    [settings = settings_](client::client& c, const execution& run) {
      return c.solve_cases(settings, run);
    },
    [this, mine](const expected<solve_outcome>& got) {
      if (mine != opening_)
        return;
      --solves_;
      if (got)
        take_outcome(*got);
      else if (got.error().code != ec::superseded && got.error().code != ec::cancelled) {
        set_field_state(field_state::failed);
        emit failed(tr("Solve"), got.error());
      }
    });
}

void document::cancel_solve() {
  solving_.cancel();
}

}  // namespace tedit::desktop
