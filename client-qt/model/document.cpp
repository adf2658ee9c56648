// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/model/document.hpp"

#include <QFileInfo>
#include <QSaveFile>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <utility>

#include "client-qt/model/document_name.hpp"
#include "client-qt/model/load_editing.hpp"
#include "client-qt/model/load_words.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

namespace {

constexpr int catalogue_retry_ms = 1000;

}  // namespace

document::document(remote& link, QObject* parent) : QObject(parent), link_(link) {
  settings_.all_load_cases = true;
  connect(&link_, &remote::connected, this, &document::reopen);
  connect(&link_, &remote::state_changed, this, &document::connection_changed);
  connect(&link_, &remote::surface_arrived, this, &document::take_surface);
  connect(&link_, &remote::field_arrived, this, &document::take_field);
  connect(&link_, &remote::committed, this, &document::take_event);
  connect(&link_, &remote::load_cases_changed, this, [this](const client::load_cases_event& event) {
    if (head() && head()->info.version_id == event.version_id)
      take_other_load_cases(event.load_cases);
    for (const auto& warning : event.warnings)
      emit notice(QString::fromStdString(warning));
  });
  connect(&link_, &remote::annotated, this, [this](const client::version_info& info) {
    const auto row = versions_.find(info.number);
    if (row == versions_.end() || row->second.info.version_id != info.version_id)
      return;
    row->second.info = info;
    row->second.annotation = ++annotations_;
    emit history_changed();
  });
  connect(&link_, &remote::solve_status, this, &document::take_status);
  connect(&link_, &remote::solved, this, &document::take_outcome);
}

// -- what is known -------------------------------------------------------------------

const version_record* document::head() const {
  const auto found = head_ ? versions_.find(*head_) : versions_.end();
  return found == versions_.end() ? nullptr : &found->second;
}

const std::vector<fem::load_case>& document::load_cases() const {
  static const std::vector<fem::load_case> none;
  const auto* now = head();
  return now ? now->load_cases : none;
}

