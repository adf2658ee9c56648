// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/recipe_player.hpp"

#include "protocol/convert.hpp"

namespace tedit::desktop {

namespace {

constexpr int poll_ms = 20;

}  // namespace

recipe_player::recipe_player(document& part, client::recipe steps, QObject* parent)
    : QObject(parent), part_(part), recipe_(std::move(steps)) {
  poll_.setInterval(poll_ms);
  connect(&poll_, &QTimer::timeout, this, &recipe_player::next);
  connect(&part_, &document::failed, this, &recipe_player::stop);
  connect(&part_, &document::closed, this, &recipe_player::stop);
}

recipe_player::~recipe_player() {
  end();
}

void recipe_player::start() {
  name_ = part_.name();
  const QString title = recipe_.name.empty() ? tr("Recipe") : QString::fromStdString(recipe_.name);
  job_ = part_.work().begin(title, [this] {
    part_.foreground().cancel();
    stop();
  });
  poll_.start();
}

void recipe_player::end() {
  poll_.stop();
  part_.work().end(std::exchange(job_, 0));
}

void recipe_player::stop() {
  if (!is_running())
    return;
  end();
  emit stopped(step_name());
  emit ended();
}

/// What this object finds; the server's refusals are told by the document itself.
void recipe_player::refuse(error reason) {
  reason.where = step_name().toStdString();
  emit part_.failed(tr("Run the recipe"), reason);  // Comes to `stop`.
}

QString recipe_player::step_name() const {
  if (at_ == 0)
    return tr("before the first step");
  return tr("step %1 of %2 (%3)")
    .arg(at_)
    .arg(recipe_.steps.size())
    .arg(client::kind_of(recipe_.steps[at_ - 1]));
}

bool recipe_player::is_ready() const {
  if (part_.foreground().current() || part_.loads().is_changing())
    return false;
  const auto* head = part_.head();
  if (!head)
    return name_.isEmpty() || at_ == 0;
  return head->surface && !part_.operations().operations.empty() &&
         (!wants_field_ || part_.solver().progress() == field_state::converged);
}

void recipe_player::next() {
  if (imports_) {
    if (part_.foreground().current())
      return;
    imports_ = false;
    name_ = part_.name();
  }
  if (part_.name() != name_)
    return stop();  // Somebody opened another one.
  if (wants_field_ && part_.solver().progress() == field_state::stopped)
    return refuse({ec::cancelled, "the solver was stopped", "Run the recipe again", {}});
  if (!is_ready())
    return;
  wants_field_ = false;
  if (at_ == recipe_.steps.size()) {
    end();
    emit finished(exports_);
    emit ended();
    return;
  }
  const auto& step = recipe_.steps[at_++];
  const double done = static_cast<double>(at_) / static_cast<double>(recipe_.steps.size() + 1);
  part_.work().progress(job_, done, step_name());
  emit began(step_name());
  if (auto ok = std::visit([this](const auto& s) { return perform(s); }, step); !ok)
    refuse(ok.error());
}

// -- steps ---------------------------------------------------------------------------

expected<void> recipe_player::perform(const client::import_step& s) {
  part_.files().import(QString::fromStdString(s.mesh.string()), {},
                       QString::fromStdString(s.length_unit));
  imports_ = true;
  return {};
}

/// For steps that need a part.
static expected<void> needs_head(const document& part) {
  if (part.head())
    return {};
  return fail(ec::conflict, "no part is open, and the recipe has opened none",
              "Open the part first, or begin the recipe with an import step");
}

expected<void> recipe_player::perform(const client::load_case_step& s) {
  if (auto ok = needs_head(part_); !ok)
    return ok;
  const auto loads = protocol::load_case_from_file(s.file);
  if (!loads)
    return fail(loads.error());
  part_.loads().set(*loads);
  return {};
}

expected<void> recipe_player::perform(const client::edit_step& s) {
  if (auto ok = needs_head(part_); !ok)
    return ok;
  const auto& wanted = s.request;
  if (!part_.operations().find(QString::fromStdString(wanted.operation)))
    return fail(ec::operation_not_found, "the server has no operation \"" + wanted.operation + "\"",
                "Install the plugin that brings it, or name one that \"tedit ops\" lists");
  for (const auto id : wanted.surfaces)
    if (!part_.head()->surface->surfaces().contains(id))
      return fail(ec::surface_not_found, "the part has no surface " + std::to_string(id),
                  "Open the part that the recipe was made for, or change the step's \"surfaces\"");
  part_.edits().apply(
    {QString::fromStdString(wanted.operation), wanted.surfaces, wanted.parameters, wanted.loads});
  return {};
}

expected<void> recipe_player::perform(const client::undo_step&) {
  if (!part_.edits().can_undo())
    return fail(ec::conflict, "there is nothing to undo", "Put an edit step before it");
  part_.edits().undo();
  return {};
}

expected<void> recipe_player::perform(const client::redo_step&) {
  if (!part_.edits().can_redo())
    return fail(ec::conflict, "there is nothing to redo", "Put an undo step before it");
  part_.edits().redo();
  return {};
}

/// The window solves all load cases with its own settings, after every step that changes something.
expected<void> recipe_player::perform(const client::solve_step&) {
  if (auto ok = needs_head(part_); !ok)
    return ok;
  if (part_.head()->info.load_cases.empty() && part_.loads().all().empty())
    return fail(ec::not_found, "this version has no load case", "Put a load_case step first");
  if (part_.solver().progress() != field_state::converged && !part_.solver().is_running())
    part_.solver().solve();
  wants_field_ = true;
  return {};
}

expected<void> recipe_player::perform(const client::export_step&) {
  ++exports_;
  return {};
}

}  // namespace tedit::desktop
