// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/solve_requests.hpp"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

#include "client-qt/model/document.hpp"
#include "client-qt/model/document_name.hpp"
#include "client-qt/model/quantities.hpp"

namespace tedit::desktop {

bool is_solving(const client::server_status& server) {
  return std::ranges::any_of(server.workers, [](const client::worker_status& worker) {
    return worker.role == "solver" && worker.jobs > 0;
  });
}

solve_requests::solve_requests(document& part, version_store& versions, remote& link)
    : part_(part), versions_(versions), link_(link) {
  settings_.all_load_cases = true;
  connect(&link_, &remote::solve_status, this, &solve_requests::take_status);
  connect(&link_, &remote::solved, this, &solve_requests::take_outcome);
  connect(&link_, &remote::state_changed, this, [this] {
    if (link_.current() == remote::state::lost && progress_ == field_state::solving)
      set_progress(field_state::waiting);
    note_server();
  });
}

void solve_requests::forget(const QString& document) {
  if (is_running())
    part_.work().leave(job_, title_of(document).words);
  status_ = {};
  set_progress(field_state::none);
}

// -- requests ------------------------------------------------------------------------

void solve_requests::set_settings(const client::solve_settings& settings) {
  settings_ = settings;
  solve();
}

void solve_requests::solve(std::uint64_t held) {
  if (!versions_.head())
    return;
  set_progress(field_state::waiting);
  auto settings = settings_;
  settings.held_solve = held;
  link_.run<solve_outcome>(
    [settings](client::client& c, const execution& run) { return c.solve_cases(settings, run); },
    [this, held, mine = part_.opening()](const expected<solve_outcome>& got) {
      if (mine != part_.opening())
        return;
      if (got && held != 0 && got->solve == held)
        return set_progress(field_state::converged);  // Its fields are here.
      if (got || got.error().code == ec::superseded)
        return;  // The document has heard of it as of everybody's solves; another one follows.
      if (got.error().code == ec::cancelled)
        return set_progress(field_state::stopped);
      set_progress(field_state::failed);
      emit part_.failed(tr("Solve"), got.error());
    },
    [this](double fraction, const QString& stage) {
      part_.work().progress(job_, fraction, words_of(stage.toStdString()));
    });
}

void solve_requests::cancel() {
  if (!is_running())
    return;
  link_.run<void>([](client::client& c, const execution&) { return c.cancel_solve(); },
                  [this](const expected<void>& ok) {  // That it ended comes as an event.
                    if (!ok)
                      emit part_.failed(tr("Stop the solver"), ok.error());
                  });
}

void solve_requests::watch(const client::watched_quantities& wanted) {
  auto all = watched_;
  all.insert(wanted.begin(), wanted.end());
  if (std::exchange(watched_, all) != all)
    send_watch();
}

std::uint64_t solve_requests::held_solve() const {
  const auto* row = versions_.head();
  if (!row || row->fields.empty() || row->fields.back()->remaining > 0 ||
      row->fields.back()->interim())
    return 0;
  const auto has_all = [&](const shared_field& one) {
    return one->envelope || std::ranges::none_of(watched_, [&](const std::string& name) {
             return one->values.of(name).empty();
           });
  };
  return std::ranges::all_of(row->fields, has_all) ? row->fields.back()->solve : 0;
}

void solve_requests::send_watch(std::uint64_t held) {
  if (!part_.is_open() || watched_.empty())
    return;
  link_.run<std::string>(
    [wanted = watched_, held](client::client& c, const execution&) {
      return c.watch_fields(wanted, held);
    },
    [this, mine = part_.opening()](const expected<std::string>& got) {
      if (mine != part_.opening() || link_.current() != remote::state::connected)
        return;
      if (!got)
        emit part_.failed(tr("Fields on demand"), got.error());
      else if (!got->empty() && progress_ == field_state::converged)
        emit part_.notice(sentence_of(*got));
    });
}

// -- what the server tells -----------------------------------------------------------

void solve_requests::take_outcome(const solve_outcome& outcome) {
  if (outcome.cases.empty() || outcome.cases.front().interim)
    return;
  auto* row = versions_.find(outcome.version_id());
  if (!row)
    return;
  row->outcome = outcome;
  for (const auto& report : outcome.cases) {
    if (!report.notice.empty())
      emit part_.notice(sentence_of(report.notice));
    for (const auto& warning : report.warnings)
      emit part_.notice(sentence_of(warning));
  }
  emit changed();
  emit part_.history_changed();
}

void solve_requests::take_status(const client::solve_status& status) {
  const auto* now = versions_.head();
  if (!now || now->info.version_id != status.version_id)
    return;
  status_ = status;
  using phase = client::solve_phase;
  if (status.phase == phase::started || status.phase == phase::converging) {
    if (progress_ != field_state::interim)
      set_progress(field_state::solving);
    note_residual(status);
  } else if (status.phase == phase::failed) {
    set_progress(field_state::failed);
    emit part_.failed(tr("Solve"), {ec::not_converged, status.message, {}, {}});
  } else if (status.phase == phase::cancelled) {
    set_progress(field_state::stopped);
  }
  emit changed();
}

/// The residual falls about evenly in its logarithm.
void solve_requests::note_residual(const client::solve_status& status) {
  const double residual = status.true_relative_residual;
  if (status.iterations > 0 && residual > 0 && residual < 1)
    part_.work().progress(
      job_, std::min(0.99, std::log(residual) / std::log(settings_.tolerance)),
      tr("iteration %1, residual %2")
        .arg(status.iterations)
        .arg(QString::number(residual, 'g', 2).replace('.', QLocale().decimalPoint())));
}

void solve_requests::set_progress(field_state next) {
  const bool other = std::exchange(progress_, next) != next;
  note_job();
  if (other)
    emit changed();
}

/// What was left is over once the server's solver has nothing to do. A status may have been on its
/// way already when the document was left.
void solve_requests::note_server() {
  constexpr int two_statuses_ms = 6000;
  const bool solves = link_.current() != remote::state::offline && is_solving(link_.server());
  if (!solves && part_.work().left_for_ms() > two_statuses_ms)
    part_.work().forget_left();
}

/// The solve among what runs.
void solve_requests::note_job() {
  const bool runs = progress_ == field_state::waiting || progress_ == field_state::solving ||
                    progress_ == field_state::interim;
  auto& all = part_.work();
  if (!runs)
    all.end(std::exchange(job_, 0));
  else if (job_ == 0)
    job_ = all.begin(tr("Solve"), [this] { cancel(); });
}

}  // namespace tedit::desktop
