// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document.hpp"
#include "client-qt/model/quantities.hpp"
#include "client-qt/model/server_words.hpp"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace tedit::desktop {

static constexpr int catalogue_retry_ms = 1000;

document::document(remote& link, QObject* parent)
    : QObject(parent),
      link_(link),
      foreground_(link),
      solver_(*this, versions_, link),
      loads_(*this, versions_, link),
      edits_(*this, versions_, link),
      files_(*this, link),
      questions_(*this, link) {
  connect(&link_, &remote::surface_arrived, this, &document::take_surface);
  connect(&link_, &remote::field_arrived, this, &document::take_field);
  connect(&link_, &remote::committed, this, [this](const client::committed& what) {
    if (is_open())
      take(what);
  });
  connect(&link_, &remote::load_cases_changed, this, &document::take_load_cases);
  connect(&link_, &remote::renamed, this, &document::take_name);
  connect(&link_, &remote::participant_changed, this,
          [this](const client::participant& who, bool gone) { take(who, gone); });
  connect(&link_, &remote::fell_behind, this, [this](const client::backlog& what) {
    constexpr double megabyte = 1e6;
    emit warned(tr("The connection is slow: %1 MB wait for this computer. If that does not change "
                   "the server ends it in %2 s; it is made anew then.")
                  .arg(static_cast<double>(what.waiting_bytes) / megabyte, 0, 'f', 0)
                  .arg(what.closes_after_s, 0, 'f', 0));
  });
  connect(&link_, &remote::annotated, this, [this](const client::version_info& info) {
    if (versions_.take_annotation(info))
      emit history_changed();
  });
  connect(&link_, &remote::cad_known, this, [this](const client::version_info& info) {
    if (!versions_.take_annotation(info))
      return;
    emit history_changed();
    emit cad_known(info);
  });
}

QString document::surface_name(surface_id id) const {
  const auto* now = head();
  if (now && now->surface) {
    const auto& rows = now->surface->surfaces();
    const auto row = rows.find(id);
    if (row != rows.end() && !row->second.name.empty())
      return QString::fromStdString(row->second.name);
  }
  return tr("Surface %1").arg(id);
}

namespace {

/// A message takes the place of the one before it: what is said together is one.
QString sentences(const std::vector<std::string>& texts) {
  QStringList lines;
  for (const auto& text : texts)
    lines << sentence_of(text);
  return lines.join("\n");
}

}  // namespace

void document::say(const std::vector<std::string>& texts) {
  if (!texts.empty())
    emit notice(sentences(texts));
}

void document::warn(const std::vector<std::string>& texts) {
  if (!texts.empty())
    emit warned(sentences(texts));
}

// -- opening -------------------------------------------------------------------------

void document::begin(const QString& name) {
  ++opening_;
  const QString before = std::exchange(name_, {});
  versions_.forget();
  edits_.forget();
  solver_.forget(before);
  loads_.forget();
  name_ = name;
  others_.clear();
  emit begun();
  emit others_changed();
}

void document::load_catalogue() {
  link_.run<operation_catalogue>(
    [](client::client& c, const execution&) { return c.operations(); },
    [this](expected<operation_catalogue> got) {
      if (got) {
        operations_ = translated(std::move(*got));
        emit operations_changed();
      } else if (link_.current() == remote::state::connected) {
        if (got.error().code != ec::service_unavailable)  // Else the server still starts.
          emit notice(tr("The list of operations did not come: %1").arg(one_line(got.error())));
        QTimer::singleShot(catalogue_retry_ms, this, &document::load_catalogue);
      }
    });
}

void document::take_name(const QString& name) {
  if (!is_open() || name == name_)
    return;
  const QString before = std::exchange(name_, name);
  emit renamed(before);
}

void document::take(const client::document_state& state) {
  take_name(QString::fromStdString(state.document));
  edits_.take(state.can_undo, state.can_redo);
  versions_.set_head({});
  if (state.head) {
    versions_.set_head(state.head->number);
    versions_.take_info(*state.head);
  }
  loads_.take(state.load_cases);
  warn(state.warnings);
  others_ = state.participants;
  std::erase_if(others_, [&](const auto& one) { return one.id == state.own_participant; });
  emit head_changed();
  emit others_changed();
}

void document::take(const client::participant& who, bool gone) {
  if (!is_open())
    return;
  std::erase_if(others_, [&](const auto& one) { return one.id == who.id; });
  if (!gone)
    others_.push_back(who);
  emit others_changed();
}

// -- versions ------------------------------------------------------------------------

void document::take(const client::committed& what) {
  auto& row = versions_.take_info(what.head);
  if (what.report)
    row.report = what.report;
  versions_.set_head(what.head.number);
  edits_.take(what.can_undo, what.can_redo);
  warn(what.warnings);
  if (what.report)
    say(what.report->notices);
  loads_.take(what.load_cases);
  take_surface();
  solver_.set_progress(what.head.load_cases.empty() ? field_state::none : field_state::waiting);
  emit head_changed();
  emit edited(what);
  emit history_changed();
}

/// Asks for all versions' rows again.
void document::refresh_history(bool reports) {
  link_.run<client::history>(
    [reports](client::client& c, const execution&) { return c.get_history(reports); },
    [this, mine = opening_, known = versions_.annotations()](const expected<client::history>& got) {
      if (!got || mine != opening_)
        return;
      versions_.take_history(*got, known);
      emit history_changed();
    });
}

void document::take_surface() {
  const auto* row =
    versions_.take_surface(std::make_shared<const client::surface_model>(link_.surface()));
  if (row && row == head())
    emit surface_changed();
}

// -- fields and load cases -----------------------------------------------------------

void document::take_field(const shared_field& field) {
  const auto* row = versions_.take_field(field);
  if (!row || row != head())
    return;
  solver_.set_progress(field->interim() ? field_state::interim : field_state::converged);
  emit field_changed();
}

/// Names that were known and are gone leave the head's row; others may be of a kind that only the
/// server knows.
void document::take_load_cases(const client::load_cases_event& event) {
  if (auto* row = versions_.head(); row && row->info.version_id == event.version_id) {
    const auto& loads = event.load_cases;
    for (const auto& before : row->load_cases)
      if (std::ranges::find(loads, before.name, &fem::load_case::name) == loads.end())
        std::erase(row->info.load_cases, before.name);
    loads_.take(loads);
  }
  warn(event.warnings);
}

void document::forget_fields() {
  auto* row = versions_.head();
  if (row) {
    row->fields.clear();
    row->outcome.reset();
  }
  solver_.set_progress(field_state::none);
  if (row)
    emit field_changed();
}

}  // namespace tedit::desktop
