// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tedit::desktop {

namespace {

constexpr std::size_t most_kept_surfaces = 64;  // Versions whose surface and field stay at hand.

}  // namespace

/// What was held of another version that had this number, in a document that was made anew on the
/// server, goes with it.
version_record& document::take_info(const client::version_info& info) {
  auto& row = versions_[info.number];
  if (!row.info.version_id.empty() && row.info.version_id != info.version_id)
    row = {};
  row.info = info;
  if (auto report = std::exchange(row.info.report, std::nullopt))
    row.report = std::move(report);
  return row;
}

/// A surface may come before the commit that it belongs to is known; then it is taken with that.
void document::take_surface() {
  auto surface = std::make_shared<const client::surface_model>(link_.surface());
  auto* row = find(surface->version_id());
  if (!row || (row->surface && row->surface->version_id() == surface->version_id()))
    return;
  row->surface = std::move(surface);
  std::size_t kept = 0;
  for (auto at = versions_.rbegin(); at != versions_.rend(); ++at)
    if (at->second.surface && ++kept > most_kept_surfaces && at->first != head_) {
      at->second.surface.reset();
      at->second.fields.clear();
    }
  if (row == head())
    emit surface_changed();
}

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
    for (const auto& report : outcome.cases) {
      if (!report.notice.empty())
        emit notice(QString::fromStdString(report.notice));
      for (const auto& warning : report.warnings)
        emit notice(QString::fromStdString(warning));
    }
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
    // The residual falls about evenly in its logarithm.
    const double residual = status.true_relative_residual;
    if (status.iterations > 0 && residual > 0 && residual < 1)
      work_.progress(
        solve_job_, std::min(0.99, std::log(residual) / std::log(settings_.tolerance)),
        tr("iteration %1, residual %2").arg(status.iterations).arg(residual, 0, 'g', 2));
  } else if (status.phase == phase::failed) {
    set_field_state(field_state::failed);
    if (solves_ == 0)  // Else the answer to the request says it.
      emit failed(tr("Solve"), {ec::not_converged, status.message, {}, {}});
  } else if (status.phase == phase::cancelled) {
    set_field_state(field_state::stopped);
  }
  emit solve_changed();
}

void document::set_field_state(field_state next) {
  const bool other = std::exchange(field_state_, next) != next;
  note_solve();
  if (other)
    emit solve_changed();
}

/// The solve among what runs.
void document::note_solve() {
  const bool runs = field_state_ == field_state::waiting || field_state_ == field_state::solving ||
                    field_state_ == field_state::interim;
  if (!runs) {
    work_.end(std::exchange(solve_job_, 0));
    return;
  }
  if (solve_job_ == 0)
    solve_job_ = work_.begin(tr("Solve"), [this] { cancel_solve(); });
}

// -- load cases and names ------------------------------------------------------------

/// Names that were known and are gone leave the head's row; others may be of a kind that only the
/// server knows.
void document::take_other_load_cases(const std::vector<fem::load_case>& loads) {
  auto& row = versions_[*head_];
  for (const auto& before : row.load_cases)
    if (std::ranges::find(loads, before.name, &fem::load_case::name) == loads.end())
      std::erase(row.info.load_cases, before.name);
  if (loads.empty())
    forget_fields();
  take_load_cases(loads);
}

/// Without loads the head has no field, whatever was shown of it before.
void document::forget_fields() {
  auto* row = head_ ? &versions_[*head_] : nullptr;
  if (row) {
    row->fields.clear();
    row->outcome.reset();
  }
  set_field_state(field_state::none);
  if (row)
    emit field_changed();
}

/// One request; `done` when it was granted and the document is still the one that asked.
void document::change_loads(const QString& title, remote::work<void> change,
                            std::function<void()> done) {
  ++load_requests_;
  link_.run<void>(std::move(change),
                  [this, title, done = std::move(done), mine = opening_](const expected<void>& ok) {
                    --load_requests_;
                    if (mine != opening_)
                      return;
                    if (ok)
                      done();
                    else
                      emit failed(title, ok.error());
                  });
}

void document::remove_load_case(const std::string& name) {
  change_loads(
    tr("Remove the load case"),
    [name](client::client& c, const execution&) { return c.remove_load_case(name); },
    [this, name] {
      emit load_case_removed(name);
      if (!load_cases().empty())
        solve();
    });
}

void document::rename_load_case(const std::string& before, const fem::load_case& renamed) {
  change_loads(
    tr("Rename the load case"),
    [before, renamed](client::client& c, const execution&) -> expected<void> {
      if (auto ok = c.set_load_case(renamed); !ok)
        return ok;
      return c.remove_load_case(before);
    },
    [this, before, renamed] {
      emit load_case_set(renamed);
      emit load_case_removed(before);
      solve();
    });
}

void document::annotate(std::uint32_t number, const QString& name, const QString& note) {
  link_.run<void>([number, name = name.toStdString(), note = note.toStdString()](
                    client::client& c, const execution&) { return c.annotate(number, name, note); },
                  [this](const expected<void>& ok) {  // What it is called now comes as an event.
                    if (!ok)
                      emit failed(tr("Name the version"), ok.error());
                  });
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
  link_.run<solve_outcome>(
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
    },
    [this](double fraction, const QString& stage) { work_.progress(solve_job_, fraction, stage); });
}

void document::cancel_solve() {
  if (!is_solving())
    return;
  link_.run<void>([](client::client& c, const execution&) { return c.cancel_solve(); },
                  [this](const expected<void>& ok) {  // That it ended comes as an event.
                    if (!ok)
                      emit failed(tr("Stop the solver"), ok.error());
                  });
}

}  // namespace tedit::desktop