/// The latest with this content: undo brings the same one back.
version_record* document::find(const std::string& version_id) {
  if (head_ && versions_.contains(*head_) && versions_[*head_].info.version_id == version_id)
    return &versions_[*head_];
  for (auto at = versions_.rbegin(); at != versions_.rend(); ++at)
    if (at->second.info.version_id == version_id)
      return &at->second;
  return nullptr;
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

QStringList document::acting_on(const std::vector<surface_id>& surfaces) const {
  QStringList result;
  const auto touches = [&](const auto& item) {
    return std::ranges::any_of(item.surfaces, [&](surface_id id) {
      return std::ranges::find(surfaces, id) != surfaces.end();
    });
  };
  for (const auto& one : load_cases()) {
    const QString in = tr(" in %1").arg(QString::fromStdString(one.name));
    for (const auto& held : one.constraints)
      if (touches(held))
        result << words(held) + in;
    for (const auto& acting : one.loads)
      if (touches(acting))
        result << words(acting) + in;
  }
  return result;
}

// -- activities ----------------------------------------------------------------------

void document::begin_activity(const QString& title) {
  activity_ = activity{title, {}, 0, true};
  work_.end(activity_job_);
  activity_job_ = work_.begin(title, [this] { cancel(); });
  emit activity_changed();
}

void document::end_activity() {
  activity_.reset();
  work_.end(activity_job_);
  emit activity_changed();
}

void document::progressed(double fraction, const QString& stage) {
  if (!activity_)
    return;
  activity_->fraction = fraction;
  activity_->stage = stage;
  work_.progress(activity_job_, fraction, stage);
  emit activity_changed();
}

/// A request that the user waits for; one at a time is shown.
template <class T>
ticket document::ask(const QString& title, remote::work<T> call, std::function<void(T&)> done,
                     std::function<bool(const error&)> keep) {
  begin_activity(title);
  const int mine = opening_;
  running_ = link_.run<T>(
    std::move(call),
    [this, title, mine, done = std::move(done), keep = std::move(keep)](expected<T> result) {
      end_activity();
      if (mine != opening_)
        return;
      if (result)
        done(*result);
      else if (!keep || !keep(result.error()))
        emit failed(title, result.error());
    },
    [this](double fraction, const QString& stage) { progressed(fraction, stage); });
  return running_;
}

void document::cancel() {
  if (!activity_)
    return;
  running_.cancel();
  activity_->stage = tr("cancelling");
  activity_->can_cancel = false;
  emit activity_changed();
}

// -- opening -------------------------------------------------------------------------

void document::forget() {
  ++opening_;
  name_.clear();
  unanswered_.reset();
  versions_.clear();
  head_.reset();
  can_undo_ = can_redo_ = false;
  solve_status_ = {};
  solves_ = 0;
  set_field_state(field_state::none);
}

void document::close() {
  forget();
  watched_ = {};
  emit closed();
}

void document::open(const QString& name) {
  forget();
  name_ = name;
  reopen();
}

/// Also when a lost connection is back: the server sends the whole surface again.
void document::reopen() {
  load_catalogue();
  if (name_.isEmpty())
    return;
  ask<client::document_state>(
    tr("Open %1").arg(name_),
    [name = name_.toStdString()](client::client& c, const execution&) {
      return c.open(name, true, true);
    },
    [this](client::document_state& state) {
      take_state(state);
      send_watch();
      emit opened();
      take_surface();  // It may have come before this answer.
      ask_history(true);
      ask_again();
      if (state.head && !state.head->load_cases.empty())
        solve();
    });
}

void document::take_state(const client::document_state& state) {
  name_ = QString::fromStdString(state.document);
  can_undo_ = state.can_undo;
  can_redo_ = state.can_redo;
  head_.reset();
  if (state.head) {
    head_ = state.head->number;
    take_info(*state.head);
  }
  if (state.load_cases.empty())
    forget_fields();
  take_load_cases(state.load_cases);
  for (const auto& warning : state.warnings)
    emit notice(QString::fromStdString(warning));
  emit head_changed();
}

void document::import(const QString& mesh, const QStringList& load_cases, const QString& unit) {
  std::vector<fem::load_case> loads;
  for (const auto& file : load_cases) {
    auto read = protocol::load_case_from_file(file.toStdString());
    if (!read) {
      emit failed(tr("Open %1").arg(file), read.error());
      return;
    }
    loads.push_back(std::move(*read));
  }
  forget();
  name_ = new_document_name(mesh, QDateTime::currentDateTime());
  load_catalogue();
  ask<client::committed>(
    tr("Open %1").arg(QFileInfo(mesh).fileName()),
    [mesh = mesh.toStdString(), unit = unit.toStdString(), name = name_.toStdString()](
      client::client& c, const execution& run) -> expected<client::committed> {
      if (auto state = c.open(name, true, true); !state)
        return fail(std::move(state.error()));
      return c.import_file(mesh, unit, run);
    },
    [this, loads = std::move(loads)](client::committed& what) {
      emit opened();
      take_commit(what);
      send_watch();
      send_load_cases(loads);
    });
}

/// One after the other, then the solve of them all.
void document::send_load_cases(std::vector<fem::load_case> loads, std::function<void()> then) {
  if (loads.empty())
    return;
  change_loads(
    tr("Set the load cases"),
    [loads = std::move(loads)](client::client& c, const execution&) -> expected<void> {
      for (const auto& one : loads)
        if (auto ok = c.set_load_case(one); !ok)
          return ok;
      return {};
    },
    [this, then = std::move(then)] {
      if (then)
        then();
      solve();
    });
}

void document::set_load_case(const fem::load_case& loads) {
  send_load_cases({loads}, [this, loads] { emit load_case_set(loads); });
}

void document::load_catalogue() {
  link_.run<catalogue>(
    [](client::client& c, const execution&) -> expected<catalogue> {
      auto json = c.catalogue_json();
      if (!json)
        return fail(std::move(json.error()));
      return catalogue_from_json(*json);
    },
    [this](expected<catalogue> got) {
      if (got) {
        operations_ = std::move(*got);
        emit operations_changed();
      } else if (link_.current() == remote::state::connected) {
        if (got.error().code != ec::service_unavailable)  // Else the server still starts.
          emit notice(tr("The list of operations did not come: %1")
                        .arg(QString::fromStdString(render(got.error()))));
        QTimer::singleShot(catalogue_retry_ms, this, &document::load_catalogue);
      }
    });
}

void document::connection_changed() {
  if (link_.current() == remote::state::lost && field_state_ == field_state::solving)
    set_field_state(field_state::waiting);
  if (link_.current() == remote::state::offline)  // It does not come back by itself.
    if (const auto left = std::exchange(unanswered_, std::nullopt))
      emit failed(left->title, left->why);
}

// -- edits ---------------------------------------------------------------------------

/// Who asks hears of it twice: as an event, then as the answer. Events of others' commits may lie
/// between the two, so the answer counts only where no event told of it since it was asked for.
/// When the connection breaks before the answer, it is asked for again once the document is open
/// again: the edit id sees to it that it is made once.
void document::ask_commit(const QString& title, remote::work<client::committed> call) {
  auto broke = std::make_shared<std::atomic<bool>>(false);
  const auto watched = [call, broke](client::client& c, const execution& run) {
    auto result = call(c, run);
    *broke = !result && !c.connected() && !run.cancel.cancelled();
    return result;
  };
  ask<client::committed>(
    title, watched,
    [this, asked = told_](client::committed& what) {
      const auto row = versions_.find(what.head.number);
      if (what.repeated && head_ != what.head.number)
        return refresh_history();  // Made before, and others went on: the head is theirs.
      if (row == versions_.end() || row->second.told <= asked)
        take_commit(what);
    },
    [this, title, call, broke](const error& why) {
      if (*broke)
        unanswered_ = unanswered_change{title, call, why};
      return broke->load();
    });
}

void document::ask_again() {
  const auto left = std::exchange(unanswered_, std::nullopt);
  if (!left)
    return;
  ask_commit(left->title, [=](client::client& c, const execution& run) {
    return c.knows_edit_ids() ? left->call(c, run) : expected<client::committed>(fail(left->why));
  });
}

void document::take_event(const client::committed& what) {
  if (!is_open())
    return;
  take_commit(what);
  versions_[what.head.number].told = ++told_;
}

void document::apply(const QString& operation, const std::vector<surface_id>& surfaces,
                     const ops::parameters& values, const fem::carry_settings& loads) {
  const auto* offered = operations_.find(operation);
  const QString title = offered ? QString::fromStdString(offered->about.name) : operation;
  const auto* now = head();
  const std::string expected_version = now ? now->info.version_id : std::string();
  emit applied(operation, surfaces, values);
  ask_commit(title, [=, id = operation.toStdString(), once = client::make_edit_id()](
                      client::client& c, const execution& run) {
    return c.edit(id, surfaces, values, run, expected_version, loads, once);
  });
}

void document::undo() {
  ask_commit(tr("Undo"), [once = client::make_edit_id()](client::client& c, const execution&) {
    return c.undo({{}, once});
  });
}

void document::redo() {
  ask_commit(tr("Redo"), [once = client::make_edit_id()](client::client& c, const execution&) {
    return c.redo({{}, once});
  });
}

void document::go_to(std::uint32_t number) {
  ask_commit(tr("Go to version %1").arg(number),
             [number, once = client::make_edit_id()](client::client& c, const execution&) {
               return c.go_to(number, {{}, once});
             });
}

void document::take_load_cases(const std::vector<fem::load_case>& loads) {
  if (head_)
    versions_[*head_].load_cases = loads;
  emit load_cases_changed();
}

void document::take_commit(const client::committed& what) {
  auto& row = take_info(what.head);
  if (what.report)
    row.report = what.report;
  const bool again = std::exchange(head_, what.head.number) == what.head.number;
  can_undo_ = what.can_undo;
  can_redo_ = what.can_redo;
  for (const auto& warning : what.warnings)
    emit notice(QString::fromStdString(warning));
  if (what.report)
    for (const auto& text : what.report->notices)
      emit notice(QString::fromStdString(text));
  take_load_cases(what.load_cases);
  take_surface();
  // An event tells it, and then the answer to an import: a field may have come in between.
  if (!again)
    set_field_state(what.head.load_cases.empty() ? field_state::none : field_state::waiting);
  emit head_changed();
  emit edited(what);
  refresh_history();
}

/// As the server does it: a new version has its parent's load cases without what is gone.
void document::refresh_history() {
  ask_history(false);
}

/// With `reports` also of what edits did that were made before this was opened.
void document::ask_history(bool reports) {
  link_.run<client::history>(
    [reports](client::client& c, const execution&) { return c.get_history(reports); },
    [this, mine = opening_, known = annotations_](const expected<client::history>& got) {
      if (got && mine == opening_)
        take_history(*got, known);
    });
}

/// Answers and events come on two ways: a name that was told since this was asked for is newer.
void document::take_history(const client::history& history, int known) {
  for (const auto& info : history.versions)
    if (versions_[info.number].annotation <= known)
      take_info(info);
  emit history_changed();
}

// -- files and selections ------------------------------------------------------------

void document::export_file(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  const auto format = suffix == "stl"   ? client::file_format::stl
                      : suffix == "vtu" ? client::file_format::vtu
                                        : client::file_format::msh;
  ask<bool>(
    tr("Export %1").arg(QFileInfo(path).fileName()),
    [path, format](client::client& c, const execution& run) -> expected<bool> {
      const auto bytes = c.export_file(format, {}, "mm", run);
      if (!bytes)
        return fail(bytes.error());
      QSaveFile file(path);
      const auto size = static_cast<qint64>(bytes->size());
      if (!file.open(QIODevice::WriteOnly) || file.write(bytes->data(), size) != size ||
          !file.commit())
        return fail(ec::io_error, "cannot write the file: " + file.errorString().toStdString(), {},
                    path.toStdString());
      return true;
    },
    [this, path](bool&) { emit exported(path); });
}

void document::select(const selection_query& query,
                      remote::reply<std::vector<found_feature>> done) {
  link_.run<std::vector<found_feature>>(
    [query](client::client& c, const execution& run) { return c.select(query, run); },
    std::move(done));
}

void document::cut(const vec3& at, const vec3& normal, const std::string& load_case,
                   remote::reply<client::section> done) {
  // The server cuts in one go: an answer that comes after a cancel is dropped.
  struct question {
    int job = 0;
    ticket asked;
    remote::reply<client::section> done;
  };
  auto open = std::make_shared<question>();
  const auto finish = [this, open](expected<client::section> got) {
    work_.end(open->job);
    if (auto then = std::exchange(open->done, nullptr))
      then(std::move(got));
  };
  open->done = std::move(done);
  open->job = work_.begin(tr("Section"), [open, finish] {
    open->asked.cancel();
    finish(fail(ec::cancelled, "the section was cancelled"));
  });
  open->asked = link_.run<client::section>(
    [=](client::client& c, const execution& run) { return c.cut(at, normal, load_case, run); },
    finish,
    [this, open](double fraction, const QString& stage) {
      work_.progress(open->job, fraction, stage);
    });
}

}  // namespace tedit::desktop
