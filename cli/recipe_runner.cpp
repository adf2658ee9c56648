// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/recipe_runner.hpp"

#include <algorithm>

#include "base/stopwatch.hpp"
#include "cli/reports.hpp"
#include "client/part_files.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

constexpr auto surface_patience = std::chrono::minutes(2);

std::string short_place(vec3 p) {
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return components(1e3 * p, 3, 1e3 * largest, 5e-4);
}

std::string kibibytes(const client::traffic& moved) {
  return pretty(static_cast<double>(moved.bytes) / 1024, 3);
}

nlohmann::ordered_json to_json(const client::traffic& moved) {
  return {{"bytes", moved.bytes}, {"messages", moved.messages}, {"ms", moved.ms}};
}

solve_outcome outcome_of(const std::vector<client::field_event>& fields) {
  solve_outcome outcome;
  for (const auto& field : fields)
    if (field.envelope)
      outcome.envelope = field.envelope;
    else
      outcome.cases.push_back(field.report);
  return outcome;
}

/// Of load cases that were solved together: their shares make up the whole.
nlohmann::ordered_json sum_of_times(const solve_outcome& outcome) {
  solve_report sum;
  for (const auto& one : outcome.cases) {
    sum.assembly_ms += one.assembly_ms;
    sum.setup_ms += one.setup_ms;
    sum.solve_ms += one.solve_ms;
    sum.recovery_ms += one.recovery_ms;
    sum.total_ms += one.total_ms;
  }
  return cli::to_json(sum)["timings_ms"];
}

/// What to write instead of a step of the window that changes the part; empty for others.
std::string needs_window(const client::recipe_step& step) {
  if (std::holds_alternative<client::apply_step>(step))
    return "Write an edit step with its surfaces, or use \"tedit-qt --script\"";
  const auto* of_window = std::get_if<client::window_step>(&step);
  for (const std::string id : {"edit.apply", "edit.undo", "edit.redo", "loads.remove"})
    if (of_window && of_window->json == R"({"command":")" + id + R"("})")
      return "Write a step edit, undo, redo or remove_load_case, or use \"tedit-qt --script\"";
  return {};
}

}  // namespace

void failed_solves::add(const std::string& version) {
  const std::lock_guard lock(mutex_);
  versions_.insert(version);
}

bool failed_solves::contains(const std::string& version) const {
  const std::lock_guard lock(mutex_);
  return versions_.contains(version);
}

expected<void> recipe_runner::check(const recipe& steps) {
  for (std::size_t i = 0; i < steps.steps.size(); ++i)
    if (const auto remedy = needs_window(steps.steps[i]); !remedy.empty())
      return fail(ec::bad_input,
                  "step " + std::to_string(i + 1) + " (" + client::kind_of(steps.steps[i]) +
                    ") changes the part, and only the window can carry it out",
                  remedy);
  return {};
}

expected<void> recipe_runner::run(const std::optional<import_step>& mesh) {
  const auto opened = server_.open("", true, true);
  if (!opened)
    return fail(opened.error());
  document_ = opened->document;
  if (mesh)
    if (auto ok = note(0, "import", [&] { return step(*mesh); }); !ok)
      return ok;
  client::recipe_player player(recipe_.steps, *this);
  while (true) {
    const auto more = player.advance();
    if (!more)
      return fail(more.error());
    if (!*more)
      return {};
  }
}

expected<bool> recipe_runner::is_ready_for(const client::recipe_step*) {
  if (session_.cancel.cancelled())
    return fail(ec::cancelled, "interrupted");
  return true;
}

expected<void> recipe_runner::perform(const client::recipe_step& what) {
  return note(++performed_, client::kind_of(what),
              [&] { return std::visit([this](const auto& s) { return step(s); }, what); });
}

/// Keeps what becomes of a step.
expected<void> recipe_runner::note(std::size_t number, const std::string& kind,
                                   const std::function<expected<void>()>& work) {
  const stopwatch clock;
  const auto passed_over = passed_over_;
  steps_.push_back({number, kind, false, std::nullopt, 0});
  auto done = work();
  auto& kept = steps_.back();
  kept.ms = clock.milliseconds();
  kept.passed_over = passed_over_ > passed_over;
  if (!done)
    kept.failure = done.error();
  return done;
}

const solve_outcome* recipe_runner::outcome() const {
  const auto found = solved_.find(head_.version_id);
  return found == solved_.end() ? nullptr : &found->second.outcome;
}

std::string recipe_runner::table() const {
  auto rows = rows_;
  rows.insert(rows.begin(), {"step", "edit ms", "sent KiB", "transfer ms", "worst q (before)",
                             "assembly ms", "solve ms", "iterations", "residual",
                             "max von Mises MPa", "at mm", "max displ. mm"});
  return format_table(rows);
}

