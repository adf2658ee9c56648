// SPDX-License-Identifier: AGPL-3.0-or-later
#include "client-qt/tools/recipes/window_player.hpp"

#include <QJsonDocument>
#include <QMainWindow>
#include <QPointer>

#include <algorithm>

#include "client-qt/tools/operations/context_panel.hpp"
#include "client-qt/tools/operations/operation_handles.hpp"
#include "client-qt/tools/recipes/window_steps.hpp"
#include "client-qt/tools/results/field_panel.hpp"
#include "client-qt/tools/toolbox.hpp"
#include "client-qt/view/viewport.hpp"
#include "client/part_files.hpp"

namespace tedit::desktop {

namespace {

constexpr int step_poll_ms = 20;

expected<const offered_operation*> find_operation(const document& part, const std::string& id) {
  if (const auto* found = part.operations().find(QString::fromStdString(id)))
    return found;
  return fail(ec::operation_not_found, "the server has no operation \"" + id + "\"",
              "Install the plugin that brings it, or name one that \"tedit ops\" lists");
}

/// As the form takes them: a whole number is a real one, too.
expected<ops::parameters> fitted(const ops::parameters& given,
                                 const ops::operation_description& about) {
  using type = ops::parameter_type;
  ops::parameters result;
  for (const auto& [id, value] : given) {
    const auto is = std::ranges::find(about.parameters, id, &ops::parameter_description::id);
    if (is == about.parameters.end())
      return fail(ec::invalid_parameter, about.id + " has no parameter \"" + id + "\"",
                  "\"tedit ops " + about.id + "\" lists them");
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto as =
      is->type == type::real && whole ? ops::parameter_value(static_cast<double>(*whole)) : value;
    if (as.index() != is->default_value.index())
      return fail(ec::invalid_parameter, "the parameter \"" + id + "\" is of another type",
                  "\"tedit ops " + about.id + "\" says of which");
    result[id] = as;
  }
  return result;
}

}  // namespace

window_player::window_player(window_context& in, toolbox& tools,
                             std::vector<client::recipe_step> steps, QObject* parent)
    : QObject(parent), in_(in), tools_(tools), player_(std::move(steps), *this, [this] {
        waited_ms_ = 0;
        emit began(step_name(), player_.fraction());
      }) {
  poll_.setInterval(step_poll_ms);
  connect(&poll_, &QTimer::timeout, this, &window_player::next);
  connect(&in_.part, &document::opened, this, [this] { imports_ = false; });
  connect(&in_.part, &document::failed, this, [this](const QString&, const error& reason) {
    if (is_running())
      end(player_.stop(reason));
  });
}

void window_player::cancel() {
  if (is_running())
    end(player_.stop({ec::cancelled, "cancelled", {}, {}}));
}

void window_player::end(const error& reason) {
  poll_.stop();
  emit failed(reason);
}

void window_player::refuse(const error& reason) {
  poll_.stop();  // Hears nothing of the next line.
  emit in_.part.failed(tr("Run the recipe"), reason);
  emit failed(reason);
}

QString window_player::step_name() const {
  if (!player_.current())
    return tr("before the first step");
  return tr("step %1 of %2 (%3)")
    .arg(player_.begun())
    .arg(player_.size())
    .arg(client::kind_of(*player_.current()));
}

void window_player::next() {
  if (drags_left_ > 0)  // One move each time the loop is idle.
    return drag(in_.view, drags_left_--);
  if (handle_moves_ && handle_moves_->advance(in_.view))
    return;
  waited_ms_ += step_poll_ms;
  const auto more = player_.advance();
  if (!is_running())
    return;
  if (!more)
    return refuse(more.error());
  if (!*more) {
    poll_.stop();
    emit finished();
  } else if (patience_s_ > 0 && waited_ms_ > 1000 * patience_s_) {
    refuse(player_.stop({ec::timeout,
                         "what follows waited longer than " + std::to_string(patience_s_) + " s",
                         {},
                         {}}));
  }
}

// -- readiness -----------------------------------------------------------------------

expected<bool> window_player::is_ready_for(const client::recipe_step* next) {
  const auto& solver = in_.part.solver();
  if (wants_field_ && solver.progress() == field_state::stopped)
    return fail(ec::cancelled, "the solver was stopped", "Run the recipe again");
  if (!is_part_ready() || (wants_field_ && solver.progress() != field_state::converged))
    return false;
  if (!next || !client::is_of_window(*next) || !in_.part.is_open())
    return true;
  const auto* of_window = std::get_if<client::window_step>(next);
  if (of_window && of_window->kind == "case" && solver.is_running())
    return false;  // It can be chosen once it has a field.
  return is_view_ready() && (!of_window || !waits_for_field(*of_window) || is_final());
}

bool window_player::is_part_ready() const {
  const auto& part = in_.part;
  if (imports_ || looks_up_ || part.foreground().current() || part.loads().is_changing() ||
      part.edits().awaits_answer() || tools_.summary.writes_report() ||
      tools_.printing.inspection().is_asking())
    return false;
  if (!part.is_open())
    return !awaits_part_;
  return part.head() && part.head()->surface && !part.operations().operations.empty();
}

/// Whether the screen has what every view shows.
bool window_player::is_view_ready() const {
  const auto& preview = tools_.operations.panel().preview();
  const auto wanted = preview.shown() ? preview.shown()->surface : in_.part.head()->surface;
  if (!in_.panels.are_settled() || !in_.view.is_settled() || preview.is_busy() ||
      in_.view.current().surface != wanted)
    return false;
  return std::ranges::all_of(in_.window.findChildren<viewport*>(), [](const viewport* one) {
    return !one->isVisible() || (one->is_settled() && one->is_seen());
  });
}

/// Whether the field has converged and is drawn, with the quantity that was chosen.
bool window_player::is_final() const {
  const auto& part = in_.part;
  const auto field = in_.view.current().field;
  return part.solver().progress() == field_state::converged && part.head()->outcome &&
         !tools_.results.panel().is_on_its_way() &&
         (tools_.operations.panel().preview().shown() ||
          (field && field->version_id() == part.head()->info.version_id));
}

// -- steps that work on the part -------------------------------------------------------

expected<void> window_player::perform(const client::recipe_step& step) {
  wants_field_ = false;
  note_last_edit();
  if (!in_.part.head() && !client::is_of_window(step) &&
      !std::holds_alternative<client::import_step>(step))
    return fail(ec::conflict, "no part is open, and the recipe has opened none",
                "Open the part first, or begin the recipe with an import step");
  return std::visit([this](const auto& s) { return carry_out(s); }, step);
}

expected<void> window_player::carry_out(const client::import_step& s) {
  imports_ = true;
  tools_.connection.when_connected([this, s] {
    const auto file = QString::fromStdString(s.mesh.string());
    const auto unit = QString::fromStdString(s.length_unit);
    const auto size = s.size.empty() ? QString("medium") : QString::fromStdString(s.size);
    if (client::is_cad_file(s.mesh) || client::is_surface_file(s.mesh))
      in_.part.files().import_cad({file, {}, unit, size, s.local_sizes_mm});
    else
      in_.part.files().import(file, {}, unit);
  });
  return {};
}

/// Its surface is here: a step waits for that.
void window_player::note_last_edit() {
  if (!label_.empty() && in_.part.head())
    known_.note(label_, *before_label_, *in_.part.head()->surface);
  label_.clear();
}

expected<void> window_player::with_meanings(
  const std::vector<client::surface_reference>& references,
  const std::function<expected<void>(const meanings&)>& go_on) {
  if (references.empty())
    return go_on({});
  looks_up_ = true;
  in_.link.run<meanings>(
    [references, known = known_, surface = in_.part.head()->surface](client::client& c,
                                                                     const execution& run) {
      return client::meanings_of(references, known, *surface, [&](const selection_query& query) {
        return c.select(query, run);
      });
    },
    [this, alive = QPointer(this), go_on](const expected<meanings>& found) {
      if (!alive || !is_running())
        return;
      looks_up_ = false;
      const auto done = found ? go_on(*found) : expected<void>(fail(found.error()));
      if (!done)
        refuse(player_.stop(done.error()));
    });
  return {};
}

expected<void> window_player::carry_out(const client::load_case_step& s) {
  return with_meanings(s.references, [this, loads = s.loads](const meanings& found) mutable {
    client::put_surfaces(loads, found);
    in_.part.loads().set(loads);
    return expected<void>();
  });
}

expected<void> window_player::carry_out(const client::remove_load_case_step& s) {
  in_.part.loads().remove(s.name);
  return {};
}

expected<void> window_player::carry_out(const client::edit_step& s) {
  return with_meanings(s.references,
                       [this, wanted = s.request, label = s.label](const meanings& found) mutable {
                         client::put_surfaces(wanted.surfaces, found);
                         label_ = label;
                         before_label_ = in_.part.head()->surface;
                         return apply(wanted);
                       });
}

expected<void> window_player::apply(const edit_request& wanted) {
  if (const auto known = find_operation(in_.part, wanted.operation); !known)
    return fail(known.error());
  for (const auto id : wanted.surfaces)
    if (!in_.part.head()->surface->surfaces().contains(id))
      return fail(ec::surface_not_found, "the part has no surface " + std::to_string(id),
                  "Open the part that the recipe was made for, or change the step's \"surfaces\"");
  in_.part.edits().apply(
    {QString::fromStdString(wanted.operation), wanted.surfaces, wanted.parameters, wanted.loads});
  return {};
}

expected<void> window_player::carry_out(const client::undo_step&) {
  if (!in_.part.edits().can_undo())
    return fail(ec::conflict, "there is nothing to undo", "Put an edit step before it");
  in_.part.edits().undo();
  return {};
}

expected<void> window_player::carry_out(const client::redo_step&) {
  if (!in_.part.edits().can_redo())
    return fail(ec::conflict, "there is nothing to redo", "Put an undo step before it");
  in_.part.edits().redo();
  return {};
}

expected<void> window_player::carry_out(const client::go_to_step& s) {
  in_.part.edits().go_to(s.version);
  return {};
}

expected<void> window_player::carry_out(const client::solve_step&) {
  if (in_.part.head()->info.load_cases.empty() && in_.part.loads().all().empty())
    return fail(ec::not_found, "this version has no load case", "Put a load_case step first");
  auto& solver = in_.part.solver();
  if (solver.progress() != field_state::converged && !solver.is_running())
    solver.solve();
  wants_field_ = true;
  return {};
}

expected<void> window_player::carry_out(const client::export_step&) {
  ++left_out_;
  return {};
}

expected<void> window_player::carry_out(const client::compare_step&) {
  ++left_out_;
  return {};
}

// -- steps of the window ---------------------------------------------------------------

expected<void> window_player::carry_out(const client::apply_step& s) {
  const auto offered = find_operation(in_.part, s.request.operation);
  if (!offered)
    return fail(offered.error());
  const auto values = fitted(s.request.parameters, (*offered)->about);
  if (!values)
    return fail(values.error());
  auto& panel = tools_.operations.panel();
  panel.set_policy(s.request.loads.policy);
  panel.choose(QString::fromStdString(s.request.operation));
  if (panel.form())
    panel.form()->set_values(*values);
  panel.apply(true);
  return {};
}

expected<void> window_player::carry_out(const client::window_step& s) {
  const auto step = QJsonDocument::fromJson(QByteArray::fromStdString(s.json)).object();
  if (s.kind == "drag") {
    drags_left_ = step["drag"].toInt();
    return {};
  }
  if (s.kind == "drag_handle") {
    auto moves = handle_moves::begin(step, in_.view, tools_.operations.handles());
    if (!moves)
      return fail(moves.error());
    handle_moves_ = *moves;
    return {};
  }
  if (!writes_ && (s.kind == "screenshot" || s.kind == "report")) {
    ++left_out_;
    return {};
  }
  return move_window(s.kind, step, in_, tools_);
}

}  // namespace tedit::desktop
