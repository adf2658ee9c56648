// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recording/recorder.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <set>
#include <string_view>

#include "client-qt/model/document_name.hpp"
#include "client-qt/tools/probes/probe_panel.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/section/section_bar.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/view/viewport.hpp"

namespace tedit::desktop {

namespace {

constexpr int rest_ms = 300;

QJsonArray to_json(const vec3& v) {
  return {v.x, v.y, v.z};
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

/// Steps of the window that name surfaces by their numbers mean nothing on another mesh.
bool names_surfaces(const char* kind) {
  static const std::set<std::string_view> kinds{"select", "hidden", "probe", "remove_probe",
                                                "measure"};
  return kinds.contains(kind);
}

client::window_step window_step(const char* kind, const QJsonValue& value) {
  const QJsonDocument step(QJsonObject{{kind, value}});
  return {kind, step.toJson(QJsonDocument::Compact).toStdString()};
}

/// A step that says how something is, not what is done: a later one of its kind replaces it.
bool is_state(const client::recipe_step& step) {
  static const std::set<std::string> kinds{"select", "field",    "case",       "deform",
                                           "bands",  "isolines", "camera",     "section",
                                           "hidden", "measure",  "print_check"};
  return kinds.contains(client::kind_of(step));
}

/// The same load case again, as while its numbers are typed: only the last one counts.
bool same_case(const client::recipe_step& a, const client::recipe_step& b) {
  const auto* one = std::get_if<client::load_case_step>(&a);
  const auto* other = std::get_if<client::load_case_step>(&b);
  return one && other && one->loads.name == other->loads.name;
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
  connect(&in_.picked, &selection::changed, this,
          [this] { add("select", to_json(in_.picked.surfaces())); });
  connect(&in_.all_commands, &commands::triggered, this, [this](const QString& id) {
    if (worth_a_step(id))
      add("command", id);
  });
  connect(&tools_.results.panel(), &field_panel::changed, this, &recorder::fields_changed);
  connect(&tools_.section.bar(), &section_bar::moved, this, &recorder::section_moved);
  connect(&tools_.printing.inspection(), &print_inspection::changed, this,
          &recorder::print_check_changed);
  connect(&in_.part, &document::edited, this, &recorder::committed);
  connect(&in_.part, &document::failed, this, [this] { pending_.reset(); });
  connect(&in_.part.edits(), &edit_requests::applied, this, [this](const edit_wish& wish) {
    const client::edit_step step{
      {wish.operation.toStdString(), wish.surfaces, wish.values, wish.loads}};
    pending_ = noted_step{step, placed(step)};
    const auto* head = in_.part.head();
    before_pending_ = head ? head->surface : nullptr;
  });
  connect(&in_.part, &document::surface_changed, this, &recorder::note_made);
  connect(&tools_.selecting, &selection_tool::hidden_changed, this, &recorder::add_hidden);
  wire_loads();
  wire_probes();
}

void recorder::wire_loads() {
  connect(&in_.part.loads(), &load_requests::was_set, this, &recorder::add_loads);
  connect(&in_.part.loads(), &load_requests::was_removed, this, [this](const std::string& name) {
    add(client::remove_load_case_step{name}, client::remove_load_case_step{name});
  });
}

void recorder::add_loads(const fem::load_case& loads) {
  client::load_case_step placed{loads};
  client::refer_to_surfaces(placed.loads, placed.references,
                            [this](surface_id id) { return reference_of(id); });
  add(client::load_case_step{loads}, std::move(placed));
}

std::optional<client::surface_reference> recorder::reference_of(surface_id id) const {
  const auto* head = in_.part.head();
  if (!head || !head->surface)
    return std::nullopt;
  const auto made = made_by_.find(id);
  return client::reference_to(id, *head->surface, made == made_by_.end() ? "" : made->second);
}

client::edit_step recorder::placed(client::edit_step step) const {
  client::refer_to_surfaces(step.request.surfaces, step.references,
                            [this](surface_id id) { return reference_of(id); });
  return step;
}

/// What a recorded edit has made is known when its surface is there; where others follow sooner,
/// its surfaces are known by their place alone.
void recorder::note_made() {
  const auto* head = in_.part.head();
  if (!unseen_ || !unseen_->before || !head || !head->surface ||
      head->info.version_id != unseen_->version_id)
    return;
  for (const auto& [id, row] : head->surface->surfaces())
    if (!unseen_->before->surfaces().contains(id))
      made_by_[id] = unseen_->label;
  unseen_.reset();
}

void recorder::wire_probes() {
  connect(&tools_.probing.pins(), &probes::added, this, &recorder::add_probe);
  connect(&tools_.probing.pins(), &probes::removed, this,
          [this](int number) { add("remove_probe", number); });
  connect(&tools_.probing.list(), &probe_panel::chosen_changed, this, [this] {
    QJsonArray numbers;
    for (const int number : tools_.probing.list().chosen())
      numbers.append(number);
    add("measure", numbers);
  });
}

void recorder::add_hidden() {
  add("hidden", to_json({tools_.selecting.hidden().begin(), tools_.selecting.hidden().end()}));
}

void recorder::add_probe(const probe& what) {
  add("probe", QJsonObject{{"number", what.number},
                           {"surface", static_cast<qint64>(what.surface)},
                           {"at", to_json(what.place.at)}});
}

void recorder::start() {
  title_ = title_of(in_.part.name()).words.toStdString();
  steps_.clear();
  pending_.reset();
  unseen_.reset();
  made_by_.clear();
  edits_ = 0;
  on_ = true;
  for (const auto& one : in_.part.loads().all())
    add_loads(one);
  fields_changed();
  look();
  add("select", to_json(in_.picked.surfaces()));
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
void recorder::add(client::recipe_step step, std::optional<client::recipe_step> by_place) {
  if (!on_)
    return;
  if (!steps_.empty() && same_case(steps_.back().by_number, step))
    steps_.pop_back();
  for (auto before = steps_.rbegin(); before != steps_.rend() && is_state(before->by_number);
       ++before) {
    if (before->by_number == step)
      return;
    if (std::string_view(client::kind_of(before->by_number)) == client::kind_of(step)) {
      steps_.erase(std::next(before).base());
      break;
    }
  }
  steps_.push_back({std::move(step), std::move(by_place)});
  emit changed();
}

void recorder::add(const char* kind, const QJsonValue& value) {
  const client::recipe_step step = window_step(kind, value);
  add(step, names_surfaces(kind) ? std::nullopt : std::optional(step));
}

client::recipe recorder::recipe() const {
  client::recipe result;
  result.name = title_;
  for (const auto& one : steps_)
    result.steps.push_back(one.by_number);
  return result;
}

client::recipe recorder::portable_recipe() const {
  client::recipe result;
  result.name = title_;
  for (const auto& one : steps_)
    if (one.by_place)
      result.steps.push_back(*one.by_place);
  return result;
}

void recorder::look() {
  const auto& view = in_.view;
  const auto pose = in_.view.view().get();
  if (!view.geometry())
    return;
  add("camera", QJsonObject{{"position", to_json(pose.position)},
                            {"focus", to_json(pose.focus)},
                            {"up", to_json(pose.up)},
                            {"scale", pose.parallel_scale},
                            {"parallel", in_.view.view().is_parallel()}});
}

/// Only what differs from what was noted last.
void recorder::fields_changed() {
  if (!on_)
    return;
  auto& fields = tools_.results.panel();
  const auto note = [this](const char* key, const QJsonValue& value, const QJsonValue& at_first) {
    const auto is_of_kind = [key](const noted_step& one) {
      return std::string_view(client::kind_of(one.by_number)) == key;
    };
    const auto known = std::find_if(steps_.rbegin(), steps_.rend(), is_of_kind);
    const client::recipe_step step = window_step(key, value);
    if (known == steps_.rend() ? value != at_first : known->by_number != step)
      add(step, step);
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
    add("section", QJsonValue::Null);
  else
    add("section", QJsonObject{{"at", to_json(plane->at)}, {"normal", to_json(plane->normal)}});
}

void recorder::print_check_changed() {
  const auto& wanted = tools_.printing.inspection().wanted();
  if (!wanted)
    return add("print_check", QJsonValue::Null);
  QJsonObject step{{"overhang", wanted->lean / degree}, {"direction", to_json(wanted->up)}};
  if (wanted->thinner_than > 0)
    step["thinner_than"] = wanted->thinner_than;
  add("print_check", step);
}

void recorder::committed(const client::committed& what) {
  if (!on_)
    return;
  if (what.cause == "edit" && pending_) {
    auto made = *std::exchange(pending_, std::nullopt);
    const auto label = "edit " + std::to_string(++edits_);
    std::get<client::edit_step>(*made.by_place).label = label;
    add(std::move(made.by_number), std::move(made.by_place));
    unseen_ = unseen_edit{label, what.head.version_id, std::exchange(before_pending_, nullptr)};
    note_made();  // The surface may be quicker.
  } else if (what.cause == "undo") {
    add(client::undo_step{}, client::undo_step{});
  } else if (what.cause == "redo") {
    add(client::redo_step{}, client::redo_step{});
  } else if (what.cause == "goto") {
    add(client::go_to_step{what.head.number}, client::go_to_step{what.head.number});
  }
}

}  // namespace tedit::desktop
