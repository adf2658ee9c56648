// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/recipe_runner.hpp"

#include <fstream>

#include "base/child_process.hpp"
#include "base/stopwatch.hpp"
#include "cli/reports.hpp"
#include "protocol/convert.hpp"

namespace tedit::cli {

namespace {

constexpr auto surface_patience = std::chrono::minutes(2);

std::string place(vec3 p) {
  const double largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return components(1e3 * p, 3, 1e3 * largest, 5e-4);
}

std::string kibibytes(const client::traffic& moved) {
  return pretty(static_cast<double>(moved.bytes) / 1024, 3);
}

nlohmann::ordered_json to_json(const client::traffic& moved) {
  return {{"bytes", moved.bytes}, {"messages", moved.messages}, {"ms", moved.ms}};
}

/// What a picture's numbers are worth, and where its colours end before the field does.
std::string caption_of(const solve_report& shown, const export_step& s) {
  std::string place = shown.element_order < 2 ? " (element)" : " (node)";
  if (shown.max_von_mises_singularity)
    place += *shown.max_von_mises_singularity == fem::singularity::clamp_rim
               ? " at a clamp's rim"
               : " at a re-entrant edge";
  const bool beyond = s.range_mpa && 1e-6 * shown.max_von_mises_pa > s.range_mpa->second;
  const auto clipped = beyond ? ",  colours end at " + pretty(s.range_mpa->second) + " MPa" : "";
  return std::string(shown.element_order < 2 ? "Preview: linear tets understate bending.  "
                     : shown.preview         ? "Preview: stopped early.  "
                                             : "Quadratic tets,  ") +
         "max von Mises " + pretty(1e-6 * shown.max_von_mises_pa, 4) + " MPa" + place + clipped +
         ",  error estimate " + pretty(100 * shown.relative_error_estimate, 2) + " %,  residual " +
         pretty(shown.true_relative_residual, 2) + ",  version " + shown.version_id.substr(0, 8);
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

expected<void> recipe_runner::run() {
  if (auto opened = server_.open("", true, true); !opened)
    return fail(opened.error());
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
  nlohmann::ordered_json json{{"version_id", head_.version_id}};
  std::string quality;
  if (done.report) {
    json = cli::to_json(*done.report);
    quality = pretty(done.report->touched_min_after, 3) + " (" +
              pretty(done.report->touched_min_before, 3) + ")";
    details_ += what + " -> " + version_name() + "\n" + describe(*done.report);
  }
  json["step"] = done.cause;
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
  const stopwatch clock;
  const auto done = server_.import_file(s.mesh, s.length_unit, make_execution(session_));
  end_progress(session_);
  if (!done)
    return fail(done.error());
  for (const auto& warning : done->warnings)
    notice(session_, "note: " + warning);
  return take_head("import", *done, clock.milliseconds());
}

expected<void> recipe_runner::step(const load_case_step& s) {
  const auto loads = protocol::load_case_from_file(s.file);
  if (!loads)
    return fail(loads.error());
  report_.push_back({{"step", "load_case"}, {"name", loads->name}});
  return server_.set_load_case(*loads);
}

expected<void> recipe_runner::step(const edit_step& s) {
  const stopwatch clock;
  const auto done = server_.edit(s.request.operation, s.request.surfaces, s.request.parameters,
                                 make_execution(session_));
  end_progress(session_);
  if (!done)
    return fail(done.error());
  std::string name = s.request.operation;
  for (const auto id : s.request.surfaces)
    name += (id == s.request.surfaces.front() ? " " : ",") + std::to_string(id);
  return take_head(name, *done, clock.milliseconds());
}

expected<void> recipe_runner::step(const undo_step&) {
  const stopwatch clock;
  const auto done = server_.undo();
  return done ? take_head("undo", *done, clock.milliseconds()) : fail(done.error());
}

expected<void> recipe_runner::step(const redo_step&) {
  const stopwatch clock;
  const auto done = server_.redo();
  return done ? take_head("redo", *done, clock.milliseconds()) : fail(done.error());
}

/// The head's field. Asked for once; from then on it comes by itself after every edit.
expected<client::field_event> recipe_runner::await_field() {
  constexpr auto interval = std::chrono::milliseconds(200);
  const auto ask = [&] {
    return server_.solve({{}, recipe_.tolerance, recipe_.device, recipe_.order},
                         make_execution(session_));
  };
  if (!follows_) {
    const auto done = ask();
    end_progress(session_);
    if (!done)
      return fail(done.error());
    follows_ = true;
  }
  while (true) {
    auto field = server_.wait_field(head_.version_id, interval);
    if (field || field.error().code != ec::timeout)
      return field;
    if (session_.cancel.cancelled())
      return fail(ec::cancelled, "interrupted");
    if (failures_->contains(head_.version_id))
      if (const auto again = ask(); !again)  // Says why.
        return fail(again.error());
  }
}

expected<void> recipe_runner::step(const solve_step&) {
  const bool known = solved_.contains(head_.version_id);
  const auto field = await_field();
  if (!field)
    return fail(field.error());
  const auto& report = field->report;
  solved_[head_.version_id] = report;
  if (!known)
    details_ += "field of " + version_name() + "\n" + summarize(report);
  auto json = cli::to_json(report);
  json["step"] = "solve";
  json["from_cache"] = known;
  json["field"] = to_json(field->moved);
  report_.push_back(std::move(json));
  // A kept field cost no solve: its times would read as if it had.
  rows_.push_back(
    {"field of " + version_name() + (known ? " (kept)" : ""), "", kibibytes(field->moved),
     pretty(field->moved.ms, 3), "", known ? "" : pretty(report.assembly_ms, 3),
     known ? "" : pretty(report.solve_ms, 4), std::to_string(report.iterations),
     pretty(report.true_relative_residual, 2), pretty(1e-6 * report.max_von_mises_pa, 4),
     place(report.max_von_mises_at), pretty(1e3 * report.max_displacement_m, 5)});
  return {};
}

// -- files -------------------------------------------------------------------------------------

std::filesystem::path recipe_runner::path_of(const std::string& name) const {
  std::string text = name;
  const std::string mark = "{version}";
  if (const auto at = text.find(mark); at != std::string::npos)
    text.replace(at, mark.size(), std::to_string(head_.number));
  return out_ / text;
}

expected<void> recipe_runner::write(client::file_format format, const std::filesystem::path& path) {
  const auto bytes = server_.export_file(format, head_.version_id, "mm", make_execution(session_));
  end_progress(session_);
  if (!bytes)
    return fail(bytes.error());
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream out(path, std::ios::binary);
  out.write(bytes->data(), static_cast<std::streamsize>(bytes->size()));
  out.close();
  if (!out)
    return fail(ec::io_error, "cannot write " + path.string(), "Choose another folder with --out");
  return {};
}

expected<void> recipe_runner::draw(const export_step& s, const std::filesystem::path& png) {
  const auto vtu = s.vtu.empty() ? std::filesystem::path(png.string() + ".vtu") : path_of(s.vtu);
  if (s.vtu.empty())
    if (auto ok = write(client::file_format::vtu, vtu); !ok)
      return ok;
  const auto& shown = solved_.at(head_.version_id);
  const auto caption = caption_of(shown, s);
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
  if ((!s.vtu.empty() || !s.png.empty()) && !solved_.contains(head_.version_id))
    return fail(ec::bad_input, "this version has no field to export", "Put a solve step first");
  const std::array<std::pair<const std::string*, client::file_format>, 3> wanted{
    {{&s.msh, client::file_format::msh},
     {&s.stl, client::file_format::stl},
     {&s.vtu, client::file_format::vtu}}};
  for (const auto& [name, format] : wanted) {
    if (name->empty())
      continue;
    if (auto ok = write(format, path_of(*name)); !ok)
      return ok;
    files_.push_back(path_of(*name).string());
  }
  if (s.png.empty())
    return {};
  if (auto ok = draw(s, path_of(s.png)); !ok)
    return ok;
  files_.push_back(path_of(s.png).string());
  return {};
}

}  // namespace tedit::cli