/// Notes a new head, once its surface is here.
expected<void> recipe_runner::take_head(const std::string& what, const client::committed& done,
                                        double ms) {
  head_ = done.head;
  const auto surface = server_.wait_surface(head_.version_id, surface_patience);
  if (!surface)
    return fail(surface.error());
  nlohmann::ordered_json json;
  std::string quality;
  if (done.report) {
    json = cli::to_json(*done.report);
    if (const auto& ratios = done.report->ratios)
      quality = pretty(ratios->min_after, 3) + " (" + pretty(ratios->min_before, 3) + ")";
    details_ += what + " -> " + version_name() + "\n" + describe(*done.report);
  }
  json["step"] = done.cause;
  json["version_id"] = head_.version_id;
  json["tets"] = head_.tets;
  json["round_trip_ms"] = ms;
  json["commit_ms"] = done.commit_ms;
  json["surface"] = to_json(surface->moved);
  json["surface"]["full"] = surface->full;
  report_.push_back(std::move(json));
  rows_.push_back({what + " -> " + version_name(), pretty(ms, 3), kibibytes(surface->moved),
                   pretty(surface->moved.ms, 3), quality});
  return {};
}

expected<void> recipe_runner::step(const import_step& s) {
  if (client::is_cad_file(s.mesh) || client::is_surface_file(s.mesh))
    return import_part(s);
  const stopwatch clock;
  const auto done = server_.import_file(s.mesh, s.length_unit, make_execution(session_));
  end_progress(session_);
  if (!done)
    return fail(done.error());
  for (const auto& warning : done->warnings)
    notice(session_, "note: " + warning);
  return take_head("import", *done, clock.milliseconds());
}

/// The server meshes it; it begins a document of its own.
expected<void> recipe_runner::import_part(const import_step& s) {
  const stopwatch clock;
  client::part_options options;
  if (!s.size.empty())
    options.fineness = s.size;
  if (client::is_surface_file(s.mesh) || s.length_unit != "mm")
    options.length_unit = s.length_unit;
  for (const auto& [surface, mm] : s.local_sizes_mm)
    options.local_sizes.push_back({surface, 1e-3 * mm});
  const auto made = server_.import_part(s.mesh, "", options, make_execution(session_));
  end_progress(session_);
  if (!made)
    return fail(made.error());
  for (const auto& warning : made->warnings)
    notice(session_, "note: " + warning);
  const auto opened = server_.open(made->document, true, true);
  if (!opened)
    return fail(opened.error());
  document_ = opened->document;
  client::committed begun;
  begun.cause = "import";
  begun.head = *opened->head;
  return take_head("import", begun, clock.milliseconds());
}

/// What was solved before has other loads.
void recipe_runner::loads_changed(const char* how, const std::string& name) {
  report_.push_back({{"step", how}, {"name", name}});
  solved_.erase(head_.version_id);
  followed_.reset();
}

expected<std::vector<std::vector<surface_id>>> recipe_runner::meanings(
  const std::vector<client::surface_reference>& references) {
  return client::meanings_of(
    references, known_, server_.surface(),
    [&](const selection_query& query) { return server_.select(query, make_execution(session_)); });
}

expected<void> recipe_runner::step(const client::load_case_step& s) {
  const auto named = meanings(s.references);
  if (!named)
    return fail(named.error());
  auto loads = s.loads;
  client::put_surfaces(loads, *named);
  loads_changed("load_case", loads.name);
  return server_.set_load_case(loads);
}

expected<void> recipe_runner::step(const client::remove_load_case_step& s) {
  loads_changed("remove_load_case", s.name);
  return server_.remove_load_case(s.name);
}

expected<void> recipe_runner::step(const client::edit_step& s) {
  const stopwatch clock;
  const auto before = server_.surface();
  const auto named = meanings(s.references);
  if (!named)
    return fail(named.error());
  auto surfaces = s.request.surfaces;
  client::put_surfaces(surfaces, *named);
  const auto done = server_.edit(s.request.operation, surfaces, s.request.parameters,
                                 make_execution(session_), {}, s.request.loads);
  end_progress(session_);
  if (!done)
    return fail(done.error());
  std::string name = s.request.operation;
  for (const auto id : surfaces)
    name += (id == surfaces.front() ? " " : ",") + std::to_string(id);
  auto taken = take_head(name, *done, clock.milliseconds());
  if (taken)
    known_.note(s.label, before, server_.surface());
  return taken;
}

expected<void> recipe_runner::step(const client::undo_step&) {
  const stopwatch clock;
  const auto done = server_.undo();
  return done ? take_head("undo", *done, clock.milliseconds()) : fail(done.error());
}

