// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recording/recorder.hpp"

#include <QJsonDocument>

#include <algorithm>
#include <set>

#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/view/viewport.hpp"
#include "protocol/convert.hpp"

namespace tedit::desktop {

namespace {

constexpr int rest_ms = 300;

QJsonArray to_json(const vec3& v) {
  return {v.x, v.y, v.z};
}

QJsonValue to_json(const ops::parameter_value& value) {
  if (const auto* flag = std::get_if<bool>(&value))
    return *flag;
  if (const auto* count = std::get_if<std::int64_t>(&value))
    return static_cast<qint64>(*count);
  if (const auto* number = std::get_if<double>(&value))
    return *number;
  return QString::fromStdString(std::get<std::string>(value));
}

/// Its surfaces are the selection.
QJsonObject to_json(const edit_wish& wish) {
  QJsonObject parameters;
  for (const auto& [id, value] : wish.values)
    parameters[QString::fromStdString(id)] = to_json(value);
  QJsonObject step{{"apply", wish.operation}, {"parameters", parameters}};
  if (wish.loads.policy != fem::load_policy::drop) {
    const auto policy = fem::policy_name(wish.loads.policy);
    step["loads"] = QString::fromUtf8(policy.data(), static_cast<qsizetype>(policy.size()));
  }
  return step;
}

QJsonArray to_json(const std::vector<surface_id>& ids) {
  QJsonArray result;
  for (const auto id : ids)
    result.append(static_cast<qint64>(id));
  return result;
}

/// Commands that change how the part is drawn and nothing else that is noted by itself.
bool worth_a_step(const QString& id) {
  static const std::set<QString> wanted{"view.mesh",
                                        "view.edges",
                                        "view.loads",
                                        "view.extremes",
                                        "view.dark",
                                        "view.compare",
                                        "view.compare_difference"};
  return wanted.contains(id);
}

/// A step that says how something is, not what is done: a later one of its kind replaces it.
bool is_state(const QJsonObject& step) {
  for (const auto* key : {"select", "field", "case", "deform", "bands", "isolines", "camera",
                          "section", "hidden", "measure"})
    if (step.contains(key))
      return true;
  return false;
}

/// The same load case again, as while its numbers are typed: only the last one counts.
bool same_case(const QJsonObject& a, const QJsonObject& b) {
  return a.contains("load_case") && b.contains("load_case") &&
         a["load_case"]["name"] == b["load_case"]["name"];
}

}  // namespace

recorder::recorder(window_context& in, toolbox& tools, QObject* parent)
    : QObject(parent), in_(in), tools_(tools) {
  looked_.setSingleShot(true);
  looked_.setInterval(rest_ms);
  connect(&looked_, &QTimer::timeout, this, &recorder::look);
  wire();
}

void recorder::wire() {
  connect(&in_.view, &viewport::view_changed, this, [this] {
    if (on_)
      looked_.start();
  });
  connect(&in_.picked, &selection::changed, this, [this] {
    add({{"select", to_json(in_.picked.surfaces())}});
  });
  connect(&in_.all_commands, &commands::triggered, this, [this](const QString& id) {
    if (worth_a_step(id))
      add({{"command", id}});
  });
  connect(&tools_.results.panel(), &field_panel::changed, this, &recorder::fields_changed);
  connect(&tools_.section.bar(), &section_bar::moved, this, &recorder::section_moved);
  connect(&in_.part, &document::edited, this, &recorder::committed);
  connect(&in_.part, &document::failed, this, [this] { pending_.reset(); });
  connect(&in_.part.edits(), &edit_requests::applied, this,
          [this](const edit_wish& wish) { pending_ = to_json(wish); });
  connect(&tools_.selecting, &selection_tool::hidden_changed, this, &recorder::add_hidden);
  wire_loads();
  wire_probes();
}

void recorder::wire_loads() {
  connect(&in_.part.loads(), &load_requests::was_set, this, &recorder::add_loads);
  connect(&in_.part.loads(), &load_requests::was_removed, this, [this](const std::string& name) {
    add({{"remove_load_case", QString::fromStdString(name)}});
  });
}

void recorder::add_loads(const fem::load_case& loads) {
  const auto text = QByteArray::fromStdString(protocol::load_case_to_json(loads));
  add({{"load_case", QJsonDocument::fromJson(text).object()}});
}

void recorder::wire_probes() {
  connect(&tools_.probing.pins(), &probes::added, this, &recorder::add_probe);
  connect(&tools_.probing.pins(), &probes::removed, this, [this](int number) {
    add({{"remove_probe", number}});
  });
  connect(&tools_.probing.list(), &probe_panel::chosen_changed, this, [this] {
    QJsonArray numbers;
    for (const int number : tools_.probing.list().chosen())
      numbers.append(number);
    add({{"measure", numbers}});
  });
}

void recorder::add_hidden() {
  add({{"hidden", to_json({tools_.selecting.hidden().begin(), tools_.selecting.hidden().end()})}});
}

void recorder::add_probe(const probe& what) {
  add({{"probe", QJsonObject{{"number", what.number},
                             {"surface", static_cast<qint64>(what.surface)},
                             {"at", to_json(what.place.at)}}}});
}

void recorder::start() {
  steps_ = {};
  pending_.reset();
  on_ = true;
  const auto* head = in_.part.head();
  head_ = head ? head->info.number : 0;
  for (const auto& one : in_.part.loads().all())
    add_loads(one);
  fields_changed();
  look();
  add({{"select", to_json(in_.picked.surfaces())}});
  add_hidden();
  for (const auto& one : tools_.probing.pins().all())
    add_probe(one);
  emit changed();
}

void recorder::stop() {
  if (looked_.isActive())
    look();
  looked_.stop();
  on_ = false;
  emit changed();
}

/// The same as before is no step; while only the state changes, its newest value counts.
void recorder::add(const QJsonObject& step) {
  if (!on_)
    return;
  if (!steps_.isEmpty() && same_case(steps_.last().toObject(), step))
    steps_.removeLast();
  for (auto i = steps_.size(); i-- > 0;) {
    const auto before = steps_[i].toObject();
    if (before == step && is_state(step))
      return;
    if (!is_state(before))
      break;
    if (before.keys() == step.keys()) {
      steps_.removeAt(i);
      break;
    }
  }
  steps_.append(step);
  emit changed();
}

void recorder::look() {
  const auto& view = in_.view;
  const auto pose = in_.view.view().get();
  if (!view.geometry())
    return;
  add({{"camera", QJsonObject{{"position", to_json(pose.position)},
                              {"focus", to_json(pose.focus)},
                              {"up", to_json(pose.up)},
                              {"scale", pose.parallel_scale},
                              {"parallel", in_.view.view().is_parallel()}}}});
}

/// Only what differs from what was noted last.
void recorder::fields_changed() {
  if (!on_)
    return;
  auto& fields = tools_.results.panel();
  const auto note = [this](const char* key, const QJsonValue& value, const QJsonValue& at_first) {
    QJsonValue known = at_first;
    for (const auto& step : steps_)
      if (step.toObject().contains(key))
        known = step.toObject()[key];
    if (known != value)
      add({{key, value}});
  };
  if (fields.field())  // Else it is only on its way.
    note("case", fields.shown_case(),
         fields.shown_case().isEmpty() ? QJsonValue("") : QJsonValue());
  note("field", field_id(fields.wanted().field), field_id(shown_field::von_mises));
  note("deform", fields.deform(), 0.0);
  note("bands", fields.wanted().bands, 0);
  note("isolines", fields.isolines(), false);
}

void recorder::section_moved() {
  const auto& bar = tools_.section.bar();
  const auto plane = bar.plane();
  if (!bar.is_on() || !plane)
    add({{"section", QJsonValue::Null}});
  else
    add({{"section", QJsonObject{{"at", to_json(plane->at)}, {"normal", to_json(plane->normal)}}}});
}

/// A commit is told twice: to who asked for it and to all.
void recorder::committed(const client::committed& what) {
  if (!on_ || what.head.number == std::exchange(head_, what.head.number))
    return;
  if (what.cause == "edit" && pending_) {
    const auto step = *std::exchange(pending_, std::nullopt);
    if (what.report && to_json(what.report->surfaces) != to_json(in_.picked.surfaces()))
      add({{"select", to_json(what.report->surfaces)}});
    add(step);
  } else if (what.cause == "undo" || what.cause == "redo") {
    add({{QString::fromStdString(what.cause), true}});
  } else if (what.cause == "goto") {
    add({{"go_to", static_cast<qint64>(what.head.number)}});
  }
}

QByteArray recorder::text() const {
  QByteArray result = "[";
  for (const auto& step : steps_)
    result += (result.size() > 1 ? ",\n " : "\n ") +
              QJsonDocument(step.toObject()).toJson(QJsonDocument::Compact);
  return result + "\n]\n";
}

}  // namespace tedit::desktop
