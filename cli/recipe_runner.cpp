// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/recipe_runner.hpp"

#include "base/child_process.hpp"
#include "base/stopwatch.hpp"
#include "cli/field_file.hpp"
#include "mesh/io/import.hpp"
#include "mesh/io/msh_writer.hpp"
#include "mesh/io/stl_writer.hpp"
#include "mesh/quality.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

std::string place(vec3 p) {
  return pretty(1e3 * p.x, 3) + "," + pretty(1e3 * p.y, 3) + "," + pretty(1e3 * p.z, 3);
}

nlohmann::ordered_json triple(vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace

expected<void> recipe_runner::run() {
  for (std::size_t i = 0; i < recipe_.steps.size(); ++i) {
    if (session_.cancel.cancelled())
      return fail(ec::cancelled, "interrupted");
    auto done = std::visit([this](const auto& s) { return step(s); }, recipe_.steps[i]);
    if (!done) {
      auto failure = done.error();
      failure.message = "step " + std::to_string(i + 1) + ": " + failure.message;
      return fail(std::move(failure));
    }
  }
  return {};
}

expected<void> recipe_runner::need_version() const {
  if (states_.empty())
    return fail(ec::bad_input, "there is no mesh yet", "Put an import step first");
  return {};
}

void recipe_runner::add_row(const std::string& what, const std::string& edit,
                            const std::string& quality, const fem::solution* solved) {
  std::vector<std::string> row{what, edit, quality};
  if (solved) {
    row.push_back(pretty(solved->assembly_ms, 3));
    row.push_back(pretty(solved->solve_ms, 4));
    row.push_back(std::to_string(solved->iterations));
    row.push_back(pretty(solved->true_relative_residual, 2));
    row.push_back(pretty(1e-6 * solved->max_von_mises_pa, 4));
    row.push_back(place(solved->max_von_mises_at));
    row.push_back(pretty(1e3 * solved->max_displacement_m, 5));
  }
  rows_.push_back(std::move(row));
}

std::string recipe_runner::table() const {
  auto rows = rows_;
  rows.insert(rows.begin(),
              {"step", "edit ms", "worst q (before)", "assembly ms", "solve ms", "iterations",
               "residual", "max von Mises MPa", "at mm", "max displ. mm"});
  return format_table(rows);
}

expected<void> recipe_runner::step(const import_step& s) {
  auto imported = import_mesh(s.mesh, s.length_unit);
  if (!imported)
    return fail(imported.error());
  for (const auto& warning : imported->warnings)
    notice(session_, "note: " + warning);
  states_ = {{imported->version, {}, 0, 0, 0}};
  head_ = 0;
  const auto quality = radius_ratios(*imported->version);
  add_row("import v0", "", pretty(quality.min, 3), nullptr);
  report_.push_back({{"step", "import"},
                     {"version_id", to_hex(imported->version->id())},
                     {"tets", imported->version->tet_count()},
                     {"import_ms", imported->read_ms + imported->build_ms}});
  return {};
}

expected<void> recipe_runner::step(const load_case_step& s) {
  if (auto ok = need_version(); !ok)
    return ok;
  auto loads = protocol::load_case_from_file(s.file);
  if (!loads)
    return fail(loads.error());
  report_.push_back({{"step", "load_case"}, {"name", loads->name}});
  states_[head_].load_cases = {std::move(*loads)};
  return {};
}

expected<void> recipe_runner::step(const edit_step& s) {
  if (auto ok = need_version(); !ok)
    return ok;
  if (!plugins_)
    plugins_ = ops::load_default_catalogue();
  const auto& base = states_[head_];
  auto outcome =
    apply_edit(*plugins_, base.version, s.request, base.load_cases, make_execution(session_));
  if (!outcome)
    return fail(outcome.error());
  auto json = to_json(*base.version, *outcome);
  json["step"] = "edit";
  report_.push_back(std::move(json));
  const auto& done = outcome->finished;
  states_.resize(head_ + 1);
  states_.push_back({outcome->version, outcome->load_cases, outcome->total_ms,
                     done.touched_min_before, done.touched_min_after});
  ++head_;
  std::string name = s.request.operation;
  for (const auto id : s.request.surfaces)
    name += (id == s.request.surfaces.front() ? " " : ",") + std::to_string(id);
  add_row(name + " -> v" + std::to_string(head_), pretty(outcome->total_ms, 3),
          pretty(done.touched_min_after, 3) + " (" + pretty(done.touched_min_before, 3) + ")",
          nullptr);
  notice(session_, name + "\n" + describe(*outcome));
  return {};
}

expected<void> recipe_runner::step(const undo_step&) {
  if (head_ == 0)
    return fail(ec::conflict, "there is nothing to undo");
  --head_;
  add_row("undo -> v" + std::to_string(head_), "0", "", nullptr);
  report_.push_back({{"step", "undo"}, {"version_id", to_hex(states_[head_].version->id())}});
  return {};
}

expected<void> recipe_runner::step(const redo_step&) {
  if (head_ + 1 >= states_.size())
    return fail(ec::conflict, "there is nothing to redo");
  ++head_;
  add_row("redo -> v" + std::to_string(head_), "0", "", nullptr);
  report_.push_back({{"step", "redo"}, {"version_id", to_hex(states_[head_].version->id())}});
  return {};
}

expected<void> recipe_runner::step(const solve_step&) {
  if (auto ok = need_version(); !ok)
    return ok;
  const auto& now = states_[head_];
  if (now.load_cases.empty())
    return fail(ec::bad_input, "there is no load case to solve", "Put a load_case step first");
  const auto id = now.version->id();
  const bool known = results_.contains(id);
  if (!known) {
    auto problem = fem::make_problem(*now.version, now.load_cases.front());
    if (!problem)
      return fail(problem.error());
    if (!device_) {
      auto opened = fem::open_backend(recipe_.device);
      if (!opened)
        return fail(opened.error());
      device_ = std::move(*opened);
    }
    fem::solve_settings settings;
    settings.tolerance = recipe_.tolerance;
    auto solved = fem::solve(*problem, *device_, settings, make_execution(session_));
    if (!solved)
      return fail(solved.error());
    results_.emplace(id, result{std::move(*problem), std::move(*solved)});
  }
  const auto& solved = results_.at(id).solution;
  add_row("field of v" + std::to_string(head_) + (known ? " (kept)" : ""), "", "", &solved);
  report_.push_back({{"step", "solve"},
                     {"version_id", to_hex(id)},
                     {"from_cache", known},
                     {"device", solved.device},
                     {"element_order", solved.element_order},
                     {"preview", solved.preview()},
                     {"iterations", solved.iterations},
                     {"true_relative_residual", solved.true_relative_residual},
                     {"max_displacement_m", solved.max_displacement_m},
                     {"compliance_j", solved.compliance_j},
                     {"max_von_mises_pa", solved.max_von_mises_pa},
                     {"max_von_mises_at_m", triple(solved.max_von_mises_at)},
                     {"reaction_n", triple(solved.reaction_n)},
                     {"applied_n", triple(solved.applied_n)},
                     {"timings_ms",
                      {{"assembly", solved.assembly_ms},
                       {"setup", solved.setup_ms},
                       {"solve", solved.solve_ms},
                       {"recovery", solved.recovery_ms}}}});
  return {};
}

std::filesystem::path recipe_runner::path_of(const std::string& name) const {
  std::string text = name;
  const std::string mark = "{version}";
  if (const auto at = text.find(mark); at != std::string::npos)
    text.replace(at, mark.size(), std::to_string(head_));
  return out_ / text;
}

expected<void> recipe_runner::draw(const export_step& s, const std::filesystem::path& png,
                                   const result& shown) {
  const auto vtu = s.vtu.empty() ? std::filesystem::path(png.string() + ".vtu") : path_of(s.vtu);
  if (s.vtu.empty())
    if (auto ok = write_field(vtu, *states_[head_].version, shown.problem, shown.solution); !ok)
      return ok;
  const auto caption =
    std::string(shown.solution.preview() ? "Preview: linear tets understate bending.  " : "") +
    "max von Mises " + pretty(1e-6 * shown.solution.max_von_mises_pa, 4) +
    " MPa (element),  residual " + pretty(shown.solution.true_relative_residual, 2) +
    ",  version " + to_hex(states_[head_].version->id()).substr(0, 8);
  std::vector<std::string> command{(executable_folder() / "tedit-render").string(),
                                   vtu.string(),
                                   "-o",
                                   png.string(),
                                   "--title",
                                   s.title,
                                   "--caption",
                                   caption};
  if (s.range_mpa) {
    command.push_back("--range");
    command.push_back(pretty(s.range_mpa->first, 9) + "," + pretty(s.range_mpa->second, 9));
  }
  const auto drawn = run_child(command, {}, {std::chrono::minutes(2), 0}, make_execution(session_));
  std::error_code ignored;
  if (s.vtu.empty())
    std::filesystem::remove(vtu, ignored);
  if (!drawn)
    return fail(drawn.error().code,
                "the picture " + png.string() + " could not be drawn: " + drawn.error().message,
                "Try \"tedit render\" by hand: it says more");
  return {};
}

expected<void> recipe_runner::step(const export_step& s) {
  if (auto ok = need_version(); !ok)
    return ok;
  const auto& mesh = *states_[head_].version;
  std::error_code ignored;
  std::filesystem::create_directories(out_, ignored);
  const auto wrote = [&](const std::filesystem::path& path) { files_.push_back(path.string()); };
  if (!s.msh.empty()) {
    if (auto ok = write_msh(path_of(s.msh), mesh, "mm"); !ok)
      return ok;
    wrote(path_of(s.msh));
  }
  if (!s.stl.empty()) {
    if (auto ok = write_stl(path_of(s.stl), mesh, "mm"); !ok)
      return ok;
    wrote(path_of(s.stl));
  }
  if (s.vtu.empty() && s.png.empty())
    return {};
  const auto shown = results_.find(mesh.id());
  if (shown == results_.end())
    return fail(ec::bad_input, "this version has no field to export", "Put a solve step first");
  if (!s.vtu.empty()) {
    if (auto ok = write_field(path_of(s.vtu), mesh, shown->second.problem, shown->second.solution);
        !ok)
      return ok;
    wrote(path_of(s.vtu));
  }
  if (!s.png.empty()) {
    if (auto ok = draw(s, path_of(s.png), shown->second); !ok)
      return ok;
    wrote(path_of(s.png));
  }
  return {};
}

}  // namespace tedit::cli