expected<void> recipe_runner::step(const client::redo_step&) {
  const stopwatch clock;
  const auto done = server_.redo();
  return done ? take_head("redo", *done, clock.milliseconds()) : fail(done.error());
}

expected<void> recipe_runner::step(const client::go_to_step& s) {
  const stopwatch clock;
  const auto done = server_.go_to(s.version);
  return done ? take_head("go to", *done, clock.milliseconds()) : fail(done.error());
}

expected<void> recipe_runner::step(const client::apply_step&) {
  ++passed_over_;  // Never here: `check` refuses it.
  return {};
}

expected<void> recipe_runner::step(const client::window_step&) {
  ++passed_over_;
  return {};
}

client::solve_settings recipe_runner::settings_of(const solve_step& s) const {
  client::solve_settings settings;
  settings.tolerance = recipe_.tolerance;
  settings.device = recipe_.device;
  settings.element_order = recipe_.order;
  settings.load_cases = s.load_cases;
  settings.all_load_cases = s.all_load_cases;
  settings.energy_tolerance = s.energy_tolerance;
  return settings;
}

expected<solve_outcome> recipe_runner::ask(const client::solve_settings& settings) {
  auto done = server_.solve_cases(settings, make_execution(session_));
  end_progress(session_);
  if (done)
    followed_ = settings;
  return done;
}

/// The head's fields. Asked for once; from then on they come by themselves after every edit.
expected<std::vector<client::field_event>> recipe_runner::await_fields(
  const client::solve_settings& settings) {
  constexpr auto interval = std::chrono::milliseconds(200);
  std::uint64_t solve = 0;  // That was asked for: fields of another may be on their way.
  bool asks = followed_ != settings;
  while (true) {
    if (asks) {
      const auto done = ask(settings);
      if (!done)  // Says why.
        return fail(done.error());
      solve = done->solve;
    }
    auto fields = server_.wait_fields(head_.version_id, interval, solve);
    if (fields || fields.error().code != ec::timeout)
      return fields;
    if (session_.cancel.cancelled())
      return fail(ec::cancelled, "interrupted");
    asks = solve == 0 && failures_->contains(head_.version_id);
  }
}

/// A row for each load case, and for several one with the worst of all.
void recipe_runner::add_rows(const std::vector<client::field_event>& fields, bool known) {
  for (const auto& field : fields) {
    std::string what = "field of " + version_name() + (known ? " (kept)" : "");
    if (field.envelope) {
      rows_.push_back({what + ": worst", "", kibibytes(field.moved), pretty(field.moved.ms, 3), "",
                       "", "", "", "", pretty(1e-6 * field.envelope->max_von_mises.value, 4),
                       short_place(field.envelope->max_von_mises.at),
                       pretty(1e3 * field.envelope->max_displacement.value, 5)});
      continue;
    }
    const auto& report = field.report;
    if (fields.size() > 1)
      what += ": " + report.load_case;
    // A kept field cost no solve: its times would read as if it had.
    rows_.push_back(
      {what, "", kibibytes(field.moved), pretty(field.moved.ms, 3), "",
       known ? "" : pretty(report.assembly_ms, 3), known ? "" : pretty(report.solve_ms, 4),
       std::to_string(report.iterations), pretty(report.true_relative_residual, 2),
       pretty(1e-6 * report.max_von_mises_pa, 4), short_place(report.max_von_mises_at),
       pretty(1e3 * report.max_displacement_m, 5)});
  }
}

expected<void> recipe_runner::step(const solve_step& s) {
  const auto settings = settings_of(s);
  const auto before = solved_.find(head_.version_id);
  const bool known = before != solved_.end() && before->second.settings == settings;
  const auto fields = await_fields(settings);
  if (!fields)
    return fail(fields.error());
  const auto outcome = outcome_of(*fields);
  solved_[head_.version_id] = {settings, outcome};
  if (!known)
    details_ += "field of " + version_name() + "\n" + summarize(outcome) +
                (recipe_.order == 2 ? preview_text(outcome) : "");  // Linear tets: said at the end.
  auto json = cli::to_json(outcome);
  json["step"] = "solve";
  json["from_cache"] = known;
  if (outcome.envelope) {
    for (std::size_t c = 0; c < outcome.cases.size(); ++c)
      json["cases"][c]["field"] = to_json((*fields)[c].moved);
    json["timings_ms"] = sum_of_times(outcome);
  }
  json["field"] = to_json(fields->back().moved);
  report_.push_back(std::move(json));
  add_rows(*fields, known);
  return {};
}

}  // namespace tedit::cli
